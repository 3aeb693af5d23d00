// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/environment_speed.h"

#include <malloc.h>

#include <chrono>
#include <memory>

#include "assessment/statistics.h"
#include "bench/timing.h"
#include "environment/expert.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"

namespace placode::bench {
namespace {

using environment::Environment;
using Clock = std::chrono::steady_clock;

constexpr double kBeginS = 4, kForS = 2;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double heap_mib() {
    const struct mallinfo2 now = ::mallinfo2();
    return static_cast<double>(now.uordblks + now.hblkhd) / (1024 * 1024);
}

environment::EnvironmentOptions options_of(const EnvironmentCase& what) {
    environment::EnvironmentOptions options;
    options.units = environment::ActionUnits::kAbsolute;
    options.fields = 1;
    options.scene_changes_json = what.scene_changes_json;
    return options;
}

/// The expert at work from kBeginS on: the moment before, and what it did.
struct ExpertWork {
    environment::SavedMoment begin;
    std::vector<std::vector<double>> actions;
    std::vector<sim::Input> inputs;
};

ExpertWork let_work(Environment& environment) {
    ExpertWork work;
    environment::Expert expert(environment, "expert", 1);
    environment.reset(1);
    std::vector<double> action(environment.tools() * environment::kActionSize);
    const auto steps_to = [](double s) { return static_cast<int>(s * 1000 / kFramesAStep); };
    for (int i = 0; i < steps_to(kBeginS + kForS) && !environment.ended(); ++i) {
        if (i == steps_to(kBeginS)) environment.save(work.begin);
        (void)expert.act(environment, kFramesAStep, action);
        (void)environment.step(action, kFramesAStep);
        if (i >= steps_to(kBeginS)) work.actions.push_back(action);
    }
    const std::vector<sim::Input>& inputs = environment.inputs();
    work.inputs.assign(inputs.begin() + steps_to(kBeginS) * kFramesAStep, inputs.end());
    return work;
}

double time_physics(Environment& environment, const ExpertWork& work) {
    const sim::Scene& scene = *environment.field().scene;
    sim::State state(scene, 1);
    sim::load_state(scene, state, work.begin.state);
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback;
    const size_t tools = scene.tools.size();
    const auto start = Clock::now();
    for (const sim::Input& input : work.inputs)
        (void)sim::step(scene, state, {input.tools, tools}, {feedback.data(), tools});
    return since(start);
}

double time_environment(Environment& environment, const ExpertWork& work) {
    std::vector<double> seen(environment.observation_names().size());
    environment.restore(work.begin);
    const auto start = Clock::now();
    for (const std::vector<double>& action : work.actions) {
        (void)environment.step(action, kFramesAStep);
        environment.observe(seen);
    }
    return since(start);
}

}  // namespace

EnvironmentRow measure_environment(const EnvironmentCase& what, int runs) {
    EnvironmentRow row;
    row.what = what;
    const auto fields = std::make_shared<environment::FieldCache>();
    auto options = options_of(what);
    options.record = true;
    const double before_mib = heap_mib();
    const auto start = Clock::now();
    Environment environment(fields, what.task, options);
    environment.reset(1);
    row.build_s = since(start);
    const double with_one_mib = heap_mib();
    {
        Environment second(fields, what.task, options);
        second.reset(1);
        row.environment_mib = heap_mib() - with_one_mib;
        row.field_mib = with_one_mib - before_mib - row.environment_mib;
    }
    row.tets = environment.field().scene->body.tet_count();
    row.substeps = environment.state().substeps;
    const ExpertWork work = let_work(environment);
    std::vector<double> physics, whole, reset, save;
    environment::SavedMoment moment;
    environment.restore(work.begin);
    for (int i = 0; i < runs; ++i) {
        physics.push_back(time_physics(environment, work));
        whole.push_back(time_environment(environment, work));
        for (int k = 0; k < 5; ++k) {
            const auto saving = Clock::now();
            environment.save(moment);
            save.push_back(since(saving));
            const auto resetting = Clock::now();
            environment.restore(work.begin);
            reset.push_back(since(resetting));
        }
    }
    const auto frames = static_cast<double>(work.inputs.size());
    row.physics_hz = frames / assessment::median_of(physics);
    row.environment_hz = frames / assessment::median_of(whole);
    row.reset_ms = 1e3 * assessment::median_of(reset);
    row.save_ms = 1e3 * assessment::median_of(save);
    row.moment_mib = static_cast<double>(work.begin.state.size()) / (1024 * 1024);
    return row;
}

SharingRow measure_sharing(const EnvironmentCase& what) {
    SharingRow row;
    const auto options = options_of(what);
    const auto taken_by = [&](bool shared) {
        const double before_mib = heap_mib();
        std::shared_ptr<environment::FieldCache> fields;
        std::vector<std::unique_ptr<Environment>> all;
        for (int i = 0; i < row.environments; ++i) {
            if (!shared || !fields) fields = std::make_shared<environment::FieldCache>();
            all.push_back(std::make_unique<Environment>(fields, what.task, options));
            all.back()->reset(1);
        }
        return heap_mib() - before_mib;
    };
    row.shared_mib = taken_by(true);
    row.apart_mib = taken_by(false);
    return row;
}

}  // namespace placode::bench
