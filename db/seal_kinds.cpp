// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/seal_kinds.h"

namespace placode::db {
namespace {

using View = std::string_view;

std::vector<SealKind> make_kinds() {
    const std::array<View, 3> attempt{"attempt_id"}, account{"account_id"},
        code{"study_id", "code"};
    const std::array<View, 3> of_answer{"a.study_id", "a.participant"};
    return {
        {"attempt",
         true,
         {// Copies that `bench store` makes are nobody's attempts, and are not sealed. Only what
          // counts for nothing is such a copy: whoever marks a row like one does not hide it.
          {"attempts t WHERE NOT (t.generated_from <> 0 AND t.demonstration = 1 AND "
           "t.exam_course = '' AND t.study = '' AND t.account_id IN (SELECT a.id FROM accounts a "
           "WHERE a.demonstration = 1))",
           {"t.id"},
           {},
           "account_id, task_id, task_version, started_utc, saved_utc, duration_s, device, seed, "
           "build, end_reason, final_hash, dropped, demonstration, points, verdict, rubric_id, "
           "rubric_version, metric_set_version, exam_course, exam_course_version, exam_stage, "
           "proctor, device_certificate, preprocessing_version, generated_from, "
           "haptic_certificate, haptic_grade, void_reason, study, participant, replay, "
           "replayed_utc"},
          {"attempt_metrics", attempt, {"position"}, "metric_id, value"},
          {"attempt_reasons",
           attempt,
           {"position"},
           "item, reason, points, time_s, critical, meaning"},
          {"attempt_events",
           attempt,
           {"position"},
           "time_s, kind, tool, tissue, value, value2, rest_x_m, rest_y_m, rest_z_m, element"},
          {"recordings", attempt, {}, "size_bytes, checksum"},
          {"attempt_scores",
           attempt,
           {"id"},
           "points, verdict, rubric_id, rubric_version, metric_set_version, "
           "preprocessing_version, scored_utc, scored_by"},
          {"attempt_score_metrics m JOIN attempt_scores s ON s.id = m.score_id",
           {"s.attempt_id"},
           {"m.score_id", "m.position"},
           "m.metric_id, m.value"},
          {"attempt_score_reasons r JOIN attempt_scores s ON s.id = r.score_id",
           {"s.attempt_id"},
           {"r.score_id", "r.position"},
           "r.item, r.reason, r.points, r.time_s, r.critical, r.meaning"},
          {"attempt_comments", attempt, {"id"}, "author_id, time_s, comment, at_utc, removed_utc"},
          {"attempt_ratings",
           attempt,
           {"id"},
           "rater_id, questionnaire_id, questionnaire_version, blinded, rated_utc"},
          {"attempt_rating_items i JOIN attempt_ratings r ON r.id = i.rating_id",
           {"r.attempt_id"},
           {"i.rating_id", "i.item"},
           "i.answer"},
          // Since 0016. Only where there is one: what was sealed before stays as it was sealed.
          {"attempts v WHERE v.void_meaning <> ''", {"v.id"}, {}, "v.void_meaning"},
          // Since 0017, likewise.
          {"attempts b WHERE b.exam_begin <> 0", {"b.id"}, {}, "b.exam_begin"}}},
        {"user",
         true,
         {{"accounts",
           {"id"},
           {},
           "password_hash, roles, active, demonstration, created_utc, password_given"},
          {"persons", account, {}, "login, login_key, display_name"},
          {"account_pins", account, {}, "pin_hash"},
          {"course_grants",
           account,
           {"id"},
           "course_id, stage_id, attempts, reason, granted_by, granted_utc"},
          {"certificates",
           account,
           {"id"},
           "course_id, course_version, mastered_utc, issued_utc, issued_by, code"},
          {"erasure_requests", account, {}, "reason, asked_utc, done_utc"},
          {"exam_begins",
           account,
           {"id"},
           "course_id, course_version, stage_id, task_id, task_version, seed, proctor, "
           "device_certificate, begun_utc"}}},
        {"group",
         true,
         {{"training_groups", {"id"}, {}, "name, name_key, created_utc"},
          {"group_members", {"group_id"}, {"account_id"}, "teaches"}}},
        {"assignment",
         true,
         {{"course_assignments",
           {"id"},
           {},
           "course_id, course_version, account_id, group_id, starts_utc, due_utc, assigned_by, "
           "assigned_utc, ended_utc"}}},
        {"invitation",
         true,
         {{"invitations",
           {"id"},
           {},
           "code_hash, roles, group_id, note, invited_by, made_utc, expires_utc, used_utc"}}},
        {"norm pack",
         true,
         {{"norm_packs",
           {"id"},
           {},
           "task_id, centre, content, signature, public_key, in_use, added_by, added_utc"}}},
        {"centre", false, {{"trusted_centres", {"public_key"}, {}, "centre, added_by, added_utc"}}},
        {"centre key",
         true,
         {{"centre_key", {"id"}, {}, "centre, public_key, secret_key, made_utc"}}},
        // The version is a number among texts: as text in both engines.
        {"definition",
         false,
         {{"definitions",
           {"kind", "id", "CAST(version AS TEXT)"},
           {},
           "content, checksum, reason, published_by, published_utc"}}},
        {"allocation", false, {{"study_allocations", {"study_id"}, {}, "seed"}}},
        {"participant",
         false,
         {{"participants", code, {}, "number, created_utc"},
          {"participant_states", code, {}, "protocol_version, arm, demonstration"},
          {"withdrawals", code, {}, "mode, reason, withdrawn_by, withdrawn_utc"},
          {"participant_devices", code, {}, "device, chosen_by, chosen_utc"},
          {"study_steps",
           code,
           {"id"},
           "visit, step, state, attempt_id, answer_id, detail, at_utc"},
          {"superseded_steps u JOIN study_steps s ON s.id = u.step_id",
           {"s.study_id", "s.code"},
           {"u.step_id"},
           "u.reason, u.superseded_by, u.superseded_utc"},
          {"step_notes", code, {"id"}, "visit, step, note, noted_by, at_utc"},
          {"answers a",
           of_answer,
           {"a.id"},
           "a.questionnaire_id, a.questionnaire_version, a.answered_utc, a.demonstration, "
           "a.language, a.visit"},
          {"answer_items i JOIN answers a ON a.id = i.answer_id",
           of_answer,
           {"i.answer_id", "i.item"},
           "i.answer"},
          {"answer_changes c JOIN answers a ON a.id = c.answer_id",
           of_answer,
           {"c.answer_id", "c.position"},
           "c.item, c.old_answer, c.new_answer, c.at_utc"},
          {"answer_corrections c JOIN answers a ON a.id = c.answer_id",
           of_answer,
           {"c.id"},
           "c.answer_id, c.entry, c.item, c.old_answer, c.new_answer, c.reason, c.corrected_by, "
           "c.at_utc"},
          {"second_entries e JOIN answers a ON a.id = e.answer_id",
           of_answer,
           {"e.answer_id"},
           "e.entered_by, e.at_utc"},
          {"second_entry_items i JOIN answers a ON a.id = i.answer_id",
           of_answer,
           {"i.answer_id", "i.item"},
           "i.answer"},
          {"record_events", code, {"id"}, "event, remark, checksum, by_login, by_name, at_utc"},
          {"consent_signatures", code, {}, "path, at_utc"},
          {"study_steps w WHERE w.detail_meaning <> ''",
           {"w.study_id", "w.code"},
           {"w.id"},
           "w.detail_meaning"}}},
    };
}

}  // namespace

const std::vector<SealKind>& seal_kinds() {
    static const std::vector<SealKind> all = make_kinds();
    return all;
}

}  // namespace placode::db
