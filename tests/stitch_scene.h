// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A block of skin in an operative scene, a needle driver with a needle of 13 mm in its jaws, and
// perhaps a second instrument: all of it through step().

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/box_scene.h"
#include "tests/suture_block.h"

namespace placode::sim::test {

struct StitchOptions {
    double puncture_n = 0.06;
    double thread_m = 0;
    double youngs_modulus_pa = 200e3;  ///< Fits the puncture: docs/suture.md.
    int threads = 1;
    Tissue tissue = Tissue::kSkin;  ///< Of the block.
    bool lies = false;              ///< The needle, on its side over the block.
    std::optional<ToolSpec> other;  ///< Second instrument.
    Vec3 gravity = Vec3::Zero();
};

inline ToolSpec driver_spec() {
    ToolSpec driver;
    driver.kind = ToolKind::kNeedleDriver;
    driver.tip_radius_m = 0.0005;
    driver.tip_length_m = 0.005;
    driver.shaft_radius_m = 0.0015;
    driver.jaw_touch_m = 0.001;
    driver.hand_n_m = 600;
    return driver;
}
inline ToolSpec second_spec(ToolKind kind) {
    ToolSpec spec;
    spec.kind = kind;
    spec.hand = Hand::kLeft;
    spec.tip_radius_m = 0.0005;
    spec.tip_length_m = 0.010;
    spec.hand_n_m = 600;
    spec.pivot_m = Vec3(0, 0, 0.080);
    return spec;
}

/// Where the jaws hold the needle, of the arc: so far back that they stay out of the skin.
inline constexpr double kHeldShare = 0.8;

/// A driver at the needle: its shaft comes from -y.
inline Pose driver_at(const Needle& needle, const Pose& X_WN) {
    const ArcPoint held = needle.at(kHeldShare * needle.arc_m());
    Mat3 r;
    r.col(0) = X_WN.q * held.back;
    r.col(2) = Vec3::UnitY();
    r.col(1) = r.col(2).cross(r.col(0));
    const Quat q(r);
    return {X_WN * held.place_m + q * Vec3(0, 0, driver_spec().tip_length_m / 3), q};
}

/// Input of a second tool whose tip is at `p`, its shaft aslant from +x and above: clear of the
/// driver.
inline ToolInput leaning(const Vec3& p) {
    ToolInput input;
    Mat3 r;
    r.col(2) = Vec3(-1, 0, -1).normalized();
    r.col(1) = Vec3::UnitY();
    r.col(0) = r.col(1).cross(r.col(2));
    input.set_pose({p, Quat(r)});
    input.engaged = 1;
    return input;
}

inline Scene stitch_scene(const StitchOptions& options, const Pose& X_WN) {
    BoxOptions box;
    box.size_m = Vec3(0.010, 0.004, 0.003);
    box.cells = {25, 10, 8};
    box.tissue = options.tissue;
    box.material.youngs_modulus_pa = options.youngs_modulus_pa;
    box.material.fail_stretch = box.material.injury_stretch = 100;
    box.heat = false;
    box.gravity = options.gravity;
    box.tool = driver_spec();
    Scene scene = box_scene(box);
    if (options.other) scene.tools.push_back(*options.other);
    SutureSpec spec;
    spec.needle.arc_m = 13e-3;
    spec.jaws.pull_n_m = 2000;
    spec.thread.length_m = options.thread_m;
    spec.gravity_m_s2 = options.gravity;
    spec.floor_m = -0.003;
    set_strength(spec, options.puncture_n);
    scene.suture.emplace(spec);
    const Needle& needle = scene.suture->needle();
    scene.needle_start.in_jaws = !options.lies;
    scene.needle_start.held_arc_m = kHeldShare * needle.arc_m();
    scene.needle_start.X_TN = driver_at(needle, X_WN).inverse() * X_WN;
    // Flat, with its centre of mass over the middle of the block.
    scene.needle_start.X_WN = {Vec3(0, 0, 0.004) - needle.centre_m(), Quat::Identity()};
    return scene;
}

class Stitch {
 public:
    explicit Stitch(const StitchOptions& options = {})
        : start(before_bite(Needle({13e-3}), 1.4e-3, 0.05e-3)),
          scene(stitch_scene(options, start)),
          state(scene, options.threads),
          inputs(scene.tools.size()),
          feedback(scene.tools.size()) {
        driver(at(0));
    }

