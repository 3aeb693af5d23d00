// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/replay_check.h"

#include <algorithm>
#include <cmath>

#include "curriculum/attempt_sample.h"
#include "sim/core/number_text.h"
#include "sim/cutting/attempt_progress.h"
#include "sim/ledger/damage.h"

namespace placode::curriculum {
namespace {

using sim::Event;
using sim::EventKind;

/// What only the clock, the window or a panel made: no replay gives it again.
bool of_the_clock(EventKind kind) {
    return kind == EventKind::kPaused || kind == EventKind::kMachineSpeed ||
           kind == EventKind::kSlowSpell || kind == EventKind::kTuned ||
           kind == EventKind::kFinished;
}

bool same(const Event& a, const Event& b) {
    return a.time_s == b.time_s && a.kind == b.kind && a.tool == b.tool && a.tissue == b.tissue &&
           a.value == b.value && a.value2 == b.value2 && a.rest_position_m == b.rest_position_m &&
           a.element == b.element && a.hash == b.hash;
}

bool same(const sim::ToolSample& a, const sim::ToolSample& b) {
    return a.tip_m == b.tip_m && a.orientation == b.orientation && a.force_n == b.force_n &&
           a.jaw_rad == b.jaw_rad && a.tip_gap_m == b.tip_gap_m && a.power_w == b.power_w &&
           a.pedals == b.pedals && a.in_contact == b.in_contact && a.in_view == b.in_view &&
           a.touched == b.touched;
}

/// But for the flags of the steps, which nobody scores.
bool same(const sim::Sample& a, const sim::Sample& b, size_t tools) {
    for (size_t i = 0; i < tools; ++i)
        if (!same(a.tools[i], b.tools[i])) return false;
    return a.time_s == b.time_s && a.placode_peak_c == b.placode_peak_c &&
           a.placode_peak_cem43_min == b.placode_peak_cem43_min &&
           a.placode_burned_m3 == b.placode_burned_m3 && a.cut_fraction == b.cut_fraction &&
           a.phase == b.phase;
}

bool same(const sim::FieldGeometry& a, const sim::FieldGeometry& b) {
    return a.planned_contour == b.planned_contour && a.placode_edge == b.placode_edge &&
           a.skin_edge == b.skin_edge && a.target_depth_m == b.target_depth_m &&
           a.placode_volume_m3 == b.placode_volume_m3;
}

/// But for the grip, which is the device's.
bool same(const sim::ToolSpec& a, const sim::ToolSpec& b) {
    return a.kind == b.kind && a.hand == b.hand && a.pivot_m == b.pivot_m &&
           a.shaft_radius_m == b.shaft_radius_m && a.length_m == b.length_m &&
           a.tip_radius_m == b.tip_radius_m && a.tip_length_m == b.tip_length_m &&
           a.scope_angle_deg == b.scope_angle_deg && a.field_of_view_deg == b.field_of_view_deg &&
           a.cut_power_w == b.cut_power_w && a.coag_power_w == b.coag_power_w &&
           a.efficiency == b.efficiency && a.jaw_open_rad == b.jaw_open_rad &&
           a.jaw_width_m == b.jaw_width_m && a.jaw_grip_m == b.jaw_grip_m &&
           a.jaw_force_n == b.jaw_force_n && a.jaw_friction == b.jaw_friction;
}

std::string at(double time_s) { return " at " + sim::fixed_text(time_s, 3) + " s"; }

sim::Recording with_task(const sim::Recording& recording, const Task& published) {
    sim::Recording own = recording;
    own.header.task_json = published.json;
    return own;
}

}  // namespace

struct ReplayCheck::Impl {
    Impl(const sim::Recording& recorded, const Task& published, int threads)
        : recording(with_task(recorded, published)),
          replay(recording, threads),
          warnings(replay.scene()),
          practice(steps_for(published, recording.header.device), replay.scene(), replay.state()),
          tools(replay.scene().tools.size()),
          frames_per_sample(std::max<int64_t>(
              1, std::llround(sim::RecordingHeader{}.sample_s / recording.header.frame_s))) {
        for (const Event& event : recording.events)
            if (!of_the_clock(event.kind)) events.push_back(&event);
        look_at_head();
    }

    void differs(const std::string& what, double time_s) {
        if (difference.empty()) difference = what + at(time_s);
    }

