// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Keys, buttons and pointer of an attempt's window: which screen each of them is for, and what ends
// the attempt. Every event is taken by one screen alone: the press that leaves a menu is not seen
// by the instruments. Pure logic, no window: a test presses everything.

#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/conduct.h"
#include "haptics/control_layout.h"
#include "sim/core/event.h"
#include "sim/step/recording.h"
#include "ui/attempt/tuning_panel.h"
#include "ui/view/overlay.h"
#include "ui/view/window_event.h"

namespace placode::ui {

enum class Screen : uint8_t { kOperate, kHelp, kMenu, kQuestion };

/// What a key asks of the session beside the screens.
enum class Command : uint8_t {
    kScreenshot,
    kWipeLens,
    kMute,
    kLouder,
    kSofter,
    kGuide,
    kPerformance
};

struct ControlsSetup {
    curriculum::AttemptMode mode = curriculum::AttemptMode::kPractice;
    bool planned_line = true;  ///< F5 may show it.
    double usual_s = 0;        ///< What the attempt usually takes; 0 = not known.
    double least_s = 0;        ///< A study's least duration; 0 = none.
    bool help_first = false;   ///< Begin with the help.
    bool gamepad = false;      ///< The hands are a gamepad: without it the attempt stands still.
    bool window_hands = true;  ///< Without the focus hands stand still, and the attempt pauses.
    std::string language = "en";
    haptics::ControlLayout layout;  ///< Which key and button does what for the hands.
};

/// Where the pointer is, while it is free.
struct Pointer {
    double x = -1, y = -1;  ///< [px]
    int menu_item = -1, tuning_item = -1;
};

/// Main thread.
class AttemptControls {
 public:
    /// `panel` must outlive it.
    AttemptControls(ControlsSetup setup, TuningPanel& panel);

    /// What happened since the last call, in order. `totals` is the window's state after it,
    /// `attempt_s` the simulated time (0: not begun), `now_s` a clock that only grows.
    void update(const view::WindowEvents& events, const sim::WindowInput& totals,
                const Pointer& pointer, double attempt_s, double now_s);

    /// A pause that nobody pressed a key for: the device is gone, the computer slept. Only
    /// once the attempt has begun.
    void interrupt(const char* title, sim::PauseCause cause);

    /// How the attempt is to end; set once, by a confirmed wish.
    [[nodiscard]] std::optional<sim::EndReason> end() const { return end_; }
    [[nodiscard]] Screen screen() const { return screen_; }
    /// Simulated time stands still: behind every screen, and behind the tuning panel.
    [[nodiscard]] bool paused() const { return screen_ != Screen::kOperate || panel_.shown(); }
    [[nodiscard]] sim::PauseCause pause_cause() const { return cause_; }
    [[nodiscard]] bool captures_pointer() const;
    /// What the devices see: nothing of what was meant for a screen, and never Enter or Start.
    [[nodiscard]] const sim::WindowInput& for_devices() const { return devices_; }
    [[nodiscard]] const view::MenuOverlay& menu() const { return menu_; }
    /// How much of the second is over for which Enter ends the attempt, 0..1.
    [[nodiscard]] double holding() const { return holding_; }
    [[nodiscard]] std::vector<Command> take_commands();
    /// A short note in English, empty = none. Taken once.
    [[nodiscard]] std::string take_note();

    static constexpr double kHoldS = 1.0;

 private:
    enum class Question : uint8_t { kFinish, kLeave, kClose };

    void take(const view::WindowEvent& event);
    void operate(const view::WindowEvent& event);
    void operate_key(const view::WindowEvent& event);
    void hand_key(sim::Key key, char32_t types);
    void letter(char32_t code);
    [[nodiscard]] bool panel_takes(const view::WindowEvent& event);
    void menu_key(const view::WindowEvent& event);
    void refuse(sim::Key key);
    /// Why not, as a note (English); nullptr where it may be had.
    [[nodiscard]] const char* no_tuning() const;
    [[nodiscard]] const char* no_help() const;
    void choose();
    void show(Screen screen, sim::PauseCause cause);
    void open_menu(const char* title, sim::PauseCause cause);
    void ask(Question question, sim::PauseCause cause);
    void finish_or_ask();
    void watch_hold();
    void hover(const Pointer& pointer);
    void publish(const sim::WindowInput& totals, bool operating);
    void hands_off();
    void out_of_sight(const view::WindowEvent& event);
    [[nodiscard]] bool too_short() const;  ///< For the study's protocol.
    [[nodiscard]] bool early() const;      ///< Less than a quarter of its usual time.
    [[nodiscard]] std::string say(const std::string& english) const;
    [[nodiscard]] std::vector<std::string> warnings(Question question) const;

    ControlsSetup setup_;
    const curriculum::Conduct& conduct_;
    TuningPanel& panel_;
    Screen screen_ = Screen::kOperate;
    sim::PauseCause cause_ = sim::PauseCause::kMenu;
    Question question_ = Question::kFinish;
    std::optional<sim::EndReason> end_;
    view::MenuOverlay menu_;
    std::vector<Command> commands_;
    std::string note_;
    // Enter, held while operating.
    std::optional<double> held_since_s_;
    double holding_ = 0, now_s_ = 0, attempt_s_ = 0;
    // Pointer in a menu: an item is under it only once it has moved there.
    Pointer pointer_;
    std::optional<Pointer> anchor_;
    // What was given to the devices.
    sim::WindowInput devices_, last_totals_;
    std::bitset<static_cast<size_t>(sim::Key::kCount)> held_, tapped_;
    std::bitset<3> buttons_, clicked_;
    uint16_t spent_pad_ = 0;  ///< Buttons of the pad that were down behind a screen.
    bool struck_ = true;      ///< A key went down since L or M was typed.
    bool first_ = true, left_operating_ = false, focused_ = true;
    double moved_ = 0;  // of the pointer since the first help was shown [counts]
    bool first_help_ = false;
};

}  // namespace placode::ui
