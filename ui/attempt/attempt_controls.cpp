// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/attempt_controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace placode::ui {

namespace {

using curriculum::AttemptMode;
using sim::EndReason;
using sim::Key;
using sim::PauseCause;
using view::WindowEvent;
using Kind = view::WindowEvent::Kind;

constexpr double kMeantCounts = 400;  // enough motion to mean it
constexpr uint16_t kPadStart = 1U << 7;

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
    if (first_) last_totals_ = totals;
    first_ = false;
    left_operating_ = paused();
    hover(pointer);
    for (const WindowEvent& event : events) {
        if (end_) break;
        take(event);
        left_operating_ = left_operating_ || paused();
    }
    if (!end_) watch_hold();
    if (first_help_ && screen_ == Screen::kHelp) {
        moved_ += std::abs(totals.mouse_x - last_totals_.mouse_x) +
                  std::abs(totals.mouse_y - last_totals_.mouse_y);
        // A gamepad's sticks and buttons come as states.
        const bool pad = std::any_of(totals.gamepad_axis.begin(), totals.gamepad_axis.begin() + 4,
                                     [](float axis) { return std::abs(axis) > 0.5F; }) ||
                         totals.gamepad_buttons != 0;
        if (moved_ > kMeantCounts || (totals.gamepad && pad))
            show(Screen::kOperate, PauseCause::kHelp);
    }
    publish(totals, !left_operating_);
}

/// One event, for one screen.
void AttemptControls::take(const WindowEvent& event) {
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
    if (event.kind == Kind::kFocus) {
        if (event.down) return;
        held_since_s_.reset();
        hands_off();
        if (setup_.window_hands && screen_ == Screen::kOperate && attempt_s_ > 0)
            open_menu("Paused: another window is in front", PauseCause::kFocus);
        return;
    }
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
        if (event.key == Key::kEnter && std::exchange(held_since_s_, std::nullopt))
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
            hand_key(event.key);
            break;
    }
}

void AttemptControls::hand_key(Key key) {
    const Key does = setup_.layout.does(key);
    if (does == Key::kCount) return;
    // Where nothing was chosen it is the letter that counts, below.
    if (does == Key::kL || does == Key::kM) {
        if (key != does) commands_.push_back(does == Key::kL ? Command::kWipeLens : Command::kMute);
        return;
    }
    held_.set(at(does));
    tapped_.set(at(does));
    ++devices_.presses[at(does)];
}

/// Letters that mean something wherever the keyboard puts them, unless their key does something
/// else: sound and lens.
void AttemptControls::letter(char32_t code) {
    const auto usual = [this](Key key) { return setup_.layout.does(key) == key; };
    if ((code == U'm' || code == U'M') && usual(Key::kM)) commands_.push_back(Command::kMute);
    if (code == U'+') commands_.push_back(Command::kLouder);
    if (code == U'-') commands_.push_back(Command::kSofter);
    if ((code == U'l' || code == U'L') && usual(Key::kL)) commands_.push_back(Command::kWipeLens);
}

void AttemptControls::watch_hold() {
    holding_ = 0;
    if (!held_since_s_) return;
    if (paused()) return held_since_s_.reset();
    holding_ = std::clamp((now_s_ - *held_since_s_) / kHoldS, 0.0, 1.0);
    if (holding_ < 1) return;
    held_since_s_.reset();
    holding_ = 0;
    // What a protocol does not count is worth a question, however long the key is held.
    if (too_short()) return ask(Question::kFinish, PauseCause::kMenu);
    end_ = EndReason::kFinished;
}

void AttemptControls::show(Screen screen, PauseCause cause) {
    screen_ = screen;
    cause_ = cause;
    menu_.shown = screen == Screen::kMenu || screen == Screen::kQuestion;
    first_help_ = false;
    held_since_s_.reset();
    hands_off();
}

/// What is held stays held for nobody: after a menu everything has to be pressed anew.
void AttemptControls::hands_off() {
    held_.reset();
    tapped_.reset();
    buttons_.reset();
    clicked_.reset();
}

void AttemptControls::publish(const sim::WindowInput& totals, bool operating) {
    const double wheel = totals.wheel - last_totals_.wheel;
    const double x = totals.mouse_x - last_totals_.mouse_x;
    const double y = totals.mouse_y - last_totals_.mouse_y;
    last_totals_ = totals;
    if (operating) {
        devices_.wheel += wheel;
        devices_.mouse_x += x;
        devices_.mouse_y += y;
    } else {
        hands_off();
    }
    // What was pressed and let go between two pictures is seen for one of them.
    devices_.down = held_ | tapped_;
    for (const Key key : {Key::kShift, Key::kControl})
        devices_.down.set(at(key), operating && haptics::is_down(totals, setup_.layout, key));
    const size_t first = setup_.layout.buttons_exchanged ? 1 : 0;
    devices_.left = buttons_[first] || clicked_[first];
    devices_.right = buttons_[1 - first] || clicked_[1 - first];
    devices_.middle = buttons_[2] || clicked_[2];
    tapped_.reset();
    clicked_.reset();
    devices_.focused = totals.focused;
    devices_.gamepad = totals.gamepad;
    devices_.gamepad_axis = totals.gamepad_axis;
    if (setup_.layout.sticks_exchanged)
        for (const size_t axis : {0, 1})
            std::swap(devices_.gamepad_axis[axis], devices_.gamepad_axis[axis + 2]);
    devices_.gamepad_buttons = totals.gamepad_buttons & static_cast<uint16_t>(~kPadStart);
    if (!operating) {
        // Triggers rest at -1.
        devices_.gamepad_axis = {0, 0, 0, 0, -1, -1};
        devices_.gamepad_buttons = 0;
    }
    devices_.t_ns = totals.t_ns;
}

}  // namespace placode::ui
