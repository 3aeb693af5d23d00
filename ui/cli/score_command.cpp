// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl score

#include <memory>

#include "assessment/scoring.h"
#include "assessment/soundness.h"
#include "curriculum/task.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "haptics/certificate.h"
#include "ui/cli/cli.h"
#include "ui/cli/recording_output.h"

namespace placode::cli {
namespace {

struct ScoreOptions {
    std::string file, task;
    bool recover = false;
};

/// The task that was asked for, else the program's own of the recording's id and version. Only
/// where there is none, and the result says so, the one that the recording carries.
curriculum::Task task_to_score_by(const sim::Recording& recording, const ScoreOptions& options,
                                  bool& published) {
    if (!options.task.empty()) return curriculum::load_task(options.task);
    const auto shipped = db::shipped_task(recording.header.task_id);
    published = shipped && shipped->version == recording.header.task_version;
    return published ? *shipped
                     : curriculum::load_task_text(recording.header.task_json,
                                                  options.file + " (its task)");
}

/// The haptic certificate in the file, judged again with the limits of today.
void add_certificate(const std::string& file, Json& json, std::string& text) {
    json["haptics"] = nullptr;
    if (const std::string found = db::haptic_certificate(file); !found.empty()) {
        const auto verdict = haptics::judge(haptics::certificate_from_json(found));
        json["haptics"] = Json::parse(found, nullptr, false);
        json["haptics"]["grade"] = haptics::grade_name(verdict.grade);
        json["haptics"]["reasons"] = Json::array();
        if (verdict.grade != haptics::CertificateGrade::kNotApplicable)
            text += "haptic certificate: " + std::string(haptics::grade_name(verdict.grade)) + "\n";
        for (const sim::Said& reason : verdict.reasons) {
            json["haptics"]["reasons"].push_back(reason.english());
            text += "  " + reason.english() + "\n";
        }
    }
}

int score(const Context& context, const ScoreOptions& options) {
    std::string damage;
    const sim::Recording recording = load_recording(options.file, options.recover, damage);
    bool published = true;
    const curriculum::Task task = task_to_score_by(recording, options, published);
    if (const auto problem = assessment::unsound(recording))
        throw InputError(options.file + ": the recording cannot be scored: " + problem->english());
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
    json["metrics"] = metrics_json(metrics);
    add_certificate(options.file, json, text);
    print(context, json, text + table(rows) + "\n" + metric_table(metrics));
    return 0;
}

}  // namespace

void add_score_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<ScoreOptions>();
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
