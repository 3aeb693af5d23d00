// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/signal_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "assessment/bimanual.h"
#include "assessment/motion_detail.h"
#include "assessment/motion_metrics.h"
#include "assessment/tissue_metrics.h"
#include "assessment/tremor.h"
#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

using assessment::Quat;
using assessment::Vec3;
using Values = std::vector<std::pair<std::string, double>>;

// PerkTutor's actions.
constexpr double kActionMmS = 50, kActionDegS = 50, kActionRestS = 0.2;
constexpr double kDegrees = 180 / std::numbers::pi;

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
            throw InputError(file.path + ":" + std::to_string(file.line(i)) + ": " +
                             file.columns[c] + ": found " + shortest(value) +
                             "; expected more than " + shortest(range->low) + " and less than " +
                             shortest(range->high) + " " + range->unit);
        }
    }
    const double span = file.values[0].back() - file.values[0].front();
    if (!raw && span > kLongestS)
        throw InputError(file.path + ":" + std::to_string(file.line(file.lines.size() - 1)) +
                         ": t_s: the signal spans " + shortest(span) + " s; expected at most " +
                         shortest(kLongestS) + " s: cut it into parts, and give times in seconds");
}

/// Sampling rate; throws when times do not grow, or with --raw are not evenly spaced.
double rate_of(const SignalFile& file, bool must_be_even) {
    const auto& time = file.values[0];
    const double mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (size_t i = 1; i < time.size(); ++i) {
        const double step = time[i] - time[i - 1];
        const std::string place = file.path + ":" + std::to_string(file.line(i)) + ": t_s";
        if (step <= 0)
            throw InputError(place + ": found " + shortest(time[i]) + " after " +
                             shortest(time[i - 1]) + "; expected a time that grows");
        // 1 %: decimals cut off at 1/30 s stay far below it.
        if (must_be_even && std::abs(step - mean) > 0.01 * mean)
            throw InputError(place + ": a step of " + shortest(step) + " s among steps of " +
                             shortest(mean) + " s; --raw needs even steps, leave it out");
    }
    return 1 / mean;
}

double trapezoid(std::span<const double> y, double dt) {
    double sum = 0;
    for (size_t i = 1; i < y.size(); ++i) sum += 0.5 * (y[i] + y[i - 1]) * dt;
    return sum;
}

void add(Values& out, const char* key, std::optional<double> value) {
    if (value) out.emplace_back(key, *value);
}

void add_speed(Values& out, std::span<const double> speed, double rate_hz,
               const SignalOptions& options) {
    const double dt = 1 / rate_hz;
    add(out, "peak_speed_mm_s", *std::max_element(speed.begin(), speed.end()));
    add(out, "sparc", assessment::sparc(speed, rate_hz));
    add(out, "ldlj_speed", assessment::ldlj_speed(speed, rate_hz));
    add(out, "movements", assessment::movement_count(speed, options.movement_threshold_mm_s));
    const int peaks = assessment::speed_peaks(speed, options.movement_threshold_mm_s);
    add(out, "speed_peaks", peaks);
    add(out, "speed_peaks_per_min", peaks / (static_cast<double>(speed.size() - 1) * dt) * 60);
    const double idle = assessment::idle_time(speed, dt, options.idle_threshold_mm_s);
    add(out, "idle_time_s", idle);
    add(out, "idle_fraction", idle / (static_cast<double>(speed.size() - 1) * dt));
}

/// Size of the movement in space, from the positions that also give the path.
void add_extent(Values& out, const std::vector<Vec3>& position) {
    Vec3 low = position.front(), high = low;
    for (const Vec3& p : position) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double path = assessment::path_length(position), volume = (high - low).prod();
    const double straight = (position.back() - position.front()).norm();
    add(out, "bounding_box_volume_mm3", volume);
    if (!(path > 0)) return;
    add(out, "economy_of_motion", straight / path);
    add(out, "economy_of_volume", std::cbrt(volume) / path);
    if (straight > 0) add(out, "path_inefficiency_percent", 100 * (path / straight - 1));
}

bool has_even_steps(const SignalFile& file) {
    const auto& time = file.values[0];
    const double mean = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (size_t i = 1; i < time.size(); ++i) {
        if (std::abs(time[i] - time[i - 1] - mean) > 0.01 * mean) return false;
    }
    return true;
}

