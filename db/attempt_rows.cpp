// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_rows.h"

#include <QtGlobal>
#include <algorithm>
#include <charconv>

#include "db/many_rows.h"
#include "db/reason_json.h"
#include "db/void_reason.h"

namespace placode::db {
namespace {

uint64_t unsigned_of(const std::string& text) {
    uint64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

void make_void(AttemptRecord& record, const VoidReason& why) {
    std::vector<VoidReason> voids = void_reasons(record.void_reason, record.void_meaning);
    if (std::any_of(voids.begin(), voids.end(),
                    [&](const VoidReason& each) { return each.cause == why.cause; }))
        return;
    voids.push_back(why);
    record.void_reason = void_text(voids);
    record.void_meaning = void_meaning(voids);
}

}  // namespace

VoidReason shown_by(const std::string& device) {
    const bool script = device.starts_with("script:");
    return {VoidCause::kScript, 0, 0,
            script ? Said::as_is(device)
                   : Said::listed(QT_TRANSLATE_NOOP("Said", "somebody for a demonstration (%1)"))
                         .with(device)};
}

std::string only_shows(const std::string& table) {
    return "(" + table + ".demonstration = 1 AND " + table +
           ".account_id NOT IN (SELECT id FROM accounts WHERE demonstration = 1))";
}

const std::string& attempt_columns() {
    static const std::string columns =
        "SELECT t.id, CASE WHEN t.study = '' THEN t.account_id ELSE 0 END AS user_id, CASE WHEN "
        "t.study = '' THEN COALESCE(p.display_name, '') ELSE t.participant END AS user_name, "
        "t.task_id, t.task_version, t.started_utc, t.duration_s, t.device, t.seed, t.build, "
        "t.end_reason, t.final_hash, t.demonstration, t.points, t.verdict, t.rubric_id, "
        "t.rubric_version, "
        "t.metric_set_version, t.preprocessing_version, t.generated_from, t.exam_course, "
        "t.exam_course_version, t.exam_stage, t.proctor, t.device_certificate, t.haptic_grade, "
        "t.exam_begin, t.void_reason, t.void_meaning, t.replay, t.study, t.participant, CASE "
        "WHEN " +
        only_shows("t") +
        " AND NOT EXISTS (SELECT 1 FROM participant_states s WHERE s.study_id = t.study AND s.code "
        "= t.participant AND s.demonstration = 1) THEN 1 ELSE 0 END AS only_shows FROM attempts t "
        "LEFT JOIN persons p ON p.account_id = t.account_id ";
    return columns;
}

AttemptRecord read_attempt(const Statement& row) {
    AttemptRecord record;
    record.id = row.integer("id");
    record.user_id = row.integer("user_id");
    record.user_name = row.text("user_name");
    record.task_id = row.text("task_id");
    record.task_version = static_cast<int>(row.integer("task_version"));
    record.started_utc = row.text("started_utc");
    record.duration_s = row.real("duration_s");
    record.device = row.text("device");
    record.seed = unsigned_of(row.text("seed"));
    record.build = row.text("build");
    record.end = static_cast<sim::EndReason>(row.integer("end_reason"));
    record.ended = unsigned_of(row.text("final_hash")) != 0;
    record.demonstration = row.integer("demonstration") != 0;
    record.points = row.real("points");
    record.verdict = static_cast<assessment::Verdict>(row.integer("verdict"));
    record.rubric_id = row.text("rubric_id");
    record.rubric_version = static_cast<int>(row.integer("rubric_version"));
    record.metric_set_version = static_cast<int>(row.integer("metric_set_version"));
    record.preprocessing_version = static_cast<int>(row.integer("preprocessing_version"));
    record.generated = row.integer("generated_from") != 0;
    record.exam = {
        row.text("exam_course"),        static_cast<int>(row.integer("exam_course_version")),
        row.text("exam_stage"),         row.text("proctor"),
        row.text("device_certificate"), row.integer("exam_begin")};
    record.haptic_grade = row.text("haptic_grade");
    record.void_reason = row.text("void_reason");
    record.void_meaning = row.text("void_meaning");
    record.replay = static_cast<ReplayState>(row.integer("replay"));
    record.study = {row.text("study"), row.text("participant")};
    if (row.integer("only_shows") != 0) make_void(record, shown_by(record.device));
    return record;
}

assessment::Reason read_reason(const Statement& row) {
    return {
        row.text("item"),   row.text("reason"),           row.real("points"),
        row.real("time_s"), row.integer("critical") != 0, reason_from_json(row.text("meaning"))};
}

sim::Event read_event(const Statement& row) {
    sim::Event event;
    event.time_s = row.real("time_s");
    event.kind = static_cast<sim::EventKind>(row.integer("kind"));
    event.tool = static_cast<int8_t>(row.integer("tool"));
    event.tissue = static_cast<sim::Tissue>(row.integer("tissue"));
    event.value = static_cast<float>(row.real("value"));
    event.value2 = static_cast<float>(row.real("value2"));
    event.rest_position_m[0] = static_cast<float>(row.real("rest_x_m"));
    event.rest_position_m[1] = static_cast<float>(row.real("rest_y_m"));
    event.rest_position_m[2] = static_cast<float>(row.real("rest_z_m"));
    event.element = static_cast<int32_t>(row.integer("element"));
    return event;
}

AttemptConditions conditions_of(int64_t user_id, int64_t group_id, const std::string& task_id,
                                OfStudies studies) {
    AttemptConditions made;
    if (studies == OfStudies::kLeftOut) made.add("t.study = ''");
    if (user_id != 0) made.add("t.account_id = ?", QVariant(qlonglong(user_id)));
    if (group_id != 0)
        made.add(
            "t.account_id IN (SELECT account_id FROM group_members WHERE teaches = 0 AND "
            "group_id = ?)",
            QVariant(qlonglong(group_id)));
    if (!task_id.empty()) made.add("t.task_id = ?", QVariant(QString::fromStdString(task_id)));
    return made;
}

std::string is_finished(const std::string& table) {
    const auto number = [](ReplayState state) { return std::to_string(static_cast<int>(state)); };
    return table + ".void_reason = '' AND " + table + ".replay NOT IN (" +
           number(ReplayState::kWaiting) + ", " + number(ReplayState::kDiffers) + ") AND " + table +
           ".study = '' AND " + table + ".end_reason <> " +
           std::to_string(static_cast<int>(sim::EndReason::kInterrupted)) + " AND " + table +
           ".verdict <> " + std::to_string(static_cast<int>(assessment::Verdict::kNotAttempted)) +
           " AND NOT " + only_shows(table);
}

void insert_score(Connection& connection, const std::string& table, const std::string& owner,
                  int64_t id, const assessment::MetricSet& metrics,
                  const assessment::Score& score) {
    ManyRows values(connection, table + "_metrics (" + owner + ", position, metric_id, value)");
    int position = 0;
    for (const auto& value : metrics.values) values.add(id, position++, value.id, value.value);
    values.finish();
    ManyRows reasons(connection, table + "_reasons (" + owner +
                                     ", position, item, reason, points, time_s, critical, "
                                     "meaning)");
    position = 0;
    for (const auto& one : score.reasons)
        reasons.add(id, position++, one.item, one.text, one.points, one.time_s, one.critical,
                    reason_json(one.meaning));
    reasons.finish();
}

}  // namespace placode::db
