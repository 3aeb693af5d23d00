// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/needle_snapshot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/core/as_index.h"
#include "sim/core/portable_math.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr double kFreeEndM = 15e-3;                // of the tail, so much is shown at most
constexpr double kStepM = 0.5e-3, kTurnsM = 5e-3;  // the tail turns downwards over this length
constexpr double kOnTissueM = 0.11e-3;             // of the middle of a 4/0 that lies on tissue
constexpr double kOverM = 3e-3;                    // tissue higher above a thread is not under it
constexpr double kHighestM = 6e-3;                 // of an arch of slack thread
constexpr double kLoopM = 0.6e-3;  // radius of the loop that a barbed thread ends in
constexpr int kLoopPoints = 16, kBridgeSteps = 20;
constexpr int kMostBridges = 32;  // room for so many
constexpr double kNoTissue = -1;  // [m], far below every scene

using Line = std::vector<std::array<float, 3>>;

void append(Line& line, const Vec3& p) {
    line.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
}

/// Height of the tissue at a place of the plane: the highest that is not far above it, or
/// kNoTissue.
double height_under(const State& state, const Vec3& p) {
    double highest = kNoTissue;
    const auto x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
    const double most = p.z() + kOverM;
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            constexpr float kStaleM = 2e-4F;  // boxes may be those of the frame before
            return x < box.low[0] - kStaleM || x > box.high[0] + kStaleM ||
                   y < box.low[1] - kStaleM || y > box.high[1] + kStaleM;
        },
        [&](int slot) noexcept {
            const auto& v = state.surface.triangles()[as_index(slot)].vertex;
            const Vec3 a = position(state.body, v[0]), b = position(state.body, v[1]),
                       c = position(state.body, v[2]);
            const double area =
                (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
            if (!(area > 0)) return;  // seen from below, or on edge
            const double wb =
                ((p.x() - a.x()) * (c.y() - a.y()) - (p.y() - a.y()) * (c.x() - a.x())) / area;
            const double wc =
                ((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x())) / area;
            if (wb < 0 || wc < 0 || wb + wc > 1) return;
            const double z = a.z() + wb * (b.z() - a.z()) + wc * (c.z() - a.z());
            if (z < most) highest = std::max(highest, z);
        });
    return highest;
}

/// How slack thread lies.
enum class Slack : uint8_t { kArch, kSag };

/// Taut over what lies between two points, as the shortest way above it; slack, by an arch that is
/// as much longer, up or down to the tissue. Without the ends themselves.
void bridge(const State& state, const Vec3& from, const Vec3& to, double slack_m, Slack slack,
            Line& line) {
    const double span = (to - from).norm();
    if (span < 2 * kStepM) return;
    const auto at = [&](int i) -> Vec3 {
        return from + static_cast<double>(i) / kBridgeSteps * (to - from);
    };
    std::array<double, kBridgeSteps + 1> z{};
    std::array<int, kBridgeSteps + 1> hull{};
    int corners = 0;
    for (int i = 0; i <= kBridgeSteps; ++i) {
        const Vec3 p = at(i);
        const bool end = i == 0 || i == kBridgeSteps;
        z[as_index(i)] = end ? p.z() : height_under(state, p) + kOnTissueM;
        // The hull from above: a point below the chord of its neighbours is none of its corners.
        while (corners >= 2) {
            const int a = hull[as_index(corners - 2)], b = hull[as_index(corners - 1)];
            const double chord =
                z[as_index(a)] + (z[as_index(i)] - z[as_index(a)]) * (b - a) / (i - a);
            if (z[as_index(b)] > chord) break;
            --corners;
        }
        hull[as_index(corners++)] = i;
    }
    const double high = std::min(kHighestM, std::sqrt(0.375 * span * std::max(0.0, slack_m))) *
                        (slack == Slack::kSag ? -1 : 1);
    for (int i = 1, corner = 1; i < kBridgeSteps; ++i) {
        while (hull[as_index(corner)] < i) ++corner;
        const int a = hull[as_index(corner - 1)], b = hull[as_index(corner)];
        const double s = static_cast<double>(i) / kBridgeSteps;
        Vec3 p = at(i);
        const double taut = std::lerp(z[as_index(a)], z[as_index(b)],
                                      static_cast<double>(i - a) / static_cast<double>(b - a));
        p.z() = std::max(taut + 4 * s * (1 - s) * high, z[as_index(i)]);
        append(line, p);
    }
}

/// The loop at the end of a barbed thread, flat on what lies below it.
void add_loop(const State& state, const Vec3& end, const Vec3& offset, Line& loop) {
    Vec3 flat(offset.x(), offset.y(), 0);
    if (flat.norm() < 1e-3) flat = Vec3::UnitX();
    flat.normalize();
    const Vec3 aside = Vec3::UnitZ().cross(flat);
    Vec3 centre = end + kLoopM * flat;
    centre.z() = std::max(centre.z(), height_under(state, centre) + kOnTissueM);
    for (int i = 0; i <= kLoopPoints; ++i) {
        const double a = 2 * std::numbers::pi * i / kLoopPoints;
        const SineAndCosine of = sin_cos_portable(a);
        append(loop, centre - kLoopM * (of.cosine * flat + of.sine * aside));
    }
}

