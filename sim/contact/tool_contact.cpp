// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/tool_contact.h"

#include <algorithm>
#include <cmath>

#include "sim/world/scene.h"
#include "sim/world/scratch.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr double kForgetM = 1e-3;  // apart: which side it was does not matter any more

Vec3 on_axis(const Pose& X_WT, double behind_m) noexcept { return X_WT * Vec3(0, 0, -behind_m); }

double radius_at(const RoundCone& part, double share) noexcept {
    return part.near_radius_m + share * (part.far_radius_m - part.near_radius_m);
}

bool touches(const Scene& scene, const State& state, int t) noexcept {
    return state.tools[t].engaged != 0 && scene.tools[t].kind != ToolKind::kScope;
}

/// A tool and the hand that holds it.
struct Held {
    ToolState& tool;
    double hand_n_m = 0;
    Vec3 hand_m;

    [[nodiscard]] Vec3 offset_m() const noexcept { return hand_m - tool.proxy.p; }
    /// What hand and tissue push along n [N].
    [[nodiscard]] double push_n(const Vec3& n) const noexcept {
        return (hand_n_m * offset_m() + tool.substep_force_n).dot(n);
    }
};

/// n from a to b.
void part(Held& a, Held& b, const Vec3& n, double overlap_m, double longest_m) noexcept {
    const double sum = a.hand_n_m + b.hand_n_m;
    a.tool.proxy.p -= b.hand_n_m / sum * overlap_m * n;
    b.tool.proxy.p += a.hand_n_m / sum * overlap_m * n;
    const Vec3 shift = std::clamp((a.push_n(n) + b.push_n(n)) / sum, -longest_m, longest_m) * n;
    a.tool.proxy.p += shift;
    b.tool.proxy.p += shift;
}

}  // namespace

ToolGap gap_between(const ToolShape& a, const Pose& X_WA, const ToolShape& b,
                    const Pose& X_WB) noexcept {
    ToolGap best;
    for (int i = 0; i < a.count; ++i) {
        const RoundCone& p = a.parts[i];
        const Vec3 p0 = on_axis(X_WA, p.near_m), p1 = on_axis(X_WA, p.far_m);
        for (int j = 0; j < b.count; ++j) {
            const RoundCone& q = b.parts[j];
            const Vec3 q0 = on_axis(X_WB, q.near_m), q1 = on_axis(X_WB, q.far_m);
            double s = 0, t = 0;
            const double length = std::sqrt(segment_segment(p0, p1, q0, q1, s, t));
            const double reach = radius_at(p, s) + radius_at(q, t);
            if (length - reach >= best.value_m) continue;
            const Vec3 offset = q0 + t * (q1 - q0) - p0 - s * (p1 - p0);
            best = {length - reach, reach, length > 0 ? Vec3(offset / length) : Vec3::Zero()};
        }
    }
    return best;
}

void part_tools(const Scene& scene, State& state, std::span<const Vec3> hands_m,
                std::span<const double> longest_m) noexcept {
    const auto& shapes = state.scratch->contacts.shapes;
    const int tools = static_cast<int>(scene.tools.size());
    for (int a = 0; a < tools; ++a) {
        for (int b = a + 1; b < tools; ++b) {
            Vec3& side = state.tool_side[a][b];
            if (!touches(scene, state, a) || !touches(scene, state, b)) {
                side.setZero();
                continue;
            }
            Held first{state.tools[a], scene.tools[a].hand_n_m, hands_m[a]};
            Held second{state.tools[b], scene.tools[b].hand_n_m, hands_m[b]};
            const ToolGap gap =
                gap_between(shapes[a], first.tool.proxy, shapes[b], second.tool.proxy);
            // On the other side of each other than before: they have been carried through.
            const bool through = gap.n.dot(side) < 0 && gap.value_m < kForgetM;
            const double overlap = through ? 2 * gap.reach_m + gap.value_m : -gap.value_m;
            const Vec3 n = through ? Vec3(-gap.n) : gap.n;
            const bool let_go = overlap + (first.offset_m() - second.offset_m()).dot(n) > kLetGoM;
            side = gap.value_m > kForgetM || let_go ? Vec3::Zero() : n;
            if (!(overlap > 0) || let_go) continue;
            part(first, second, n, overlap, std::min(longest_m[a], longest_m[b]));
            first.tool.steel_n -= std::max(0.0, first.push_n(n)) / state.substeps * n;
            second.tool.steel_n -= std::min(0.0, second.push_n(n)) / state.substeps * n;
        }
    }
}

}  // namespace placode::sim
