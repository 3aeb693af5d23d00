// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A procedure of a study that went wrong: done again for a reason, remarked on, never removed.

#include "db/store_context.h"
#include "db/study_records.h"

namespace placode::db {

using Kind = StoreError::Kind;

void StudyRecords::repeat_step(const std::string& study_id, const std::string& code, int visit,
                               const std::string& step, const std::string& reason) {
    connection_.begin_operation("have the step \"" + step + "\" of " + code + " done again in");
    context_.need(Action::kRunQuestionnaire);
    if (reason.empty()) connection_.fail(Kind::kRefused, Said::that("a repeat needs a reason"));
    UnitOfWork work(connection_);
    context_.need_participant(study_id, code);
    context_.need_active_participant(study_id, code, "");
    Statement query(connection_,
                    "SELECT s.id, s.state, s.attempt_id FROM study_steps s WHERE s.study_id = ? "
                    "AND s.code = ? AND s.visit = ? AND s.step = ? AND NOT EXISTS (SELECT 1 FROM "
                    "superseded_steps u WHERE u.step_id = s.id) ORDER BY s.id");
    query.run(study_id, code, visit, step);
    // What was tried and did not do the step counts already for nothing.
    std::vector<int64_t> ids;
    int64_t attempt = 0;
    while (query.next()) {
        if (query.text("state") == "started") continue;
        ids.push_back(query.integer("id"));
        if (const int64_t made = query.integer("attempt_id"); made != 0) attempt = made;
    }
    if (attempt == 0)
        connection_.fail(Kind::kRefused,
                         Said::that("there is no attempt of this step that counts; only a "
                                    "procedure that was done is done again"));
    context_.touch("participant", {study_id, code});
    for (const int64_t id : ids)
        Statement(connection_,
                  "INSERT INTO superseded_steps (step_id, reason, superseded_by, superseded_utc) "
                  "VALUES (?, ?, ?, ?)")
            .run(id, reason, context_.actor.name, utc_now());
    // Why stands in the rows, which go with the participant's data; the trail stays.
    context_.append_audit("study.repeat", study_id + " " + code,
                          step + ", visit " + std::to_string(visit) + ", instead of attempt " +
                              std::to_string(attempt));
    work.commit();
}

void StudyRecords::note_step(const std::string& study_id, const std::string& code, int visit,
                             const std::string& step, const std::string& note) {
    connection_.begin_operation("note something on the step \"" + step + "\" of " + code + " in");
    context_.need(Action::kRunQuestionnaire);
    if (note.empty()) connection_.fail(Kind::kRefused, Said::that("the note is empty"));
    if (step.empty()) connection_.fail(Kind::kRefused, Said::that("the step has no id"));
    UnitOfWork work(connection_);
    context_.need_participant(study_id, code);
    context_.need_unlocked(study_id, code);
    context_.touch("participant", {study_id, code});
    Statement insert(connection_,
                     "INSERT INTO step_notes (study_id, code, visit, step, note, noted_by, at_utc) "
                     "VALUES (?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(study_id, code, visit, step, note, context_.actor.name, utc_now());
    // Which note, never what: the trail stays when the participant's data are erased.
    context_.append_audit("study.note", study_id + " " + code,
                          step + ": note " + std::to_string(insert.returned_id()));
    work.commit();
}

std::vector<StepNote> StudyRecords::step_notes(const std::string& study_id) {
    connection_.begin_operation("read the notes of a study from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT id, code, visit, step, note, noted_by, at_utc FROM step_notes WHERE "
                    "study_id = ? ORDER BY id");
    query.run(study_id);
    std::vector<StepNote> found;
    while (query.next())
        found.push_back({query.integer("id"), study_id, query.text("code"),
                         static_cast<int>(query.integer("visit")), query.text("step"),
                         query.text("note"), query.text("noted_by"), query.text("at_utc")});
    context_.show_names(found, &StepNote::noted_by);
    return found;
}

}  // namespace placode::db
