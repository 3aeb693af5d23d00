// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in its window. Keys that belong to the menu never reach the device.

#include <algorithm>
#include <chrono>
#include <thread>

#include "sim/view/fetoscope_view.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;
using sim::Key;

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
                view_settings(arguments, overlay_.title)) {
        overlay_.show_help = true;  // until the first key, so that nobody starts in the dark
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
        overlay_.menu = false;
        overlay_.notice = "Finished";
        picture();
    }

 private:
    [[nodiscard]] bool pressed(Key key) const {
        const auto i = static_cast<size_t>(key);
        return input_.presses[i] != before_.presses[i];
    }

    void handle_keys() {
        if (pressed(Key::kF3)) overlay_.show_performance = !overlay_.show_performance;
        if (pressed(Key::kF5)) overlay_.show_guide = !overlay_.show_guide;
        if (pressed(Key::kF12)) screenshot_asked_ = true;
        if (overlay_.menu) {
            handle_menu();
        } else if (pressed(Key::kEscape)) {
            open_menu(true);
        } else if (pressed(Key::kEnter)) {
            runner_.request_finish(sim::EndReason::kFinished);
        } else if (pressed(Key::kF1)) {
            overlay_.show_help = !overlay_.show_help;
            help_seen_ = true;
        } else if (!help_seen_ && (input_.left || input_.right || moved())) {
            overlay_.show_help = false;
            help_seen_ = true;
        }
        if (!input_.left) hold_left_ = false;
        before_ = input_;
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
        if (overlay_.menu) {
            hidden_enter_ += seen.presses[enter] - last_enter_;
            hidden_wheel_ += seen.wheel - last_wheel_;
            seen.down.reset();
            seen.left = seen.right = seen.middle = false;
        }
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
        if (!status.warning.empty()) overlay_.notice = status.warning;
        if (notice_until_ > Clock::now()) overlay_.notice = notice_;
        if (notice_until_ <= Clock::now() && status.warning.empty() && overlay_.notice == notice_) {
            overlay_.notice.clear();
        }
        view_.draw(snapshot, overlay_);
        if (snapshot.x.empty()) return;
        if (shots_.due(snapshot.time_s)) shots_.save(view_, snapshot.time_s);
        if (screenshot_asked_) extra_screenshot(snapshot.time_s);
    }

    void extra_screenshot(double time_s) {
        screenshot_asked_ = false;
        try {
            shots_.save_extra(view_, time_s);
            notice_ = "Screenshot saved";
        } catch (const sim::ViewError&) {
            notice_ = "Screenshot could not be saved";
        }
        notice_until_ = Clock::now() + std::chrono::seconds(2);
    }

    curriculum::AttemptRunner& runner_;
    sim::Latest<sim::WindowInput>& published_;
    StatusLine& status_;
    Screenshots shots_;
    sim::OverlayState overlay_;
    sim::FetoscopeView view_;
    sim::WindowInput input_, before_;
    bool help_seen_ = false, hold_left_ = false, screenshot_asked_ = false;
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
