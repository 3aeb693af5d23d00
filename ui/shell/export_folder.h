// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports of several files get a folder of their own within the one that was chosen, so that they
// neither lie loose in somebody's home nor replace those of the day before.

#include <QDateTime>
#include <QDir>

namespace placode::ui {

/// "placode_NAME_2026-11-25_0440" in `parent`, with a number behind it where that is there already.
/// Not made yet: whoever writes makes it.
[[nodiscard]] inline QString export_folder(const QString& parent, const QString& name) {
    const QString base = QString("placode_%1_%2")
                             .arg(name, QDateTime::currentDateTime().toString("yyyy-MM-dd_HHmm"));
    const QDir inside(parent);
    QString folder = base;
    for (int n = 2; inside.exists(folder); ++n) folder = QString("%1_%2").arg(base).arg(n);
    return inside.filePath(folder);
}

}  // namespace placode::ui
