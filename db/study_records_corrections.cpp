// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Answers after they were submitted: corrections with a reason, the second entry from paper, the
// signature under a consent.

#include "db/consent_encryption.h"
#include "db/store_context.h"
#include "db/study_records.h"

namespace placode::db {

using Kind = StoreError::Kind;

AnswerRecord StudyRecords::need_answers(int64_t answer_id, int entry) {
    AnswerRecord record;
    {
        Statement query(connection_,
                        "SELECT study_id, participant, questionnaire_id, questionnaire_version "
                        "FROM answers WHERE id = ?");
        if (!query.run(answer_id).next())
            connection_.fail(Kind::kNotFound, "there are no answers number " +
                                                  std::to_string(answer_id) +
                                                  "; they may have "
                                                  "been erased with a withdrawal");
        record.id = answer_id;
        record.study_id = query.text("study_id");
        record.participant = query.text("participant");
        record.questionnaire_id = query.text("questionnaire_id");
        record.questionnaire_version = static_cast<int>(query.integer("questionnaire_version"));
    }
    Statement items(connection_, entry == 1
                                     ? "SELECT item, answer FROM answer_items WHERE answer_id = ?"
                                     : "SELECT item, answer FROM second_entry_items WHERE "
                                       "answer_id = ?");
    items.run(answer_id);
    while (items.next()) record.answers[items.text(0)] = items.text(1);
    return record;
}

void StudyRecords::need_valid(const AnswerRecord& answers) {
    const auto published = context_.find_definition("questionnaire", answers.questionnaire_id,
                                                    answers.questionnaire_version);
    if (!published)
        connection_.fail(Kind::kRefused, Said::that("the questionnaire %1 is not published, so "
                                                    "that nothing says which answers are possible")
                                             .with(answers.questionnaire_id));
    const auto questionnaire = curriculum::load_questionnaire_text(
        published->json, "questionnaire " + answers.questionnaire_id);
    if (const auto problem = curriculum::check_answers(questionnaire, answers.answers))
        connection_.fail(Kind::kRefused, Said::that("%1; nothing was changed").with(*problem));
}

void StudyRecords::correct_answers(int64_t answer_id, int entry, const curriculum::Answers& changes,
                                   const std::string& reason) {
    connection_.begin_operation("correct answers in");
    context_.need(Action::kRunQuestionnaire);
    if (reason.empty()) connection_.fail(Kind::kRefused, Said::that("a correction needs a reason"));
    UnitOfWork work(connection_);
    AnswerRecord record = need_answers(answer_id, entry);
    if (entry == 2 && record.answers.empty())
        connection_.fail(Kind::kNotFound, Said::that("these answers have no second entry"));
    context_.need_unlocked(record.study_id, record.participant);
    const curriculum::Answers before = record.answers;
    for (const auto& [item, answer] : changes) {
        if (answer.empty())
            record.answers.erase(item);
        else
            record.answers[item] = answer;
    }
    need_valid(record);
    context_.touch("participant", {record.study_id, record.participant});
    const std::string table = entry == 1 ? "answer_items" : "second_entry_items";
    Statement(connection_, "DELETE FROM " + table + " WHERE answer_id = ?").run(answer_id);
    Statement insert(connection_,
                     "INSERT INTO " + table + " (answer_id, item, answer) VALUES (?, ?, ?)");
    for (const auto& [item, answer] : record.answers) insert.run(answer_id, item, answer);
    Statement keep(connection_,
                   "INSERT INTO answer_corrections (answer_id, entry, item, old_answer, "
                   "new_answer, reason, corrected_by, at_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?) "
                   "RETURNING id");
    std::string items, numbers;
    for (const auto& [item, answer] : changes) {
        const auto old = before.find(item);
        const std::string was = old == before.end() ? "" : old->second;
        if (was == answer) continue;
        keep.run(answer_id, entry, item, was, answer, reason, context_.actor.name, utc_now());
        items += " " + item;
        numbers += " " + std::to_string(keep.returned_id());
    }
    if (items.empty()) connection_.fail(Kind::kRefused, Said::that("nothing would change"));
    // Which corrections, never why: the trail stays when the participant's data are erased.
    context_.append_audit("study.correct", record.study_id + " " + record.participant,
                          record.questionnaire_id + (entry == 2 ? ", second entry:" : ":") + items +
                              "; correction" + numbers);
    work.commit();
}

std::vector<Correction> StudyRecords::corrections(const std::string& study_id) {
    connection_.begin_operation("read corrections from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT c.id, c.answer_id, c.entry, c.item, c.old_answer, c.new_answer, "
                    "c.reason, c.corrected_by, c.at_utc FROM answer_corrections c JOIN answers a "
                    "ON a.id = c.answer_id WHERE a.study_id = ? ORDER BY c.id");
    query.run(study_id);
    std::vector<Correction> found;
    while (query.next())
        found.push_back({query.integer("id"), query.integer("answer_id"),
                         static_cast<int>(query.integer("entry")), query.text("item"),
                         query.text("old_answer"), query.text("new_answer"), query.text("reason"),
                         query.text("corrected_by"), query.text("at_utc")});
    context_.show_names(found, &Correction::corrected_by);
    return found;
}

void StudyRecords::save_second_entry(const SecondEntry& entry) {
    connection_.begin_operation("save a second entry in");
    context_.need(Action::kRunQuestionnaire);
    UnitOfWork work(connection_);
    AnswerRecord record = need_answers(entry.answer_id, 1);
    context_.need_unlocked(record.study_id, record.participant);
    Statement there(connection_, "SELECT entered_by FROM second_entries WHERE answer_id = ?");
    if (there.run(entry.answer_id).next())
        connection_.fail(
            Kind::kConflict,
            Said::that("these answers have a second entry, by %1").with(there.text(0)));
    record.answers = entry.answers;
    need_valid(record);
    context_.touch("participant", {record.study_id, record.participant});
    Statement(connection_,
              "INSERT INTO second_entries (answer_id, entered_by, at_utc) VALUES (?, ?, ?)")
        .run(entry.answer_id, context_.actor.name, utc_now());
    Statement item(connection_,
                   "INSERT INTO second_entry_items (answer_id, item, answer) VALUES (?, ?, ?)");
    for (const auto& [name, value] : entry.answers) item.run(entry.answer_id, name, value);
    context_.append_audit("study.second_entry", record.study_id + " " + record.participant,
                          record.questionnaire_id);
    work.commit();
}

std::vector<SecondEntry> StudyRecords::second_entries(const std::string& study_id) {
    connection_.begin_operation("read second entries from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT e.answer_id, e.entered_by, e.at_utc, i.item, i.answer FROM "
                    "second_entries e JOIN answers a ON a.id = e.answer_id LEFT JOIN "
                    "second_entry_items i ON i.answer_id = e.answer_id WHERE a.study_id = ? ORDER "
                    "BY e.answer_id, i.item");
    query.run(study_id);
    std::vector<SecondEntry> found;
    while (query.next()) {
        const int64_t answer_id = query.integer("answer_id");
        if (found.empty() || found.back().answer_id != answer_id)
            found.push_back({answer_id, {}, query.text("entered_by"), query.text("at_utc")});
        if (const std::string item = query.text("item"); !item.empty())
            found.back().answers[item] = query.text("answer");
    }
    context_.show_names(found, &SecondEntry::entered_by);
    return found;
}

void StudyRecords::save_consent_signature(const std::string& study_id, const std::string& code,
                                          const std::string& path) {
    connection_.begin_operation("save the signature under the consent of " + code + " in");
    context_.need(Action::kRunQuestionnaire);
    if (path.empty()) connection_.fail(Kind::kRefused, Said::that("nothing was signed"));
    UnitOfWork work(connection_);
    context_.need_active_participant(study_id, code, "");
    Statement there(connection_,
                    "SELECT at_utc FROM consent_signatures WHERE study_id = ? AND code = ?");
    if (there.run(study_id, code).next())
        connection_.fail(Kind::kConflict,
                         Said::that("the consent was signed at %1").with(there.text(0)));
    const auto key = context_.find_definition("consent_seal", study_id, 0);
    context_.touch("participant", {study_id, code});
    Statement(connection_,
              "INSERT INTO consent_signatures (study_id, code, path, at_utc) VALUES (?, ?, ?, ?)")
        .run(study_id, code, key ? encrypted(path, consent_key_of(key->json).public_key) : path,
             utc_now());
    context_.append_audit("study.consent.signature", study_id + " " + code, "");
    work.commit();
}

std::optional<ConsentSignature> StudyRecords::consent_signature(const std::string& study_id,
                                                                const std::string& code) {
    connection_.begin_operation("read the signature under a consent from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT path, at_utc FROM consent_signatures WHERE study_id = ? AND code = ?");
    if (!query.run(study_id, code).next()) return std::nullopt;
    return ConsentSignature{code, query.text(0), query.text(1)};
}

}  // namespace placode::db