    /// Where the driver is when it has driven the needle round by `path_m`.
    [[nodiscard]] Pose at(double path_m) const {
        const double angle = path_m / scene.suture->needle().radius_m();
        const Pose X_WN{start.p, start.q * turned(-angle, Vec3::UnitZ())};
        return X_WN * scene.needle_start.X_TN.inverse();
    }
    void driver(const Pose& X_WT, double jaw_rad = 0) {
        inputs[0].set_pose(X_WT);
        inputs[0].jaw_rad = static_cast<float>(jaw_rad);
        inputs[0].engaged = 1;
    }
    StepReport frame() {
        const StepReport report = step(scene, state, inputs, feedback);
        for (int e = 0; e < state.event_count; ++e) events.push_back(state.events[as_index(e)]);
        return report;
    }
    void rest(int frames) {
        for (int i = 0; i < frames; ++i) frame();
    }
    /// On from where it has been driven to; `look()` after every frame.
    template <class Look>
    void drive(double path_m, double speed_m_s, Look&& look) {
        const int frames = std::max(1, static_cast<int>(std::abs(path_m) / (speed_m_s * 1e-3)));
        const double from = driven_m;
        for (int i = 1; i <= frames; ++i) {
            driven_m = from + path_m * i / frames;
            driver(at(driven_m), jaw_rad);
            frame();
            look();
        }
    }
    void drive(double path_m, double speed_m_s = 10e-3) {
        drive(path_m, speed_m_s, [] {});
    }
    /// Moves the jaws; opening takes 50 frames.
    void jaws(double to_rad) {
        const double from = jaw_rad;
        for (int i = 1; i <= 50; ++i) {
            jaw_rad = from + (to_rad - from) * i / 50;
            inputs[0].jaw_rad = static_cast<float>(jaw_rad);
            frame();
        }
    }
    [[nodiscard]] SutureState& needle() { return state.suturing.needle[0]; }
    [[nodiscard]] Vec3 middle_m() { return needle().needle * scene.suture->needle().centre_m(); }
    [[nodiscard]] const Event* find(EventKind kind) const {
        const auto found = std::find_if(events.begin(), events.end(),
                                        [&](const Event& e) { return e.kind == kind; });
        return found == events.end() ? nullptr : &*found;
    }
    [[nodiscard]] Vec3 carried_n() const {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : scene.body.spec().fixed)
            sum += elastic_force(scene.body, state.body, v);
        return sum;
    }
    /// Vertices that instruments touch and that needle or thread hang on.
    [[nodiscard]] int shared_vertices() {
        int count = 0;
        for (int i = 0; i < needle().passage_count; ++i)
            for (const int32_t v :
                 corners(scene.body, state.body, needle().passages[as_index(i)].at.tet))
                count += state.body.contact_vertex[as_index(v)] != 0 ? 1 : 0;
        return count;
    }
    [[nodiscard]] bool finite() {
        const auto sound = [](const Float4& f) {
            return std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z);
        };
        return needle().needle.p.allFinite() && needle().needle.q.coeffs().allFinite() &&
               std::all_of(state.body.x.begin(), state.body.x.end(), sound) &&
               std::all_of(state.body.v.begin(), state.body.v.end(), sound);
    }

    Pose start;  ///< Of the needle.
    Scene scene;
    State state;
    std::vector<ToolInput> inputs;
    std::vector<ToolFeedback> feedback;
    std::vector<Event> events;
    double driven_m = 0, jaw_rad = 0;
};

}  // namespace placode::sim::test
