// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/items.h"

#include "assessment/metrics.h"
#include "assessment/scoring.h"
#include "assessment/soundness.h"
#include "assessment/tissue_metrics.h"
#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "batches/scores.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/replay_check.h"
#include "db/recording_file.h"
#include "db/store_error.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;

constexpr int kFramesBetweenQuestions = 50;

/// Names of recordings only: folders differ from machine to machine.
std::string plain_name(const Json& item) {
    return fs::path(item.at("recording").get<std::string>()).filename().string();
}

bool same_text(const curriculum::Task& published, const std::string& recorded_json) {
    try {
        return curriculum::load_task_text(recorded_json, "recorded task").json ==
               curriculum::load_task_text(published.json, "published task").json;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

Worker::Worker(fs::path folder, const Manifest& manifest, GoOn go_on)
    : folder_(std::move(folder)),
      manifest_(manifest),
      go_on_(std::move(go_on)),
      fields_(std::make_shared<environment::FieldCache>(2)) {}
Worker::~Worker() = default;

void Worker::check_stop() const {
    if (go_on_ && !go_on_()) throw Stopped{};
}

Json Worker::perform(size_t index) {
    check_stop();
    const Json& item = manifest_.items.at(index);
    Json result{{"item", index}};
    if (manifest_.kind == "rollouts") {
        result.update(rollout(item));
        return result;
    }
    result["recording"] = plain_name(item);
    try {
        result.update(manifest_.kind == "replay" ? replay(item) : rescore(item));
    } catch (const db::StoreError& error) {
        if (error.kind() != db::StoreError::Kind::kDamaged &&
            error.kind() != db::StoreError::Kind::kTooNew)
            throw;
        result["problem"] = "the recording is damaged or of a later version";
    } catch (const curriculum::DefinitionError& error) {
        result["problem"] = std::string("its task cannot be built here: ") + error.what();
    }
    return result;
}

const curriculum::Task* Worker::task(const std::string& key, const std::string& value) {
    const Json* const entry = entry_of(manifest_, key, value);
    if (entry == nullptr) return nullptr;
    const auto ref = entry->at("ref").get<std::string>();
    auto known = tasks_.find(ref);
    if (known == tasks_.end()) known = tasks_.emplace(ref, task_of_entry(*entry, folder_)).first;
    return &known->second;
}

sim::Recording Worker::planned_recording(const Json& item) const {
    const fs::path path = input_path(folder_, item);
    if (sha256_of_file(path) != item.at("sha256").get<std::string>())
        throw BatchError(Kind::kBadInput,
                         path.string() +
                             ": is not the file that the batch was planned with (its checksum "
                             "differs); put that one back, or plan anew in another folder");
    return db::read_recording_file(path.string());
}

Json Worker::rescore(const Json& item) {
    const sim::Recording recording = planned_recording(item);
    const Json& by = manifest_.options.at("task");
    const curriculum::Task* judge =
        by.is_null() ? task("id", recording.header.task_id) : task("ref", by.get<std::string>());
    Json result{{"task", recording.header.task_id},
                {"task_version", recording.header.task_version}};
    if (judge == nullptr) {
        result["problem"] = "no such task is published here";
        return result;
    }
    if (judge->id != recording.header.task_id) {
        result["problem"] = "is of another task than " + judge->id;
        return result;
    }
    if (const auto problem = assessment::unsound(recording)) {
        result["problem"] = "cannot be scored: " + problem->english();
        return result;
    }
    assessment::Rubric rubric = judge->rubric;
    rubric.pass_points = item.value("pass_points", rubric.pass_points);
    const assessment::MetricSet metrics = assessment::compute_metrics(recording);
    const assessment::Score score = assessment::score_attempt(rubric, metrics, recording);
    const bool of_store = item.contains("attempt");
    result.update(score_json(score));
    for (const std::string_view id : assessment::not_recorded(recording))
        result["lacks"].push_back(id);
    if (of_store) result["reasons"] = reasons_json(score);
    if (of_store || manifest_.options.at("metrics").get<bool>())
        result["metrics"] = metrics_json(metrics);
    return result;
}

Json Worker::replay(const Json& item) {
    const sim::Recording recording = planned_recording(item);
    const curriculum::Task* published = task("id", recording.header.task_id);
    // Its own task: what is asked is whether the same comes out again. Whether that task is the
    // published one is said beside it.
    const curriculum::Task own =
        curriculum::load_task_text(recording.header.task_json, plain_name(item) + " (its task)");
    Json result{{"task", own.id},
                {"task_is_published",
                 published != nullptr && same_text(*published, recording.header.task_json)},
                {"recorded_by_this_build", recording.header.build == curriculum::this_build()},
                {"frames", recording.inputs.size()},
                {"recorded_hash", hash_text(recording.end.final_hash)}};
    if (const auto problem = assessment::unsound(recording)) {
        result["problem"] = "cannot be simulated: " + problem->english();
        return result;
    }
    curriculum::ReplayCheck check(recording, own, manifest_.options.at("threads").get<int>());
    for (int64_t frame = 0; check.step(); ++frame)
        if (frame % kFramesBetweenQuestions == 0) check_stop();
    const curriculum::ReplayVerdict verdict = check.verdict();
    result["replay"] = verdict.identical ? "identical" : "differs";
    if (!verdict.identical) result["difference"] = verdict.difference.english();
    return result;
}

void write_recording(const sim::Recording& recording, const fs::path& path) {
    const fs::path part = path.string() + ".part";
    fs::create_directories(path.parent_path());
    fs::remove(part);
    {
        const auto sink = db::create_recording_file(part.string());
        sink->begin(recording.header);
        if (!recording.given.empty()) sink->give(recording.given);
        sink->append(recording.inputs, recording.samples, recording.events);
        sink->finish(recording.end);
    }
    fs::rename(part, path);
}

}  // namespace placode::batches
