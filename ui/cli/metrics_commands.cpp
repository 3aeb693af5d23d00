// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl metrics | contour | score

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <optional>

#include "assessment/bites.h"
#include "assessment/phases.h"
#include "assessment/scoring.h"
#include "assessment/signal.h"
#include "assessment/signal_metrics.h"
#include "assessment/soundness.h"
#include "assessment/tissue_metrics.h"
#include "curriculum/task.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "db/store.h"
#include "haptics/certificate.h"
#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

struct MetricsOptions {
    std::string file, task, plan;
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

// A recording that cannot be read is bad input.
sim::Recording load_recording(const MetricsOptions& options, std::string& damage) {
    try {
        auto recovered = db::recover_recording_file(options.file);
        damage = recovered.damage;
        if (!damage.empty() && !options.recover)
            throw InputError("read the recording " + options.file + ": " + damage +
                             "; --recover uses what is whole");
        return std::move(recovered.recording);
    } catch (const db::StoreError& error) {
        throw InputError(error.what());
    }
}

Json recording_head(const sim::Recording& recording, const std::string& damage) {
    constexpr std::array<const char*, 5> kEnds{"running", "finished", "time limit", "closed",
                                               "interrupted"};
    Json json{{"task", recording.header.task_id},
              {"task_version", recording.header.task_version},
              {"device", recording.header.device},
              {"seed", recording.header.seed},
              {"build", recording.header.build},
              {"demonstration", recording.header.demonstration},
              {"duration_s", recording.end.duration_s},
              {"end", kEnds[static_cast<size_t>(recording.end.reason) % kEnds.size()]},
              {"dropped", recording.end.dropped}};
    if (!damage.empty()) json["damage"] = damage;
    return json;
}

Json to_json(const assessment::MetricSet& metrics) {
    Json values = Json::object();
    for (const auto& metric : metrics.values) values[metric.id] = metric.value;
    return values;
}

std::string metric_table(const assessment::MetricSet& metrics) {
    std::vector<std::vector<std::string>> rows{{"metric", "value", "unit"}};
    for (const auto& metric : metrics.values) {
        const auto* known = assessment::metric_definition(metric.id);
        rows.push_back(
            {metric.id, fixed(metric.value, 3), known == nullptr ? "" : std::string(known->unit)});
    }
    return table(rows);
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

int metrics_of_recording(const Context& context, const MetricsOptions& options) {
    std::string damage;
    const sim::Recording recording = load_recording(options, damage);
    const auto metrics = assessment::compute_metrics(recording);
    Json json = recording_head(recording, damage);
    json["metric_set_version"] = metrics.version;
    json["preprocessing_version"] = assessment::kPreprocessingVersion;
    json["metrics"] = to_json(metrics);
    std::string text = (damage.empty() ? "" : "damaged: " + damage + "\n") + metric_table(metrics);
    add_bites(recording, json, text);
    if (options.phases) {
        json["phases"] = Json::array();
        for (const auto& part : assessment::compute_phase_metrics(recording)) {
            const std::string name(sim::phase_name(part.phase));
            json["phases"].push_back({{"phase", name},
                                      {"from_s", part.from_s},
                                      {"to_s", part.to_s},
                                      {"metrics", to_json(part.metrics)}});
            text += "\n" + name + ", " + fixed(part.from_s, 1) + " to " + fixed(part.to_s, 1) +
                    " s\n" + metric_table(part.metrics);
        }
    }
    print(context, json, text);
    return 0;
}

int metrics_of_signal(const Context& context, const MetricsOptions& options) {
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
    if (!(options.tolerance_mm > 0)) {
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

/// The task that was asked for, else the program's own of the recording's id and version. Only
/// where there is none, and the result says so, the one that the recording carries.
curriculum::Task task_to_score_by(const sim::Recording& recording, const MetricsOptions& options,
                                  bool& published) {
    if (!options.task.empty()) return curriculum::load_task(options.task);
    const auto shipped = db::shipped_task(recording.header.task_id);
    published = shipped && shipped->version == recording.header.task_version;
    return published ? *shipped
                     : curriculum::load_task_text(recording.header.task_json,
                                                  options.file + " (its task)");
}

int score(const Context& context, const MetricsOptions& options) {
    std::string damage;
    const sim::Recording recording = load_recording(options, damage);
    bool published = true;
    const curriculum::Task task = task_to_score_by(recording, options, published);
    if (const std::string problem = assessment::unsound(recording); !problem.empty())
        throw InputError(options.file + ": the recording cannot be scored: " + problem);
    const auto metrics = assessment::compute_metrics(recording);
    const auto result = assessment::score_attempt(task.rubric, metrics, recording);
    const std::string verdict = assessment::verdict_name(result.verdict);
    Json json = recording_head(recording, damage);
    json["points"] = result.points;
    json["verdict"] = verdict;
    json["rubric"] = result.rubric_id;
    json["rubric_version"] = result.rubric_version;
    json["metric_set_version"] = result.metric_set_version;
    json["published_task"] = published;
    json["reasons"] = Json::array();
    std::string text = "score " + fixed(result.points, 1) + " of 100: " + verdict + " (" + task.id +
                       " version " + std::to_string(task.version) + ", " + recording.header.device +
                       (recording.header.demonstration ? ", demonstration" : "") + ")\n";
    if (!damage.empty()) text += "damaged: " + damage + "\n";
    if (task.id != recording.header.task_id)
        text += "the recording is of another task: " + recording.header.task_id + "\n";
    if (!published)
        text += "not verified: no such task is published here, the recording's own was used\n";
    std::vector<std::vector<std::string>> rows;
    for (const auto& reason : result.reasons) {
        json["reasons"].push_back({{"item", reason.item},
                                   {"text", reason.text},
                                   {"points", reason.points},
                                   {"time_s", reason.time_s},
                                   {"critical", reason.critical}});
        // A critical error may fail the attempt without taking points.
        rows.push_back({reason.points > 0 ? "  -" + fixed(reason.points, 1) : "  !", reason.text,
                        reason.time_s < 0 ? "" : "at " + fixed(reason.time_s, 1) + " s",
                        reason.critical ? "critical" : ""});
    }
    json["metrics"] = to_json(metrics);
    json["haptics"] = nullptr;
    if (const std::string found = db::haptic_certificate(options.file); !found.empty()) {
        const auto verdict = haptics::judge(haptics::certificate_from_json(found));
        json["haptics"] = Json::parse(found, nullptr, false);
        // Judged again with the limits of today.
        json["haptics"]["grade"] = haptics::grade_name(verdict.grade);
        json["haptics"]["reasons"] = verdict.reasons;
        if (verdict.grade != haptics::CertificateGrade::kNotApplicable)
            text += "haptic certificate: " + std::string(haptics::grade_name(verdict.grade)) + "\n";
        for (const std::string& reason : verdict.reasons) text += "  " + reason + "\n";
    }
    print(context, json, text + table(rows) + "\n" + metric_table(metrics));
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
    metrics_command->add_option("--threshold", options->threshold_n,
                                "Force signal: what counts as too much [N]");
    metrics_command->add_flag("--phases", options->phases, "Recording: each phase as well");
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

    CLI::App* score_command =
        app.add_subcommand("score", "Metrics, score and reasons of a recording");
    score_command->add_option("FILE", options->file, "FILE.placode")->required();
    score_command->add_option("--task", options->task,
                              "Task id or FILE.json (default: the task in the recording)");
    score_command->add_flag("--recover", options->recover, "Use what stands before the damage");
    score_command->callback([&context, options] {
        context.run = [&context, options] { return score(context, *options); };
    });
}

}  // namespace placode::cli
