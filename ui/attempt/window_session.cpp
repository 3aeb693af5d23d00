// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in its window. Keys that belong to the menu never reach the device.

#include <algorithm>
#include <chrono>
#include <thread>

#include "sim/view/fetoscope_view.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"
#include "ui/attempt/sound.h"
#include "ui/attempt/tuning_panel.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;
using sim::Key;

constexpr double kReadHelpS = 4;  // the two lines of it that matter beside a script

class WindowSession {
 public:
    WindowSession(curriculum::AttemptRunner& runner, sim::Latest<sim::WindowInput>& published,
                  const Arguments& arguments, StatusLine& status)
        : runner_(runner),
          published_(published),
          status_(status),
          shots_(arguments),
          overlay_(attempt_overlay(runner.task(), arguments)),
          view_(sim::view_field(*runner.scene(), arguments.seed),
                view_settings(arguments, overlay_.title)),
          panel_(runner.task(),
                 {.language = arguments.language,
                  .author = arguments.author,
                  .allowed = !arguments.exam,
                  .saved_utc = {},
                  .tune = [&runner](auto p, auto tissue,
                                    double value) { runner.tune(p, tissue, value); }}),
          sound_(sound_settings(arguments)) {
        // Until the first key, so that nobody starts in the dark; steps say it themselves.
        overlay_.show_help = overlay_.practice.steps.empty() && !arguments.exam;
        scripted_ = arguments.device.rfind("script:", 0) == 0;
    }

