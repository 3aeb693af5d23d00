// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt and its recording as reports get them.

#include <cmath>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "db/records.h"
#include "sim/step/recording.h"

namespace placode::test {

inline std::vector<sim::Vec3> ring_of(double a, double b) {
    std::vector<sim::Vec3> line;
    for (int i = 0; i < 90; ++i)
        line.emplace_back(a * std::cos(i * 4 * M_PI / 180), b * std::sin(i * 4 * M_PI / 180),
                          0.001);
    return line;
}

inline sim::Recording recording() {
    sim::Recording result;
    result.header.tools.resize(2);
    result.header.tools[1].kind = sim::ToolKind::kScope;
    result.header.geometry.skin_edge = ring_of(0.012, 0.008);
    result.header.geometry.placode_edge = ring_of(0.008, 0.003);
    result.header.geometry.planned_contour = ring_of(0.0095, 0.0045);
    for (int i = 0; i < 360; ++i) {
        sim::Sample sample;
        sample.time_s = i * 0.01;
        sample.tools[0].tip_m = {static_cast<float>(0.0095 * std::cos(i * M_PI / 180)),
                                 static_cast<float>(0.0045 * std::sin(i * M_PI / 180)), 0.001F};
        result.samples.push_back(sample);
        if (i > 180) continue;
        sim::Event event;
        event.kind = sim::EventKind::kVaporised;
        event.value = 3e-11F;
        event.rest_position_m = sample.tools[0].tip_m;
        result.events.push_back(event);
    }
    result.end.final_hash = 0xabcdef;
    return result;
}

inline db::AttemptDetail attempt() {
    db::AttemptDetail detail;
    detail.record.id = 12;
    detail.record.user_name = "Zofia \u0141ucka";
    detail.record.task_id = "diathermy_ring";
    detail.record.points = 61.5;
    detail.record.demonstration = true;
    detail.record.device = "script:novice";
    detail.score.points = 61.5;
    detail.score.verdict = assessment::Verdict::kFailed;
    detail.score.reasons = {
        {"placode_touched", "The needle touched the placode 2 times, first at 4 o'clock.", 12, 3.5,
         false},
        {"placode_burned", "The placode was burned.", 26.5, 7.25, true}};
    for (const auto& definition : assessment::metric_definitions()) {
        detail.metrics.values.push_back({std::string(definition.id), 1.0 / 3.0});
    }
    return detail;
}

/// A recording of a shipped task; `first_done` of its steps were done.
inline sim::Recording recording_of(const char* task_id, int first_done = 0) {
    const curriculum::Task task = curriculum::load_task(task_id);
    sim::Recording result = recording();
    result.header.task_id = task_id;
    result.header.task_json = task.json;
    result.header.tools = task.scene.tools;
    std::erase_if(result.events,
                  [](const sim::Event& event) { return event.kind == sim::EventKind::kVaporised; });
    const auto add = [&](sim::EventKind kind, double value, double time_s) {
        sim::Event event;
        event.kind = kind;
        event.value = static_cast<float>(value);
        event.time_s = time_s;
        result.events.push_back(event);
    };
    add(sim::EventKind::kPhase, static_cast<double>(sim::Phase::kIncise), 0);
    add(sim::EventKind::kPracticeSteps, static_cast<double>(task.steps.size()), 0);
    for (int i = 0; i < first_done; ++i) add(sim::EventKind::kStepDone, i, i);
    result.end.duration_s = 10;
    return result;
}

}  // namespace placode::test
