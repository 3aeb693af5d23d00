// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button that shows a key of the simulator's window and, once pressed, takes the next key.

#include <QPushButton>
#include <optional>

#include "haptics/control_layout.h"

class QKeyEvent;

namespace placode::ui {

/// The simulator's key of a key press, by the place on the keyboard where the desktop tells it, as
/// the simulator's own window does; nothing for keys that it does not know.
[[nodiscard]] std::optional<sim::Key> simulator_key(const QKeyEvent& event);

class KeyButton : public QPushButton {
    Q_OBJECT
 public:
    explicit KeyButton(QWidget* parent = nullptr);
    /// What stands on it.
    void showKey(sim::Key key, const QString& language);
    [[nodiscard]] bool waiting() const { return waiting_; }

 Q_SIGNALS:
    void chosen(placode::sim::Key key);
    void refused(const QString& key);  ///< A key that is nobody's to choose.

 protected:
    bool event(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

 private:
    void wait(bool waiting);
    void take(const QKeyEvent& event);

    QString name_;
    bool waiting_ = false;
};

}  // namespace placode::ui
