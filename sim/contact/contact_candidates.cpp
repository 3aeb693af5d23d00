// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Before the contacts: what an instrument can reach in a frame, and how far it may go in a substep.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/contact/contact.h"
#include "sim/contact/jaw_spread.h"
#include "sim/contact/patch_contact.h"
#include "sim/contact/tool_contact.h"
#include "sim/core/float_lanes.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kTissueReach = 0.0005;  // tissue may come this much nearer within a frame [m]
constexpr double kStepOfRadius = 0.6;    // motion per substep near tissue, in radii of the tip
constexpr double kTremor = 1e-4;         // of an instrument that balances hand and tissue [m]
constexpr double kFreeStep = 0.003;      // motion per frame where nothing is near [m]
// Tried on a 1.5 mm probe in 60 kPa tissue with grips of 50 and 600 N/m: 1 oscillates, 4 is quiet.
constexpr double kCaution = 6;

/// Normalised linear interpolation: for the small turns of a frame as good as slerp, without the
/// library's sine, whose last bit depends on the processor.
Quat between(const Quat& from, const Quat& to, double share) noexcept {
    const double sign = from.dot(to) < 0 ? -1.0 : 1.0;
    Quat q;
    q.coeffs() = (1 - share) * from.coeffs() + (share * sign) * to.coeffs();
    q.normalize();
    return q;
}

constexpr int kPatchGroup = 8;  // triangles that follow each other, and lie side by side

/// Balls around groups of a patch's triangles: most of it is far from any instrument.
class PatchGroups {
 public:
    PatchGroups(const Patch& patch, const State& state) noexcept
        : count_((static_cast<int>(patch.triangles.size()) + kPatchGroup - 1) / kPatchGroup) {
        for (int g = 0; g < count_; ++g) {
            FloatLanes low = every_lane(1e9F), high = every_lane(-1e9F);
            float longest2 = 0;
            const int end =
                std::min(kPatchGroup * (g + 1), static_cast<int>(patch.triangles.size()));
            for (int i = kPatchGroup * g; i < end; ++i) {
                const auto& v = patch.triangles[i].vertex;
                const FloatLanes a = lanes_of(state.body.x[v[0]]), b = lanes_of(state.body.x[v[1]]),
                                 c = lanes_of(state.body.x[v[2]]);
                const FloatLanes l = least(least(a, b), c), h = most(most(a, b), c);
                longest2 = std::max(longest2, dot3(h - l, h - l));
                low = least(low, l);
                high = most(high, h);
            }
            const FloatLanes middle = every_lane(0.5F) * (low + high), size = high - low;
            // The centre of a triangle is in the box, its corners no farther than it is long.
            const float radius =
                kRounding * (0.5F * std::sqrt(dot3(size, size)) + std::sqrt(longest2));
            ball_[g] = {middle[0], middle[1], middle[2], radius};
        }
    }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] Vec3 centre(int g) const noexcept { return to_vec(ball_[g]); }
    [[nodiscard]] bool beyond(int g, double distance, double limit) const noexcept {
        return distance > limit + static_cast<double>(ball_[g].w);
    }

 private:
    static constexpr float kRounding = 1.0001F;
    int count_;
    std::array<Float4, 2 * kMostPatchVertices / kPatchGroup + 1> ball_;
};

/// The boxes of the surface around the tissue as it is. Every other frame is enough: returns how
/// much too small those of the frame before are by what the tissue may have moved since [m].
double refit_surface(State& state) noexcept {
    const bool refit = state.frame % 2 == 0 || state.colour.fitted != state.surface.version();
    if (refit && !state.sleep.still()) {
        if (state.sleep.enabled())
            state.surface.refit(state.body.x, state.sleep.leaf_moves, *state.workers);
        else
            state.surface.refit(state.body.x);
        state.colour.fitted = state.surface.version();
    }
    return refit ? 0 : kTissueReach;
}

/// How near to an instrument tissue has to be to meet it within this frame [m].
double reach_in_frame(const Scene& scene, const State& state, int t) noexcept {
    const ToolState& tool = state.tools[t];
    const ToolShape& shape = state.scratch->contacts.shapes[t];
    // To the hand and back, and as far as the tissue's last push; near tissue never faster than
    // kStepOfRadius allows.
    const double to_hand = (tool.hand.p - tool.proxy.p).norm();
    const double push = tool.substep_force_n.norm() / scene.tools[t].hand_n_m;
    const double path =
        std::min(2 * (to_hand + push) + kTremor,
                 to_hand + kStepOfRadius * shape.parts[0].near_radius_m * state.substeps);
    return scene.contact.margin_m + std::min(path, kFreeStep) + kTissueReach;
}

/// Puts the triangles that one instrument can meet into the set.
class ToolCandidates {
 public:
    ToolCandidates(State& state, int tool) noexcept
        : state_(state),
          set_(state.scratch->contacts),
          shape_(set_.shapes[tool]),
          to_tool_(state.tools[tool].proxy.inverse()),
          tool_(tool) {}