    void run() {
        view_.capture_pointer(true);
        view_.poll(input_);
        before_ = input_;
        publish();
        runner_.start();
        Clock::time_point next_picture = Clock::now();
        while (!runner_.finished()) {
            view_.poll(input_);
            if (view_.close_requested() || finish_requested())
                runner_.request_finish(sim::EndReason::kClosed);
            if (stop_requested()) runner_.request_finish(sim::EndReason::kInterrupted);
            handle_keys();
            publish();
            listen();
            status_.print(runner_.status());
            if (Clock::now() >= next_picture) {
                const Clock::time_point start = Clock::now();
                picture();
                // The physics shares the processor with a software renderer: at most half of the
                // time goes into pictures, however slow they are.
                const Clock::duration spent = Clock::now() - start;
                const Clock::duration pause =
                    view_.software()
                        ? std::max<Clock::duration>(spent, std::chrono::milliseconds(30))
                        : Clock::duration::zero();
                next_picture =
                    std::max(start + std::chrono::milliseconds(16), Clock::now() + pause);
            } else {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        }
        sound_.silence();
        overlay_.menu = false;
        overlay_.notice = "Finished";
        picture();
    }

 private:
    [[nodiscard]] bool pressed(Key key) const {
        const auto i = static_cast<size_t>(key);
        return input_.presses[i] != before_.presses[i];
    }

    static SoundSettings sound_settings(const Arguments& arguments) {
        SoundSettings settings = load_sound_settings();
        if (arguments.volume_percent >= 0) settings.volume = arguments.volume_percent / 100.0;
        settings.muted = settings.muted || arguments.mute;
        return settings;
    }

    void listen() {
        const sim::Snapshot& snapshot = runner_.snapshot();
        if (snapshot.x.empty()) return;
        sound_.play(score_.listen(snapshot, overlay_.time_limit_s, overlay_.exam));
    }

    /// Letters that mean something wherever the keyboard puts them: sound and lens.
    void handle_letters() {
        const std::string typed = view_.typed();
        if (panel_.typing()) {
            panel_.type(typed);
            return;
        }
        SoundSettings settings = sound_.settings();
        for (const char c : typed) {
            if (c == 'm' || c == 'M') settings.muted = !settings.muted;
            if (c == '+') settings.volume = std::min(1.0, settings.volume + 0.1);
            if (c == '-') settings.volume = std::max(0.0, settings.volume - 0.1);
            if (c == 'l' || c == 'L') view_.wipe_lens();
            if (c != 'm' && c != 'M' && c != '+' && c != '-') continue;
            if (c == '+' || c == '-') settings.muted = false;
            sound_.set(settings);
            save_sound_settings(settings);
            note(!sound_.problem().empty() ? "No sound on this computer"
                 : settings.muted          ? "Sound off"
                                           : "Sound on");
        }
    }

    /// F2 and what belongs to the panel. True when nothing else shall see the keys.
    bool handle_panel() {
        const bool pointed = panel_.takes_pointer();
        const bool was_typing = panel_.typing();
        if (pressed(Key::kF2)) {
            if (overlay_.exam) note("No tuning in an exam");
            panel_.toggle();
        }
        bool taken = false;
        for (const Key key :
             {Key::kUp, Key::kDown, Key::kLeft, Key::kRight, Key::kEnter, Key::kEscape}) {
            if (pressed(key)) taken = panel_.key(key) || taken;
        }
        if (panel_.takes_pointer() && input_.left && !before_.left)
            panel_.click(view_.tuning_item_under_pointer());
        if (panel_.takes_pointer() != pointed) {
            view_.capture_pointer(!panel_.takes_pointer());
            hold_left_ = true;
        }
        if (panel_.tuned()) {
            overlay_.banner = "TUNED, not scored";
            overlay_.cut_power_w = panel_.power_w(sim::TuneParameter::kCutPower);
            overlay_.coag_power_w = panel_.power_w(sim::TuneParameter::kCoagPower);
        }
        overlay_.tuning = panel_.picture();
        return taken || was_typing || panel_.typing();
    }

    void handle_keys() {
        handle_letters();
        if (!overlay_.menu && handle_panel()) {
            hide_enter_ = true;
            before_ = input_;
            return;
        }
        const bool aids = !overlay_.exam;  // An exam has none.
        if (aids && pressed(Key::kF3)) overlay_.show_performance = !overlay_.show_performance;
        if (aids && pressed(Key::kF5)) overlay_.show_guide = !overlay_.show_guide;
        if (pressed(Key::kF12)) screenshot_asked_ = true;
        if (overlay_.menu) {
            handle_menu();
        } else if (pressed(Key::kEscape)) {
            open_menu(true);
        } else if (pressed(Key::kEnter)) {
            runner_.request_finish(sim::EndReason::kFinished);
        } else if (aids && pressed(Key::kF1)) {
            overlay_.show_help = !overlay_.show_help;
            help_seen_ = true;
        } else if (!help_seen_ && (input_.left || input_.right || moved() || help_read())) {
            overlay_.show_help = false;
            help_seen_ = true;
        }
        if (!input_.left) hold_left_ = false;
        before_ = input_;
    }

    /// Nobody presses a key where a script is at work.
    [[nodiscard]] bool help_read() const {
        return scripted_ && runner_.status().time_s > kReadHelpS;
    }

    // Enough motion to mean it, or any key of the device.
    [[nodiscard]] bool moved() const {
        return std::abs(input_.mouse_x) + std::abs(input_.mouse_y) > 400 || input_.down.any();
    }

    void handle_menu() {
        const int under = view_.menu_item_under_pointer();
        if (under >= 0) overlay_.menu_selected = under;
        if (pressed(Key::kUp))
            overlay_.menu_selected =
                (overlay_.menu_selected + sim::kMenuItems - 1) % sim::kMenuItems;
        if (pressed(Key::kDown))
            overlay_.menu_selected = (overlay_.menu_selected + 1) % sim::kMenuItems;
        const bool click = input_.left && !before_.left && under >= 0;
        if (pressed(Key::kEscape)) {
            open_menu(false);
        } else if (pressed(Key::kEnter) || click) {
            const int item = overlay_.menu_selected;
            open_menu(false);
            if (item == 1) runner_.request_finish(sim::EndReason::kFinished);
            if (item == 2) runner_.request_finish(sim::EndReason::kClosed);
        }
    }

    void open_menu(bool open) {
        overlay_.menu = open;
        overlay_.menu_selected = 0;
        runner_.set_paused(open);
        view_.capture_pointer(!open);
        hold_left_ = true;  // the click that leaves the menu must not fire the needle
    }

    // What the devices see: nothing of what was meant for the menu.
    void publish() {
        sim::WindowInput seen = input_;
        const auto enter = static_cast<size_t>(Key::kEnter);
        if (overlay_.menu || panel_.takes_pointer() || panel_.typing()) {
            hidden_enter_ += seen.presses[enter] - last_enter_;
            hidden_wheel_ += seen.wheel - last_wheel_;
            seen.down.reset();
            seen.left = seen.right = seen.middle = false;
        } else if (panel_.shown()) {  // the arrows are the panel's
            for (const Key key : {Key::kUp, Key::kDown, Key::kLeft, Key::kRight})
                seen.down.reset(static_cast<size_t>(key));
            if (hide_enter_) hidden_enter_ += seen.presses[enter] - last_enter_;
        }
        hide_enter_ = false;
        last_enter_ = seen.presses[enter];
        last_wheel_ = seen.wheel;
        seen.presses[enter] -= hidden_enter_;
        seen.wheel -= hidden_wheel_;
        if (hold_left_) seen.left = false;
        published_.publish(seen);
    }

    void picture() {
        const sim::Snapshot& snapshot = runner_.snapshot();
        const curriculum::AttemptStatus status = runner_.status();
        overlay_.practice.goal = runner_.practice();
        if (!status.warning.empty()) overlay_.notice = status.warning;
        if (notice_until_ > Clock::now()) overlay_.notice = notice_;
        if (notice_until_ <= Clock::now() && status.warning.empty() && overlay_.notice == notice_) {
            overlay_.notice.clear();
        }
        tend_lens();
        view_.draw(snapshot, overlay_);
        if (snapshot.x.empty()) return;
        if (shots_.due(snapshot.time_s)) shots_.save(view_, snapshot.time_s);
        if (screenshot_asked_) extra_screenshot(snapshot.time_s);
    }

    /// Says once how a lens is wiped that lets little through; a script wipes it.
    void tend_lens() {
        const bool dirty = view_.lens().dirty();
        if (dirty && scripted_) view_.wipe_lens();
        if (dirty && !lens_told_ && !scripted_ && !overlay_.exam) note("L wipes the lens");
        lens_told_ = dirty;
    }

    void note(const char* text) {
        notice_ = text;
        notice_until_ = Clock::now() + std::chrono::seconds(2);
    }

    void extra_screenshot(double time_s) {
        screenshot_asked_ = false;
        try {
            shots_.save_extra(view_, time_s);
            note("Screenshot saved");
        } catch (const sim::ViewError&) {
            note("Screenshot could not be saved");
        }
    }

    curriculum::AttemptRunner& runner_;
    sim::Latest<sim::WindowInput>& published_;
    StatusLine& status_;
    Screenshots shots_;
    sim::OverlayState overlay_;
    sim::FetoscopeView view_;
    TuningPanel panel_;
    Sound sound_;
    SoundScore score_;
    sim::WindowInput input_, before_;
    bool scripted_ = false, lens_told_ = false;
    bool help_seen_ = false, hold_left_ = false, screenshot_asked_ = false, hide_enter_ = false;
    uint32_t hidden_enter_ = 0, last_enter_ = 0;
    double hidden_wheel_ = 0, last_wheel_ = 0;
    std::string notice_;
    Clock::time_point notice_until_{};
};

}  // namespace

void run_in_window(curriculum::AttemptRunner& runner, sim::Latest<sim::WindowInput>& input,
                   const Arguments& arguments, StatusLine& status) {
    WindowSession(runner, input, arguments, status).run();
}

}  // namespace placode::ui
