// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/signal_metrics.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/signal_motion.h"
#include "assessment/tissue_metrics.h"
#include "sim/core/number_text.h"

namespace placode::assessment {
namespace {

using Values = SignalValues;

constexpr const char* kKnownColumns =
    "t_s,speed_mm_s | t_s,speed | t_s,speed_left_mm_s,speed_right_mm_s | t_s,x_mm | "
    "t_s,x_mm,y_mm,z_mm[,qw,qx,qy,qz] | t_s,force_N | t_s,T_C (several together, in any order; "
    "x_raw_mm and its like for positions that nobody filtered)";

// Arrhenius sets: Henriques & Moritz 1947 (skin), liver as in Jacques.
constexpr double kSkinAPerS = 3.1e98, kSkinEaJMol = 6.28e5;
// Agah et al. 1994, artery.
constexpr double kArteryAPerS = 5.6e63, kArteryEaJMol = 4.3e5;
constexpr double kAbsoluteZeroC = -273.15;
constexpr double kLiverAPerS = 7.39e39, kLiverEaJMol = 2.577e5;

/// What a column may hold. Beyond, squares and powers are no numbers any more, and nothing that a
/// hand or tissue does is out there.
struct ColumnRange {
    const char* ending;  ///< Of the column's name: its unit.
    double low, high;
    const char* unit;
};
constexpr ColumnRange kRanges[]{{"t_s", -1e12, 1e12, "s"},
                                {"_mm_s", -1e6, 1e6, "mm/s"},
                                {"_mm", -1e6, 1e6, "mm"},
                                {"force_N", -1e4, 1e4, "N"},
                                {"T_C", kAbsoluteZeroC, 1000, "degrees Celsius"},
                                {"q", -1e3, 1e3, ""}};
/// Longer than any attempt; resampling a gap of days would fill the memory.
constexpr double kLongestS = 3600;

const ColumnRange* range_of(const std::string& column) {
    for (const ColumnRange& range : kRanges) {
        const std::string ending = range.ending;
        if (ending == "q" ? column.starts_with("q") : column.ends_with(ending)) return &range;
    }
    return nullptr;
}

void check_ranges(const SignalFile& file, bool raw) {
    for (size_t c = 0; c < file.columns.size(); ++c) {
        const ColumnRange* range = range_of(file.columns[c]);
        for (size_t i = 0; range != nullptr && i < file.values[c].size(); ++i) {
            const double value = file.values[c][i];
            if (value > range->low && value < range->high) continue;
            throw SignalError(file.path + ":" + std::to_string(file.line(i)) + ": " +
                              file.columns[c] + ": found " + sim::shortest_text(value) +
                              "; expected more than " + sim::shortest_text(range->low) +
                              " and less than " + sim::shortest_text(range->high) + " " +
                              range->unit);
        }
    }
    const double span = file.values[0].back() - file.values[0].front();
    if (!raw && span > kLongestS)
        throw SignalError(file.path + ":" + std::to_string(file.line(file.lines.size() - 1)) +
                          ": t_s: the signal spans " + sim::shortest_text(span) +
                          " s; expected at most " + sim::shortest_text(kLongestS) +
                          " s: cut it into parts, and give times in seconds");
}

Values force_metrics(const SignalFile& file, const SignalOptions& options) {
    (void)rate_of(file, false);
    const auto force =
        summarise_force(file.values[0], file.values[1], options.threshold_n.value_or(0));
    Values out;
    add(out, "time_s", file.values[0].back() - file.values[0].front());
    add(out, "peak_force_n", force.peak_n);
    add(out, "mean_force_n", force.mean_n);
    add(out, "rms_force_n", force.rms_n);
    add(out, "impulse_n_s", force.impulse_n_s);
    if (options.threshold_n) {
        add(out, "over_force_s", force.over_s);
        add(out, "excess_impulse_n_s", force.excess_impulse_n_s);
    }
    return out;
}

Values temperature_metrics(const SignalFile& file, const SignalOptions& /*options*/) {
    (void)rate_of(file, false);
    const auto& time = file.values[0];
    const auto& celsius = file.values[1];
    Values out;
    add(out, "time_s", time.back() - time.front());
    add(out, "peak_temperature_c", *std::max_element(celsius.begin(), celsius.end()));
    add(out, "cem43_min", cem43_min(time, celsius));
    const double skin = arrhenius_damage(time, celsius, kSkinAPerS, kSkinEaJMol);
    add(out, "arrhenius_skin", skin);
    add(out, "dead_fraction_skin", -std::expm1(-skin));
    add(out, "arrhenius_liver", arrhenius_damage(time, celsius, kLiverAPerS, kLiverEaJMol));
    add(out, "arrhenius_artery", arrhenius_damage(time, celsius, kArteryAPerS, kArteryEaJMol));
    return out;
}

/// One thing that columns may hold, beside t_s.
struct Kind {
    std::vector<std::string> columns;
    Values (*metrics)(const SignalFile&, const SignalOptions&);
    bool movement;  ///< Of one tool: only the first kind of a file is used, for they give the same.
};

// The fuller comes first.
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {{"x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz"}, pose_metrics, true},
        {{"x_mm", "y_mm", "z_mm"}, pose_metrics, true},
        {{"x_mm"}, pose_metrics, true},
        {{"speed_mm_s"}, speed_metrics, true},
        {{"speed"}, unitless_speed_metrics, true},
        {{"speed_left_mm_s", "speed_right_mm_s"}, bimanual_metrics, false},
        {{"force_N"}, force_metrics, false},
        {{"T_C"}, temperature_metrics, false}};
    return all;
}

