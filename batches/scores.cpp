// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/scores.h"

#include <sstream>

#include "assessment/signal.h"
#include "batches/batch_error.h"
#include "batches/merge.h"
#include "batches/shard.h"
#include "db/reason_json.h"

namespace placode::batches {
namespace {

using assessment::Verdict;

Verdict verdict_of(const std::string& name) {
    for (const Verdict one :
         {Verdict::kPassed, Verdict::kNotYet, Verdict::kFailed, Verdict::kNotAttempted})
        if (name == assessment::verdict_name(one)) return one;
    throw BatchError(BatchError::Kind::kFailed, "verdict \"" + name + "\" in a result: unknown");
}

assessment::MetricSet metrics_of(const Json& json) {
    assessment::MetricSet metrics;
    for (const auto& [id, value] : json.items())
        metrics.values.push_back({id, value.get<double>()});
    return metrics;
}

db::RescoreRecord record_of(const Json& line, int64_t attempt) {
    db::RescoreRecord record;
    record.attempt_id = attempt;
    record.preprocessing_version = assessment::kPreprocessingVersion;
    assessment::Score& score = record.score;
    score.points = line.at("points").get<double>();
    score.verdict = verdict_of(line.at("verdict").get<std::string>());
    score.rubric_id = line.at("rubric").get<std::string>();
    score.rubric_version = line.at("rubric_version").get<int>();
    score.metric_set_version = line.at("metric_set_version").get<int>();
    for (const Json& one : line.at("reasons"))
        score.reasons.push_back({one.at("item").get<std::string>(),
                                 one.at("text").get<std::string>(), one.at("points").get<double>(),
                                 one.at("time_s").get<double>(), one.at("critical").get<bool>(),
                                 db::reason_from_json(one.at("meaning").get<std::string>())});
    record.metrics = metrics_of(line.at("metrics"));
    record.metrics.version = score.metric_set_version;
    return record;
}

/// Every line of all shards, which must be done.
template <class Take>
void for_each_line(const std::filesystem::path& folder, const Manifest& manifest, Take&& take) {
    need_all_shards(batch_status(folder, manifest));
    for (int number = 0; number < manifest.shards(); ++number) {
        const Shard shard = read_done_shard(folder, manifest, number);
        std::istringstream lines(shard.lines);
        for (std::string text; std::getline(lines, text);) take(Json::parse(text));
    }
}

}  // namespace

Json score_json(const assessment::Score& score) {
    return {{"points", score.points},
            {"verdict", assessment::verdict_name(score.verdict)},
            {"rubric", score.rubric_id},
            {"rubric_version", score.rubric_version},
            {"metric_set_version", score.metric_set_version}};
}

Json reasons_json(const assessment::Score& score) {
    Json reasons = Json::array();
    for (const assessment::Reason& one : score.reasons)
        reasons.push_back({{"item", one.item},
                           {"text", one.text},
                           {"points", one.points},
                           {"time_s", one.time_s},
                           {"critical", one.critical},
                           {"meaning", db::reason_json(one.meaning)}});
    return reasons;
}

Json metrics_json(const assessment::MetricSet& metrics) {
    Json json = Json::object();
    for (const auto& metric : metrics.values) json[metric.id] = metric.value;
    return json;
}

std::map<int64_t, StoredScore> scores_for_store(const std::filesystem::path& folder,
                                                const Manifest& manifest) {
    const bool of_store = manifest.kind == "rescore" && !manifest.options.at("task").is_null() &&
                          !manifest.items.empty() && manifest.items[0].contains("attempt");
    if (!of_store)
        throw BatchError(BatchError::Kind::kBadInput,
                         folder.string() +
                             ": its scores are of no store; expected a batch that `placodectl "
                             "batch plan rescore --from-store --task TASK` planned");
    std::map<int64_t, StoredScore> scores;
    for_each_line(folder, manifest, [&](const Json& line) {
        const Json& item = manifest.items.at(line.at("item").get<size_t>());
        const auto attempt = item.at("attempt").get<int64_t>();
        StoredScore& stored = scores[attempt];
        stored.recording_sha256 = item.at("sha256").get<std::string>();
        stored.problem = line.value("problem", "");
        if (!stored.problem.empty()) return;
        stored.score.record = record_of(line, attempt);
        stored.score.lacks = line.value("lacks", std::vector<std::string>());
    });
    return scores;
}

std::vector<RolloutScore> scores_of_rollouts(const std::filesystem::path& folder,
                                             const Manifest& manifest) {
    if (manifest.kind != "rollouts" || !manifest.options.at("metrics").get<bool>())
        throw BatchError(BatchError::Kind::kBadInput,
                         folder.string() +
                             ": has no metrics of rollouts; expected a batch that `placodectl "
                             "batch plan rollouts --metrics` planned");
    std::vector<RolloutScore> scores;
    for_each_line(folder, manifest, [&](const Json& line) {
        scores.push_back({line.at("task").get<std::string>(), line.at("policy").get<std::string>(),
                          line.at("seed").get<uint64_t>(), line.at("points").get<double>(),
                          verdict_of(line.at("verdict").get<std::string>()),
                          metrics_of(line.at("metrics"))});
    });
    return scores;
}

}  // namespace placode::batches
