// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A day as people read it: the month as a word, because 06/12 is June to some and December to
// others.

#include <QDate>
#include <QLocale>
#include <string>

namespace placode::ui {

inline constexpr const char* kDayFormat = "d MMM yyyy";

/// Of an ISO 8601 time or day; a dash when there is none.
[[nodiscard]] inline QString day_text(const std::string& utc) {
    const QDate day = QDate::fromString(QString::fromStdString(utc).left(10), Qt::ISODate);
    return day.isValid() ? QLocale().toString(day, kDayFormat) : QStringLiteral("–");
}

}  // namespace placode::ui
