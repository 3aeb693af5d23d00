// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in its window: what happened goes to the controls, what they decide to runner, view
// and sound.

#include <chrono>
#include <thread>
#include <utility>

#include "haptics/control_words.h"
#include "ui/attempt/attempt_controls.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/controls_setup.h"
#include "ui/attempt/picture_pace.h"
#include "ui/attempt/session_sound.h"
#include "ui/attempt/sessions.h"
#include "ui/attempt/tuning_panel.h"
#include "ui/attempt/user_settings.h"
#include "ui/view/fetoscope_view.h"
#include "ui/view/strings.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kTooSlow = "COMPUTER TOO SLOW, does not count";
constexpr int kReadPathS = 6, kReadTimeS = 4;
constexpr double kReadHelpS = 4;  // the two lines of it that matter beside a script

/// The size that the last one who practised here left. Exams and studies begin alike for everybody.
bool has_own_size(const Arguments& arguments) {
    return !arguments.size_given && arguments.mode == curriculum::AttemptMode::kPractice;
}

bool is_script(const Arguments& arguments) { return arguments.device.rfind("script:", 0) == 0; }

class ViewQuality final : public PictureQuality {
 public:
    explicit ViewQuality(view::FetoscopeView& view) : view_(view) {}
    bool simplify() override { return view_.simplify(); }
    bool enrich() override { return view_.enrich(); }
    [[nodiscard]] bool software() const override { return view_.software(); }

 private:
    view::FetoscopeView& view_;
};

class WindowSession {
 public:
    WindowSession(curriculum::AttemptRunner& runner, sim::Latest<sim::WindowInput>& published,
                  const Arguments& arguments, StatusLine& status)
        : runner_(runner),
          published_(published),
          status_(status),
          conduct_(curriculum::conduct_of(arguments.mode)),
          shots_(arguments),
          overlay_(attempt_overlay(runner.task(), arguments)),
          view_(view::view_field(*runner.scene(), arguments.seed),
                view_settings(arguments, overlay_.title)),
          panel_(runner.task(),
                 {.language = arguments.language,
                  .author = arguments.author,
                  .allowed = conduct_.tuning,
                  .saved_utc = {},
                  .tune = [&runner](auto p, auto tissue,
                                    double value) { runner.tune(p, tissue, value); }}),
          controls_(controls_setup(runner.task(), arguments), panel_),
          quality_(view_),
          pace_(quality_),
          sound_(arguments),
          scripted_(is_script(arguments)),
          space_mouse_(arguments.device == "spacemouse"),
          read_on_(!scripted_ && !is_in_window(arguments.device) && conduct_.help),
          remember_size_(has_own_size(arguments) && !arguments.fullscreen) {}

