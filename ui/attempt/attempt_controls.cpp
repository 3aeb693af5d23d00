// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/attempt_controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace placode::ui {

namespace {

using sim::EndReason;
using sim::Key;
using sim::PauseCause;
using view::WindowEvent;
using Kind = view::WindowEvent::Kind;

constexpr double kMeantCounts = 400;  // enough motion to mean it

constexpr size_t at(Key key) { return static_cast<size_t>(key); }

/// Held like a pedal, not struck: what they mean does not begin with a press.
constexpr bool is_modifier(Key does) { return does == Key::kShift || does == Key::kControl; }

}  // namespace

AttemptControls::AttemptControls(ControlsSetup setup, TuningPanel& panel)
    : setup_(std::move(setup)), conduct_(curriculum::conduct_of(setup_.mode)), panel_(panel) {
    if (!setup_.help_first) return;
    show(Screen::kHelp, PauseCause::kHelp);
    first_help_ = true;
}

bool AttemptControls::captures_pointer() const {
    return screen_ != Screen::kMenu && screen_ != Screen::kQuestion && !panel_.shown();
}

std::vector<Command> AttemptControls::take_commands() { return std::exchange(commands_, {}); }
std::string AttemptControls::take_note() { return std::exchange(note_, {}); }

void AttemptControls::update(const view::WindowEvents& events, const sim::WindowInput& totals,
                             const Pointer& pointer, double attempt_s, double now_s) {
    now_s_ = now_s;
    attempt_s_ = attempt_s;
    focused_ = totals.focused;
    if (first_) last_totals_ = totals;
    first_ = false;
    left_operating_ = paused();
    hover(pointer);
    for (const WindowEvent& event : events) {
        if (end_) break;
        take(event);
        left_operating_ = left_operating_ || paused();
    }
    if (!end_ && setup_.gamepad && !totals.gamepad)
        interrupt("Paused: the gamepad is gone", PauseCause::kDevice);
    left_operating_ = left_operating_ || paused();
    if (!end_) watch_hold();
    if (first_help_ && screen_ == Screen::kHelp) {
        moved_ += std::abs(totals.mouse_x - last_totals_.mouse_x) +
                  std::abs(totals.mouse_y - last_totals_.mouse_y);
        // A gamepad's sticks and buttons come as states.
        const bool pad = std::any_of(totals.gamepad_axis.begin(), totals.gamepad_axis.begin() + 4,
                                     [](float axis) { return std::abs(axis) > 0.5F; }) ||
                         totals.gamepad_buttons != 0;
        if (moved_ > kMeantCounts || (totals.gamepad && totals.focused && pad))
            show(Screen::kOperate, PauseCause::kHelp);
    }
    publish(totals, !left_operating_);
}

/// One event, for one screen.
void AttemptControls::take(const WindowEvent& event) {
    if (event.kind == Kind::kKey && event.down) struck_ = true;
    if (event.kind == Kind::kKey && !event.down) {
        const Key does = setup_.layout.does(event.key);
        if (does != Key::kCount) held_.reset(at(does));
    }
    if (event.kind == Kind::kButton && !event.down && event.button < 3)
        buttons_.reset(event.button);
    // Whoever presses something else meanwhile does not mean to end.
    if (event.down &&
        ((event.kind == Kind::kKey && event.key != Key::kEnter) || event.kind == Kind::kButton))
        held_since_s_.reset();
    if (event.kind == Kind::kClose) {
        // A second wish to close changes nothing: the question stands.
        if (screen_ != Screen::kQuestion) ask(Question::kClose, PauseCause::kClosing);
        return;
    }
    if (event.kind == Kind::kFocus || event.kind == Kind::kHidden) return out_of_sight(event);
    // A pad is heard without the focus, too: there it may pause, never go on.
    if (event.kind == Kind::kStart && !focused_ && paused()) return;
    switch (screen_) {
        case Screen::kOperate:
            if (!panel_takes(event)) operate(event);
            break;
        case Screen::kHelp:
            // Who presses Escape before anything was done wants the pointer back, not to operate.
            if (first_help_ && event.kind == Kind::kKey && event.down &&
                event.key == Key::kEscape) {
                open_menu("Paused", PauseCause::kMenu);
                break;
            }
            // Any press leaves it, and does nothing else.
            if ((event.kind == Kind::kKey && event.down &&
                 !is_modifier(setup_.layout.does(event.key))) ||
                (event.kind == Kind::kButton && event.down) || event.kind == Kind::kStart)
                show(Screen::kOperate, PauseCause::kHelp);
            break;
        case Screen::kMenu:
        case Screen::kQuestion:
            menu_key(event);
            break;
    }
}

