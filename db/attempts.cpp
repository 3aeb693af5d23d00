// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One transaction from result to recording; attempts read back.

#include "db/attempts.h"

#include <QFile>

#include "assessment/signal.h"
#include "db/attempt_counting.h"
#include "db/attempt_doubts.h"
#include "db/attempt_rows.h"
#include "db/exam_check.h"
#include "db/haptic_verdict.h"
#include "db/many_rows.h"
#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/store_context.h"
#include "sim/core/event.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// Exams and attempts of studies count only when they were simulated again. What does not count
/// anyway need not be.
ReplayState replay_asked(const AttemptResult& result, const std::vector<VoidReason>& voids) {
    return matters(result) && voids.empty() && result.end.reason != sim::EndReason::kInterrupted
               ? ReplayState::kWaiting
               : ReplayState::kNotReplayed;
}

int64_t insert_attempt(StoreContext& context, int64_t user_id, const AttemptResult& result,
                       const HapticVerdict& haptics, const ExamCheck& exam,
                       const std::vector<VoidReason>& voids) {
    Connection& connection = context.connection;
    Statement insert(
        connection,
        "INSERT INTO attempts (account_id, task_id, task_version, started_utc, "
        "saved_utc, duration_s, device, seed, build, end_reason, final_hash, dropped, "
        "demonstration, points, verdict, rubric_id, rubric_version, "
        "metric_set_version, preprocessing_version, exam_course, exam_course_version, exam_stage, "
        "proctor, device_certificate, haptic_certificate, haptic_grade, void_reason, void_meaning, "
        "replay, study, participant, exam_begin) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?, "
        "?, ?, ?, ?) RETURNING id");
    insert.run(
        user_id, result.header.task_id, result.header.task_version,
        result.header.started_utc.empty() ? utc_now() : result.header.started_utc, utc_now(),
        result.end.duration_s, result.header.device, std::to_string(result.header.seed),
        result.header.build, static_cast<int>(result.end.reason),
        std::to_string(result.end.final_hash), result.end.dropped, result.header.demonstration,
        result.score.points, static_cast<int>(result.score.verdict), result.score.rubric_id,
        result.score.rubric_version, result.metrics.version, assessment::kPreprocessingVersion,
        result.exam.course_id, result.exam.course_version, result.exam.stage_id, exam.proctor,
        result.exam.device_certificate, haptics.certificate, haptics.grade, void_text(voids),
        void_meaning(voids), static_cast<int>(replay_asked(result, voids)), result.study.study,
        result.study.participant, exam.begin);
    return insert.returned_id();
}

void insert_lists(Connection& connection, int64_t id, const AttemptResult& result) {
    insert_score(connection, "attempt", "attempt_id", id, result.metrics, result.score);
    ManyRows events(connection,
                    "attempt_events (attempt_id, position, time_s, kind, tool, tissue, value, "
                    "value2, rest_x_m, rest_y_m, rest_z_m, element)");
    int position = 0;
    for (const auto& one : result.events) {
        if (sim::only_in_recording(one.kind)) continue;
        events.add(id, position++, one.time_s, static_cast<int>(one.kind), int{one.tool},
                   static_cast<int>(one.tissue), double{one.value}, double{one.value2},
                   double{one.rest_position_m[0]}, double{one.rest_position_m[1]},
                   double{one.rest_position_m[2]}, int{one.element});
    }
    events.finish();
}

Bytes read_bytes(Connection& connection, const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        connection.fail(Kind::kNotFound, "the recording " + path + " cannot be read (" +
                                             file.errorString().toStdString() + ")");
    const QByteArray content = file.readAll();
    const auto* first = reinterpret_cast<const std::byte*>(content.constData());
    return {first, first + content.size()};
}

}  // namespace

Attempts::Attempts(StoreContext& context) : context_(context), connection_(context.connection) {}

