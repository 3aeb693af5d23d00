// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A day as people read it: the month as a word, because 06/12 is June to some and December to
// others.

#include <QDate>
#include <QLocale>
#include <QRegularExpression>
#include <string>

namespace placode::ui {

inline constexpr const char* kDayFormat = "d MMM yyyy";

/// Of an ISO 8601 time or day; a dash when there is none.
[[nodiscard]] inline QString day_text(const std::string& utc) {
    const QDate day = QDate::fromString(QString::fromStdString(utc).left(10), Qt::ISODate);
    return day.isValid() ? QLocale().toString(day, kDayFormat) : QStringLiteral("–");
}

/// A sentence of the engine, whose days are ISO 8601.
[[nodiscard]] inline QString with_day_words(QString sentence) {
    static const QRegularExpression kDay("\\b\\d{4}-\\d{2}-\\d{2}\\b");
    QRegularExpressionMatch found = kDay.match(sentence);
    while (found.hasMatch()) {
        const QString words = day_text(found.captured().toStdString());
        sentence.replace(found.capturedStart(), found.capturedLength(), words);
        found = kDay.match(sentence, found.capturedStart() + words.size());
    }
    return sentence;
}

}  // namespace placode::ui