/// A position that nobody filtered is what `x_mm` holds as well.
std::string plain_name(const std::string& column) {
    for (const char* axis : {"x", "y", "z"})
        if (column == std::string(axis) + "_raw_mm") return std::string(axis) + "_mm";
    return column;
}

/// The columns that a kind wants, in its order, with t_s before them; nothing where one is missing.
std::optional<SignalFile> columns_of(const SignalFile& file, const Kind& kind,
                                     std::set<size_t>& used) {
    SignalFile part;
    part.path = file.path;
    part.lines = file.lines;
    std::vector<std::string> wanted{"t_s"};
    wanted.insert(wanted.end(), kind.columns.begin(), kind.columns.end());
    std::set<size_t> taken;
    for (const std::string& name : wanted) {
        const auto found = std::find_if(file.columns.begin(), file.columns.end(),
                                        [&](const auto& each) { return plain_name(each) == name; });
        if (found == file.columns.end()) return std::nullopt;
        const auto at = static_cast<size_t>(found - file.columns.begin());
        taken.insert(at);
        part.columns.push_back(*found);
        part.values.push_back(file.values[at]);
    }
    used.merge(taken);
    return part;
}

}  // namespace

SignalMetrics signal_metrics(const SignalFile& file, const SignalOptions& options) {
    std::vector<std::pair<const Kind*, SignalFile>> parts;
    std::set<size_t> used;
    bool moved = false;
    for (const Kind& kind : kinds()) {
        if (kind.movement && moved) continue;
        auto part = columns_of(file, kind, used);
        if (!part) continue;
        moved = moved || kind.movement;
        parts.emplace_back(&kind, std::move(*part));
    }
    if (parts.empty())
        throw SignalError(file.path + ":1: found the columns \"" + joined(file.columns) +
                          "\"; expected one of " + kKnownColumns);
    SignalMetrics all;
    for (size_t c = 0; c < file.columns.size(); ++c)
        if (!used.contains(c)) all.columns_not_used.push_back(file.columns[c]);
    int dropped = 0;
    for (auto& [kind, part] : parts) {
        // Devices stamp two samples with one time now and then; what is raw is clean already.
        dropped = options.raw ? 0 : drop_repeated_times(part);
        if (part.values[0].size() < 4)
            throw SignalError(file.path + ": found " + std::to_string(part.values[0].size()) +
                              " rows; expected at least 4");
        check_ranges(part, options.raw);
        for (auto& [key, value] : kind->metrics(part, options)) {
            // What is no number is not known: no metric, rather than null.
            if (std::isfinite(value) && (key != "time_s" || all.values.empty()))
                all.values.emplace_back(key, value);
        }
    }
    if (dropped > 0) add(all.values, "dropped_samples", dropped);
    return all;
}

}  // namespace placode::assessment
