// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A recording again: every state hash in it must come out the same.

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "db/recording_file.h"
#include "sim/view/fetoscope_view.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;

struct StoppedByUser {};

// Draws while the recording is simulated: in real time in a window, or only the pictures asked for.
class Watcher {
 public:
    Watcher(const Arguments& arguments, const sim::Recording& recording, StatusLine& status)
        : arguments_(arguments), status_(status), shots_(arguments) {
        const curriculum::Task task =
            curriculum::load_task_text(recording.header.task_json, arguments.play);
        overlay_ = attempt_overlay(task, arguments);
        overlay_.time_limit_s = recording.end.duration_s;
    }

    void frame(const sim::Scene& scene, const sim::State& state) {
        if (stop_requested()) throw StoppedByUser{};
        last_.time_s = state.time_s;
        last_.phase = state.phase;
        last_.substeps = state.substeps;
        const size_t points = state.progress.cut.size();
        last_.cut_fraction =
            points > 0 ? static_cast<double>(state.progress.cut_count) / static_cast<double>(points)
                       : 0;
        status_.print(last_);
        const bool due = shots_.due(state.time_s);
        const bool window = !arguments_.headless;
        // Smoke lives on what happens between pictures: look ten times a second.
        const bool look = state.time_s >= next_look_s_ && shots_.wanted();
        if (!due && !look && !(window && picture_time(state.time_s))) return;
        next_look_s_ = state.time_s + 0.1;
        sim::fill_snapshot(scene, state, snapshot_);
        if (!view_)
            view_.emplace(sim::view_field(scene, arguments_.seed),
                          view_settings(arguments_, overlay_.title));
        if (!due && !window) {
            view_->observe(snapshot_);
            return;
        }
        view_->draw(snapshot_, overlay_);
        if (due) shots_.save(*view_, state.time_s);
        if (window) handle_window();
    }
    [[nodiscard]] const curriculum::AttemptStatus& last() const { return last_; }

 private:
    // Waits where the simulation is ahead of real time; skips pictures where it is behind.
    bool picture_time(double time_s) {
        if (!started_) {
            started_ = true;
            start_ = Clock::now();
            start_s_ = time_s;
        }
        const auto due = start_ + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(time_s - start_s_));
        if (due > Clock::now()) std::this_thread::sleep_until(due);
        if (time_s < next_picture_s_) return false;
        next_picture_s_ =
            time_s + (Clock::now() - due > std::chrono::milliseconds(200) ? 0.2 : 0.033);
        return true;
    }
    void handle_window() {
        sim::WindowInput input;
        view_->poll(input);
        const auto pressed = [&](sim::Key key) {
            return input.presses[static_cast<size_t>(key)] % 2 != 0;
        };
        overlay_.show_performance = pressed(sim::Key::kF3);
        overlay_.show_guide = pressed(sim::Key::kF5);
        overlay_.show_help = pressed(sim::Key::kF1);
        if (view_->close_requested() || input.presses[static_cast<size_t>(sim::Key::kEscape)] > 0)
            throw StoppedByUser{};
    }

    const Arguments& arguments_;
    StatusLine& status_;
    Screenshots shots_;
    sim::OverlayState overlay_;
    std::optional<sim::FetoscopeView> view_;
    sim::Snapshot snapshot_;
    curriculum::AttemptStatus last_;
    bool started_ = false;
    Clock::time_point start_{};
    double start_s_ = 0, next_picture_s_ = 0, next_look_s_ = 0;
};

}  // namespace

int run_replay(const Arguments& arguments, StatusLine& status) {
    const sim::Recording recording = db::read_recording_file(arguments.play);
    Watcher watcher(arguments, recording, status);
    status.print(watcher.last(), true);
    try {
        const curriculum::ReplayResult result = curriculum::replay(
            recording, arguments.threads,
            [&](const sim::Scene& scene, const sim::State& state) { watcher.frame(scene, state); });
        status.end(watcher.last(), result.identical ? "identical" : "different", arguments.play,
                   result.message);
        // With --status standard output is for JSON only.
        std::fprintf(arguments.status ? stderr : stdout, "%s\n", result.message.c_str());
        return result.identical ? 0 : 1;
    } catch (const StoppedByUser&) {
        status.end(watcher.last(), "closed", arguments.play);
        std::fprintf(
            stderr,
            "placode-sim: replay stopped before its end; nothing was compared to the last frame\n");
        return 1;
    }
}

}  // namespace placode::ui
