// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where hard cases for needle and thread begin: the field of a task that has them, and the scripted
// expert's bite, which is done frame by frame until the hand of the case takes over.

#include <memory>
#include <vector>

#include "bench/tissue_watch.h"
#include "curriculum/task.h"
#include "sim/core/geometry.h"
#include "sim/step/step.h"

namespace placode::bench {

/// What the scripted expert's hand asks, frame by frame, and what happened.
struct Bite {
    uint64_t seed = 1;  ///< Of the field.
    std::vector<sim::Input> inputs;
    std::vector<sim::Event> events;
    /// Of the first such event [s]. @throws std::runtime_error when there is none.
    [[nodiscard]] double time_of(sim::EventKind kind) const;
};
/// The same every time; made when first asked for.
[[nodiscard]] const Bite& experts_bite();

/// The field with its needle, in the hands of a case.
class SutureStage {
 public:
    /// @param changes of the scene, as JSON (curriculum/scene_changes.h).
    explicit SutureStage(const char* changes = "{}");

    /// Does what the expert did until `time_s`. @throws std::runtime_error when that ended before.
    void bite_until(double time_s);
    /// Changes what the driver's hand asks.
    void hand(const sim::Pose& X_WT, double jaw_rad, bool engaged = true) {
        inputs_[driver_].set_pose(X_WT);
        inputs_[driver_].jaw_rad = static_cast<float>(jaw_rad);
        inputs_[driver_].engaged = engaged ? 1 : 0;
    }
    void frame();
    void frames(double seconds);

    [[nodiscard]] double farthest() const { return farthest_tissue(*scene_, *state_, at_rest_); }
    [[nodiscard]] double fastest() const { return fastest_vertex(*state_); }
    [[nodiscard]] const sim::SutureState& needle() const { return state_->suturing.needle[0]; }
    [[nodiscard]] const sim::Suturing& suturing() const { return state_->suturing; }
    [[nodiscard]] sim::Pose hand_pose() const { return inputs_[driver_].pose(); }
    [[nodiscard]] bool finite() const { return finite_; }
    [[nodiscard]] double farthest_ever() const { return farthest_m_; }
    [[nodiscard]] int cuts() const { return cuts_; }
    [[nodiscard]] int torn() const { return torn_; }
    [[nodiscard]] int dropped() const { return dropped_; }

 private:
    curriculum::Task task_;
    std::shared_ptr<const sim::Scene> scene_;
    std::unique_ptr<sim::State> state_;
    std::vector<sim::ToolInput> inputs_;
    std::vector<sim::ToolFeedback> feedback_;
    std::vector<sim::Float4> at_rest_;
    size_t driver_ = 0;
    bool finite_ = true;
    double farthest_m_ = 0;
    int cuts_ = 0, torn_ = 0, dropped_ = 0;
};

}  // namespace placode::bench
