// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/suture_stage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "curriculum/scene_changes.h"
#include "environment/environment.h"
#include "environment/expert.h"
#include "sim/anatomy/operative_field.h"

namespace placode::bench {
namespace {

using sim::EventKind;

constexpr const char* kTask = "suture_bite";

curriculum::Task task_with(const char* changes) {
    curriculum::Task task = curriculum::with_scene_changes(curriculum::load_task(kTask), changes);
    task.scene.seed = experts_bite().seed;
    return task;
}

}  // namespace

double Bite::time_of(sim::EventKind kind) const {
    for (const sim::Event& event : events)
        if (event.kind == kind) return event.time_s;
    throw std::runtime_error(std::string("the scripted expert's bite has no event: ") +
                             std::string(sim::event_name(kind)));
}

const Bite& experts_bite() {
    static const Bite bite = [] {
        environment::EnvironmentOptions options;
        options.units = environment::ActionUnits::kAbsolute;
        options.record = true;
        options.judge_every_s = 0;
        environment::Environment world(std::make_shared<environment::FieldCache>(), kTask, options);
        world.reset(1);
        environment::Expert expert(world, "expert", 1);
        std::vector<double> action(world.tools() * environment::kActionSize);
        while (!world.ended()) {
            const bool done = expert.act(world, 10, action);
            (void)world.step(action, 10, done);
        }
        const sim::Recording& recording = world.recording();
        return Bite{recording.header.seed, recording.inputs, recording.events};
    }();
    return bite;
}

SutureStage::SutureStage(const char* changes)
    : task_(task_with(changes)),
      scene_(sim::build_operative_field(task_.scene)),
      state_(std::make_unique<sim::State>(*scene_, 1)),
      inputs_(scene_->tools.size()),
      feedback_(inputs_.size()) {
    sim::settle(*scene_, *state_, task_.settle_s);
    for (size_t i = 0; i < inputs_.size(); ++i)
        if (scene_->tools[i].kind == sim::ToolKind::kNeedleDriver) driver_ = i;
    at_rest_.assign(state_->body.x.begin(), state_->body.x.end());
}

void SutureStage::bite_until(double time_s) {
    for (const sim::Input& input : experts_bite().inputs) {
        if (state_->time_s >= time_s) return;
        std::copy_n(input.tools, inputs_.size(), inputs_.begin());
        frame();
    }
    throw std::runtime_error("the scripted expert's bite ended too early");
}

void SutureStage::frame() {
    const sim::StepReport report = sim::step(*scene_, *state_, inputs_, feedback_);
    const bool not_finite = (report.flags & sim::kNotFinite) != 0;
    if (not_finite || !needle().needle.p.allFinite()) finite_ = false;
    for (int i = 0; i < state_->event_count; ++i) {
        const EventKind kind = state_->events[static_cast<size_t>(i)].kind;
        torn_ += kind == EventKind::kTorn ? 1 : 0;
        cuts_ += kind == EventKind::kThreadCut || kind == EventKind::kThreadToreOut ? 1 : 0;
        dropped_ += kind == EventKind::kNeedleReleased ? 1 : 0;
    }
    if (state_->frame % 10 == 0) farthest_m_ = std::max(farthest_m_, farthest());
}

void SutureStage::frames(double seconds) {
    const auto count = std::llround(seconds / scene_->body.spec().solver.frame_s);
    for (int64_t n = 0; n < count; ++n) frame();
}

}  // namespace placode::bench
