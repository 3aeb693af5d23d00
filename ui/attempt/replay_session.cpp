// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A recording again: every state hash in it must come out the same. Going on to a moment means to
// simulate up to it without pictures, going back means from a kept moment up to it; nothing is
// skipped.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>
#include <thread>

#include "curriculum/replay.h"
#include "db/recording_file.h"
#include "db/stage_cache.h"
#include "sim/core/number_text.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"
#include "ui/view/fetoscope_view.h"
#include "ui/view/strings.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

struct StoppedByUser {};
/// A moment before the present one was asked for.
struct GoBack {
    double time_s = 0;
};

/// Below this share of the speed asked for the picture says so.
constexpr double kNearlyAsAsked = 0.9;
constexpr size_t kKeyFrameBytes = size_t{400}
                                  << 20;  // moments to go back to, where somebody watches

/// What stands at the foot of the picture, in the user's language.
/// @param pace reached where that is less than was asked for [simulated s/s]; 0 = as asked for.
std::string foot_text(const ReplayWish& wish, double pace, double target_s, bool at_end,
                      const std::string& language) {
    static constexpr const char* kCameras[]{"as operated", "from above", "from the left",
                                            "from the feet", "near the tip"};
    const auto say = [&](const char* english) { return view::translated(english, language); };
    const auto say_with = [&](const char* english, const std::string& part) {
        std::string text = say(english);
        return text.replace(text.find("%1"), 2, part);
    };
    std::string text = sim::rounded_text(wish.speed, 6) + "x";
    if (pace > 0 && target_s < 0 && !at_end && !wish.paused)
        text += " " + say_with("(computer: %1x)", sim::fixed_text(pace, 1));
    text += "   " + say(kCameras[static_cast<size_t>(wish.camera)]);
    if (target_s >= 0)
        text += "   " + say_with("simulating to %1", view::clock_text(target_s));
    else if (at_end)
        text += "   " + say("end of the recording");
    else if (wish.paused)
        text += "   " + say("paused");
    return text;
}

// Draws while the recording is simulated: at the speed asked for, or only the pictures asked for.
class Watcher {
 public:
    Watcher(const Arguments& arguments, const sim::Recording& recording, StatusLine& status)
        : arguments_(arguments),
          recording_(recording),
          status_(status),
          shots_(arguments),
          wish_(arguments.wish),
          paced_((!arguments.headless || arguments.control) && !arguments.fast) {
        overlay_ =
            replay_overlay(curriculum::load_task_text(recording.header.task_json, arguments.play),
                           recording, arguments);
    }

    /// What was given before the attempt is simulated first, and takes a while.
    void preparing(double share, const sim::Scene& scene, const sim::State& state) {
        if (stop_requested()) throw StoppedByUser{};
        if (!progress_due()) return;
        if (arguments_.control) control_.poll(wish_);
        if (!arguments_.headless) {
            const int percent = static_cast<int>(std::lround(100 * share));
            std::string text =
                view::translated("Preparing what was given, %1 %", arguments_.language);
            if (const size_t at = text.find("%1"); at != std::string::npos)
                text.replace(at, 2, std::to_string(percent));
            show_with(scene, state, text);
            handle_window(0);
        }
        if (wish_.quit) throw StoppedByUser{};
        tell();
    }

    void begin(double time_s = 0) {
        last_.time_s = time_s;
        next_picture_s_ = next_look_s_ = time_s;
        started_ = false;
    }

    void frame(const curriculum::Replay& replay) {
        const sim::Scene& scene = replay.scene();
        const sim::State& state = replay.state();
        overlay_.practice.goal = replay.practice();
        note(state);
        // Commands and keys are looked at a hundred times a second, not a thousand times.
        if (Clock::now() - last_look_ > std::chrono::milliseconds(10)) {
            last_look_ = Clock::now();
            obey(scene, state);
            if (wish_.paused && target_s_ < 0) hold(scene, state, false);
        }
        tell();
        const bool due = shots_.due(state.time_s);
        // Smoke lives on what happens between pictures: look ten times a second.
        const bool look = state.time_s >= next_look_s_ && shots_.wanted();
        const bool window = !arguments_.headless;
        const bool picture = target_s_ >= 0 ? progress_due() : paced_ && picture_time(state.time_s);
        if (!due && !look && !(window && picture)) return;
        next_look_s_ = state.time_s + 0.1;
        show(scene, state, due || window);
        if (due) shots_.save(*view_, state.time_s);
    }

