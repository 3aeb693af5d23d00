// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/evidence.h"

#include <QtGlobal>
#include <algorithm>
#include <array>

#include "assessment/soundness.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/preset.h"
#include "curriculum/shipped_definitions.h"
#include "db/attempt_comparison.h"
#include "db/recording_file.h"
#include "db/rescore.h"
#include "db/standards.h"

namespace placode::db {
namespace {

using curriculum::Task;

/// With every number spelled out as this program does it: an older one left out what it did not
/// know. nullopt: it cannot be read.
std::optional<Task> task_of_text(const std::string& json) {
    try {
        return curriculum::load_task_text(json, "recorded task");
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

/// A preset changes tissue on purpose and is said to be tuned already.
bool is_told_as_tuned(const Task& recorded, const sim::Recording& recording) {
    return !curriculum::preset_of(recorded).empty() &&
           std::any_of(recording.events.begin(), recording.events.end(),
                       [](const auto& event) { return event.kind == sim::EventKind::kTuned; });
}

Said name_of(const std::string& id, int version) {
    return Said::listed(QT_TRANSLATE_NOOP("Said", "%1 version %2")).with(id).with(version);
}

/// No points for what nobody can judge.
assessment::Score no_score(const std::optional<Task>& task, const std::string& pattern) {
    assessment::Score score;
    if (task) {
        score.rubric_id = task->rubric.id;
        score.rubric_version = task->rubric.version;
    }
    assessment::Reason reason;
    reason.item = "not_verified";
    reason.meaning.pattern = pattern;
    reason.text = pattern;
    reason.time_s = -1;
    score.reasons.push_back(std::move(reason));
    return score;
}

}  // namespace

const char* replay_name(ReplayState state) noexcept {
    constexpr std::array<const char*, 4> kNames{"not replayed", "waiting", "identical", "differs"};
    return kNames[static_cast<size_t>(state) % kNames.size()];
}

std::optional<Task> shipped_task(const std::string& id) { return curriculum::shipped_task(id); }

std::optional<Task> published_task(Store& store, const std::string& id, int version) {
    if (version < 0) return std::nullopt;
    if (const auto kept = store.definitions().find("task", id, version))
        return task_of_text(kept->json);
    const auto shipped = shipped_task(id);
    return shipped && shipped->version == version ? shipped : std::nullopt;
}

TaskEvidence task_evidence(Store& store, const sim::Recording& recording) {
    const sim::RecordingHeader& head = recording.header;
    TaskEvidence evidence{published_task(store, head.task_id, head.task_version), {}};
    if (!evidence.task) {
        evidence.doubts.push_back(
            {VoidCause::kTaskUnknown, 0, 0, name_of(head.task_id, head.task_version)});
        return evidence;
    }
    const auto recorded = task_of_text(head.task_json);
    const auto published = task_of_text(evidence.task->json);
    if (recorded && published && recorded->json == published->json) return evidence;
    if (!recorded || !is_told_as_tuned(*recorded, recording))
        evidence.doubts.push_back(
            {VoidCause::kTaskDiffers, 0, 0, name_of(head.task_id, head.task_version)});
    return evidence;
}

AttemptResult judged(Store& store, const sim::Recording& recording) {
    AttemptResult result;
    result.header = recording.header;
    result.end = recording.end;
    result.events = recording.events;
    TaskEvidence evidence = task_evidence(store, recording);
    if (const auto problem = assessment::unsound(recording)) {
        evidence.doubts.push_back({VoidCause::kUnsound, 0, 0, *problem});
        result.score = no_score(evidence.task, "The recording cannot be scored.");
        // Numbers that nobody measured do not reach lists and sums either.
        result.events.clear();
        result.end.duration_s = std::clamp(result.end.duration_s, 0.0, 7200.0);
        if (!(recording.end.duration_s >= 0)) result.end.duration_s = 0;
    } else {
        result.metrics = assessment::compute_metrics(recording);
        result.score = evidence.task
                           ? assessment::score_attempt(
                                 rubric_at(store, *evidence.task, recording.header.started_utc),
                                 result.metrics, recording)
                           : no_score(evidence.task, "No rubric of this task is published here.");
    }
    result.not_verified = evidence.doubts;
    return result;
}

void publish_task_on_first_use(Store& store, const std::string& id, int version) {
    if (store.definitions().find("task", id, version)) return;
    const auto shipped = shipped_task(id);
    if (!shipped || shipped->version != version) return;
    DefinitionRecord definition;
    definition.kind = "task";
    definition.id = id;
    definition.version = version;
    definition.json = shipped->json;
    definition.reason = "first use of this version";
    try {
        store.definitions().publish(definition);
    } catch (const StoreError& error) {
        // A newer version is there, or somebody else was first: theirs holds.
        if (error.kind() != StoreError::Kind::kConflict) throw;
    }
}

std::string build_waited_for(const AttemptRecord& record) {
    if (record.build == curriculum::this_build()) return {};
    constexpr size_t kMost = 80;
    std::string shown = record.build.substr(0, kMost);
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return shown;
}

namespace {

/// Why the store's word for an attempt is not that of its recording; no verdict: it cannot be told
/// here, and the attempt stays as it is.
struct Doubted {
    bool told = true;
    std::optional<Said> why;
};

Doubted doubt_about(Store& store, const AttemptDetail& kept, const sim::Recording& recording,
                    const std::string& file) {
    AttemptResult found = judged(store, recording);
    found.exam = kept.record.exam;
    found.recording_file = file;
    ComparedScore score = compare_score(kept, found);
    if (score.outcome == ScoreComparison::kDiffers) return {true, std::move(score.difference)};
    return {score.outcome == ScoreComparison::kSame, std::nullopt};
}

}  // namespace

std::optional<curriculum::ReplayVerdict> verify_attempt(Store& store, int64_t attempt_id,
                                                        const ReplayProgress& progress) {
    const auto keep = [&](const curriculum::ReplayVerdict& verdict) {
        store.attempts().set_replay(
            attempt_id, verdict.identical ? ReplayState::kIdentical : ReplayState::kDiffers,
            verdict.difference);
        return verdict;
    };
    // Attempts of other builds are many after an update, and each is read once.
    if (store.attempts().was_read(attempt_id)) return std::nullopt;
    const AttemptDetail kept = store.attempts().detail(attempt_id);
    if (!store.attempts().judges_replay(attempt_id)) return std::nullopt;
    std::optional<ExtractedRecording> file;
    sim::Recording recording;
    try {
        file.emplace(store, attempt_id);
        recording = read_recording_file(file->path);
    } catch (const StoreError& error) {
        if (error.kind() != StoreError::Kind::kDamaged) throw;
        return keep({false, Said::listed(QT_TRANSLATE_NOOP("Said", "the recording is damaged"))});
    }
    const TaskEvidence evidence = task_evidence(store, recording);
    const bool of_this_build = recording.header.build == curriculum::this_build();
    if (of_this_build && !evidence.task) return std::nullopt;
    if (of_this_build && !evidence.doubts.empty())
        return keep(
            {false, Said::listed(QT_TRANSLATE_NOOP("Said", "its task is not the published one"))});
    const auto problem = assessment::unsound(recording);
    if (of_this_build && problem) return keep({false, *problem});
    // What the row says of the recording, and who signed it, every build reads alike.
    if (!problem) {
        if (kept.record.exam.begin != 0 && recording.header.mode != "exam")
            return keep(
                {false, Said::listed(QT_TRANSLATE_NOOP("Said", "it was not recorded as an exam"))});
        if (const auto differs = facts_that_differ(kept, recording)) return keep({false, *differs});
        if (const auto doubt = store.attempts().doubt_about(attempt_id, file->path))
            return keep({false, *doubt});
    }
    if (!of_this_build) {
        store.attempts().set_read(attempt_id);
        return std::nullopt;
    }
    const Doubted score = doubt_about(store, kept, recording, file->path);
    if (score.why) return keep({false, *score.why});
    if (!score.told) return std::nullopt;
    curriculum::ReplayCheck check(recording, *evidence.task, 1);
    constexpr int kFramesBetween = 50;
    for (int64_t frame = 0; check.step(); ++frame)
        if (progress && frame % kFramesBetween == 0 && !progress(check.share()))
            return std::nullopt;
    return keep(check.verdict());
}

}  // namespace placode::db
