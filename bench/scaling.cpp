// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scaling.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>

#include "bench/timing.h"
#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"

namespace placode::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Bytes that the program holds on the heap, mapped blocks included.
double heap_bytes() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

ScalingRow measure_slab(sim::Method method, const std::array<int, 3>& cells, const Plan& plan) {
    ScalingRow row{"slab", method_name(method)};
    const double before = heap_bytes();
    const auto start = Clock::now();
    const sim::SoftBody body = slab(method, cells);
    sim::SoftBodyState state(body);
    row.build_s = seconds_since(start);
    row.vertices = body.vertex_count();
    row.tets = body.tet_count();
    row.bytes_a_tet = (heap_bytes() - before) / row.tets;
    sim::Workers workers(1);
    // Every size does the same number of tet passes, but at least four substeps a run.
    Plan scaled = plan;
    scaled.substeps = std::max(4, static_cast<int>(plan.substeps * 43200.0 / row.tets));
    row.per_second =
        measure_rates(scaled, [&](int n) { sim::run_substeps(body, state, n, workers); }).median;
    return row;
}

/// The whole scene: body, surface, heat, contact, progress; hands off.
ScalingRow measure_field(const std::string& task, const Plan& plan) {
    const auto spec = curriculum::load_task(task).scene;
    const double before = heap_bytes();
    const auto start = Clock::now();
    const auto scene = sim::build_operative_field(spec);
    sim::State state(*scene, 1);
    ScalingRow row{"field of " + task + ", whole frame",
                   method_name(scene->body.spec().solver.method)};
    row.build_s = seconds_since(start);
    row.vertices = scene->body.vertex_count();
    row.tets = scene->body.tet_count();
    row.bytes_a_tet = (heap_bytes() - before) / row.tets;
    const std::vector<sim::ToolInput> inputs(scene->tools.size());
    std::vector<sim::ToolFeedback> feedback(inputs.size());
    row.per_second = measure_rates(plan, [&](int n) {
                         for (int done = 0; done < n; done += state.substeps)
                             sim::step(*scene, state, inputs, feedback);
                     }).median;
    return row;
}

}  // namespace

std::vector<ScalingRow> measure_scaling(const std::string& task, bool quick,
                                        const std::function<void(const ScalingRow&)>& measured) {
    const Plan plan = quick ? Plan{3, 50} : Plan{9, 200};
    // Slabs of 4, 5, 8, 12 and 20 layers; the last has 640,000 tets.
    std::vector<std::array<int, 3>> sizes{{16, 8, 4}, {36, 20, 5}, {45, 20, 8}, {70, 30, 12}};
    if (!quick) sizes.push_back({107, 50, 20});
    std::vector<ScalingRow> rows;
    const auto add = [&](ScalingRow row) {
        if (measured) measured(row);
        rows.push_back(std::move(row));
    };
    for (const sim::Method method : {sim::Method::kVbd, sim::Method::kXpbd})
        for (const auto& cells : sizes) add(measure_slab(method, cells, plan));
    add(measure_field(task, plan));
    return rows;
}

double exponent(const std::vector<ScalingRow>& rows, const std::string& method) {
    std::vector<double> tets, cost;
    for (const ScalingRow& row : rows) {
        if (row.case_name != "slab" || row.method != method) continue;
        tets.push_back(row.tets);
        cost.push_back(1 / row.per_second);
    }
    return log_slope(tets, cost);
}

}  // namespace placode::bench
