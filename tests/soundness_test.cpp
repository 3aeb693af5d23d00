// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording must hold to be scored: what is bad can neither be turned round nor left out.
#include "assessment/soundness.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

namespace placode::assessment {
namespace THIS_TEST {

using sim::Event;
using sim::EventKind;
using testing::HasSubstr;

/// A tenth of a second in which nothing happens.
sim::Recording sound() {
    sim::Recording r;
    r.header.frame_s = 1e-3;
    r.header.sample_s = 1e-2;
    r.header.tools.resize(1);
    for (auto* line : {&r.header.geometry.planned_contour, &r.header.geometry.placode_edge,
                       &r.header.geometry.skin_edge})
        *line = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}};
    r.header.geometry.placode_volume_m3 = 1e-9;
    for (int frame = 0; frame < 100; ++frame) {
        sim::Input input;
        input.frame = frame;
        input.substeps = 4;
        input.tool_count = 1;
        r.inputs.push_back(input);
        if (frame % 10 != 9) continue;
        sim::Sample sample;
        sample.time_s = 1e-3 * (frame + 1);
        sample.placode_peak_c = 37;
        r.samples.push_back(sample);
    }
    r.end.reason = sim::EndReason::kFinished;
    r.end.duration_s = 0.1;
    return r;
}

Event event(EventKind kind, float value, float value2 = 0, int element = -1) {
    Event e;
    e.time_s = 0.05;
    e.kind = kind;
    e.value = value;
    e.value2 = value2;
    e.element = element;
    return e;
}

std::string problem(const sim::Recording& r) {
    const auto found = unsound(r);
    return found ? found->english() : std::string();
}

TEST(Soundness, NothingHarmfulIsLessThanNone) {
    ASSERT_EQ(problem(sound()), "");
    for (const EventKind kind :
         {EventKind::kTorn, EventKind::kPlacodeContact, EventKind::kOverForce, EventKind::kBuried,
          EventKind::kWatertight, EventKind::kThreadDrawn, EventKind::kStretchSum,
          EventKind::kPatchFold, EventKind::kSlitPressed, EventKind::kNeedleHandedOver,
          EventKind::kNeedleSwung, EventKind::kBiteEntry, EventKind::kBiteExit,
          EventKind::kIrrigated, EventKind::kUndermined}) {
        auto r = sound();
        r.events = {event(kind, 1e-9F, 1e-3F)};
        EXPECT_EQ(problem(r), "") << event_name(kind);
        r.events = {event(kind, -1e-9F, 1e-3F)};
        EXPECT_THAT(problem(r), HasSubstr("expected 0 or more")) << event_name(kind);
        EXPECT_THAT(problem(r), HasSubstr(std::string(event_name(kind))));
        r.events = {event(kind, 1e-9F, -1e-3F)};
        EXPECT_THAT(problem(r), HasSubstr("expected 0 or more")) << event_name(kind);
    }
}

/// What is lost may be the event that costs the points.
TEST(Soundness, NothingIsLost) {
    for (const int64_t lost : {1, 49, 51, -1}) {
        auto r = sound();
        r.end.dropped = lost;
        EXPECT_EQ(problem(r), std::to_string(lost) + " entries are lost, of 100 inputs");
    }
}

TEST(Soundness, AListIsAsLongAsItsHeadTells) {
    for (const EventKind kind : {EventKind::kSlitGap, EventKind::kSlitOpened, EventKind::kPatchEdge,
                                 EventKind::kRingGap, EventKind::kThermalSpread}) {
        auto whole = sound();
        whole.events = {event(kind, 2, 1e-3F), event(kind, 1e-3F, 0, 0), event(kind, 5e-3F, 0, 1)};
        EXPECT_EQ(problem(whole), "") << event_name(kind);
        auto shorter = whole;
        shorter.events.pop_back();
        EXPECT_THAT(problem(shorter), HasSubstr("1 entries")) << event_name(kind);
        auto headless = whole;
        headless.events.erase(headless.events.begin());
        EXPECT_THAT(problem(headless), HasSubstr("2 entries")) << event_name(kind);
        auto twice = whole;
        twice.events.push_back(event(kind, 2, 1e-3F));
        EXPECT_NE(problem(twice), "") << event_name(kind);
    }
}

/// Each alone, so that no other rule stands in for the one that is gone.
TEST(Soundness, EveryNumberThatScoringTakesIsInItsRange) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr float kFloatNan = std::numeric_limits<float>::quiet_NaN();
    struct Change {
        const char* said;
        std::function<void(sim::Recording&)> make;
    };
    const Change changes[]{
        {"frame_s is", [](auto& r) { r.header.frame_s = 0; }},
        {"frame_s is", [](auto& r) { r.header.frame_s = kNan; }},
        {"sample_s is", [](auto& r) { r.header.sample_s = -1e-2; }},
        {"sample_s is", [](auto& r) { r.header.sample_s = 1e300; }},
        {"it has 0 tools", [](auto& r) { r.header.tools.clear(); }},
        {"duration_s is", [](auto& r) { r.end.duration_s = 1e300; }},
        {"duration_s is", [](auto& r) { r.end.duration_s = -0.1; }},
        {"its inputs last", [](auto& r) { r.end.duration_s = 0.2; }},
        {"planned_contour_m has 0 points", [](auto& r) { r.header.geometry.planned_contour = {}; }},
        {"planned_contour_m has a point",
         [](auto& r) { r.header.geometry.planned_contour[1].x() = kNan; }},
        {"placode_edge_m has 2 points", [](auto& r) { r.header.geometry.placode_edge.pop_back(); }},
        {"skin_edge_m has 2 points", [](auto& r) { r.header.geometry.skin_edge.pop_back(); }},
        {"target_depth_m is", [](auto& r) { r.header.geometry.target_depth_m = -1; }},
        {"placode_volume_m3 is", [](auto& r) { r.header.geometry.placode_volume_m3 = 0; }},
        {"the input of frame 51 follows", [](auto& r) { r.inputs[50].frame = 51; }},
        {"is of 2 tools", [](auto& r) { r.inputs[50].tool_count = 2; }},
        {"has 0 substeps", [](auto& r) { r.inputs[50].substeps = 0; }},
        {"a hand that lies nowhere",
         [](auto& r) { r.inputs[50].tools[0].position_m[0] = kFloatNan; }},
        {"sample 5 is at", [](auto& r) { r.samples[5].time_s = r.samples[4].time_s; }},
        {"a tip that lies nowhere", [](auto& r) { r.samples[5].tools[0].tip_m[0] = kFloatNan; }},
        {"a force that is no number",
         [](auto& r) { r.samples[5].tools[0].force_n[0] = kFloatNan; }},
        {"a temperature, dose or volume", [](auto& r) { r.samples[5].placode_burned_m3 = -1; }},
        {"a share that was cut", [](auto& r) { r.samples[5].cut_fraction = 2; }},
        {"samples for 0.1 s", [](auto& r) { r.samples.resize(5); }},
    };
    for (const Change& change : changes) {
        sim::Recording changed = sound();
        change.make(changed);
        EXPECT_THAT(problem(changed), HasSubstr(change.said));
    }
}

TEST(Soundness, TheEndRepeatsTheLastHash) {
    sim::Recording r = sound();
    Event last = event(EventKind::kStateHash, 0);
    last.hash = 7;
    r.events = {last};
    r.end.final_hash = 7;
    EXPECT_EQ(problem(r), "");
    r.end.final_hash = 8;
    EXPECT_EQ(problem(r), "final_hash is not the hash of its last state");
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
