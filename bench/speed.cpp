// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/speed.h"

#include <chrono>

#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"

namespace placode::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// The slab of the design's measurements: 43,200 tets.
constexpr std::array<int, 3> kSlabCells{60, 30, 4};

void fill(SpeedRow& row, const Rates& rates) {
    row.per_second = rates.median;
    row.slowest = rates.slowest;
    row.fastest = rates.fastest;
}

SpeedRow bench_slab(sim::Method method, int threads, const Plan& plan) {
    const sim::SoftBody body = slab(method, kSlabCells);
    sim::SoftBodyState state(body);
    sim::Workers workers(threads);
    SpeedRow row{"slab, solver only",
                 method_name(method),
                 body.vertex_count(),
                 body.tet_count(),
                 threads,
                 8};
    fill(row, measure_rates(plan, [&](int n) { sim::run_substeps(body, state, n, workers); }));
    return row;
}

SpeedRow bench_field_body(const sim::Scene& scene, int threads, const Plan& plan) {
    sim::State state(scene, threads);
    SpeedRow row{"field, solver only",
                 method_name(scene.body.spec().solver.method),
                 scene.body.vertex_count(),
                 scene.body.tet_count(),
                 threads,
                 state.substeps};
    fill(row, measure_rates(plan, [&](int n) {
             sim::run_substeps(scene.body, state.body, n, *state.workers);
         }));
    return row;
}

/// Tips at the planned contour, `depth_m` below the surface, each shaft through its trocar.
std::vector<sim::ToolInput> hands(const sim::Scene& scene, double depth_m) {
    std::vector<sim::ToolInput> inputs(scene.tools.size());
    for (size_t i = 0; i < inputs.size(); ++i) {
        const sim::ToolSpec& tool = scene.tools[i];
        if (tool.kind == sim::ToolKind::kScope || scene.geometry.planned_contour.empty()) continue;
        const sim::Vec3 target = scene.geometry.planned_contour.front() - sim::Vec3(0, 0, depth_m);
        const sim::Vec3 along = (target - tool.pivot_m).normalized();
        inputs[i].set_pose({target, sim::Quat::FromTwoVectors(sim::Vec3::UnitZ(), along)});
        inputs[i].engaged = 1;
    }
    return inputs;
}

SpeedRow bench_frames(const sim::Scene& scene, const std::string& name, double depth_m, int threads,
                      const Plan& plan) {
    sim::State state(scene, threads);
    const auto inputs = hands(scene, depth_m);
    std::vector<sim::ToolFeedback> feedback(inputs.size());
    SpeedRow row{name,
                 method_name(scene.body.spec().solver.method),
                 scene.body.vertex_count(),
                 scene.body.tet_count(),
                 threads,
                 state.substeps};
    fill(row, measure_rates(plan, [&](int n) {
             for (int done = 0; done < n; done += state.substeps)
                 sim::step(scene, state, inputs, feedback);
         }));
    return row;
}

}  // namespace

Speed measure_speed(const std::string& task, const Plan& plan,
                    const std::function<void(const SpeedRow&)>& measured) {
    Speed speed;
    const auto start = Clock::now();
    const auto scene = sim::build_operative_field(curriculum::load_task(task).scene);
    speed.field_build_s = std::chrono::duration<double>(Clock::now() - start).count();
    const auto add = [&](SpeedRow row) {
        if (measured) measured(row);
        speed.rows.push_back(std::move(row));
    };
    for (const int threads : {1, 2}) {
        add(bench_field_body(*scene, threads, plan));
        add(bench_frames(*scene, "field, whole frame, hands off", -0.01, threads, plan));
        add(bench_frames(*scene, "field, whole frame, needle 0.5 mm in", 0.0005, threads, plan));
        add(bench_slab(sim::Method::kVbd, threads, plan));
        add(bench_slab(sim::Method::kXpbd, threads, plan));
    }
    return speed;
}

}  // namespace placode::bench
