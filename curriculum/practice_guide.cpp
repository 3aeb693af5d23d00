// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/practice_guide.h"

namespace placode::curriculum {

namespace {

/// The surface vertices that stand for a step's targets: targets move with the tissue.
std::array<int32_t, 2> find_targets(const sim::Scene& scene, const sim::State& settled,
                                    const sim::PracticeStep& step) {
    std::array<int32_t, 2> out{-1, -1};
    for (int t = 0; t < sim::targets_of(step.kind); ++t) {
        const sim::Vec2 wanted = assessment::practice_target(step, scene.geometry, t == 1);
        double nearest = 1;
        for (size_t v = 0; v < scene.field.depth_m.size(); ++v) {
            if (scene.field.depth_m[v] > 0) continue;
            const double way = (to_vec(settled.body.x[v]).head<2>() - wanted).norm();
            if (way >= nearest) continue;
            nearest = way;
            out[static_cast<size_t>(t)] = static_cast<int32_t>(v);
        }
    }
    return out;
}

}  // namespace

PracticeGuide::PracticeGuide(const std::vector<TaskStep>& steps, const sim::Scene& scene,
                             const sim::State& settled) {
    if (steps.empty()) return;
    std::vector<sim::PracticeStep> goals;
    for (const TaskStep& step : steps) goals.push_back(step.goal);
    tracker_.emplace(goals, scene.tools, scene.geometry);
    for (const sim::PracticeStep& step : goals) {
        const auto vertices = find_targets(scene, settled, step);
        target_vertex_.push_back(vertices);
        auto& marks = mark_m_.emplace_back();
        for (size_t t = 0; t < marks.size(); ++t) {
            marks[t].setZero();
            if (vertices[t] >= 0)
                marks[t] = scene.body.mesh().rest[static_cast<size_t>(vertices[t])];
        }
    }
    goal_.count = tracker_->count();
    look(settled);
}

void PracticeGuide::look(const sim::State& state) noexcept {
    goal_.index = tracker_->index();
    goal_.step = tracker_->step();
    goal_.progress = tracker_->progress();
    goal_.traced = tracker_->traced();
    goal_.targets = 0;
    if (tracker_->done()) return;
    for (const int32_t v : target_vertex_[static_cast<size_t>(goal_.index)]) {
        if (v < 0) continue;
        goal_.target_m[static_cast<size_t>(goal_.targets++)] =
            to_vec(state.body.x[static_cast<size_t>(v)]);
    }
}

void PracticeGuide::look_at_needle(const sim::State& state,
                                   assessment::NeedleSight& needle) const noexcept {
    const sim::Suturing& s = state.suturing;
    if (s.needle.empty() || tracker_->done()) return;
    needle.taken = s.taken;
    needle.entered = s.entered;
    needle.left = s.left;
    needle.through = s.through;
    for (int k = 0; k < 3; ++k) {
        needle.entry_m[k] = static_cast<double>(s.entry_m[static_cast<size_t>(k)]);
        needle.exit_m[k] = static_cast<double>(s.exit_m[static_cast<size_t>(k)]);
    }
    needle.mark_m = mark_m_[static_cast<size_t>(goal_.index)];
}

std::span<const sim::Event> PracticeGuide::see(const sim::State& state,
                                               std::span<const sim::ToolInput> inputs,
                                               const sim::Sample& sample) noexcept {
    if (!tracker_) return {};
    look(state);
    assessment::PracticeSight sight{
        sample, {goal_.target_m.data(), static_cast<size_t>(goal_.targets)}, {}, {}, {}, {}};
    for (size_t i = 0; i < inputs.size(); ++i) {
        sight.holds[i] = state.grasps[i].count > 0;
        sight.pull_n[i] = state.grasps[i].force_n.norm();
        sight.engaged[i] = inputs[i].engaged != 0;
    }
    look_at_needle(state, sight.needle);
    const std::span<const sim::Event> events = tracker_->see(sight);
    look(state);
    return events;
}

std::span<const sim::Event> PracticeGuide::end(double time_s) noexcept {
    return tracker_ ? tracker_->end(time_s) : std::span<const sim::Event>{};
}

}  // namespace placode::curriculum
