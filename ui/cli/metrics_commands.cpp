// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl metrics | contour. The score: score_command.cpp.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "assessment/bites.h"
#include "assessment/leak_map.h"
#include "assessment/phases.h"
#include "assessment/signal.h"
#include "assessment/signal_metrics.h"
#include "assessment/tissue_metrics.h"
#include "reports/leak_figure.h"
#include "ui/cli/cli.h"
#include "ui/cli/recording_output.h"
#include "ui/cli/write_file.h"
#include "ui/finite_range.h"

namespace placode::cli {
namespace {

struct MetricsOptions {
    std::string file, plan, leaks;
    double tolerance_mm = 1;
    bool recover = false, phases = false;
    double threshold_n = -1;
    assessment::SignalOptions signal;
};

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A signal that cannot be used is bad input.
template <class Work>
auto as_bad_file(Work&& work) {
    try {
        return work();
    } catch (const assessment::SignalError& error) {
        throw InputError(error.what());
    }
}

/// The bites of a running suture, one by one; nothing for other tasks.
void add_bites(const sim::Recording& recording, Json& json, std::string& text) {
    const std::vector<assessment::Bite> bites = assessment::bites_of(recording);
    if (bites.empty()) return;
    json["bites"] = Json::array();
    std::vector<std::vector<std::string>> rows{{"bite", "entry mm", "exit mm", "depth mm",
                                                "entry to line mm", "exit to line mm", "angle deg",
                                                "pitch mm", "done"}};
    for (size_t i = 0; i < bites.size(); ++i) {
        const assessment::Bite& bite = bites[i];
        Json one{{"bite", bite.number + 1}, {"done", bite.done}};
        std::vector<std::string> row{std::to_string(bite.number + 1)};
        const auto add = [&](const char* key, bool known, double value) {
            one[key] = known ? Json(value) : Json();
            row.push_back(known ? fixed(value, 2) : "-");
        };
        const bool both = bite.entered && bite.left;
        add("entry_offset_mm", bite.entered, 1e3 * bite.entry_offset_m);
        add("exit_offset_mm", bite.left, 1e3 * bite.exit_offset_m);
        add("depth_mm", bite.left, 1e3 * bite.depth_m);
        add("entry_from_line_mm", both, 1e3 * bite.entry_from_line_m());
        add("exit_from_line_mm", both, 1e3 * bite.exit_from_line_m());
        add("angle_deg", bite.entered, bite.angle_rad * 180 / std::numbers::pi);
        const auto pitch = i == 0 ? std::nullopt : assessment::pitch_m(bites[i - 1], bite);
        add("pitch_mm", pitch.has_value(), 1e3 * pitch.value_or(0));
        row.emplace_back(bite.done ? "yes" : "no");
        json["bites"].push_back(one);
        rows.push_back(row);
    }
    text += "\n" + table(rows);
}

/// What a sewn slit leaks, station by station; nothing for other tasks. Writes the file that was
/// asked for.
void add_leaks(const sim::Recording& recording, const MetricsOptions& options, Json& json,
               std::string& text) {
    const std::optional<assessment::LeakMap> map = assessment::leak_map(recording);
    if (!map && !options.leaks.empty())
        throw InputError(options.file +
                         ": the recording does not say what leaks where; expected an attempt at a "
                         "task whose slit is put under pressure (suture_slit)");
    if (!map) return;
    const reports::LeakTable leaks = reports::leak_table(*map);
    json["leaks"] = Json::array();
    std::vector<std::vector<std::string>> rows{leaks.columns};
    for (const auto& station : leaks.rows) {
        Json one;
        std::vector<std::string> row;
        for (size_t k = 0; k < station.size(); ++k) {
            one[leaks.columns[k]] = optional_number(station[k]);
            row.push_back(optional_text(station[k], k == 0 ? 0 : 3));
        }
        json["leaks"].push_back(std::move(one));
        rows.push_back(std::move(row));
    }
    text += "\n" + table(rows);
    if (options.leaks.empty()) return;
    write_file(options.leaks, reports::leak_csv(leaks));
    text += "written: " + options.leaks + "\n";
}

int metrics_of_recording(const Context& context, const MetricsOptions& options) {
    need_writable_file("--leaks", options.leaks);
    std::string damage;
    const sim::Recording recording = load_recording(options.file, options.recover, damage);
    const auto metrics = assessment::compute_metrics(recording);
    Json json = recording_head(recording, damage);
    json["metric_set_version"] = metrics.version;
    json["preprocessing_version"] = assessment::kPreprocessingVersion;
    json["metrics"] = metrics_json(metrics);
    std::string text = (damage.empty() ? "" : "damaged: " + damage + "\n") + metric_table(metrics);
    add_bites(recording, json, text);
    add_leaks(recording, options, json, text);
    if (options.phases) {
        json["phases"] = Json::array();
        for (const auto& part : assessment::compute_phase_metrics(recording)) {
            const std::string name(sim::phase_name(part.phase));
            json["phases"].push_back({{"phase", name},
                                      {"from_s", part.from_s},
                                      {"to_s", part.to_s},
                                      {"metrics", metrics_json(part.metrics)}});
            text += "\n" + name + ", " + fixed(part.from_s, 1) + " to " + fixed(part.to_s, 1) +
                    " s\n" + metric_table(part.metrics);
        }
    }
    print(context, json, text);
    return 0;
}

int metrics_of_signal(const Context& context, const MetricsOptions& options) {
    if (!options.leaks.empty())
        throw InputError("--leaks: " + options.file + " is a signal; expected FILE.placode");
    assessment::SignalOptions signal = options.signal;
    if (options.threshold_n >= 0) signal.threshold_n = options.threshold_n;
    const assessment::SignalFile file = assessment::read_signal_file(options.file);
    Json json = Json::object();
    std::vector<std::vector<std::string>> rows{{"metric", "value"}};
    const assessment::SignalMetrics metrics = assessment::signal_metrics(file, signal);
    for (const auto& [key, value] : metrics.values) {
        json[key] = value;
        rows.push_back({key, shortest(value)});
    }
    std::string text = table(rows);
    if (!metrics.columns_not_used.empty()) {
        json["columns_not_used"] = metrics.columns_not_used;
        text += "columns not used: " + assessment::joined(metrics.columns_not_used) + "\n";
    }
    print(context, json, text);
    return 0;
}

int metrics(const Context& context, const MetricsOptions& options) {
    if (ends_with(options.file, ".placode")) return metrics_of_recording(context, options);
    if (ends_with(options.file, ".csv"))
        return as_bad_file([&] { return metrics_of_signal(context, options); });
    throw InputError(options.file + ": expected FILE.placode (a recording) or FILE.csv (a signal)");
}

std::vector<assessment::Vec3> read_line(const std::string& path) {
    const assessment::SignalFile file = assessment::read_signal_file(path);
    const std::string columns = assessment::joined(file.columns);
    if (columns != "x_mm,y_mm" && columns != "x_mm,y_mm,z_mm") {
        throw InputError(path + ":1: found the columns \"" + columns +
                         "\"; expected x_mm,y_mm[,z_mm]");
    }
    std::vector<assessment::Vec3> line(file.values[0].size(), assessment::Vec3::Zero());
    if (line.size() < 3) {
        throw InputError(path + ": found " + std::to_string(line.size()) +
                         " points; expected at least 3");
    }
    for (size_t axis = 0; axis < file.values.size(); ++axis) {
        for (size_t i = 0; i < line.size(); ++i) {
            line[i][static_cast<Eigen::Index>(axis)] = file.values[axis][i];
        }
    }
    return line;
}

int contour(const Context& context, const MetricsOptions& options) {
    if (!(options.tolerance_mm > 0 && std::isfinite(options.tolerance_mm))) {
        throw InputError("--tolerance " + shortest(options.tolerance_mm) +
                         ": expected a distance above 0 mm");
    }
    const auto c = as_bad_file([&] {
        return assessment::compare_contours(read_line(options.plan), read_line(options.file),
                                            options.tolerance_mm);
    });
    const Json json{{"mean_abs_dev_mm", c.mean_abs},
                    {"rms_mm", c.rms},
                    {"p95_mm", c.p95},
                    {"max_mm", c.max},
                    {"mean_signed_mm", c.mean_signed},
                    {"hausdorff_cut_to_plan_mm", c.hausdorff_cut_to_plan},
                    {"hausdorff_plan_to_cut_mm", c.hausdorff_plan_to_cut},
                    {"hausdorff_mm", c.hausdorff},
                    {"completeness_percent", 100 * c.completeness},
                    {"largest_gap_mm", c.largest_gap},
                    {"gaps", c.gaps},
                    {"tolerance_mm", options.tolerance_mm}};
    std::vector<std::vector<std::string>> rows{{"measure", "value"}};
    for (const auto& [key, value] : json.items()) {
        rows.push_back({key, shortest(value.get<double>())});
    }
    print(context, json, table(rows));
    return 0;
}

}  // namespace

void add_metrics_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<MetricsOptions>();
    CLI::App* metrics_command = app.add_subcommand(
        "metrics", "Every metric that a recording, or the columns of a CSV signal, allow");
    metrics_command->add_option("FILE", options->file, "FILE.placode or FILE.csv")->required();
    metrics_command->add_flag("--raw", options->signal.raw,
                              "Signal: no filter and no resampling, it is clean already");
    metrics_command
        ->add_option("--threshold", options->threshold_n,
                     "Force signal: what counts as too much [N]")
        ->check(ui::finite_range(0.0, 1e6));
    metrics_command->add_flag("--phases", options->phases, "Recording: each phase as well");
    metrics_command->add_option("--leaks", options->leaks,
                                "Recording of a sewn slit: OUT.csv, what each station leaks");
    metrics_command->add_flag("--recover", options->recover,
                              "Recording: use what stands before the damage");
    metrics_command->callback([&context, options] {
        context.run = [&context, options] { return metrics(context, *options); };
    });

    CLI::App* contour_command =
        app.add_subcommand("contour", "How a cut line follows the planned closed line");
    contour_command->add_option("PLAN", options->plan, "PLAN.csv: x_mm,y_mm[,z_mm]")->required();
    contour_command->add_option("CUT", options->file, "CUT.csv, likewise")->required();
    contour_command->add_option("--tolerance", options->tolerance_mm,
                                "Distance at which the plan counts as cut [mm], default 1");
    contour_command->callback([&context, options] {
        context.run = [&context, options] { return contour(context, *options); };
    });

    add_score_command(app, context);
}

}  // namespace placode::cli
