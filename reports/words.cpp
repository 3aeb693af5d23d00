// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace placode::reports {
namespace {

using sim::EventKind;

constexpr const char* kPatterns[]{
    "Energy was on for {value} s while touching the placode{where}.",
    "More than 2 % of the placode was burned.",
    "No piece of tissue was taken out.",
    "Only {value} % of the marked tissue is out.",
    "The force on the tissue was too high {times}, worst{where}.",
    "The instrument stayed {value} s on the placode{where}.",
    "The needle rested {value} s with energy on one spot{where}.",
    "The pedal was pressed in the air for over 1 s, {times}.",
    "The placode is free over {value} degrees only.",
    "The placode was burned{where}: {value} % of its volume is beyond the injury dose.",
    "The placode was overheated{where}.",
    "The placode was pressed with {value} mN{where}; 20 mN is the limit.",
    "The placode was touched {times}, first{where}.",
    "The ring is {value} % complete; the largest gap is{where}.",
    "The ring was left open: only {value} % is cut through.",
    "The scissors cut {value} mm2 of skin{where}.",
    "The scissors cut {value} mm2 of the placode{where}.",
    "The tissue was pulled too hard {times}{where}.",
    "Tissue slid out of the jaws {times}{where}.",
    "Tissue was crushed between the jaws {times}{where}.",
    "Tissue was grasped {value} times; three places were the goal.",
    "Tissue was held lifted for {value} s; three times 3 s was the goal.",
    "{value} mm of the incision came within 0.5 mm of the placode{where}.",
    "{value} mm of the incision left the planned line by more than 0.5 mm{where}.",
    "{value} mm of the incision went more than 1 mm into healthy skin{where}.",
    "{value} mm3 of skin tore{where}.",
    "{value} mm3 of the placode was cut{where}.",
    "{value} s is more than the target time.",
    "{value} % of the steps were done.",
    "Tissue was touched beside the marked place {times}.",
    "{value} % of the places were touched.",
    "The first touch was {value} mm beside the centre on average.",
    "The tissue was pressed with up to {value} mN{where}; 100 mN is enough.",
    "The tip was out of view for {value} s.",
    "{value} % of the line was followed within 1 mm.",
    "The tip was {value} mm beside the line on average.",
    "In places the tip was {value} mm beside the line.",
    "The tissue was pulled with up to {value} mN{where}; 25 mN is the limit.",
    "{value} mm3 of tissue tore{where}.",
    "Tissue was grasped {value} times; four are enough.",
    "Tissue or generator was tuned: this attempt is not scored as a pass.",
    "{value} % of the ring is cut, and points are given for that share; the largest gap is{where}.",
    "{value} % of the steps were done, and points are given for that share.",
    "{value} % of the places were touched, and points are given for that share.",
    "{value} % of the line was followed within 1 mm, and points are given for that share.",
    "The placode is free over {value} degrees, and points are given for that share; it still hangs "
    "on{where}.",
    "The placode is not released: it is free over {value} of 360 degrees only.",
    "{value} % of the marked tissue is gone, and points are given for that share; most of the rest "
    "hangs{where}.",
    "More than 15 % of the marked tissue was left behind.",
    "Tissue was held lifted for {value} s of 9 s, and points are given for that share.",
    "Tissue was grasped {value} times of three, and points are given for that share.",
    "More than 5 mm3 of skin tore.",
    "Tissue was held beyond its limit of stretch: {value} mm3 s, most{where}.",
    "The tip was below the surface for {value} s{where}.",
    "Not recorded, so this is no pass: {metric}.",
    "It could not be measured and counts in full: {metric}.",
    "Nothing was done: this attempt does not count.",
};

QString translated(const char* context, const char* english) {
    return QCoreApplication::translate(context, english);
}

/// The pattern as a regular expression with named groups.
QRegularExpression expression_of(const char* pattern) {
    QString text = QRegularExpression::escape(QString::fromUtf8(pattern));
    text.replace(QStringLiteral("\\{value\\}"),
                 QStringLiteral("(?<value>-?[0-9.]+(e[+-]?[0-9]+)?|inf|nan)"));
    text.replace(QStringLiteral("\\{times\\}"), QStringLiteral("(?<times>once|twice|\\d+ times)"));
    text.replace(QStringLiteral("\\{where\\}"), QStringLiteral("( at (?<hour>\\d+) o'clock)?"));
    text.replace(QStringLiteral("\\{metric\\}"), QStringLiteral("(?<metric>.+)"));
    return QRegularExpression(QStringLiteral("^") + text + QStringLiteral("$"));
}

QString times_words(const QString& english) {
    if (english == QLatin1String("once")) return translated("Reason", "once");
    if (english == QLatin1String("twice")) return translated("Reason", "twice");
    return translated("Reason", "%1 times").arg(english.section(QLatin1Char(' '), 0, 0));
}

QString local(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

/// A number as a reason has it, with the decimal sign of the language; beyond a million as it is.
QString local_number(const QString& said) {
    if (said.contains(QLatin1Char('e')) || said.contains(QLatin1Char('n'))) return said;
    const qsizetype dot = said.indexOf(QLatin1Char('.'));
    return local(said.toDouble(), dot < 0 ? 0 : static_cast<int>(said.size() - dot - 1));
}

QString seconds(double s) { return translated("Ledger", "%1 s").arg(local(s, 1)); }
QString millinewton(double n) {
    return translated("Ledger", "at most %1 mN").arg(local(1000 * n, 0));
}
QString celsius(double c) { return translated("Ledger", "%1 °C").arg(local(c, 0)); }

QString cubic(double m3) { return QStringLiteral("%1 mm³").arg(local(1e9 * m3, 2)); }
QString square(double m2) { return QStringLiteral("%1 mm²").arg(local(1e6 * m2, 1)); }

/// What happened, without numbers.
const char* deed_of(const assessment::LedgerEntry& entry) {
    const bool placode = entry.lane == assessment::HarmLane::kPlacode;
    switch (entry.kind) {
        case EventKind::kPlacodeContact:
            return "Placode touched";
        case EventKind::kPlacodeEnergised:
            return "Placode touched with energy on";
        case EventKind::kPlacodeOverheated:
            return "Placode overheated";
        case EventKind::kPlacodeBurned:
            return "Placode burned";
        case EventKind::kPlacodeCut:
            return "Placode cut by scissors";
        case EventKind::kOverForce:
            return "Too much force";
        case EventKind::kOverTraction:
            return "Pulled too hard";
        case EventKind::kCrushed:
            return "Crushed between the jaws";
        case EventKind::kSlipped:
            return "Slid out of the jaws";
        case EventKind::kBuried:
            return "Tip below the surface";
        case EventKind::kTorn:
            return placode ? "Placode torn" : "Skin torn";
        case EventKind::kVaporised:
            return placode ? "Placode cut by heat" : "Cut into healthy skin";
        case EventKind::kSnipped:
            return placode ? "Placode cut by scissors" : "Skin cut by scissors";
        case EventKind::kEnergyInAir:
            return "Energy in the air";
        default:
            return "Resting on one spot with energy on";
    }
}

QString numbers_of(const assessment::LedgerEntry& entry) {
    switch (entry.kind) {
        case EventKind::kPlacodeContact:
        case EventKind::kOverForce:
        case EventKind::kOverTraction:
            return seconds(entry.value) + QStringLiteral(", ") + millinewton(entry.value2);
        case EventKind::kPlacodeEnergised:
        case EventKind::kEnergyInAir:
        case EventKind::kDwell:
            return seconds(entry.value);
        case EventKind::kBuried:
            return seconds(entry.value) +
                   QStringLiteral(", %1 mm").arg(local(1000 * entry.value2, 1));
        case EventKind::kPlacodeOverheated:
        case EventKind::kPlacodeBurned:
            return celsius(entry.value2);
        case EventKind::kPlacodeCut:
        case EventKind::kSnipped:
            return square(entry.value);
        case EventKind::kCrushed:
            return QStringLiteral("%1 kPa").arg(local(entry.value / 1000, 0));
        case EventKind::kSlipped:
            return QStringLiteral("%1 mm").arg(local(1000 * entry.value, 1));
        default:
            return cubic(entry.value);
    }
}

}  // namespace

QString figure_word(const char* english) { return translated("Figure", english); }

std::vector<std::string> reason_patterns() { return {std::begin(kPatterns), std::end(kPatterns)}; }

QString reason_words(const std::string& english) {
    const QString said = QString::fromStdString(english);
    for (const char* pattern : kPatterns) {
        const QString other = translated("Reason", pattern);
        if (other == QLatin1String(pattern)) continue;
        const QRegularExpressionMatch match = expression_of(pattern).match(said);
        if (!match.hasMatch()) continue;
        QString text = other;
        const QString value = match.captured(QStringLiteral("value"));
        if (!value.isEmpty()) text.replace(QLatin1String("{value}"), local_number(value));
        const QString times = match.captured(QStringLiteral("times"));
        if (!times.isEmpty()) text.replace(QLatin1String("{times}"), times_words(times));
        const QString metric = match.captured(QStringLiteral("metric"));
        if (!metric.isEmpty())
            text.replace(QLatin1String("{metric}"),
                         translated("Metric", metric.toUtf8().constData()));
        const QString hour = match.captured(QStringLiteral("hour"));
        text.replace(QLatin1String("{where}"),
                     hour.isEmpty() ? QString() : translated("Reason", " at %1 o'clock").arg(hour));
        return text.replace(QLatin1String("mm2"), QStringLiteral("mm²"))
            .replace(QLatin1String("mm3"), QStringLiteral("mm³"));
    }
    return QString(said)
        .replace(QLatin1String("mm2"), QStringLiteral("mm²"))
        .replace(QLatin1String("mm3"), QStringLiteral("mm³"));
}

QString ledger_words(const assessment::LedgerEntry& entry) {
    return translated("Ledger", deed_of(entry)) + QStringLiteral(", ") + numbers_of(entry);
}

QString place_words(const assessment::LedgerEntry& entry) {
    if (!entry.has_place) return {};
    return translated("Ledger", "%1 o'clock").arg(entry.hour) + QStringLiteral(", ") +
           region_words(entry.region);
}

QString region_words(assessment::Region region) {
    switch (region) {
        case assessment::Region::kPlacode:
            return figure_word("placode");
        case assessment::Region::kZone:
            return figure_word("junctional zone");
        case assessment::Region::kSkin:
            return figure_word("skin");
    }
    return {};
}

QString phase_words(sim::Phase phase) {
    switch (phase) {
        case sim::Phase::kInspect:
            return figure_word("Inspect");
        case sim::Phase::kIncise:
            return figure_word("Incise");
        case sim::Phase::kRelease:
            return figure_word("Release");
        case sim::Phase::kResect:
            return figure_word("Resect");
        case sim::Phase::kCheck:
            return figure_word("Check");
    }
    return {};
}

QString theme_words(assessment::Theme theme) {
    switch (theme) {
        case assessment::Theme::kPlacode:
            return translated("Theme", "Sparing the placode");
        case assessment::Theme::kIncision:
            return translated("Theme", "The incision");
        case assessment::Theme::kRelease:
            return translated("Theme", "Freeing and taking out");
        case assessment::Theme::kTissue:
            return translated("Theme", "Gentle with tissue");
        case assessment::Theme::kEnergy:
            return translated("Theme", "Use of energy");
        case assessment::Theme::kTime:
            return translated("Theme", "Time");
        case assessment::Theme::kPrecision:
            return translated("Theme", "Precision and view");
        case assessment::Theme::kSteps:
            return translated("Theme", "Steps of the task");
    }
    return {};
}

QString lane_words(assessment::HarmLane lane) {
    switch (lane) {
        case assessment::HarmLane::kPlacode:
            return figure_word("Placode");
        case assessment::HarmLane::kForce:
            return figure_word("Force");
        case assessment::HarmLane::kTissue:
            return figure_word("Tissue");
        case assessment::HarmLane::kEnergy:
            return figure_word("Energy");
    }
    return {};
}

QString tool_words(sim::ToolKind kind) {
    switch (kind) {
        case sim::ToolKind::kNeedle:
            return figure_word("needle");
        case sim::ToolKind::kScissors:
            return figure_word("scissors");
        case sim::ToolKind::kGrasper:
            return figure_word("grasper");
        case sim::ToolKind::kScope:
            return figure_word("scope");
        default:
            return figure_word("instrument");
    }
}

QString minute_second(double seconds) {
    const int whole = static_cast<int>(std::lround(std::max(0.0, seconds)));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace placode::reports