    void run() {
        view_.poll(totals_);
        (void)view_.events();  // of the time while the window came up
        steer();
        runner_.start();
        while (!runner_.finished()) {
            view_.poll(totals_);
            steer();
            if (finish_requested()) runner_.request_finish(sim::EndReason::kClosed);
            if (stop_requested()) runner_.request_finish(sim::EndReason::kInterrupted);
            listen();
            const curriculum::AttemptStatus status = runner_.status();
            status_.print(status);
            keep_pace(status);
            if (pace_.due(Clock::now())) {
                const Clock::time_point start = Clock::now();
                picture(status);
                pace_.drawn(start, Clock::now());
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        }
        sound_.silence();
        overlay_.menu = {};
        overlay_.holding = 0;
        overlay_.notice = "Finished";
        picture(runner_.status());
        if (remember_size_) {
            const auto [width, height] = view_.window_size();
            save_window_size({width, height});
        }
    }

 private:
    static double seconds() {
        return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    }

    void listen() {
        const sim::Snapshot& snapshot = runner_.snapshot();
        if (snapshot.x.empty()) return;
        if (controls_.paused()) return sound_.silence();
        const double left_s = sound_.listen(snapshot, overlay_.time_limit_s, overlay_.warnings);
        // What the other alarms mean stands there as a warning; the clock's has words as well.
        if (left_s > 0) note(left_s >= 60 ? "One minute left" : "Ten seconds left", kReadTimeS);
    }

    /// Window, controls, runner: once a round.
    void steer() {
        const auto [x, y] = view_.pointer();
        const Pointer pointer{x, y, view_.menu_item_under_pointer(),
                              view_.tuning_item_under_pointer()};
        const curriculum::AttemptStatus status = runner_.status();
        if (space_mouse_ && status.device_lost)
            controls_.interrupt("Paused: the SpaceMouse is gone", sim::PauseCause::kDevice);
        if (std::exchange(sleeps_, status.sleeps) != status.sleeps)
            controls_.interrupt("Paused: the computer was asleep", sim::PauseCause::kAsleep);
        controls_.update(view_.events(), totals_, pointer, status.time_s, seconds());
        if (controls_.paused() != paused_) {
            paused_ = controls_.paused();
            runner_.set_paused(paused_, controls_.pause_cause());
        }
        // After the pause has begun: what is let go in it keeps its jaws.
        published_.publish(controls_.for_devices());
        view_.capture_pointer(controls_.captures_pointer());
        if (const auto end = controls_.end()) runner_.request_finish(*end);
        for (const Command command : controls_.take_commands()) obey(command);
        if (const std::string text = controls_.take_note(); !text.empty()) note(text);
        if (panel_.tuned()) {
            overlay_.banner = "TUNED, not scored";
            overlay_.cut_power_w = panel_.power_w(sim::TuneParameter::kCutPower);
            overlay_.coag_power_w = panel_.power_w(sim::TuneParameter::kCoagPower);
        }
        overlay_.tuning = panel_.picture();
        overlay_.menu = controls_.menu();
        overlay_.holding = controls_.holding();
    }

    void obey(Command command) {
        switch (command) {
            case Command::kScreenshot:
                screenshot_asked_ = true;
                break;
            case Command::kWipeLens:
                view_.wipe_lens();
                break;
            case Command::kGuide:
                overlay_.show_guide = !overlay_.show_guide;
                break;
            case Command::kPerformance:
                overlay_.show_performance = !overlay_.show_performance;
                break;
            case Command::kMute:
            case Command::kLouder:
            case Command::kSofter:
                note(sound_.change(command));
                break;
        }
    }

    void keep_pace(const curriculum::AttemptStatus& status) {
        if (scripted_ || paused_) return;
        pace_.watch(status, Clock::now());
        runner_.may_save_substeps(pace_.may_save_substeps());
        if (const std::string text = pace_.take_note(); !text.empty()) note(text, 6);
        // A note goes; that it will not count stands there as long as it is so.
        const bool void_now = PicturePace::will_not_count(status);
        if (void_now && overlay_.banner.empty()) overlay_.banner = kTooSlow;
        if (!void_now && overlay_.banner == kTooSlow) overlay_.banner.clear();
    }

    void picture(const curriculum::AttemptStatus& status) {
        const sim::Snapshot& snapshot = runner_.snapshot();
        overlay_.practice.goal = runner_.practice();
        overlay_.practice.in_hand = status.in_hand;
        overlay_.waiting = status.waiting;
        // Beside arms and scripts nobody presses a key: the help goes by itself.
        const bool read = scripted_ ? status.time_s < kReadHelpS && overlay_.practice.steps.empty()
                                    : read_on_ && status.waiting;
        overlay_.help_waits = controls_.screen() == Screen::kHelp;
        overlay_.show_help =
            overlay_.help_waits || (read && controls_.screen() == Screen::kOperate);
        const bool noted = notice_until_ > Clock::now();
        overlay_.notice = noted ? notice_ : status.warning;
        tend_lens();
        if (view_.draw(snapshot, overlay_)) runner_.picture_drawn();
        if (snapshot.x.empty()) return;
        if (shots_.due(snapshot.time_s)) shots_.save(view_, snapshot.time_s);
        if (screenshot_asked_) extra_screenshot(snapshot.time_s);
    }

    /// Says once how a lens is wiped that lets little through; a script wipes it.
    void tend_lens() {
        const bool dirty = view_.lens().dirty();
        if (dirty && scripted_) view_.wipe_lens();
        if (dirty && !lens_told_ && !scripted_ && overlay_.warnings)
            note(haptics::in_layout(view::translated("L wipes the lens", overlay_.language),
                                    overlay_.layout, overlay_.practice.device, overlay_.language));
        lens_told_ = dirty;
    }

    void note(const std::string& text, int seconds = 2) {
        notice_ = text;
        notice_until_ = Clock::now() + std::chrono::seconds(seconds);
    }

    void extra_screenshot(double time_s) {
        screenshot_asked_ = false;
        try {
            const std::string path = shots_.save_extra(view_, time_s);
            note(view::translated("Screenshot saved", overlay_.language) + ": " + path, kReadPathS);
        } catch (const view::ViewError&) {
            note("Screenshot could not be saved");
        }
    }

    curriculum::AttemptRunner& runner_;
    sim::Latest<sim::WindowInput>& published_;
    StatusLine& status_;
    const curriculum::Conduct& conduct_;
    Screenshots shots_;
    view::OverlayState overlay_;
    view::FetoscopeView view_;
    TuningPanel panel_;
    AttemptControls controls_;
    ViewQuality quality_;
    PicturePace pace_;
    SessionSound sound_;
    sim::WindowInput totals_;
    bool scripted_ = false, space_mouse_ = false, read_on_ = false, lens_told_ = false;
    bool screenshot_asked_ = false, paused_ = false, remember_size_ = false;
    int sleeps_ = 0;
    std::string notice_;
    Clock::time_point notice_until_{};
};

}  // namespace

void run_in_window(curriculum::AttemptRunner& runner, sim::Latest<sim::WindowInput>& input,
                   const Arguments& arguments, StatusLine& status) {
    Arguments sized = arguments;
    if (const auto last = load_window_size(); last && has_own_size(arguments)) {
        sized.width = last->width;
        sized.height = last->height;
    }
    WindowSession(runner, input, sized, status).run();
}

}  // namespace placode::ui
