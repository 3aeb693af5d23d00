// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What `bench haptics` prints and writes.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "haptics/real_time.h"
#include "reports/report.h"
#include "ui/cli/haptics_bench_report.h"

namespace placode::cli {
namespace {

using haptics::HapticBenchCheck;
using haptics::HapticBenchResult;
using haptics::HapticBenchRow;
using haptics::HapticBenchRun;
using haptics::HapticBenchSuite;
constexpr const char* kShipped = "as shipped";

/// Small numbers keep their digits.
std::string number(double v) {
    return std::abs(v) < 0.01 && v != 0 ? fixed(1000 * v, 3) + "e-3" : fixed(v, 3);
}

/// Without a sign where nothing is left of the number.
std::string milli(double v, int decimals) {
    const std::string text = fixed(1000 * v, decimals);
    return text.find_first_of("123456789") == std::string::npos ? fixed(0, decimals) : text;
}

std::string k_max_table(const HapticBenchSuite& bench) {
    std::vector<std::vector<std::string>> cells{
        {"world", "law", "grip", "physics [Hz]", "K_max [N/m]"}};
    for (const HapticBenchRow& row : bench.rows)
        cells.push_back({row.world, row.law, row.grip, fixed(row.physics_hz, 0),
                         (row.k_max > haptics::kSweepTopNM ? ">= " : "") + fixed(row.k_max, 0)});
    return table(cells);
}

std::string run_table(const HapticBenchSuite& bench) {
    std::vector<std::vector<std::string>> cells{{"run", "grip", "physics [Hz]", "oscillation [mm]",
                                                 "peak force [N]", "least energy [mJ]",
                                                 "given at rest [mJ/s]"}};
    for (const HapticBenchRun& run : bench.runs) {
        const HapticBenchResult& r = run.result;
        const bool rests = run.name != "air";
        cells.push_back({run.name, run.grip, fixed(run.physics_hz, 0),
                         rests ? milli(r.peak_to_peak_m, 3) : "-", fixed(r.peak_force_n, 3),
                         milli(r.least_energy_j, 4), rests ? milli(r.drift_j_s, 4) : "-"});
    }
    return table(cells);
}

std::string check_table(const HapticBenchSuite& bench) {
    std::vector<std::vector<std::string>> cells{{"check", "value", "limit", ""}};
    for (const HapticBenchCheck& one : bench.checks)
        cells.push_back({one.name, number(one.value),
                         (one.at_most ? "<= " : ">= ") + number(one.limit),
                         one.passed() ? "ok" : "NOT WITHIN"});
    return table(cells);
}

reports::Curve curve_of(const std::string& name, const std::vector<float>& values, double scale) {
    reports::Curve curve;
    curve.name = name;
    for (size_t i = 0; i < values.size(); ++i) {
        curve.x.push_back(1e-3 * static_cast<double>(i));
        curve.y.push_back(scale * static_cast<double>(values[i]));
    }
    return curve;
}

/// K_max over the rate of the physics: a curve for each grip and what `kind_of` says of a row;
/// empty: left out.
template <class KindOf>
reports::CurveChart k_max_chart(const HapticBenchSuite& bench, const std::string& title,
                                KindOf&& kind_of) {
    reports::CurveChart chart;
    chart.title = title;
    chart.x_label = "rate of the physics [Hz]";
    chart.y_label = "largest stable stiffness [N/m]";
    chart.log_x = chart.log_y = false;
    for (const HapticBenchRow& row : bench.rows) {
        const std::string kind = kind_of(row);
        if (kind.empty()) continue;
        const std::string name = row.grip + ", " + kind;
        auto at = std::find_if(chart.curves.begin(), chart.curves.end(),
                               [&](const reports::Curve& c) { return c.name == name; });
        if (at == chart.curves.end()) at = chart.curves.insert(at, {name, {}, {}});
        at->x.push_back(row.physics_hz);
        at->y.push_back(row.k_max);
    }
    const double standard = haptics::CouplingSettings{}.stiffness_n_m;
    chart.levels = {{"default stiffness", standard},
                    {"three times the default: least allowed", haptics::kStableTimes * standard}};
    return chart;
}

void write_figures(const HapticBenchSuite& bench, const std::string& folder) {
    const auto save = [&](const reports::CurveChart& chart, const std::string& name) {
        reports::write_chart_png(chart, folder + "/bench_haptics_" + name + ".png");
    };
    save(
        k_max_chart(bench, "Largest stable stiffness, law as shipped (simulated operator)",
                    [](const HapticBenchRow& row) { return row.law == kShipped ? row.world : ""; }),
        "kmax");
    save(k_max_chart(bench, "What the parts of the law are worth against a rigid wall",
                     [](const HapticBenchRow& row) { return row.world == "wall" ? row.law : ""; }),
         "laws");
    reports::CurveChart time;
    time.title = "A light grip pushes into wall and tissue";
    time.x_label = "time [s]";
    time.y_label = "position of the device [mm]";
    time.log_x = time.log_y = false;
    time.curves = {curve_of("wall", bench.wall.position_m, 1000),
                   curve_of("tissue of 60 kPa", bench.tissue.position_m, 1000)};
    save(time, "push");
    time.title = "The same push with the control case, which must be seen to be unstable";
    time.curves = {curve_of("wall, law as shipped", bench.wall.position_m, 1000),
                   curve_of("control: K 4000 N/m, B 0, held 4 ms", bench.control.position_m, 1000)};
    save(time, "control");
    time.title = "Energy that went into the port";
    time.y_label = "energy [mJ]";
    time.curves = {curve_of("wall", bench.wall.energy_j, 1000),
                   curve_of("tissue of 60 kPa", bench.tissue.energy_j, 1000)};
    time.levels = {{"least allowed", -0.5}};
    save(time, "energy");
}

void write_traces(const HapticBenchSuite& bench, std::ostream& out) {
    out << "t_s,wall_position_m,wall_force_n,wall_energy_j,tissue_position_m,tissue_force_n,"
           "tissue_energy_j,control_position_m,control_force_n,control_energy_j\n";
    const auto cell = [](const std::vector<float>& v, size_t i) {
        return i < v.size() ? fixed(static_cast<double>(v[i]), 7) : std::string();
    };
    for (size_t i = 0; i < bench.control.position_m.size(); ++i) {
        out << fixed(1e-3 * static_cast<double>(i), 3);
        for (const HapticBenchResult* result : {&bench.wall, &bench.tissue, &bench.control})
            out << ',' << cell(result->position_m, i) << ',' << cell(result->force_n, i) << ','
                << cell(result->energy_j, i);
        out << '\n';
    }
}

}  // namespace

std::string haptics_bench_text(const HapticBenchSuite& bench) {
    const haptics::HapticCertificate& thread = bench.thread;
    std::string out =
        k_max_table(bench) + "\n" + run_table(bench) + "\n" + check_table(bench) + "\n";
    out += "Attempts run at 1000 Hz. Servo thread beside a physics thread with tissue, " +
           fixed(thread.duration_s, 1) + " s: period p50 " + fixed(thread.period_p50_us, 0) +
           ", p99 " + fixed(thread.period_p99_us, 0) + ", p99.9 " +
           fixed(thread.period_p999_us, 0) + ", max " + fixed(thread.period_max_us, 0) + " us; " +
           std::to_string(thread.missed) + " periods missed, " + std::to_string(thread.gaps) +
           " gaps above 5 ms; age of the tool state p50 " + fixed(thread.tool_age_p50_us, 0) +
           ", p99 " + fixed(thread.tool_age_p99_us, 0) + ", max " +
           fixed(thread.tool_age_max_us, 0) + " us; " +
           (thread.real_time ? "SCHED_FIFO" : "ordinary scheduling");
    const std::string missing = haptics::missing_rights(thread.real_time, thread.memory_locked);
    if (!missing.empty()) out += ".\n" + missing;
    return out;
}

Json haptics_bench_json(const HapticBenchSuite& bench) {
    Json json{{"checks", Json::array()}, {"k_max", Json::array()}, {"cases", Json::array()}};
    for (const HapticBenchCheck& check : bench.checks)
        json["checks"].push_back({{"name", check.name},
                                  {"value", check.value},
                                  {check.at_most ? "at_most" : "at_least", check.limit},
                                  {"passed", check.passed()}});
    for (const HapticBenchRow& row : bench.rows)
        json["k_max"].push_back({{"world", row.world},
                                 {"law", row.law},
                                 {"grip", row.grip},
                                 {"physics_hz", row.physics_hz},
                                 {"k_max_n_m", row.k_max}});
    for (const HapticBenchRun& run : bench.runs)
        json["cases"].push_back({{"case", run.name},
                                 {"grip", run.grip},
                                 {"physics_hz", run.physics_hz},
                                 {"peak_to_peak_m", run.result.peak_to_peak_m},
                                 {"peak_force_n", run.result.peak_force_n},
                                 {"mean_force_n", run.result.mean_force_n},
                                 {"gap_m", run.result.gap_m},
                                 {"tissue_force_n", run.result.tissue_force_n},
                                 {"least_energy_j", run.result.least_energy_j},
                                 {"drift_j_s", run.result.drift_j_s},
                                 {"compared_ticks", run.result.certificate.compared},
                                 {"differing_ticks", run.result.certificate.differing}});
    json["servo_thread"] = Json::parse(haptics::certificate_to_json(bench.thread));
    json["servo_thread"]["missing"] =
        haptics::missing_rights(bench.thread.real_time, bench.thread.memory_locked);
    return json;
}

void write_haptics_bench(const HapticBenchSuite& bench, const Json& json,
                         const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_haptics.csv");
    csv << "world,law,grip,physics_hz,k_max_n_m\n";
    for (const HapticBenchRow& row : bench.rows)
        csv << row.world << ',' << row.law << ',' << row.grip << ',' << fixed(row.physics_hz, 0)
            << ',' << fixed(row.k_max, 1) << '\n';
    std::ofstream traces(folder + "/bench_haptics_traces.csv");
    write_traces(bench, traces);
    std::ofstream document(folder + "/bench_haptics.json");
    document << json.dump(2) << '\n';
    for (std::ofstream* file : {&csv, &traces, &document}) file->flush();
    if (!csv || !traces || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
    write_figures(bench, folder);
}

}  // namespace placode::cli