std::vector<double> on_analysis_rate(const std::vector<double>& time,
                                     const std::vector<double>& signal) {
    const double rate = assessment::kAnalysisRateHz;
    const auto count = static_cast<size_t>((time.back() - time.front()) * rate + 1e-9) + 1;
    std::vector<double> even(count);
    size_t at = 0;
    for (size_t k = 0; k < count; ++k) {
        const double t = time.front() + static_cast<double>(k) / rate;
        while (at + 2 < time.size() && time[at + 1] < t) ++at;
        const double share = std::clamp((t - time[at]) / (time[at + 1] - time[at]), 0.0, 1.0);
        even[k] = signal[at] + share * (signal[at + 1] - signal[at]);
    }
    return even;
}

/// Tremor of unfiltered positions, as recorded or (uneven steps) on the analysis rate.
void add_tremor(Values& out, const SignalFile& file, size_t axes) {
    const bool even = has_even_steps(file);
    const double rate_hz = even ? rate_of(file, false) : assessment::kAnalysisRateHz;
    double power = 0, acceleration = 0;
    for (size_t axis = 1; axis <= axes; ++axis) {
        const std::vector<double> x =
            even ? file.values[axis] : on_analysis_rate(file.values[0], file.values[axis]);
        std::vector<double> second;
        for (size_t i = 1; i + 1 < x.size(); ++i) {
            second.push_back((x[i + 1] - 2 * x[i] + x[i - 1]) * rate_hz * rate_hz);
        }
        const auto p = assessment::band_power(x, rate_hz);
        const auto a = assessment::band_power(second, rate_hz);
        if (!p || !a) return;
        power += *p;
        acceleration += *a;
    }
    add(out, "tremor_power_mm2", power);
    add(out, "tremor_rms_mm", std::sqrt(power));
    add(out, "tremor_acceleration_rms_mm_s2", std::sqrt(acceleration));
}

/// A speed profile as the positions of a track are treated: one filter, one rate.
std::vector<double> filtered_speed(const SignalFile& file, size_t column) {
    std::vector<Vec3> line;
    for (const double speed : file.values[column]) line.emplace_back(speed, 0, 0);
    std::vector<double> filtered;
    for (const Vec3& point : assessment::make_track(file.values[0], line, {}).position_m)
        filtered.push_back(point.x());
    return filtered;
}

Values speed_metrics(const SignalFile& file, const SignalOptions& options) {
    const double recorded = rate_of(file, options.raw);
    const double rate = options.raw ? recorded : assessment::kAnalysisRateHz;
    const std::vector<double> speed = options.raw ? file.values[1] : filtered_speed(file, 1);
    Values out;
    add(out, "time_s", file.values[0].back() - file.values[0].front());
    add(out, "path_length_mm", trapezoid(speed, 1 / rate));
    add_speed(out, speed, rate, options);
    return out;
}

Values pose_metrics(const SignalFile& file, const SignalOptions& options) {
    const auto& v = file.values;
    const size_t count = v[0].size();
    double rate = rate_of(file, options.raw);
    std::vector<Vec3> position(count), velocity;
    std::vector<Quat> orientation;
    const size_t axes = v.size() == 2 ? 1 : 3;
    for (size_t i = 0; i < count; ++i)
        position[i] = axes == 1 ? Vec3(v[1][i], 0, 0) : Vec3(v[1][i], v[2][i], v[3][i]);
    for (size_t i = 0; v.size() == 8 && i < count; ++i) {
        const Quat q(v[4][i], v[5][i], v[6][i], v[7][i]);
        if (!(q.norm() > 0.5))
            throw InputError(file.path + ":" + std::to_string(file.line(i)) +
                             ": qw..qz: not a rotation; expected a quaternion of length 1");
        orientation.push_back(q.normalized());
    }
    std::vector<double> speed;
    const double recorded_path = assessment::path_length(position);
    if (options.raw) {
        for (size_t i = 0; i + 1 < count; ++i)
            velocity.emplace_back((position[i + 1] - position[i]) * rate);
        for (const Vec3& one : velocity) speed.push_back(one.norm());
    } else {
        const assessment::Track track = assessment::make_track(v[0], position, orientation);
        rate = assessment::kAnalysisRateHz;
        position = track.position_m;  // Millimetres here: the track keeps the unit it is given.
        orientation = track.orientation;
        velocity = track.velocity_m_s;
        speed = track.speed_m_s;
    }
    if (speed.size() < 3)
        throw InputError(file.path + ": too short; expected at least 0.03 s of movement");
    Values out;
    const double time = v[0].back() - v[0].front();
    add(out, "time_s", time);
    add(out, "path_length_mm", assessment::path_length(position));
    // Tremor and noise lengthen it: what the filter took away is worth knowing.
    if (!options.raw) add(out, "path_length_recorded_mm", recorded_path);
    add(out, "mean_speed_mm_s", assessment::path_length(position) / time);
    add_speed(out, speed, rate, options);
    add(out, "ldlj_vector", assessment::ldlj_vector(velocity, rate));
    add(out, "jerk_normalised", assessment::normalised_jerk(velocity, rate));
    add(out, "translational_actions",
        assessment::action_count(speed, 1 / rate, kActionMmS, kActionRestS));
    if (axes == 3) add_extent(out, position);
    add_tremor(out, file, axes);
    if (!orientation.empty()) {
        add(out, "depth_path_mm", assessment::depth_path(position, orientation));
        add(out, "angular_path_deg", assessment::angular_path(orientation) * kDegrees);
        add(out, "roll_path_deg", assessment::roll_path(orientation) * kDegrees);
        const auto pivot = assessment::pivot_paths(orientation);
        add(out, "pitch_path_deg", pivot.pitch_rad * kDegrees);
        add(out, "yaw_path_deg", pivot.yaw_rad * kDegrees);
        add(out, "rotational_actions",
            assessment::action_count(assessment::angular_speed(orientation, 1 / rate), 1 / rate,
                                     kActionDegS / kDegrees, kActionRestS));
    }
    return out;
}

