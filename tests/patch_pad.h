// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A flat pad of skin with a patch on it and a grasper over it, for the tests of the patch.

#include <memory>
#include <vector>

#include "sim/core/tool_shape.h"
#include "sim/step/step.h"
#include "sim/world/scene.h"
#include "tests/box_scene.h"
#include "tests/flat_pad.h"

namespace placode::sim::test {

inline constexpr double kGrasperTip = 0.005;

/// A flat pad of skin with a grasper and, where wanted, a patch of 8 x 6 mm in its middle.
inline OperativeFieldSpec patch_pad(bool patch = true) {
    OperativeFieldSpec spec = flat_pad();
    spec.domain_x_m = 0.020;
    spec.edge_ring_m = spec.edge_placode_m = 0.0009;
    spec.edge_outer_m = 0.0012;
    spec.skin_edge_a_m = spec.skin_edge_b_m = 0.0032;
    spec.placode_a_m = spec.placode_b_m = 0.0011;
    spec.contour_offset_m = 0.0008;
    ToolSpec grasper;
    grasper.kind = ToolKind::kGrasper;
    grasper.tip_radius_m = 0.0005;
    grasper.tip_length_m = kGrasperTip;
    grasper.jaw_touch_m = 0.0012;
    spec.tools = {grasper};
    if (patch) {
        spec.patch.emplace();
        spec.patch->length_m = 0.008;
        spec.patch->width_m = 0.006;
    }
    return spec;
}

/// An attempt on it.
struct Lying {
    explicit Lying(const OperativeFieldSpec& spec, int threads = 1)
        : scene(build_operative_field(spec)), state(*scene, threads), input(away()) {}

    static ToolInput away() {
        ToolInput out = upright(Vec3(0.006, 0.006, 0.01));
        out.jaw_rad = 0.6F;
        return out;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame(*scene, state, input, feedback);
    }
    /// The tip to `p` and the jaws to an opening, linearly.
    void go(const Vec3& p, double jaw, int count) {
        const Vec3 from = input.pose().p;
        const double jaw0 = static_cast<double>(input.jaw_rad);
        for (int i = 1; i <= count; ++i) {
            const double s = static_cast<double>(i) / count;
            input = upright(from + s * (p - from));
            input.jaw_rad = static_cast<float>(jaw0 + s * (jaw - jaw0));
            frames(1);
        }
    }
    [[nodiscard]] const Patch& patch() const { return *scene->patch; }
    [[nodiscard]] Vec3 at(int number) const {
        return position(state.body, patch().first_vertex + number);
    }
    /// Height over the tissue just below: the highest of its faces there [m].
    [[nodiscard]] double gap(int number) const {
        const Vec3 p = at(number);
        double best = 1;
        for (const SurfaceTriangle& t : state.surface.triangles()) {
            Triangle x;
            for (size_t k = 0; k < 3; ++k) x[k] = position(state.body, t.vertex[k]);
            const Vec3 w = closest_on_triangle(p, x);
            const Vec3 offset = p - w.x() * x[0] - w.y() * x[1] - w.z() * x[2];
            if (offset.norm() >= std::abs(best)) continue;
            best =
                offset.dot((x[1] - x[0]).cross(x[2] - x[0])) < 0 ? -offset.norm() : offset.norm();
        }
        return best;
    }
    /// Deepest overlap of tissue and patch, with its thickness [m].
    [[nodiscard]] double overlap() const {
        double most = -1;
        for (int i = 0; i < patch().vertex_count; ++i)
            most = std::max(most, patch().thickness_m / 2 - gap(i));
        return most;
    }
    [[nodiscard]] double lowest() const {
        double z = 1;
        for (int i = 0; i < patch().vertex_count; ++i) z = std::min(z, at(i).z());
        return z;
    }
    [[nodiscard]] double highest() const {
        double z = -1;
        for (int i = 0; i < patch().vertex_count; ++i) z = std::max(z, at(i).z());
        return z;
    }
    /// Of mass, and its velocity.
    [[nodiscard]] Vec3 middle() const {
        return mean([this](int i) { return at(i); });
    }
    [[nodiscard]] Vec3 speed() const {
        return mean([this](int i) {
            return to_vec(state.body.v[static_cast<size_t>(patch().first_vertex + i)]);
        });
    }
    template <class Of>
    [[nodiscard]] Vec3 mean(Of&& of) const {
        Vec3 sum = Vec3::Zero();
        double mass = 0;
        for (int i = 0; i < patch().vertex_count; ++i) {
            const auto v = static_cast<size_t>(patch().first_vertex + i);
            const auto m = static_cast<double>(scene->body.mass_kg()[v]);
            sum += m * of(i);
            mass += m;
        }
        return sum / mass;
    }
    [[nodiscard]] std::vector<Vec3> places() const {
        std::vector<Vec3> out;
        for (int i = 0; i < patch().vertex_count; ++i) out.push_back(at(i));
        return out;
    }
    [[nodiscard]] double farthest(const std::vector<Vec3>& from) const {
        double most = 0;
        for (int i = 0; i < patch().vertex_count; ++i)
            most = std::max(most, (at(i) - from[static_cast<size_t>(i)]).norm());
        return most;
    }

    std::shared_ptr<const Scene> scene;
    State state;
    ToolInput input;
    ToolFeedback feedback;
};

}  // namespace placode::sim::test