    /// @param stale of refit_surface().
    void add_tissue(double limit, double stale) noexcept {
        const auto triangles = state_.surface.triangles();
        state_.surface.tree().walk(
            [&](const SurfaceTree::Box& box) noexcept {
                const Vec3 low(box.low[0], box.low[1], box.low[2]);
                const Vec3 high(box.high[0], box.high[1], box.high[2]);
                const double radius = 0.5 * (high - low).norm() + stale;
                const Vec3 centre_T = to_tool_ * (0.5 * (low + high));
                return distance_value(shape_, centre_T) > limit + radius;
            },
            [&](int i) noexcept { add(triangles[i].vertex, i, limit); });
    }

    void add_patch(const Patch& patch, const PatchGroups& groups, double limit) noexcept {
        const int count = static_cast<int>(patch.triangles.size());
        for (int g = 0; g < groups.count(); ++g) {
            const double distance = distance_value(shape_, to_tool_ * groups.centre(g));
            if (groups.beyond(g, distance, limit)) continue;
            for (int i = kPatchGroup * g; i < std::min(kPatchGroup * (g + 1), count); ++i)
                add(patch.triangles[i].vertex, kPatchCandidate + i, limit);
        }
    }

 private:
    /// A ball around box or triangle: the distance changes by no more than the way.
    void add(const std::array<int32_t, 3>& v, int number, double within) noexcept {
        const Vec3 a = position(state_.body, v[0]), b = position(state_.body, v[1]),
                   c = position(state_.body, v[2]);
        const Vec3 centre = (a + b + c) / 3;
        const double radius = std::sqrt(std::max(
            {(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()}));
        const Vec3 centre_T = to_tool_ * centre;
        const double distance = distance_value(shape_, centre_T);
        if (distance > within + radius) return;
        if (set_.candidate_count == static_cast<int>(set_.candidates.size())) {
            state_.flags |= kContactsDropped;
            return;
        }
        set_.near[tool_] = 1;
        const Vec3f p = centre_T.cast<float>();
        set_.start[set_.candidate_count] = {p.x(), p.y(), p.z(), static_cast<float>(distance)};
        set_.candidates[set_.candidate_count++] = number * 4 + tool_;
    }

    State& state_;
    ContactSet& set_;
    const ToolShape& shape_;
    const Pose to_tool_;
    const int tool_;
};

}  // namespace

void collect_candidates(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    set.candidate_count = set.most_contacts = 0;
    set.near.fill(0);
    const double stale = refit_surface(state);
    spread_jaws(scene, state);
    std::optional<PatchGroups> groups;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        if (!state.tools[t].engaged) continue;
        ToolCandidates candidates(state, t);
        const double limit = reach_in_frame(scene, state, t);
        candidates.add_tissue(limit, stale);
        if (!scene.patch) continue;
        if (!groups) groups.emplace(*scene.patch, state);
        candidates.add_patch(*scene.patch, *groups, limit + scene.patch->thickness_m / 2);
    }
}

void move_tools(const Scene& scene, State& state, std::span<const Pose> from,
                std::span<const Pose> to, double share) noexcept {
    ContactSet& set = state.scratch->contacts;
    std::array<Vec3, kMaxTools> hands;
    std::array<double, kMaxTools> longest_step{};
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        const Vec3 hand = hands[t] = from[t].p + share * (to[t].p - from[t].p);
        if (!tool.engaged) continue;
        tool.proxy.q = between(from[t].q, to[t].q, share);
        const NeedlePull needle = needle_pull(scene, state, t);
        if (!set.near[t] && needle.stiffness_n_m == 0) {
            Vec3 offset = hand - tool.proxy.p;
            const double most = longest_step[t] = kFreeStep / state.substeps,
                         length = offset.norm();
            if (length > most) offset *= most / length;
            tool.proxy.p += offset;
            continue;
        }
        // Quasi-static balance of hand and tissue, one Newton step with the stiffness that the
        // touched vertices show at once. kCaution keeps it calm while contacts come and go; at rest
        // the balance is exact whatever the stiffness.
        const double grip = scene.tools[t].hand_n_m;
        Vec3 force = tool.substep_force_n;
        if (needle.stiffness_n_m > 0) force += needle.force_n;
        Vec3 step = (grip * (hand - tool.proxy.p) + force) /
                    (grip + kCaution * tool.substep_stiffness_n_m + needle.stiffness_n_m);
        double longest = kStepOfRadius * set.shapes[t].parts[0].near_radius_m;
        // Into tissue that has not given way yet only as far as the axis stays outside of it.
        if (step.dot(tool.substep_force_n) < 0) {
            longest = std::max(0.0, longest - tool.substep_overlap_m);
        }
        longest_step[t] = longest;
        const double length = step.norm();
        if (length > longest) step *= longest / length;
        tool.proxy.p += step;
    }
    part_tools(scene, state, hands, longest_step);
}

}  // namespace placode::sim