Values bimanual_metrics(const SignalFile& file, const SignalOptions& options) {
    const double recorded = rate_of(file, options.raw);
    const double rate = options.raw ? recorded : assessment::kAnalysisRateHz;
    std::array<std::vector<double>, 2> speed{file.values[1], file.values[2]};
    if (!options.raw) speed = {filtered_speed(file, 1), filtered_speed(file, 2)};
    const auto b = assessment::bimanual_dexterity(speed[0], speed[1], 1 / rate,
                                                  options.bimanual_threshold_mm_s);
    Values out;
    add(out, "time_s", file.values[0].back() - file.values[0].front());
    add(out, "pearson_r", b.pearson_r);
    add(out, "path_length_left_mm", b.path_left);
    add(out, "path_length_right_mm", b.path_right);
    add(out, "path_ratio_LR", b.path_ratio);
    add(out, "path_balance", b.balance);
    add(out, "both_moving_fraction", b.both);
    add(out, "left_only_fraction", b.left_only);
    add(out, "right_only_fraction", b.right_only);
    add(out, "neither_fraction", b.neither);
    return out;
}

Values force_metrics(const SignalFile& file, const SignalOptions& options) {
    (void)rate_of(file, false);
    const auto force = assessment::summarise_force(file.values[0], file.values[1],
                                                   options.threshold_n.value_or(0));
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
    add(out, "cem43_min", assessment::cem43_min(time, celsius));
    const double skin = assessment::arrhenius_damage(time, celsius, kSkinAPerS, kSkinEaJMol);
    add(out, "arrhenius_skin", skin);
    add(out, "dead_fraction_skin", -std::expm1(-skin));
    add(out, "arrhenius_liver",
        assessment::arrhenius_damage(time, celsius, kLiverAPerS, kLiverEaJMol));
    add(out, "arrhenius_artery",
        assessment::arrhenius_damage(time, celsius, kArteryAPerS, kArteryEaJMol));
    return out;
}

Values unitless_speed_metrics(const SignalFile& file, const SignalOptions& options) {
    // Of a speed without unit only what has none can be said.
    Values values = speed_metrics(file, options);
    std::erase_if(values, [](const auto& each) {
        return each.first != "time_s" && each.first != "sparc" && each.first != "ldlj_speed";
    });
    return values;
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
        throw InputError(file.path + ":1: found the columns \"" + joined(file.columns) +
                         "\"; expected one of " + kKnownColumns);
    SignalMetrics all;
    for (size_t c = 0; c < file.columns.size(); ++c)
        if (!used.contains(c)) all.columns_not_used.push_back(file.columns[c]);
    int dropped = 0;
    for (auto& [kind, part] : parts) {
        // Devices stamp two samples with one time now and then; what is raw is clean already.
        dropped = options.raw ? 0 : drop_repeated_times(part);
        if (part.values[0].size() < 4)
            throw InputError(file.path + ": found " + std::to_string(part.values[0].size()) +
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

}  // namespace placode::cli