int64_t Attempts::save(int64_t user_id, const AttemptResult& result) {
    connection_.begin_operation("save an attempt in");
    // Of a study it belongs to the participant, whoever was signed in when it began.
    if (result.study.study.empty())
        context_.need_for(Action::kSaveAttempt, user_id);
    else
        context_.need(Action::kRunQuestionnaire);
    Bytes packed;
    std::string checksum;
    size_t size = 0;
    // Everything slow comes before the transaction: the store is locked for milliseconds only.
    if (!result.recording_file.empty()) {
        settle_recording_file(result.recording_file);
        const Bytes file = read_bytes(connection_, result.recording_file);
        if (file.size() > kMostRecordingBytes)
            connection_.fail(Kind::kRefused, Said::that("the recording is larger than 1 GiB"));
        size = file.size();
        checksum = checksum_hex(file);
        packed = compress(file);
    }
    const HapticVerdict haptics = haptic_verdict(result);
    std::vector<VoidReason> voids = void_causes(result);
    voids.insert(voids.end(), haptics.voids.begin(), haptics.voids.end());
    voids.insert(voids.end(), result.not_verified.begin(), result.not_verified.end());
    UnitOfWork work(connection_);
    const UserRecord user = context_.need_owner(user_id);
    // Nothing more of who has withdrawn, also where it was recorded before.
    if (!result.study.study.empty())
        context_.need_active_participant(result.study.study, result.study.participant, {});
    for (VoidReason& doubt : doubts_in_store(context_, user, result, checksum))
        voids.push_back(std::move(doubt));
    ExamCheck exam = check_exam(context_, user, result);
    std::move(exam.doubts.begin(), exam.doubts.end(), std::back_inserter(voids));
    const int64_t id = insert_attempt(context_, user_id, result, haptics, exam, voids);
    context_.made("attempt", id);
    insert_lists(connection_, id, result);
    if (!result.recording_file.empty())
        Statement(
            connection_,
            "INSERT INTO recordings (attempt_id, size_bytes, checksum, content) VALUES (?, ?, "
            "?, ?)")
            .run(id, static_cast<int64_t>(size), checksum,
                 QByteArray::fromRawData(reinterpret_cast<const char*>(packed.data()),
                                         static_cast<qsizetype>(packed.size())));
    context_.append_audit("attempt.save", "attempt " + std::to_string(id),
                          result.study.study.empty()
                              ? "user " + std::to_string(user_id)
                              : result.study.study + " " + result.study.participant);
    if (!voids.empty())
        context_.append_audit("attempt.void", "attempt " + std::to_string(id), void_text(voids));
    work.commit();
    return id;
}

std::vector<AttemptRecord> Attempts::list(int64_t user_id, const std::string& task_id) {
    connection_.begin_operation("list the attempts of");
    user_id == 0 ? context_.need(Action::kViewAttempts)
                 : context_.need_for(Action::kViewAttempts, user_id);
    const AttemptConditions where = conditions_of(
        user_id, 0, task_id, user_id == 0 ? OfStudies::kTakenIn : OfStudies::kLeftOut);
    Statement query(connection_, attempt_columns() + where.sql + " ORDER BY t.started_utc, t.id");
    query.run_list(where.values);
    std::vector<AttemptRecord> found;
    while (query.next()) found.push_back(read_attempt(query));
    show_proctors(context_, found);
    return found;
}

AttemptOwner Attempts::owner_of(int64_t id) {
    connection_.begin_operation("look up an attempt in");
    context_.need(Action::kUseStore);
    if (const auto owner = context_.owner_of_attempt(id)) return *owner;
    connection_.fail(Kind::kNotFound, "there is no attempt " + std::to_string(id));
}

std::optional<int64_t> Attempts::find_recording(const std::string& recording_file) {
    connection_.begin_operation("look for a recording in");
    context_.need(Action::kUseStore);
    settle_recording_file(recording_file);
    const std::string checksum = checksum_hex(read_bytes(connection_, recording_file));
    return attempt_with(connection_, checksum);
}

}  // namespace placode::db
