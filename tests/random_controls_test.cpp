// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// 10^5 random keys, buttons, clicks and closings in random modes: an attempt ends only by a wish
// that was confirmed, no event is taken twice, every screen can be left.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "ui/attempt/attempt_controls.h"

namespace placode::ui {
namespace THIS_TEST {

using curriculum::AttemptMode;
using sim::Key;
using view::WindowEvent;
using Kind = WindowEvent::Kind;

/// Everything of one window that the test presses at random, and a second opinion on what may end.
class Monkey {
 public:
    Monkey(uint64_t seed, const curriculum::Task& task)
        : random_(seed), panel_(task, {}), controls_(setup(), panel_) {
        controls_.update({}, totals_, pointer_, attempt_s_, now_s_);
    }

    /// One random event. False when the attempt has ended.
    bool act() {
        const WindowEvent event = any();
        now_s_ += below(8) == 0 ? 0.7 : 0.01 * below(30);
        if (!controls_.paused()) attempt_s_ += below(4) == 0 ? 1 : 0;
        if (below(3) == 0) move_pointer();
        // The pointer is looked at first, with nothing pressed.
        controls_.update({}, totals_, pointer_, attempt_s_, now_s_);
        if (controls_.end()) {
            held_ends_ += 1;
            EXPECT_TRUE(held_long()) << "ended by time alone, Enter down since " << enter_since_;
            return false;
        }
        if (held_s() >= 1 + 1e-9 && asks()) {
            held_asks_ += 1;
            EXPECT_EQ(controls_.screen(), Screen::kQuestion);
            enter_since_ = -1;
        }
        const Before before = look();
        controls_.update({event}, totals_, pointer_, attempt_s_, now_s_);
        remember(event, before);
        check_taken_once(event, before);
        if (!controls_.end()) return true;
        confirmed_ends_ += 1;
        EXPECT_TRUE(held_long() || confirmed(event, before))
            << "screen " << static_cast<int>(before.screen) << ", selected " << before.selected;
        return false;
    }

    /// Esc alone leads back to the operation from wherever the monkey is.
    void leave() {
        if (controls_.screen() != Screen::kOperate || panel_.shown()) enter_since_ = -1;
        for (int i = 0; i < 4 && (controls_.screen() != Screen::kOperate || panel_.shown()); ++i) {
            for (const bool down : {true, false})
                controls_.update({{.kind = Kind::kKey, .key = Key::kEscape, .down = down}}, totals_,
                                 pointer_, attempt_s_, now_s_ += 0.05);
        }
        EXPECT_EQ(controls_.screen(), Screen::kOperate);
        EXPECT_FALSE(panel_.shown());
        EXPECT_FALSE(controls_.end());
    }

    static int held_ends_, held_asks_, confirmed_ends_, screens_[4];

 private:
    struct Before {
        Screen screen;
        int selected, items;
        bool panel, typing, may_finish;
        std::bitset<static_cast<size_t>(Key::kCount)> down;
        std::array<uint32_t, static_cast<size_t>(Key::kCount)> presses;
        bool buttons;
    };

    int below(int n) { return static_cast<int>(random_() % static_cast<uint64_t>(n)); }

    ControlsSetup setup() {
        // Practice more often: only there may a key that is held end anything.
        setup_.mode = static_cast<AttemptMode>(std::max(0, below(5) - 2));
        setup_.usual_s = below(2) * 40;
        setup_.least_s = setup_.mode == AttemptMode::kStudy ? below(3) * 15 : 0;
        setup_.help_first = below(2) == 0;
        setup_.window_hands = below(4) != 0;
        return setup_;
    }

    WindowEvent any() {
        switch (below(12)) {
            case 0:
                return {.kind = Kind::kButton,
                        .button = static_cast<uint8_t>(below(3)),
                        .down = below(2) == 0};
            case 1:
                return {.kind = Kind::kLetter, .letter = U"ml+-x\bż"[below(7)]};
            case 2:
                return below(3) == 0 ? WindowEvent{.kind = Kind::kClose}
                                     : WindowEvent{.kind = Kind::kStart, .down = true};
            case 3:
                return {.kind = Kind::kFocus, .down = below(2) == 0};
            case 4:
            case 5:
            case 6:  // the dangerous ones more often
            {
                constexpr Key kMenu[] = {Key::kEnter, Key::kEscape, Key::kUp, Key::kDown, Key::kF1};
                return {.kind = Kind::kKey, .key = kMenu[below(5)], .down = below(3) != 0};
            }
            default:
                return {.kind = Kind::kKey,
                        .key = static_cast<Key>(below(static_cast<int>(Key::kCount))),
                        .down = below(2) == 0};
        }
    }