    /// The last picture stays until somebody wants something else.
    void stay(const sim::Scene& scene, const sim::State& state) { hold(scene, state, true); }
    [[nodiscard]] const curriculum::AttemptStatus& last() const { return last_; }

 private:
    void note(const sim::State& state) {
        last_.time_s = state.time_s;
        last_.phase = state.phase;
        last_.substeps = state.substeps;
        const size_t points = state.progress.cut.size();
        last_.cut_fraction =
            points > 0 ? static_cast<double>(state.progress.cut_count) / static_cast<double>(points)
                       : 0;
        if (target_s_ >= 0 && state.time_s >= target_s_) {
            target_s_ = -1;
            started_ = false;
            next_picture_s_ = 0;
        }
    }

    void tell(bool now = false) {
        const double wall = Seconds(Clock::now() - pace_from_).count();
        if (wall > 0.5) {
            pace_ = std::max(0.0, (last_.time_s - pace_from_s_) / wall);
            pace_from_ = Clock::now();
            pace_from_s_ = last_.time_s;
        }
        if (arguments_.control) {
            status_.set_replay({wish_.paused, wish_.speed, pace_, target_s_,
                                camera_name(wish_.camera), wish_.problem});
        }
        status_.print(last_, now);
    }

    void obey(const sim::Scene& scene, const sim::State& state) {
        if (stop_requested()) throw StoppedByUser{};
        const ReplayWish before = wish_;
        if (arguments_.control) control_.poll(wish_);
        if (!arguments_.headless && view_) handle_window(state.time_s);
        if (wish_.quit) throw StoppedByUser{};
        if (before.speed != wish_.speed || before.paused != wish_.paused) started_ = false;
        if (wish_.seek_s >= 0) {
            target_s_ = std::min(wish_.seek_s, std::max(0.0, recording_.end.duration_s - 0.05));
            wish_.seek_s = -1;
            if (std::abs(target_s_ - state.time_s) < 0.1)
                target_s_ = -1;  // there already, e.g. at the end
            else if (target_s_ < state.time_s)
                throw GoBack{target_s_};
        }
        if (before.camera != wish_.camera && !arguments_.headless && view_)
            show(scene, state, true);
    }

    void hold(const sim::Scene& scene, const sim::State& state, bool at_end) {
        at_end_ = at_end;
        tell(true);
        while ((wish_.paused || at_end) && target_s_ < 0) {
            if (!arguments_.headless) show(scene, state, true);
            std::this_thread::sleep_for(std::chrono::milliseconds(arguments_.headless ? 20 : 66));
            obey(scene, state);
            tell();
        }
        at_end_ = false;
        started_ = false;
    }

    void show_with(const sim::Scene& scene, const sim::State& state, const std::string& notice) {
        show(scene, state, false);
        overlay_.notice = notice;
        view_->draw(snapshot_, overlay_);
    }

    void show(const sim::Scene& scene, const sim::State& state, bool draw) {
        sim::fill_snapshot(scene, state, snapshot_);
        place_camera(wish_.camera, scene.tools, snapshot_);
        if (!view_)
            view_.emplace(view::view_field(scene, arguments_.seed),
                          view_settings(arguments_, overlay_.title));
        if (!draw) {
            view_->observe(snapshot_);
            return;
        }
        const bool behind = paced_ && pace_ < kNearlyAsAsked * wish_.speed;
        overlay_.notice =
            foot_text(wish_, behind ? pace_ : 0, target_s_, at_end_, arguments_.language);
        view_->draw(snapshot_, overlay_);
    }

    // While a moment is being reached: three pictures a second say that something happens.
    bool progress_due() {
        if (Clock::now() - last_progress_ < std::chrono::milliseconds(330)) return false;
        last_progress_ = Clock::now();
        return true;
    }

