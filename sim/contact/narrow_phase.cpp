// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/narrow_phase.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/patch_contact.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kOfAJob = 24;  // candidates

FloatLanes in_floats(const Vec3& a) noexcept {
    const Vec3f f = a.cast<float>();
    return FloatLanes{f.x(), f.y(), f.z(), 0};
}

/// True when a triangle that was `start[3]` away at the frame's start cannot have come within
/// `margin`: a distance changes by no more than the way, here of the centre in T, so that most
/// candidates end here, with one root.
bool surely_apart(const std::array<float, 4>& start, const FloatPose& to_tool,
                  const std::array<FloatLanes, 3>& x, float margin) noexcept {
    constexpr float kRounding = 1e-6F;  // of places within a few tenths of a metre, as floats [m]
    const FloatLanes centre = (x[0] + x[1] + x[2]) * every_lane(1.0F / 3);
    const FloatLanes offset = to_tool * centre - lanes_of(start);
    const float left = start[3] - std::sqrt(dot3(offset, offset)) - margin - kRounding;
    if (!(left > 0)) return false;
    float size2 = 0;
    for (const FloatLanes& corner : x)
        size2 = std::max(size2, dot3(corner - centre, corner - centre));
    return left * left > size2;
}

}  // namespace

FloatPose::FloatPose(const Pose& pose) noexcept : origin(in_floats(pose.p)) {
    const Mat3 r = pose.q.toRotationMatrix();
    for (int k = 0; k < 3; ++k) column[static_cast<size_t>(k)] = in_floats(r.col(k));
}

NarrowPhase::NarrowPhase(const Scene& scene, State& state) noexcept
    : scene_(scene), state_(state), set_(state.scratch->contacts) {
    for (size_t t = 0; t < scene.tools.size(); ++t) {
        to_tool_[t] = state.tools[t].proxy.inverse();
        roughly_[t] = FloatPose(to_tool_[t]);
    }
}

int NarrowPhase::jobs() const noexcept { return (set_.candidate_count + kOfAJob - 1) / kOfAJob; }

void NarrowPhase::job(int number) noexcept {
    const int last = std::min(set_.candidate_count, kOfAJob * (number + 1));
    for (int i = kOfAJob * number; i < last; ++i) set_.nearest[i] = nearest(i);
}

/// part -1 where nothing is near enough to count.
TriangleDistance NarrowPhase::nearest(int i) const noexcept {
    const SurfaceTriangle& tri = touched_triangle(scene_, state_, set_.candidates[i] / 4);
    const int t = set_.candidates[i] % 4;
    // What the jaws hold does not push them.
    if (state_.held_by[tri.vertex[0]] == t || state_.held_by[tri.vertex[1]] == t ||
        state_.held_by[tri.vertex[2]] == t) {
        return {};
    }
    const double margin =
        scene_.contact.margin_m + (tri.tet < 0 ? scene_.patch->thickness_m / 2 : 0);
    std::array<FloatLanes, 3> x;
    for (size_t k = 0; k < 3; ++k) x[k] = lanes_of(state_.body.x_start[tri.vertex[k]]);
    if (surely_apart(set_.start[i], roughly_[t], x, static_cast<float>(margin))) return {};
    Triangle x_T;
    for (int k = 0; k < 3; ++k) x_T[k] = to_tool_[t] * to_vec(state_.body.x_start[tri.vertex[k]]);
    const TriangleDistance d = nearest_on_triangle(set_.shapes[t], x_T, margin);
    return d.part == 0 && blades_open(scene_, state_, t) ? TriangleDistance{} : d;
}

}  // namespace placode::sim