    void look_at_head() {
        const sim::RecordingHeader& head = recording.header;
        const sim::Scene& scene = replay.scene();
        if (head.frame_s != scene.body.spec().solver.frame_s ||
            head.sample_s != sim::RecordingHeader{}.sample_s)
            differs("frame or sample time", 0);
        if (!same(head.geometry, scene.geometry)) differs("the field", 0);
        if (recording.end.dropped != 0) differs("entries that were lost", 0);
        if (head.tools.size() != tools ||
            !std::equal(head.tools.begin(), head.tools.end(), scene.tools.begin(),
                        [](const auto& a, const auto& b) { return same(a, b); }))
            differs("the instruments", 0);
    }

    void expect(const Event& event) {
        if (of_the_clock(event.kind)) return;
        if (next_event >= events.size() || !same(*events[next_event], event))
            differs("event \"" + std::string(sim::event_name(event.kind)) + "\"", event.time_s);
        ++next_event;
    }

    void expect(sim::Sample sample) {
        if (next_sample >= recording.samples.size() ||
            !same(recording.samples[next_sample], sample, tools))
            differs("a sample", sample.time_s);
        ++next_sample;
    }

    /// What the attempt wrote down after this frame (AttemptLoop::hand_out).
    void compare_frame() {
        const sim::State& state = replay.state();
        const auto& input = recording.inputs[static_cast<size_t>(state.frame - 1)];
        const std::span<const sim::ToolInput> hands{input.tools, tools};
        for (int i = 0; i < state.event_count; ++i) expect(state.events[static_cast<size_t>(i)]);
        const bool sampled = state.frame % frames_per_sample == 0;
        warnings.look(state, hands, sampled);
        for (const Event& event : warnings.events()) expect(event);
        if (!sampled) return;
        sim::Sample sample = sample_of(replay.scene(), state, hands);
        sample.cut_fraction = static_cast<float>(sim::ring_share(state));
        expect(sample);
        for (const Event& event : practice.see(state, hands, sample)) expect(event);
    }

    /// As AttemptLoop::close(). An attempt that broke off has written none of it.
    void compare_end() {
        const ReplayResult states = replay.result();
        if (!states.identical) {
            if (difference.empty())
                differs("state", states.first_difference_s < 0 ? 0 : states.first_difference_s);
            return;
        }
        const double time_s = replay.state().time_s;
        if (next_sample != recording.samples.size()) differs("the number of samples", time_s);
        if (recording.end.reason != sim::EndReason::kInterrupted) {
            const uint64_t hash = sim::state_hash(replay.state());
            for (const Event& event : practice.end(time_s)) expect(event);
            for (const Event& event : warnings.end(time_s)) expect(event);
            for (const Event& event : sim::reached_events(replay.scene(), replay.state()))
                expect(event);
            // The replay is over: nothing else looks at its state any more.
            auto& state = const_cast<sim::State&>(replay.state());
            for (const Event& event : sim::closing_events(replay.scene(), state)) expect(event);
            Event last;
            last.time_s = time_s;
            last.kind = EventKind::kStateHash;
            last.hash = hash;
            expect(last);
            if (recording.end.duration_s != time_s) differs("the duration", time_s);
        }
        if (next_event != events.size()) differs("the number of events", time_s);
    }

    sim::Recording recording;
    Replay replay;
    LiveWarnings warnings;
    PracticeGuide practice;
    size_t tools;
    int64_t frames_per_sample;
    std::vector<const Event*> events;
    size_t next_event = 0, next_sample = 0;
    std::string difference;
    bool ended = false;
};

ReplayCheck::ReplayCheck(const sim::Recording& recording, const Task& published, int threads)
    : impl_(std::make_unique<Impl>(recording, published, threads)) {}
ReplayCheck::~ReplayCheck() = default;

bool ReplayCheck::step() {
    if (!impl_->difference.empty() || !impl_->replay.step()) return false;
    impl_->compare_frame();
    return impl_->difference.empty();
}

double ReplayCheck::share() const {
    const size_t all = impl_->recording.inputs.size();
    return all == 0 ? 1
                    : static_cast<double>(impl_->replay.state().frame) / static_cast<double>(all);
}

ReplayVerdict ReplayCheck::verdict() {
    if (!impl_->ended && impl_->difference.empty()) impl_->compare_end();
    impl_->ended = true;
    return {impl_->difference.empty(), impl_->difference};
}

ReplayVerdict check_replay(const sim::Recording& recording, const Task& published, int threads) {
    ReplayCheck check(recording, published, threads);
    while (check.step()) {
    }
    return check.verdict();
}

}  // namespace placode::curriculum
