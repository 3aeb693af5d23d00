// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a protocol, as they are done.

#include <array>

#include "db/store_context.h"
#include "db/studies.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr std::array<const char*, 3> kStates{"started", "done", "skipped"};

}  // namespace

int64_t Studies::insert_step(const StepRecord& step) {
    context_.touch("participant", {step.study_id, step.participant});
    if (step.attempt_id != 0) context_.touch("attempt", step.attempt_id);
    Statement insert(connection_,
                     "INSERT INTO study_steps (study_id, code, visit, step, state, attempt_id, "
                     "answer_id, detail, at_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(step.study_id, step.participant, step.visit, step.step,
               kStates[static_cast<size_t>(step.state)], step.attempt_id, step.answer_id,
               step.detail, step.at_utc.empty() ? utc_now() : step.at_utc);
    const int64_t id = insert.returned_id();
    // Whoever was signed in: it is the participant's from now on.
    if (step.attempt_id != 0)
        Statement(connection_,
                  "UPDATE attempts SET study = ?, participant = ? WHERE id = ? AND study = ''")
            .run(step.study_id, step.participant, step.attempt_id);
    return id;
}

int64_t Studies::record_step(const StepRecord& step) {
    connection_.begin_operation("record the step \"" + step.step + "\" in");
    context_.need(Action::kRunQuestionnaire);
    if (step.step.empty()) connection_.fail(Kind::kRefused, "the step has no id");
    UnitOfWork work(connection_);
    context_.need_active_participant(step.study_id, step.participant, step.step);
    Statement owner(connection_, "SELECT study, participant FROM attempts WHERE id = ?");
    if (owner.run(step.attempt_id).next()) {
        const std::string study = owner.text("study"), participant = owner.text("participant");
        if (!study.empty() && (study != step.study_id || participant != step.participant))
            connection_.fail(Kind::kRefused, "attempt " + std::to_string(step.attempt_id) +
                                                 " belongs to " + participant + " of the study \"" +
                                                 study + "\"");
    }
    const int64_t id = insert_step(step);
    context_.append_audit("study.step", step.study_id + " " + step.participant,
                          step.step + " " + kStates[static_cast<size_t>(step.state)] +
                              (step.detail.empty() ? "" : ": " + step.detail));
    work.commit();
    return id;
}

std::vector<StepRecord> Studies::steps(const std::string& study_id) {
    connection_.begin_operation("read the steps of a study from");
    // They say which attempt is whose code, which who sees all attempts sees anyway.
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy, Action::kViewAttempts});
    Statement query(connection_,
                    "SELECT s.id, s.code, s.visit, s.step, s.state, s.attempt_id, s.answer_id, "
                    "s.detail, s.at_utc, COALESCE(u.reason, '') AS superseded_reason, "
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
