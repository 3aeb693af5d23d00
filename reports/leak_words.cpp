// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The map of leaks in a sentence, and as a table.

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/csv_table.h"
#include "reports/leak_figure.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using assessment::kMlMinPerM3S, assessment::kPaPerCmH2O;
using assessment::LeakMap;
using assessment::LeakPlace;
using assessment::LeakStage;

QString said(const char* english) { return QCoreApplication::translate("Leak", english); }

/// As many places as say something: 12, 1.2, 0.15.
QString amount(double value) {
    return spoken().toString(value, 'f', value >= 10 ? 0 : value >= 1 ? 1 : 2);
}
QString one_place(double value) { return spoken().toString(value, 'f', 1); }

/// " between bites 2 and 3, 5.1 mm from the left end".
QString place_of(const LeakPlace& place) {
    const QString from =
        said(place.between.upright ? "%1 mm from the upper end" : "%1 mm from the left end")
            .arg(one_place(1e3 * place.along_m));
    const QString between = between_words(place.between);
    return (between.isEmpty() ? QStringLiteral(" ") : between + QStringLiteral(", ")) + from;
}

QString leak_sentence(const LeakMap& map) {
    const auto worst = assessment::worst_leak(map, LeakStage::kGood);
    if (!worst || !(worst->leak_m3_s + worst->rest_m3_s > assessment::kTightM3S))
        return said("It is tight at 12.5 cmH2O.");
    const QString rest =
        worst->rest_m3_s > assessment::kTightM3S
            ? said("the rest lets %1 ml/min through").arg(amount(kMlMinPerM3S * worst->rest_m3_s))
        : worst->between.any() ? said("the rest is tight")
                               : said("there is no finished bite");
    return said("It leaks most%1: %2 ml/min at 12.5 cmH2O; %3.")
        .arg(place_of(*worst), amount(kMlMinPerM3S * worst->leak_m3_s), rest);
}

/// Rounded down, as the measure is.
QString pressure(double pa) { return one_place(std::floor(10 * pa / kPaPerCmH2O) / 10); }

QString burst_sentence(const LeakMap& map) {
    if (!map.whole)
        return said("It held up to %1 cmH2O; where it burst then was not recorded.")
            .arg(pressure(map.held_pa));
    if (!map.burst)
        return said("It held %1 cmH2O, the end of the test.").arg(pressure(map.held_pa));
    const auto burst = assessment::worst_leak(map, LeakStage::kLast);
    return said("It burst at %1 cmH2O%2.")
        .arg(pressure(map.held_pa), burst ? place_of(*burst) : QString());
}

}  // namespace

QString leak_words(const LeakMap& map) {
    return leak_sentence(map) + QStringLiteral(" ") + burst_sentence(map);
}

QString no_leak_map_words() {
    return said("No map: this recording does not say what leaks where.");
}

bool looks_at_leak(const std::vector<std::string>& scored) noexcept {
    return std::any_of(scored.begin(), scored.end(), [](const std::string& id) {
        return id == "slit_burst_cmh2o" || id.starts_with("slit_leak_");
    });
}

LeakTable leak_table(const LeakMap& map) {
    LeakTable table;
    table.columns = {"station",        "along_mm",        "length_mm",   "gap_mm",
                     "gap_6_mm",       "gap_12_mm",       "gap_end_mm",  "leak_6_ml_min",
                     "leak_12_ml_min", "leak_end_ml_min", "opened_cmh2o"};
    const auto only_whole = [&](double value) {
        return map.whole ? std::optional(value) : std::nullopt;
    };
    for (const assessment::LeakStation& station : map.stations) {
        std::vector<std::optional<double>> row{static_cast<double>(station.number),
                                               1e3 * station.along_m, 1e3 * station.length_m,
                                               1e3 * station.gap_m};
        for (const double gap_m : station.pressed_gap_m) row.push_back(only_whole(1e3 * gap_m));
        const assessment::PerStage& leak = station.leak_m3_s;
        row.emplace_back(kMlMinPerM3S * leak[0]);
        row.emplace_back(kMlMinPerM3S * leak[1]);
        row.push_back(only_whole(kMlMinPerM3S * leak[2]));
        row.push_back(station.opened_pa < 0 ? std::nullopt
                                            : only_whole(station.opened_pa / kPaPerCmH2O));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string leak_csv(const LeakTable& table) {
    std::string text = csv_line(table.columns);
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (const std::optional<double>& value : row)
            cells.push_back(value ? shortest_text(*value) : "");
        text += csv_line(cells);
    }
    return text;
}

}  // namespace placode::reports
