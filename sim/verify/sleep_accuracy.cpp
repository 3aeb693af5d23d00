// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What sleep (sim/solver/sleep.h) costs in accuracy: a needle that is dragged along the planned
// incision of the default field, against the same frames in which every vertex is solved.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

#include "sim/anatomy/operative_field.h"
#include "sim/core/as_index.h"
#include "sim/step/step.h"
#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kNeedleDepth = 3e-4, kNeedleLift = 5e-4;  // of the tip [m]
constexpr double kFramePath = 3e-6;                        // [m], 3 mm/s
constexpr int kWayDown = 100;                              // frames

OperativeFieldSpec dragged_spec(bool sleep) {
    OperativeFieldSpec spec;
    spec.solver.sleep = sleep;
    ToolSpec needle;
    needle.kind = ToolKind::kNeedle;
    needle.pivot_m = Vec3(-0.02, -0.055, 0.06);
    needle.tip_radius_m = 2.5e-4;
    needle.tip_length_m = 2.5e-3;
    needle.shaft_radius_m = 1.5e-3;
    needle.length_m = 0.2;
    needle.hand_n_m = 600;
    spec.tools = {needle};
    return spec;
}

/// A needle in a hand at the field's contour.
class FieldHand {
 public:
    explicit FieldHand(bool sleep)
        : scene_(build_operative_field(dragged_spec(sleep))), state_(*scene_, 1) {
        settle(*scene_, state_, 0.3);
        contour_.resize(scene_->contour_anchors.size());
        deformed_contour(*scene_, state_, contour_);
    }

    /// The next frame; the force on the hand.
    Vec3 frame() {
        Vec3 tip = on_contour(kFramePath * frames_);
        tip.z() += std::max(-kNeedleDepth, kNeedleLift - 2e-5 * frames_);
        const Vec3 along = (tip - scene_->tools[0].pivot_m).normalized();
        ToolInput input;
        input.set_pose({tip, Quat::FromTwoVectors(Vec3::UnitZ(), along)});
        input.engaged = 1;
        const std::clock_t start = std::clock();
        ToolFeedback feedback;
        (void)step(*scene_, state_, {&input, 1}, {&feedback, 1});
        cpu_s_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        ++frames_;
        return feedback.force_n;
    }
    [[nodiscard]] double cost() const {
        return cpu_s_ / (frames_ * scene_->body.spec().solver.frame_s);
    }
    [[nodiscard]] const SoftBody& body() const { return scene_->body; }
    [[nodiscard]] const SoftBodyState& now() const { return state_.body; }

 private:
    [[nodiscard]] Vec3 on_contour(double path) const {
        for (size_t n = 0; n + 1 < contour_.size(); ++n) {
            const Vec3 edge = contour_[n + 1] - contour_[n];
            if (path < edge.norm()) return contour_[n] + path * edge.normalized();
            path -= edge.norm();
        }
        return contour_.back();
    }

    std::shared_ptr<const Scene> scene_;
    State state_;
    std::vector<Vec3> contour_;
    double cpu_s_ = 0;
    int frames_ = 0;
};

double farthest_vertex(const FieldHand& a, const FieldHand& b) {
    double most = 0;
    for (int v = 0; v < a.body().vertex_count(); ++v)
        most = std::max(most, (position(a.now(), v) - position(b.now(), v)).norm());
    return most;
}

}  // namespace

void measure_sleep(AccuracyTable& table) {
    FieldHand truth(false), hand(true);
    double off = 0, size = 0, shape_m = 0;
    const int frames = table.quick() ? 400 : 2000;
    for (int n = 0; n < kWayDown + frames; ++n) {
        const Vec3 expected = truth.frame(), found = hand.frame();
        if (n < kWayDown) continue;
        off += (found - expected).squaredNorm();
        size += expected.squaredNorm();
        shape_m = std::max(shape_m, farthest_vertex(hand, truth));
    }
    const SolverSettings& s = hand.body().spec().solver;
    AccuracyRow row;
    set_text(row.study, "tissue that sleeps");
    set_text(row.setting, "needle dragged over the default field at 3 mm/s, 0.3 mm deep");
    set_text(row.method, "vbd");
    set_text(row.quantity, "force on the hand against all tissue awake (RMS)");
    row.h_s = s.frame_s / s.substeps;
    row.edge_m = 5e-4;
    row.tets = hand.body().tet_count();
    const auto courant = hand.body().courant_numbers();
    row.courant = *std::max_element(courant.begin(), courant.end());
    row.cost = hand.cost();
    row.value = row.error = std::sqrt(off / size);
    row.target = 0.01;
    table.add(row);
    set_text(row.quantity, "largest difference of a vertex, as a share of the depth");
    row.value = row.error = shape_m / kNeedleDepth;
    row.target = 5e-6 / kNeedleDepth;
    table.add(row);
}

}  // namespace placode::sim
