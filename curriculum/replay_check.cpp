// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/replay_check.h"

#include <algorithm>
#include <optional>

#include "curriculum/attempt_frames.h"
#include "curriculum/replay.h"
#include "sim/core/number_text.h"

namespace placode::curriculum {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Said;

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

/// But for the grip, which is the device's, and for where a scope looks first, which its recorded
/// poses say and older recordings do not have.
bool same(const sim::ToolSpec& a, const sim::ToolSpec& b) {
    return a.kind == b.kind && a.hand == b.hand && a.pivot_m == b.pivot_m &&
           a.shaft_radius_m == b.shaft_radius_m && a.length_m == b.length_m &&
           a.tip_radius_m == b.tip_radius_m && a.tip_length_m == b.tip_length_m &&
           a.scope_angle_deg == b.scope_angle_deg && a.field_of_view_deg == b.field_of_view_deg &&
           a.cut_power_w == b.cut_power_w && a.coag_power_w == b.coag_power_w &&
           a.efficiency == b.efficiency && a.jaw_open_rad == b.jaw_open_rad &&
           a.jaw_width_m == b.jaw_width_m && a.jaw_touch_m == b.jaw_touch_m &&
           a.jaw_force_n == b.jaw_force_n && a.jaw_friction == b.jaw_friction;
}

/// The step that the attempt began with; none: the first. Of a stage that the task does not have
/// the replay says so.
std::optional<int> first_step(const sim::Recording& recording, const Task& published) {
    const auto stage = static_cast<size_t>(std::max(0, recording.header.stage));
    if (stage == 0 || stage > published.stages.size()) return std::nullopt;
    return published.stages[stage - 1].before_step;
}

}  // namespace

/// What the attempt writes down again, held against what it wrote down then.
struct ReplayCheck::Impl final : AttemptBook {
    Impl(const sim::Recording& recorded, const Task& published, int threads)
        : recording(recorded),
          replay(recording, published, threads),
          // Marks were looked for in the settled state, also where another one was given.
          frames(published, steps_for(published, recording.header.device), replay.scene(),
                 replay.state(), recording.end.duration_s),
          first(first_step(recording, published)),
          tools(replay.scene().tools.size()) {
        for (const Event& event : recording.events)
            if (!of_the_clock(event.kind)) events.push_back(&event);
        look_at_head();
    }

    void differs(const Said& what, double time_s) noexcept {
        if (!difference)
            difference = Said::that("%1 at %2 s").with(what).with(sim::fixed_text(time_s, 3));
    }

    void look_at_head() {
        const sim::RecordingHeader& head = recording.header;
        const sim::Scene& scene = replay.scene();
        if (recording.end.dropped != 0) differs(Said::that("entries that were lost"), 0);
        if (head.frame_s != scene.body.spec().solver.frame_s ||
            head.sample_s != sim::RecordingHeader{}.sample_s)
            differs(Said::that("frame or sample time"), 0);
        if (!same(head.geometry, scene.geometry)) differs(Said::that("the field"), 0);
        if (head.tools.size() != tools ||
            !std::equal(head.tools.begin(), head.tools.end(), scene.tools.begin(),
                        [](const auto& a, const auto& b) { return same(a, b); }))
            differs(Said::that("the instruments"), 0);
    }

    void write(const sim::Input&) noexcept override {}  // what is simulated
    void write(const Event& event) noexcept override {
        if (of_the_clock(event.kind)) return;
        if (next_event >= events.size() || !same(*events[next_event], event))
            differs(Said::that("event \"%1\"").with(std::string(sim::event_name(event.kind))),
                    event.time_s);
        ++next_event;
    }
    void write(const sim::Sample& sample) noexcept override {
        if (next_sample >= recording.samples.size() ||
            !same(recording.samples[next_sample], sample, tools))
            differs(Said::that("a sample"), sample.time_s);
        ++next_sample;
    }

    /// One frame of what was given before the attempt; false once it is done.
    bool step_given() {
        if (begun) return false;
        if (replay.step_given()) {
            ++given;
            return true;
        }
        begun = true;
        if (first) frames.begin_at(*first, replay.state());
        return false;
    }

    void compare_frame() {
        const sim::State& state = replay.state();
        const auto& input = recording.inputs[static_cast<size_t>(state.frame - 1)];
        frames.look(state, {}, {input.tools, tools}, *this);
    }

    /// An attempt that broke off has written none of its end.
    void compare_end() {
        const ReplayResult states = replay.result();
        if (!states.identical) {
            differs(Said::that("state"), std::max(0.0, states.first_difference_s));
            return;
        }
        const double time_s = replay.state().time_s;
        if (next_sample != recording.samples.size())
            differs(Said::that("the number of samples"), time_s);
        if (recording.end.reason != sim::EndReason::kInterrupted) {
            frames.close(replay.last_state(), *this);
            // That this is its hash the replay has just shown.
            Event hash;
            hash.time_s = time_s;
            hash.kind = EventKind::kStateHash;
            hash.hash = recording.end.final_hash;
            write(hash);
            if (recording.end.duration_s != time_s) differs(Said::that("the duration"), time_s);
        }
        if (next_event != events.size()) differs(Said::that("the number of events"), time_s);
    }

    const sim::Recording& recording;
    Replay replay;
    AttemptFrames frames;
    std::optional<int> first;
    size_t tools, given = 0;
    bool begun = false;
    std::vector<const Event*> events;
    size_t next_event = 0, next_sample = 0;
    std::optional<Said> difference;
    bool ended = false;
};

ReplayCheck::ReplayCheck(const sim::Recording& recording, const Task& published, int threads)
    : impl_(std::make_unique<Impl>(recording, published, threads)) {}
ReplayCheck::~ReplayCheck() = default;

bool ReplayCheck::step() {
    if (impl_->difference) return false;
    if (impl_->step_given()) return true;
    if (!impl_->replay.step()) return false;
    impl_->compare_frame();
    return !impl_->difference;
}

double ReplayCheck::share() const {
    const sim::Recording& recording = impl_->recording;
    const size_t all = recording.given.size() + recording.inputs.size();
    const auto own = impl_->begun ? static_cast<size_t>(impl_->replay.state().frame) : 0;
    return all == 0 ? 1 : static_cast<double>(impl_->given + own) / static_cast<double>(all);
}

ReplayVerdict ReplayCheck::verdict() {
    if (!impl_->ended && !impl_->difference) impl_->compare_end();
    impl_->ended = true;
    return {!impl_->difference, impl_->difference.value_or(Said())};
}

}  // namespace placode::curriculum
