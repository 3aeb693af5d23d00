// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a protocol, as they are done.

#include <QTemporaryDir>
#include <algorithm>
#include <array>

#include "curriculum/study.h"
#include "db/attempts.h"
#include "db/recording_file.h"
#include "db/store_context.h"
#include "db/studies.h"
#include "db/void_reason.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr std::array<const char*, 3> kStates{"started", "done", "skipped"};

/// Makes a person's attempt the participant's, whoever was signed in. From then on it counts as
/// every attempt of a study: once it was simulated again, and without a recording not at all.
/// @return false where there is no recording.
bool adopt(Connection& connection, const StepRecord& step) {
    Statement query(
        connection,
        "SELECT void_reason, void_meaning, replay, end_reason FROM attempts WHERE id = ? "
        "AND study = ''");
    if (!query.run(step.attempt_id).next()) return true;
    std::vector<VoidReason> voids =
        void_reasons(query.text("void_reason"), query.text("void_meaning"));
    auto replay = static_cast<ReplayState>(query.integer("replay"));
    const auto end = static_cast<sim::EndReason>(query.integer("end_reason"));
    (void)query.next();  // its end, before the next question
    Statement recording(connection, "SELECT 1 FROM recordings WHERE attempt_id = ?");
    const bool recorded = recording.run(step.attempt_id).next();
    const VoidReason none{VoidCause::kNoRecording, 0, 0, {}};
    if (!recorded && std::find(voids.begin(), voids.end(), none) == voids.end())
        voids.push_back(none);
    if (voids.empty() && replay == ReplayState::kNotReplayed && end != sim::EndReason::kInterrupted)
        replay = ReplayState::kWaiting;
    Statement(connection,
              "UPDATE attempts SET study = ?, participant = ?, void_reason = ?, void_meaning = ?, "
              "replay = ?, read_by = '' WHERE id = ?")
        .run(step.study_id, step.participant, void_text(voids), void_meaning(voids),
             static_cast<int>(replay), step.attempt_id);
    return recorded;
}

/// The task that the participant's protocol asks for in this step; "" where it asks for none.
std::string asked_task(StoreContext& context, const StepRecord& step) {
    Statement query(context.connection,
                    "SELECT protocol_version FROM participant_states WHERE study_id = ? AND code = "
                    "?");
    const int version =
        query.run(step.study_id, step.participant).next() ? static_cast<int>(query.integer(0)) : 0;
    (void)query.next();  // its end, before the next question
    if (version == 0) return {};
    const auto published = context.find_definition("study", step.study_id, version);
    if (!published) return {};
    const auto protocol = curriculum::load_study_text(published->json, "study " + step.study_id);
    const curriculum::StudyStep* asked = protocol.step(step.step);
    return asked == nullptr ? std::string() : asked->task;
}

/// Whether it says itself that it was begun for a study. Without a recording it counts for nothing.
bool recorded_for_a_study(StoreContext& context, int64_t attempt_id) {
    Statement there(context.connection, "SELECT 1 FROM recordings WHERE attempt_id = ?");
    if (!there.run(attempt_id).next()) return true;
    (void)there.next();
    const QTemporaryDir folder;
    const std::string path = folder.filePath("attempt.placode").toStdString();
    Attempts(context).extract_recording(attempt_id, path);
    return recording_summary(path).header.mode == "study";
}

/// An attempt that was saved as a person's becomes the participant's only where it was made for a
/// study, by who records the step: anything else is somebody's training or exam, and would go with
/// the participant's data. Programs without an account work for whoever has the store.
void need_work_for_study(StoreContext& context, const StepRecord& step) {
    context.need_sight_of_attempt(step.attempt_id);
    Connection& connection = context.connection;
    Statement query(connection,
                    "SELECT account_id, task_id, exam_course FROM attempts WHERE id = ? AND study "
                    "= ''");
    if (!query.run(step.attempt_id).next()) return;
    const int64_t owner = query.integer("account_id");
    const std::string task = query.text("task_id"), exam = query.text("exam_course");
    (void)query.next();  // its end, before the next question
    const bool own = context.actor.kind == Actor::Kind::kProgram || context.is_self(owner);
    const std::string doing = "record the step \"" + step.step + "\" in";
    if (!own || !exam.empty() || !recorded_for_a_study(context, step.attempt_id)) {
        connection.begin_operation(doing);
        connection.fail(Kind::kRefused,
                        Said::that("attempt %1 was not recorded for a study under your account")
                            .with(step.attempt_id));
    }
    connection.begin_operation(doing);
    if (const std::string asked = asked_task(context, step); !asked.empty() && asked != task)
        connection.fail(Kind::kRefused,
                        Said::that("attempt %1 is of the task \"%2\"; this step asks for \"%3\"")
                            .with(step.attempt_id)
                            .with(task)
                            .with(asked));
}

}  // namespace