    // Waits where the simulation is ahead of the speed asked for; skips pictures where it is
    // behind.
    bool picture_time(double time_s) {
        if (!started_) {
            started_ = true;
            start_ = Clock::now();
            start_s_ = time_s;
        }
        const auto due = start_ + std::chrono::duration_cast<Clock::duration>(
                                      Seconds((time_s - start_s_) / wish_.speed));
        if (due > Clock::now()) std::this_thread::sleep_until(due);
        if (time_s < next_picture_s_) return false;
        const bool behind = Clock::now() - due > std::chrono::milliseconds(200);
        next_picture_s_ = time_s + (behind ? 0.2 : 0.033) * wish_.speed;
        return true;
    }

    void handle_window(double now_s) {
        sim::WindowInput input;
        view_->poll(input);
        const auto pressed = [&](sim::Key key) {
            return input.presses[static_cast<size_t>(key)] % 2 != 0;
        };
        overlay_.show_performance = pressed(sim::Key::kF3);
        overlay_.show_guide = pressed(sim::Key::kF5);
        overlay_.show_help = pressed(sim::Key::kF1);
        keys_.apply(input, now_s, wish_);
        if (view_->close_requested()) throw StoppedByUser{};
    }

    const Arguments& arguments_;
    const sim::Recording& recording_;
    StatusLine& status_;
    Screenshots shots_;
    ReplayWish wish_;
    ControlInput control_;
    ReplayKeys keys_;
    view::OverlayState overlay_;
    std::optional<view::FetoscopeView> view_;
    sim::Snapshot snapshot_;
    curriculum::AttemptStatus last_;
    bool paced_, started_ = false, at_end_ = false;
    Clock::time_point start_{}, last_look_{}, last_progress_{}, pace_from_ = Clock::now();
    double start_s_ = 0, next_picture_s_ = 0, next_look_s_ = 0, target_s_ = -1;
    double pace_ = 0, pace_from_s_ = 0;
};

/// To the end, back and forth as wished.
curriculum::ReplayResult play(const Arguments& arguments, const sim::Recording& recording,
                              Watcher& watcher) {
    const bool watched = arguments.control || !arguments.headless;
    // On the computer where it was recorded what was given is often known.
    const auto known = db::StageCache().find(recording.header);
    const curriculum::GivenPart given{
        known ? &known->state : nullptr,
        [&watcher](double share, const sim::Scene& scene, const sim::State& state) {
            watcher.preparing(share, scene, state);
        }};
    curriculum::Replay replay(recording, arguments.threads, watched ? kKeyFrameBytes : 0, given);
    const auto last = std::ssize(recording.inputs);
    watcher.begin();
    for (bool more = true; more;) {
        try {
            more = replay.step();
            if (!more) break;
            watcher.frame(replay);
            if (replay.state().frame == last && arguments.control)
                watcher.stay(replay.scene(), replay.state());
        } catch (const GoBack& back) {
            replay.back_to(back.time_s);
            watcher.begin(replay.state().time_s);
        }
    }
    return replay.result();
}

}  // namespace

int run_replay(const Arguments& arguments, StatusLine& status) {
    const sim::Recording recording = db::read_recording_file(arguments.play);
    Watcher watcher(arguments, recording, status);
    status.print(watcher.last(), true);
    try {
        const curriculum::ReplayResult result = play(arguments, recording, watcher);
        status.end(watcher.last(), result.identical ? "identical" : "different", arguments.play,
                   result.message);
        // With --status standard output is for JSON only.
        std::fprintf(arguments.status ? stderr : stdout, "%s\n", result.message.c_str());
        return result.identical ? 0 : 1;
    } catch (const StoppedByUser&) {
        status.end(watcher.last(), "closed", arguments.play);
        // With --control closing is the way to end.
        if (arguments.control) return 0;
        std::fprintf(
            stderr,
            "placode-sim: replay stopped before its end; nothing was compared to the last frame\n");
        return 1;
    }
}

}  // namespace placode::ui
