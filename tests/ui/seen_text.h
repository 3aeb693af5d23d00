// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a person could read on the screen.

#include <QLabel>
#include <QPlainTextEdit>
#include <QStringList>

namespace placode::ui {

/// All that a person could read of a widget now.
inline QString read_all(const QWidget* widget) {
    QStringList all;
    for (const auto* label : widget->findChildren<QLabel*>())
        if (label->isVisible()) all << label->text();
    for (const auto* edit : widget->findChildren<QPlainTextEdit*>())
        if (edit->isVisible()) all << edit->toPlainText();
    return all.join("\n");
}

}  // namespace placode::ui
