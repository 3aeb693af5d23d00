// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/key_button.h"

#include <QFocusEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <algorithm>

#include "haptics/control_words.h"

namespace placode::ui {
namespace {

using sim::Key;

/// Codes of linux/input-event-codes.h; X and Wayland tell them with 8 added. Qt's key where no code
/// is told.
struct KnownKey {
    Key key;
    int code, qt;
};
constexpr KnownKey kKnown[] = {
    {Key::kQ, 16, Qt::Key_Q},
    {Key::kW, 17, Qt::Key_W},
    {Key::kE, 18, Qt::Key_E},
    {Key::kR, 19, Qt::Key_R},
    {Key::kT, 20, Qt::Key_T},
    {Key::kY, 21, Qt::Key_Y},
    {Key::kU, 22, Qt::Key_U},
    {Key::kI, 23, Qt::Key_I},
    {Key::kO, 24, Qt::Key_O},
    {Key::kP, 25, Qt::Key_P},
    {Key::kLeftBracket, 26, Qt::Key_BracketLeft},
    {Key::kRightBracket, 27, Qt::Key_BracketRight},
    {Key::kA, 30, Qt::Key_A},
    {Key::kS, 31, Qt::Key_S},
    {Key::kD, 32, Qt::Key_D},
    {Key::kF, 33, Qt::Key_F},
    {Key::kG, 34, Qt::Key_G},
    {Key::kH, 35, Qt::Key_H},
    {Key::kJ, 36, Qt::Key_J},
    {Key::kK, 37, Qt::Key_K},
    {Key::kL, 38, Qt::Key_L},
    {Key::kSemicolon, 39, Qt::Key_Semicolon},
    {Key::kApostrophe, 40, Qt::Key_Apostrophe},
    {Key::kGrave, 41, Qt::Key_QuoteLeft},
    {Key::kBackslash, 43, Qt::Key_Backslash},
    {Key::kZ, 44, Qt::Key_Z},
    {Key::kX, 45, Qt::Key_X},
    {Key::kC, 46, Qt::Key_C},
    {Key::kV, 47, Qt::Key_V},
    {Key::kB, 48, Qt::Key_B},
    {Key::kN, 49, Qt::Key_N},
    {Key::kM, 50, Qt::Key_M},
    {Key::kComma, 51, Qt::Key_Comma},
    {Key::kPeriod, 52, Qt::Key_Period},
    {Key::kSlash, 53, Qt::Key_Slash},
    {Key::k3, 4, Qt::Key_3},
    {Key::k4, 5, Qt::Key_4},
    {Key::k5, 6, Qt::Key_5},
    {Key::k6, 7, Qt::Key_6},
    {Key::k7, 8, Qt::Key_7},
    {Key::k8, 9, Qt::Key_8},
    {Key::k9, 10, Qt::Key_9},
    {Key::k0, 11, Qt::Key_0},
    {Key::kBackspace, 14, Qt::Key_Backspace},
    {Key::kTab, 15, Qt::Key_Tab},
    {Key::kTab, 15, Qt::Key_Backtab},
    {Key::kControl, 29, Qt::Key_Control},
    {Key::kControl, 97, Qt::Key_Control},
    {Key::kShift, 42, Qt::Key_Shift},
    {Key::kShift, 54, Qt::Key_Shift},
    {Key::kAlt, 56, Qt::Key_Alt},
    {Key::kSpace, 57, Qt::Key_Space},
    {Key::kHome, 102, Qt::Key_Home},
    {Key::kUp, 103, Qt::Key_Up},
    {Key::kPageUp, 104, Qt::Key_PageUp},
    {Key::kLeft, 105, Qt::Key_Left},
    {Key::kRight, 106, Qt::Key_Right},
    {Key::kEnd, 107, Qt::Key_End},
    {Key::kDown, 108, Qt::Key_Down},
    {Key::kPageDown, 109, Qt::Key_PageDown},
    {Key::kInsert, 110, Qt::Key_Insert},
    {Key::kDelete, 111, Qt::Key_Delete},
    {Key::kPad7, 71, 0},
    {Key::kPad8, 72, 0},
    {Key::kPad9, 73, 0},
    {Key::kPad4, 75, 0},
    {Key::kPad5, 76, 0},
    {Key::kPad6, 77, 0},
    {Key::kPad1, 79, 0},
    {Key::kPad2, 80, 0},
    {Key::kPad3, 81, 0},
    {Key::kPad0, 82, 0},
};
constexpr int kToldWith = 8;

}  // namespace

std::optional<Key> simulator_key(const QKeyEvent& event) {
    const QString platform = QGuiApplication::platformName();
    const bool told =
        (platform == "xcb" || platform.startsWith("wayland")) && event.nativeScanCode() > kToldWith;
    const auto* found = std::ranges::find_if(kKnown, [&](const KnownKey& known) {
        return told ? known.code + kToldWith == static_cast<int>(event.nativeScanCode())
                    : known.qt != 0 && known.qt == event.key();
    });
    if (found == std::end(kKnown)) return std::nullopt;
    return found->key;
}

KeyButton::KeyButton(QWidget* parent) : QPushButton(parent) {
    setProperty("role", "secondary");
    setAutoDefault(true);  // Enter presses it
    setMinimumWidth(112);
    connect(this, &QPushButton::clicked, this, [this] { wait(true); });
}

void KeyButton::showKey(Key key, const QString& language) {
    name_ = QString::fromStdString(haptics::key_name_in(key, language.toStdString()));
    wait(false);
}

void KeyButton::wait(bool waiting) {
    waiting_ = waiting;
    setText(waiting ? tr("Press a key…") : name_);
}

bool KeyButton::event(QEvent* event) {
    if (waiting_ && event->type() == QEvent::ShortcutOverride) {
        event->accept();  // Ctrl+K and the like are keys here.
        return true;
    }
    if (waiting_ && event->type() == QEvent::KeyPress) {
        take(static_cast<const QKeyEvent&>(*event));
        event->accept();
        return true;
    }
    // The release of the key that was taken must not press the button again.
    if (event->type() == QEvent::KeyRelease && !isDown()) return true;
    return QPushButton::event(event);
}

void KeyButton::take(const QKeyEvent& event) {
    if (event.isAutoRepeat()) return;
    wait(false);
    if (event.key() == Qt::Key_Escape) return;
    const std::optional<Key> key = simulator_key(event);
    if (key)
        Q_EMIT chosen(*key);
    else
        Q_EMIT refused(QKeySequence(event.key()).toString(QKeySequence::NativeText));
}

void KeyButton::focusOutEvent(QFocusEvent* event) {
    if (waiting_) wait(false);
    QPushButton::focusOutEvent(event);
}

}  // namespace placode::ui
