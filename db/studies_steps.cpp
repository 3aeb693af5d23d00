// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a protocol, as they are done.

#include <algorithm>
#include <array>

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
              "replay = ? WHERE id = ?")
        .run(step.study_id, step.participant, void_text(voids), void_meaning(voids),
             static_cast<int>(replay), step.attempt_id);
    return recorded;
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