    void move_pointer() {
        pointer_ = {100.0 * below(4), 100.0 * below(4), below(5) - 1, below(8) - 1};
        // An item that is not there cannot be under the pointer.
        if (pointer_.menu_item >= static_cast<int>(controls_.menu().items.size()))
            pointer_.menu_item = -1;
        totals_.mouse_x += below(200);
        totals_.wheel += below(3) - 1;
    }

    [[nodiscard]] bool asks() const {
        return setup_.mode != AttemptMode::kPractice || attempt_s_ < 0.25 * setup_.usual_s ||
               attempt_s_ < setup_.least_s;
    }

    Before look() {
        ++screens_[static_cast<int>(controls_.screen())];
        const sim::WindowInput& seen = controls_.for_devices();
        return {controls_.screen(),
                controls_.menu().selected,
                static_cast<int>(controls_.menu().items.size()),
                panel_.shown(),
                panel_.typing(),
                !asks(),
                seen.down,
                seen.presses,
                seen.left || seen.right || seen.middle};
    }

    void remember(const WindowEvent& event, const Before& before) {
        if (before.screen != Screen::kOperate || controls_.screen() != Screen::kOperate)
            enter_since_ = -1;
        if (event.kind == Kind::kFocus && !event.down) enter_since_ = -1;
        if (event.kind == Kind::kButton && event.down) enter_since_ = -1;
        if (event.kind != Kind::kKey) return;
        if (event.key == Key::kEnter && event.down && before.screen == Screen::kOperate &&
            !before.panel)
            enter_since_ = now_s_;
        // Enter let go, or anything else pressed.
        if ((event.key == Key::kEnter) != event.down) enter_since_ = -1;
    }

    [[nodiscard]] double held_s() const { return enter_since_ >= 0 ? now_s_ - enter_since_ : 0; }
    [[nodiscard]] bool held_long() const { return held_s() >= 1 - 1e-9 && !asks(); }

    [[nodiscard]] bool confirmed(const WindowEvent& event, const Before& before) const {
        const bool menu = before.screen == Screen::kMenu && before.may_finish;
        if (before.screen != Screen::kQuestion && !menu) return false;
        if (event.kind == Kind::kKey)
            return event.key == Key::kEnter && event.down && before.selected > 0;
        return event.kind == Kind::kButton && event.down && event.button == 0 &&
               pointer_.menu_item > 0;
    }

    /// Either a screen or the instruments, never both; Enter and Start never the instruments.
    void check_taken_once(const WindowEvent& event, const Before& before) {
        const sim::WindowInput& seen = controls_.for_devices();
        EXPECT_EQ(seen.presses[static_cast<size_t>(Key::kEnter)], 0U);
        EXPECT_FALSE(seen.is_down(Key::kEnter));
        EXPECT_EQ(seen.gamepad_buttons, 0);
        const bool screen_took =
            controls_.screen() != before.screen || panel_.shown() != before.panel ||
            panel_.typing() != before.typing || controls_.menu().selected != before.selected ||
            !controls_.take_commands().empty() || !controls_.take_note().empty();
        const bool press = event.down && (event.kind == Kind::kKey || event.kind == Kind::kButton);
        const bool hands_took =
            press && (seen.presses != before.presses ||
                      (!before.buttons && (seen.left || seen.right || seen.middle)));
        EXPECT_FALSE(screen_took && hands_took);
        if (before.screen != Screen::kOperate || before.panel) {
            EXPECT_FALSE(hands_took);
        }
    }

    std::mt19937_64 random_;
    ControlsSetup setup_;
    TuningPanel panel_;
    AttemptControls controls_;
    sim::WindowInput totals_;
    Pointer pointer_;
    double now_s_ = 10, attempt_s_ = 0, enter_since_ = -1;
};
int Monkey::held_ends_ = 0, Monkey::held_asks_ = 0, Monkey::confirmed_ends_ = 0;
int Monkey::screens_[4] = {};

TEST(RandomControls, NothingEndsByAccidentNothingIsTakenTwiceEverythingCanBeLeft) {
    // Presets that the monkey saves belong nowhere.
    const auto folder =
        std::filesystem::temp_directory_path() / ("placode-monkey-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    int left = 100'000;
    for (uint64_t seed = 1; left > 0 && !testing::Test::HasFailure(); ++seed) {
        Monkey monkey(seed, task);
        for (int i = 1; left > 0 && monkey.act(); ++i) {
            --left;
            if (i % 97 == 0) monkey.leave();
        }
        --left;
    }
    std::filesystem::remove_all(folder);
    // The monkey has been everywhere, or it would prove nothing.
    EXPECT_GT(Monkey::held_ends_, 10);
    EXPECT_GT(Monkey::held_asks_, 10);
    EXPECT_GT(Monkey::confirmed_ends_, 100);
    for (const int visits : Monkey::screens_) EXPECT_GT(visits, 1000);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
