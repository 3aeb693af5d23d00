// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "assessment/tissue_metrics.h"
#include "reports/words.h"

namespace placode::reports {

QString number(double value, int decimals) {
    if (!std::isfinite(value)) return QStringLiteral("-");
    const double scale = std::pow(10.0, decimals);
    if (std::round(value * scale) == 0) value = 0;  // no "-0.0" on paper
    return QString::number(value, 'f', decimals);
}

std::string shortest_text(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest).toStdString();
}

QString metric_number(double value) {
    const double size = std::abs(value);
    if (size == 0) return QStringLiteral("0");
    if (size < 0.1) return number(value, 3);
    if (size < 10) return number(value, 2);
    if (size < 100) return number(value, 1);
    return number(value, 0);
}

QString duration_words(double seconds) {
    const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
    if (whole < 60) return QStringLiteral("%1 s").arg(whole);
    return QStringLiteral("%1:%2 min").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

bool in_minutes(const assessment::MetricDefinition& metric, double value) {
    return metric.unit == "s" && std::lround(value) >= 60;
}

bool is_count(const assessment::MetricDefinition& metric, double value) {
    return metric.unit.empty() && value == std::floor(value) && value < 1e5;
}

bool is_ceiling(const assessment::MetricDefinition& metric, double value) {
    return (metric.id == "placode_peak_cem43_min" && value >= assessment::kLargestDoseMin) ||
           (metric.id == "placode_arrhenius" && value >= assessment::kLargestDamage);
}

QString metric_text(const assessment::MetricDefinition& metric, double value) {
    if (in_minutes(metric, value)) return minute_second(value);
    if (is_ceiling(metric, value)) return QStringLiteral("≥ ") + number(value, 0);
    return is_count(metric, value) ? number(value, 0) : metric_number(value);
}

QString unit_sign(std::string_view unit) {
    if (unit == "C") return QStringLiteral("°C");
    if (unit == "deg") return QStringLiteral("°");
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()))
        .replace("mm3", "mm³")
        .replace("mm2", "mm²")
        .replace("s2", "s²");
}

QString verdict_word(assessment::Verdict verdict) {
    switch (verdict) {
        case assessment::Verdict::kPassed:
            return QStringLiteral("Passed");
        case assessment::Verdict::kNotYet:
            return QStringLiteral("Not yet");
        case assessment::Verdict::kFailed:
            return QStringLiteral("Failed");
        case assessment::Verdict::kNotAttempted:
            return QStringLiteral("Not attempted");
    }
    return {};
}

QString end_word(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kRunning:
            return QStringLiteral("running");
        case sim::EndReason::kFinished:
            return QStringLiteral("finished");
        case sim::EndReason::kTimeLimit:
            return QStringLiteral("time limit");
        case sim::EndReason::kClosed:
            return QStringLiteral("closed");
        case sim::EndReason::kInterrupted:
            return QStringLiteral("interrupted");
    }
    return {};
}

QColor verdict_colour(assessment::Verdict verdict, const ChartStyle& style) {
    switch (verdict) {
        case assessment::Verdict::kPassed:
            return colour(style.good);
        case assessment::Verdict::kNotYet:
            return colour(style.warn);
        case assessment::Verdict::kFailed:
            return colour(style.critical);
        case assessment::Verdict::kNotAttempted:
            return colour(style.muted);
    }
    return colour(style.text);
}

}  // namespace placode::reports