/// A free end hangs from the way that it leaves tissue or needle, and comes to lie on tissue.
void hang_end(const State& state, Vec3 at, Vec3 offset, double length, bool stopper,
              NeedleSnapshot& out) {
    for (double s = 0; s < std::min(length, kFreeEndM); s += kStepM) {
        offset = (offset - kStepM / kTurnsM * Vec3::UnitZ()).normalized();
        at += kStepM * offset;
        const double ground = height_under(state, at) + kOnTissueM;
        if (at.z() < ground) {
            at.z() = ground;
            offset.z() = std::max(offset.z(), 0.0);
            if (offset.norm() < 1e-3) offset = Vec3::UnitX();
            offset.normalize();
        }
        append(out.thread, at);
    }
    if (stopper && length <= kFreeEndM) add_loop(state, at, offset, out.loop);
}

/// The line from the front to the tail, as it is built.
class SeenThread {
 public:
    SeenThread(const Scene& scene, const State& state, NeedleSnapshot& out)
        : scene_(scene), state_(state), thread_(state.suturing.needle[0].thread), out_(out) {}

    void build() {
        front();
        for (int c = thread_.channel_count - 1; c >= 0; --c) {
            const ThreadChannel& channel = thread_.channels[as_index(c)];
            for (int i = channel.count - 1; i >= 0; --i) {
                const Vec3 p = place(thread_.passages[as_index(channel.first + i)].at);
                // Into the channel: the piece before it lies outside, unless the needle is in it.
                const bool outside = i == channel.count - 1 && channel.open == 0;
                if (outside && !out_.thread.empty())
                    bridge(state_, last_, p, -thread_.pieces[as_index(c + 1)].stretch_m,
                           c + 1 < thread_.channel_count ? Slack::kArch : Slack::kSag, out_.thread);
                add(p);
            }
        }
        tail();
    }

 private:
    void add(const Vec3& p) {
        if (!out_.thread.empty() && (p - last_).norm() > 0) way_ = (p - last_).normalized();
        last_ = p;
        append(out_.thread, p);
    }
    [[nodiscard]] Vec3 place(const TissuePoint& point) const {
        const auto& c = corners(scene_.body, state_.body, point.tet);
        Vec3 p = Vec3::Zero();
        for (size_t k = 0; k < 4; ++k) p += point.b[k] * position(state_.body, c[k]);
        return p;
    }
    void front() {
        if (thread_.ends[1].mode == ThreadEndMode::kSwage) {
            const Needle& shape = scene_.suture->needle();
            const ArcPoint swage = shape.at(shape.arc_m());
            const Pose& X_WN = state_.suturing.needle[0].needle;
            add(X_WN * swage.place_m);
            way_ = X_WN.q * swage.back;
        } else if (thread_.ends[1].mode == ThreadEndMode::kHeld) {
            add(thread_.ends[1].place_m);
        }
    }
    void tail() {
        if (thread_.ends[0].mode == ThreadEndMode::kHeld) {
            bridge(state_, last_, thread_.ends[0].place_m, -thread_.pieces[0].stretch_m,
                   Slack::kSag, out_.thread);
            add(thread_.ends[0].place_m);
        } else if (!out_.thread.empty()) {
            hang_end(state_, last_, way_, -thread_.pieces[0].stretch_m,
                     scene_.suture->spec().thread.stopper, out_);
        }
    }

    const Scene& scene_;
    const State& state_;
    const ThreadState& thread_;
    NeedleSnapshot& out_;
    Vec3 last_ = Vec3::Zero(), way_ = Vec3::UnitX();
};

}  // namespace

void fill_needle(const Scene& scene, const State& state, NeedleSnapshot& out) {
    assert(scene.suture && !state.suturing.needle.empty());
    out.present = state.suturing.placed;
    out.driver = state.suturing.driver;
    out.thread.clear();
    out.loop.clear();
    if (out.present == 0) return;
    const SutureState& needle = state.suturing.needle[0];
    const Needle& shape = scene.suture->needle();
    out.pose = needle.needle;
    out.arc_m = static_cast<float>(shape.arc_m());
    out.wire_radius_m = static_cast<float>(shape.spec().wire_radius_m);
    if (needle.thread.pieces.empty()) return;
    // Room for all that it may come to, once.
    out.thread.reserve(kMostPassages + 2 + as_index(kMostBridges * kBridgeSteps) +
                       static_cast<size_t>(kFreeEndM / kStepM));
    out.loop.reserve(kLoopPoints + 1);
    SeenThread(scene, state, out).build();
}

}  // namespace placode::sim
