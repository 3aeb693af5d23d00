// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who operates with an arm, a gamepad or a SpaceMouse touches neither mouse nor keyboard: the
// desktop must not take that for nobody, and darken or lock the screen in the middle of an attempt.

#include <QString>
#include <QVariant>
#include <functional>
#include <memory>

namespace placode::ui {

/// Main thread.
class ScreenAwake {
 public:
    /// Given what was answered; never called where nobody answers.
    using Answered = std::function<void(const QVariant&)>;
    /// Calls a method of the desktop's screen saver, without waiting for it.
    using Call = std::function<void(const QString& method, const QVariantList& arguments,
                                    const Answered& answered)>;
    /// org.freedesktop.ScreenSaver on the session's bus; nothing where there is no bus.
    [[nodiscard]] static Call desktop();

    explicit ScreenAwake(Call call = desktop());
    ~ScreenAwake();
    ScreenAwake(const ScreenAwake&) = delete;
    ScreenAwake& operator=(const ScreenAwake&) = delete;

    /// From now on, until release(). The desktop may show `reason`.
    void keep(const QString& reason);
    void release();

 private:
    struct Wish;
    Call call_;
    std::shared_ptr<Wish> wish_;  ///< Null: the screen may go dark.
};

}  // namespace placode::ui
