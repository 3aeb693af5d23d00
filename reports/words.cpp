// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/words.h"

#include <QCoreApplication>
#include <cmath>
#include <utility>

namespace placode::reports {
namespace {

using sim::EventKind;

// Asked for by functions that know no reader: it goes with the thread that makes the page.
thread_local std::optional<QLocale> spoken_here;

QString translated(const char* context, const char* english) {
    return QCoreApplication::translate(context, english);
}

QString times_words(int count) {
    if (count == 1) return translated("Reason", "once");
    if (count == 2) return translated("Reason", "twice");
    return translated("Reason", "%1 times").arg(count);
}

QString local(double value, int decimals) { return spoken().toString(value, 'f', decimals); }

/// A number as a reason has it, with the decimal sign of the language; beyond a million as it is.
std::string local_number(const std::string& number) {
    const QString said = QString::fromStdString(number);
    if (said.contains(QLatin1Char('e')) || said.contains(QLatin1Char('n'))) return number;
    const qsizetype dot = said.indexOf(QLatin1Char('.'));
    return local(said.toDouble(), dot < 0 ? 0 : static_cast<int>(said.size() - dot - 1))
        .toStdString();
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
            return "Force above the scene's limit";
        case EventKind::kOverTraction:
            return "Pulled too hard";
        case EventKind::kCrushed:
            return "Crushed between the jaws";
        case EventKind::kSlipped:
            return "Slid out of the jaws";
        case EventKind::kNeedleSlipped:
            return "Needle slid in the jaws";
        case EventKind::kNeedleTurned:
            return "Needle turned in the jaws";
        case EventKind::kNeedleDropped:
            return "Needle dropped";
        case EventKind::kThreadCut:
            return "Thread cut through tissue";
        case EventKind::kThreadToreOut:
            return "Thread tore out of tissue";
        case EventKind::kBuried:
            return "Tip stuck in tissue";
        case EventKind::kTorn:
            // Of the skin or below it: an entry gathers what tore together.
            return placode ? "Placode torn" : "Tissue torn";
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
        case EventKind::kNeedleSlipped:
            return seconds(entry.value) + QStringLiteral(", ") + millinewton(entry.value2);
        case EventKind::kPlacodeEnergised:
        case EventKind::kEnergyInAir:
        case EventKind::kDwell:
        case EventKind::kNeedleTurned:
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
        case EventKind::kThreadCut:
        case EventKind::kThreadToreOut:
            return QStringLiteral("%1 N/mm").arg(local(entry.value / 1000, 2));
        case EventKind::kSlipped:
            return QStringLiteral("%1 mm").arg(local(1000 * entry.value, 1));
        case EventKind::kNeedleDropped:  // from so high
            return QStringLiteral("%1 mm").arg(local(1000 * entry.value2, 1));
        default:
            return cubic(entry.value);
    }
}

}  // namespace

Speaking::Speaking(const QLocale& language) : before_(std::exchange(spoken_here, language)) {}
Speaking::~Speaking() { spoken_here = before_; }

QLocale spoken() { return spoken_here.value_or(QLocale()); }

QString with_spoken_sign(QString number) {
    return spoken_here ? number.replace('.', spoken_here->decimalPoint()) : number;
}

QString said_part(const db::Said& said) {
    const char* code = spoken().language() == QLocale::Polish ? "pl" : "en";
    return QString::fromStdString(said.in(code, [](const char* sentence) {
        return translated(db::Said::kContext, sentence).toStdString();
    }));
}

QString said_words(const db::Said& said) {
    QString words = said_part(said);
    if (words.isEmpty()) return words;
    // "the login is taken; choose another one" goes on a line; alone it is a sentence.
    words[0] = words[0].toUpper();
    return words.endsWith('.') || words.endsWith('?') ? words : words + '.';
}

QString figure_word(const char* english) { return translated("Figure", english); }

QString between_words(const assessment::BetweenBites& between) {
    if (!between.any()) return {};
    const auto [first, second] = assessment::between_numbers(between);
    const QString words = translated("Reason", assessment::between_pattern(between)).arg(first);
    return second > 0 ? words.arg(second) : words;
}

QString reason_words(const assessment::Reason& reason) {
    const assessment::ReasonMeaning& meaning = reason.meaning;
    std::string said = reason.text;
    if (!meaning.pattern.empty()) {
        const bool own = spoken().language() == QLocale::Polish && !meaning.pattern_pl.empty();
        assessment::ReasonWords words = assessment::english_places(meaning, reason.points);
        words.value = local_number(words.value);
        words.points = local_number(words.points);
        words.times = times_words(meaning.count).toStdString();
        if (meaning.hour > 0)
            words.where = translated("Reason", " at %1 o'clock").arg(meaning.hour).toStdString();
        if (meaning.between.any()) words.where = between_words(meaning.between).toStdString();
        // An id that no metric has is no word to translate: it stays.
        words.metric = translated("Metric", words.metric.c_str()).toStdString();
        said = assessment::fill_places(
            own ? meaning.pattern_pl : translated("Reason", meaning.pattern.c_str()).toStdString(),
            words);
    }
    return QString::fromStdString(said)
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
        case sim::ToolKind::kNeedleDriver:
            return figure_word("needle driver");
        case sim::ToolKind::kIrrigator:
            return figure_word("irrigator");
        default:
            return figure_word("instrument");
    }
}

QString minute_second(double seconds) {
    const int whole = static_cast<int>(std::lround(std::max(0.0, seconds)));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace placode::reports
