// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/rescore.h"

#include <algorithm>
#include <array>
#include <set>

#include "assessment/signal.h"
#include "assessment/soundness.h"
#include "assessment/tissue_metrics.h"
#include "db/attempt_comparison.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "db/said.h"
#include "db/standards.h"

namespace placode::db {
namespace {

/// The first score or a further one is of exactly this rubric, metric set and pre-processing.
bool has_score(Store& store, const AttemptRecord& attempt, const assessment::Rubric& rubric) {
    const auto same = [&](const std::string& id, int version, int metrics, int preprocessing) {
        return id == rubric.id && version == rubric.version &&
               metrics == assessment::kMetricSetVersion &&
               preprocessing == assessment::kPreprocessingVersion;
    };
    if (same(attempt.rubric_id, attempt.rubric_version, attempt.metric_set_version,
             attempt.preprocessing_version))
        return true;
    const auto further = store.attempts().rescores(attempt.id);
    return std::any_of(further.begin(), further.end(), [&](const RescoreRecord& one) {
        return same(one.score.rubric_id, one.score.rubric_version, one.score.metric_set_version,
                    one.preprocessing_version);
    });
}

/// The definition that keeps the rubric's text.
DefinitionRecord rubric_definition(const curriculum::Task& task) {
    DefinitionRecord definition;
    definition.kind = "rubric";
    definition.id = task.id + "/" + task.rubric.id;
    definition.version = task.rubric.version;
    definition.json = curriculum::rubric_text(task);
    definition.reason = "used for rescoring";
    return definition;
}

[[noreturn]] void refuse_text(const DefinitionRecord& wanted) {
    throw StoreError(
        StoreError::Kind::kConflict, "",
        Said::that(
            "rubric %1 version %2 is known with another text; give the rubric the next version")
            .with(wanted.id)
            .with(wanted.version));
}

void check_version(Store& store, const DefinitionRecord& wanted) {
    const auto there = store.definitions().find(wanted.kind, wanted.id, wanted.version);
    if (there && there->json != wanted.json) refuse_text(wanted);
}

/// A version that a published task is judged by means that task's text. What recordings carry is
/// not asked: one forged file would speak for all.
void check_published(Store& store, const std::vector<AttemptRecord>& attempts,
                     const curriculum::Task& task, const DefinitionRecord& wanted) {
    std::set<int> versions;
    for (const AttemptRecord& attempt : attempts) versions.insert(attempt.task_version);
    versions.insert(0);  // The newest that the store keeps; the program's below.
    const auto compare = [&](const std::optional<curriculum::Task>& published) {
        if (published && published->rubric.id == task.rubric.id &&
            published->rubric.version == task.rubric.version &&
            curriculum::rubric_text(*published) != wanted.json)
            refuse_text(wanted);
    };
    for (const int version : versions) compare(published_task(store, task.id, version));
    compare(shipped_task(task.id));
}

/// Throws StoreError kDamaged when the recording cannot be scored.
ComputedScore compute(Store& store, const AttemptRecord& attempt, const curriculum::Task& task,
                      const std::string& file) {
    const sim::Recording recording = read_recording_file(file);
    if (const auto problem = assessment::unsound(recording))
        throw StoreError(StoreError::Kind::kDamaged, "it cannot be scored: " + problem->english());
    ComputedScore found;
    found.record.attempt_id = attempt.id;
    found.record.metrics = assessment::compute_metrics(recording);
    found.record.score = assessment::score_attempt(rubric_at(store, task, attempt.started_utc),
                                                   found.record.metrics, recording);
    found.record.preprocessing_version = assessment::kPreprocessingVersion;
    for (const std::string_view id : assessment::not_recorded(recording))
        found.lacks.emplace_back(id);
    return found;
}

/// Before anything is saved: a computer that computes otherwise, or lies, is found on a sample.
void compare_computed(Store& store, const std::vector<AttemptRecord>& attempts,
                      const curriculum::Task& task, const RescoreOptions& options) {
    for (const AttemptRecord& attempt : attempts) {
        if (!options.recompute.contains(attempt.id)) continue;
        const ExtractedRecording file(store, attempt.id);
        const auto theirs = options.computed(attempt.id, file.path);
        if (!theirs) continue;
        const RescoreRecord ours = compute(store, attempt, task, file.path).record;
        if (!score_difference(theirs->record.metrics, theirs->record.score, ours.metrics,
                              ours.score)
                 .empty())
            throw StoreError(StoreError::Kind::kConflict,
                             "attempt " + std::to_string(attempt.id) + ": the batch says " +
                                 std::to_string(theirs->record.score.points) + " points, " +
                                 assessment::verdict_name(theirs->record.score.verdict) +
                                 ", this computer finds " + std::to_string(ours.score.points) +
                                 ", " + assessment::verdict_name(ours.score.verdict) +
                                 "; nothing of the batch was kept");
    }
}

RescoreOutcome rescore_one(Store& store, const AttemptRecord& attempt, const curriculum::Task& task,
                           const RescoreOptions& options) {
    RescoreOutcome outcome;
    outcome.attempt_id = attempt.id;
    outcome.old_points = attempt.points;
    outcome.old_verdict = attempt.verdict;
    const bool there = has_score(store, attempt, task.rubric);
    if (there && !options.dry_run) {
        outcome.state = RescoreState::kAlreadyThere;
        return outcome;
    }
    try {
        const ExtractedRecording file(store, attempt.id);
        const auto found = options.computed ? options.computed(attempt.id, file.path)
                                            : compute(store, attempt, task, file.path);
        if (!found) {
            outcome.state = RescoreState::kNotComputed;
            return outcome;
        }
        outcome.lacks = found->lacks;
        outcome.new_points = found->record.score.points;
        outcome.new_verdict = found->record.score.verdict;
        if (there) outcome.state = RescoreState::kAlreadyThere;
        if (!options.dry_run) store.attempts().save_rescore(found->record);
    } catch (const StoreError& error) {
        if (error.kind() != StoreError::Kind::kNotFound &&
            error.kind() != StoreError::Kind::kDamaged)
            throw;
        outcome.state = error.kind() == StoreError::Kind::kNotFound ? RescoreState::kNoRecording
                                                                    : RescoreState::kUnreadable;
        outcome.problem = error.what();
    }
    return outcome;
}

}  // namespace

const char* rescore_state_name(RescoreState state) {
    constexpr std::array<const char*, 5> kNames{"rescored", "already there", "no recording",
                                                "unreadable", "not in the batch"};
    return kNames[static_cast<size_t>(state)];
}

ExtractedRecording::ExtractedRecording(Store& store, int64_t attempt_id)
    : path(folder.filePath(QStringLiteral("a.placode")).toStdString()) {
    store.attempts().extract_recording(attempt_id, path);
}

sim::Recording stored_recording(Store& store, int64_t attempt_id) {
    return read_recording_file(ExtractedRecording(store, attempt_id).path);
}

std::vector<RescoreOutcome> rescore(Store& store, const curriculum::Task& task,
                                    const RescoreOptions& options) {
    const DefinitionRecord rubric = rubric_definition(task);
    check_version(store, rubric);
    const auto attempts = store.attempts().list(options.user_id, task.id);
    if (!store.definitions().find("rubric", rubric.id, rubric.version))
        check_published(store, attempts, task, rubric);
    if (options.computed) compare_computed(store, attempts, task, options);
    if (!options.dry_run && !attempts.empty() &&
        !store.definitions().find("rubric", rubric.id, rubric.version))
        store.definitions().publish(rubric);
    std::vector<RescoreOutcome> outcomes;
    for (const AttemptRecord& attempt : attempts) {
        if (options.progress && !options.progress(outcomes.size(), attempts.size())) break;
        outcomes.push_back(rescore_one(store, attempt, task, options));
    }
    return outcomes;
}

}  // namespace placode::db
