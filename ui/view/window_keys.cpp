// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/window_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdint>
#include <utility>

namespace placode::view {

using sim::Key;
namespace {

// Pedals appear as keyboards (F13, F14); 1 and 2 stand in for them.
constexpr std::pair<int, Key> kKeys[] = {
    {GLFW_KEY_W, Key::kW},
    {GLFW_KEY_A, Key::kA},
    {GLFW_KEY_S, Key::kS},
    {GLFW_KEY_D, Key::kD},
    {GLFW_KEY_Q, Key::kQ},
    {GLFW_KEY_E, Key::kE},
    {GLFW_KEY_R, Key::kR},
    {GLFW_KEY_F, Key::kF},
    {GLFW_KEY_X, Key::kX},
    {GLFW_KEY_C, Key::kC},
    {GLFW_KEY_V, Key::kV},
    {GLFW_KEY_B, Key::kB},
    {GLFW_KEY_SPACE, Key::kSpace},
    {GLFW_KEY_TAB, Key::kTab},
    {GLFW_KEY_LEFT_SHIFT, Key::kShift},
    {GLFW_KEY_RIGHT_SHIFT, Key::kShift},
    {GLFW_KEY_LEFT_CONTROL, Key::kControl},
    {GLFW_KEY_RIGHT_CONTROL, Key::kControl},
    {GLFW_KEY_ENTER, Key::kEnter},
    {GLFW_KEY_KP_ENTER, Key::kEnter},
    {GLFW_KEY_ESCAPE, Key::kEscape},
    {GLFW_KEY_LEFT, Key::kLeft},
    {GLFW_KEY_RIGHT, Key::kRight},
    {GLFW_KEY_UP, Key::kUp},
    {GLFW_KEY_DOWN, Key::kDown},
    {GLFW_KEY_F1, Key::kF1},
    {GLFW_KEY_F2, Key::kF2},
    {GLFW_KEY_F3, Key::kF3},
    {GLFW_KEY_F5, Key::kF5},
    {GLFW_KEY_F12, Key::kF12},
    {GLFW_KEY_G, Key::kG},
    {GLFW_KEY_H, Key::kH},
    {GLFW_KEY_I, Key::kI},
    {GLFW_KEY_J, Key::kJ},
    {GLFW_KEY_K, Key::kK},
    {GLFW_KEY_L, Key::kL},
    {GLFW_KEY_M, Key::kM},
    {GLFW_KEY_N, Key::kN},
    {GLFW_KEY_O, Key::kO},
    {GLFW_KEY_P, Key::kP},
    {GLFW_KEY_T, Key::kT},
    {GLFW_KEY_U, Key::kU},
    {GLFW_KEY_Y, Key::kY},
    {GLFW_KEY_Z, Key::kZ},
    {GLFW_KEY_0, Key::k0},
    {GLFW_KEY_3, Key::k3},
    {GLFW_KEY_4, Key::k4},
    {GLFW_KEY_5, Key::k5},
    {GLFW_KEY_6, Key::k6},
    {GLFW_KEY_7, Key::k7},
    {GLFW_KEY_8, Key::k8},
    {GLFW_KEY_9, Key::k9},
    {GLFW_KEY_COMMA, Key::kComma},
    {GLFW_KEY_PERIOD, Key::kPeriod},
    {GLFW_KEY_SLASH, Key::kSlash},
    {GLFW_KEY_SEMICOLON, Key::kSemicolon},
    {GLFW_KEY_APOSTROPHE, Key::kApostrophe},
    {GLFW_KEY_LEFT_BRACKET, Key::kLeftBracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::kRightBracket},
    {GLFW_KEY_BACKSLASH, Key::kBackslash},
    {GLFW_KEY_GRAVE_ACCENT, Key::kGrave},
    {GLFW_KEY_LEFT_ALT, Key::kAlt},
    {GLFW_KEY_BACKSPACE, Key::kBackspace},
    {GLFW_KEY_INSERT, Key::kInsert},
    {GLFW_KEY_DELETE, Key::kDelete},
    {GLFW_KEY_HOME, Key::kHome},
    {GLFW_KEY_END, Key::kEnd},
    {GLFW_KEY_PAGE_UP, Key::kPageUp},
    {GLFW_KEY_PAGE_DOWN, Key::kPageDown},
    {GLFW_KEY_KP_0, Key::kPad0},
    {GLFW_KEY_KP_1, Key::kPad1},
    {GLFW_KEY_KP_2, Key::kPad2},
    {GLFW_KEY_KP_3, Key::kPad3},
    {GLFW_KEY_KP_4, Key::kPad4},
    {GLFW_KEY_KP_5, Key::kPad5},
    {GLFW_KEY_KP_6, Key::kPad6},
    {GLFW_KEY_KP_7, Key::kPad7},
    {GLFW_KEY_KP_8, Key::kPad8},
    {GLFW_KEY_KP_9, Key::kPad9},
    {GLFW_KEY_F13, Key::kCut},
    {GLFW_KEY_1, Key::kCut},
    {GLFW_KEY_F14, Key::kCoag},
    {GLFW_KEY_2, Key::kCoag},
};

}  // namespace

Key key_of(int code) noexcept {
    for (const auto& [glfw, key] : kKeys)
        if (glfw == code) return key;
    return Key::kCount;
}

char32_t other_letter(const char* name) noexcept {
    if (name == nullptr) return 0;
    const auto byte = [&](int i) { return static_cast<uint8_t>(name[i]); };
    const auto follows = [&](int i) { return (byte(i) & 0xC0U) == 0x80U; };
    if ((byte(0) & 0xE0U) == 0xC0U && follows(1)) return (byte(0) & 0x1FU) << 6 | (byte(1) & 0x3FU);
    if ((byte(0) & 0xF0U) == 0xE0U && follows(1) && follows(2))
        return (byte(0) & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU);
    return 0;
}

}  // namespace placode::view