/// Hands on a mouse or SpaceMouse stand still while another window is in front; an arm goes on.
/// Nobody operates in a window that is minimised: whatever the device, there is no force and no
/// clock.
void AttemptControls::out_of_sight(const WindowEvent& event) {
    if (event.kind == Kind::kFocus && event.down) return;
    held_since_s_.reset();
    hands_off();
    if (screen_ != Screen::kOperate || attempt_s_ <= 0) return;
    if (event.kind == Kind::kHidden)
        open_menu("Paused", PauseCause::kFocus);
    else if (setup_.window_hands)
        open_menu("Paused: another window is in front", PauseCause::kFocus);
}

void AttemptControls::interrupt(const char* title, PauseCause cause) {
    if (screen_ != Screen::kOperate || attempt_s_ <= 0) return;
    held_since_s_.reset();
    hands_off();
    open_menu(title, cause);
}

/// F2 and what belongs to the panel. True when nothing else shall see the event.
bool AttemptControls::panel_takes(const WindowEvent& event) {
    const bool press = event.down && (event.kind == Kind::kKey || event.kind == Kind::kButton);
    if (press && event.kind == Kind::kKey && event.key == Key::kF2) {
        if (const char* why = no_tuning()) {
            note_ = why;
            return true;
        }
        panel_.toggle();
        cause_ = PauseCause::kMenu;
        hands_off();
        return true;
    }
    if (!panel_.shown()) return false;
    if (event.kind == Kind::kLetter && panel_.typing()) {
        view::WindowEvent copy = event;
        std::string text;  // UTF-8 of one code point of the basic plane
        const auto code = static_cast<uint32_t>(copy.letter);
        if (code < 0x80) {
            text += static_cast<char>(code);
        } else if (code < 0x800) {
            text += static_cast<char>(0xC0 | (code >> 6));
            text += static_cast<char>(0x80 | (code & 0x3F));
        } else {
            text += static_cast<char>(0xE0 | (code >> 12));
            text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
            text += static_cast<char>(0x80 | (code & 0x3F));
        }
        panel_.type(text);
        return true;
    }
    if (event.kind == Kind::kKey && press && panel_.key(event.key)) return true;
    // The hands stand still: whatever the panel does not know goes to nobody.
    if (event.kind == Kind::kButton && press && event.button == 0)
        panel_.click(pointer_.tuning_item);
    return event.kind != Kind::kLetter;
}

void AttemptControls::operate(const WindowEvent& event) {
    switch (event.kind) {
        case Kind::kKey:
            operate_key(event);
            break;
        case Kind::kButton:
            if (!event.down || event.button >= 3) break;
            buttons_.set(event.button);
            clicked_.set(event.button);
            break;
        case Kind::kLetter:
            letter(event.letter);
            break;
        case Kind::kStart:
            open_menu("Paused", PauseCause::kMenu);
            break;
        default:
            break;
    }
}

void AttemptControls::operate_key(const WindowEvent& event) {
    if (!event.down) {
        // Enter that was only touched asks instead.
        if (event.key == Key::kEnter && std::exchange(held_since_s_, std::nullopt) && !event.unseen)
            ask(Question::kFinish, PauseCause::kMenu);
        return;
    }
    switch (event.key) {
        case Key::kEnter:
            held_since_s_ = now_s_;
            break;
        case Key::kEscape:
            open_menu("Paused", PauseCause::kMenu);
            break;
        case Key::kF1:
            if (const char* why = no_help())
                note_ = why;
            else
                show(Screen::kHelp, PauseCause::kHelp);
            break;
        case Key::kF3:
            if (conduct_.performance) commands_.push_back(Command::kPerformance);
            break;
        case Key::kF5:
            if (setup_.planned_line) commands_.push_back(Command::kGuide);
            break;
        case Key::kF12:
            if (conduct_.screenshots) commands_.push_back(Command::kScreenshot);
            break;
        case Key::kF2:
            break;
        default:
            hand_key(event.key, event.letter);
            break;
    }
}

void AttemptControls::watch_hold() {
    holding_ = 0;
    if (!held_since_s_) return;
    if (paused()) return held_since_s_.reset();
    holding_ = std::clamp((now_s_ - *held_since_s_) / kHoldS, 0.0, 1.0);
    if (holding_ < 1) return;
    held_since_s_.reset();
    holding_ = 0;
    // A key may be held by a book or a sleeve: it ends alone only what the menu ends without
    // asking.
    cause_ = PauseCause::kMenu;
    finish_or_ask();
}

void AttemptControls::show(Screen screen, PauseCause cause) {
    screen_ = screen;
    cause_ = cause;
    menu_.shown = screen == Screen::kMenu || screen == Screen::kQuestion;
    first_help_ = false;
    held_since_s_.reset();
    hands_off();
}

}  // namespace placode::ui
