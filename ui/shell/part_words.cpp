// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, times, verdicts, roles and devices as every page writes them.
#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "db/attempt_counting.h"
#include "reports/text.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// In one context with the words of parts.cpp.
struct PartWords {
    Q_DECLARE_TR_FUNCTIONS(Parts)
};

QDateTime parse_utc(const QString& utc) {
    QDateTime when = QDateTime::fromString(utc, Qt::ISODate);
    when.setTimeSpec(Qt::UTC);
    return when.toLocalTime();
}

/// To the tenth that is shown.
bool is_whole(double points) { return std::lround(points * 10) % 10 == 0; }

}  // namespace

QString format_number(double value, int decimals) {
    // What rounds to nothing has no sign: "-0.0" reads like a loss.
    const double half = 0.5 * std::pow(10.0, -decimals);
    return QLocale().toString(std::abs(value) < half ? 0.0 : value, 'f', decimals);
}

QString format_value(double value) {
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size >= 1e5) return QLocale().toString(value, 'g', 3);
    return format_number(value, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

QString format_duration(double seconds) {
    // One style on the screen and on paper.
    return reports::duration_words(seconds);
}

QString format_when(const std::string& utc) {
    const QDateTime when = parse_utc(qstr(utc));
    return when.isValid() ? QLocale().toString(when, "d MMM yyyy, HH:mm") : qstr(utc);
}

QString format_clock(const QString& utc) {
    const QDateTime when = parse_utc(utc);
    if (!when.isValid()) return utc;
    const bool today = when.date() == QDate::currentDate();
    return QLocale().toString(when, today ? "HH:mm" : "d MMM HH:mm");
}

QString format_points(double points) { return format_number(points, is_whole(points) ? 0 : 1); }

QString points_words(double points) {
    return is_whole(points) ? PartWords::tr("%n point(s)", nullptr, whole_points(points))
                            : PartWords::tr("%1 points", "with a tenth").arg(format_points(points));
}

int whole_points(double points) { return QString::number(points, 'f', 0).toInt(); }

QString verdict_word(const db::AttemptRecord& attempt) {
    // One word for all of them; why it is so stands beside it.
    if (!db::counts(attempt)) return PartWords::tr("Does not count");
    switch (attempt.verdict) {
        case assessment::Verdict::kPassed:
            return PartWords::tr("Passed");
        case assessment::Verdict::kFailed:
            return PartWords::tr("Failed: critical error");
        default:
            return PartWords::tr("Not yet");
    }
}

const char* verdict_tone(const db::AttemptRecord& attempt) {
    if (!db::counts(attempt)) return "";
    switch (attempt.verdict) {
        case assessment::Verdict::kPassed:
            return "good";
        case assessment::Verdict::kFailed:
            return "critical";
        case assessment::Verdict::kNotAttempted:
            return "";
        default:
            return "warn";
    }
}

QString end_word(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kFinished:
            return PartWords::tr("finished");
        case sim::EndReason::kTimeLimit:
            return PartWords::tr("time limit");
        case sim::EndReason::kClosed:
            return PartWords::tr("stopped");
        default:
            return PartWords::tr("interrupted");
    }
}

QString role_names(db::Roles roles) {
    QStringList names;
    if (db::has_role(roles, db::Role::kTrainee)) names << PartWords::tr("Trainee");
    if (db::has_role(roles, db::Role::kEducator)) names << PartWords::tr("Educator");
    if (db::has_role(roles, db::Role::kCoordinator)) names << PartWords::tr("Coordinator");
    if (db::has_role(roles, db::Role::kAdministrator)) names << PartWords::tr("Administrator");
    return names.join(", ");
}

QString device_name(const std::string& device) {
    if (device == "mouse") return PartWords::tr("Mouse");
    if (device == "keyboard") return PartWords::tr("Keyboard");
    if (device == "gamepad") return PartWords::tr("Gamepad");
    // Names of products stay as they are.
    if (device == "spacemouse") return "SpaceMouse";
    if (device == "openhaptics") return "Touch (OpenHaptics)";
    if (device == "haply") return "Haply Inverse3";
    if (device == "avatar") return "Haptic Avatar";
    if (device == "forcedimension") return "Force Dimension";
    if (device == "script:expert") return PartWords::tr("Scripted expert");
    if (device == "script:intermediate") return PartWords::tr("Scripted intermediate");
    if (device == "script:novice") return PartWords::tr("Scripted novice");
    return qstr(device);
}

}  // namespace placode::ui