int64_t Studies::insert_step(StepRecord step) {
    context_.touch("participant", {step.study_id, step.participant});
    if (step.attempt_id != 0) {
        context_.touch("attempt", step.attempt_id);
        if (!adopt(connection_, step) && step.state == StepState::kDone) {
            NotDone why;
            why.voids.push_back({VoidCause::kNoRecording, 0, 0, {}});
            step.state = StepState::kStarted;
            step.detail = not_done_text(why);
            step.detail_meaning = not_done_meaning(why);
        }
    }
    Statement insert(
        connection_,
        "INSERT INTO study_steps (study_id, code, visit, step, state, attempt_id, "
        "answer_id, detail, detail_meaning, at_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
        "RETURNING id");
    insert.run(step.study_id, step.participant, step.visit, step.step,
               kStates[static_cast<size_t>(step.state)], step.attempt_id, step.answer_id,
               step.detail, step.detail_meaning, step.at_utc.empty() ? utc_now() : step.at_utc);
    const int64_t id = insert.returned_id();
    context_.append_audit("study.step", step.study_id + " " + step.participant,
                          step.step + " " + kStates[static_cast<size_t>(step.state)] +
                              (step.detail.empty() ? "" : ": " + step.detail));
    return id;
}

int64_t Studies::record_step(const StepRecord& step) {
    connection_.begin_operation("record the step \"" + step.step + "\" in");
    context_.need(Action::kRunQuestionnaire);
    if (step.step.empty()) connection_.fail(Kind::kRefused, Said::that("the step has no id"));
    if (step.attempt_id != 0 && context_.owner_of_attempt(step.attempt_id))
        need_work_for_study(context_, step);
    UnitOfWork work(connection_);
    context_.need_active_participant(step.study_id, step.participant, step.step);
    Statement owner(connection_, "SELECT study, participant FROM attempts WHERE id = ?");
    if (owner.run(step.attempt_id).next()) {
        const std::string study = owner.text("study"), participant = owner.text("participant");
        if (!study.empty() && (study != step.study_id || participant != step.participant))
            connection_.fail(Kind::kRefused,
                             Said::that("attempt %1 belongs to %2 of the study \"%3\"")
                                 .with(step.attempt_id)
                                 .with(participant)
                                 .with(study));
    } else if (step.attempt_id != 0 && context_.owner_of_attempt(step.attempt_id)) {
        // There, and a server does not show it: somebody else's, of no study.
        context_.refuse(Action::kViewAttempts);
    }
    const int64_t id = insert_step(step);
    work.commit();
    return id;
}

std::vector<StepRecord> Studies::steps(const std::string& study_id) {
    connection_.begin_operation("read the steps of a study from");
    // They say which attempt is whose code, which who sees all attempts sees anyway.
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy, Action::kViewAttempts});
    Statement query(
        connection_,
        "SELECT s.id, s.code, s.visit, s.step, s.state, s.attempt_id, s.answer_id, "
        "s.detail, s.detail_meaning, s.at_utc, COALESCE(u.reason, '') AS superseded_reason, "
        "COALESCE(u.superseded_by, '') AS superseded_by, COALESCE(u.superseded_utc, "
        "'') AS superseded_utc FROM study_steps s LEFT JOIN superseded_steps u ON "
        "u.step_id = s.id WHERE s.study_id = ? ORDER BY s.id");
    query.run(study_id);
    std::vector<StepRecord> found;
    while (query.next()) {
        StepRecord step;
        step.id = query.integer("id");
        step.study_id = study_id;
        step.participant = query.text("code");
        step.visit = static_cast<int>(query.integer("visit"));
        step.step = query.text("step");
        const std::string state = query.text("state");
        for (size_t i = 0; i < kStates.size(); ++i)
            if (state == kStates[i]) step.state = static_cast<StepState>(i);
        step.attempt_id = query.integer("attempt_id");
        step.answer_id = query.integer("answer_id");
        step.detail = query.text("detail");
        step.detail_meaning = query.text("detail_meaning");
        step.at_utc = query.text("at_utc");
        step.superseded_reason = query.text("superseded_reason");
        step.superseded_by = query.text("superseded_by");
        step.superseded_utc = query.text("superseded_utc");
        found.push_back(std::move(step));
    }
    context_.show_names(found, &StepRecord::superseded_by);
    return found;
}

}  // namespace placode::db
