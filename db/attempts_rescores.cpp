// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scores beyond the first one of an attempt: both are kept.

#include "db/attempt_rows.h"
#include "db/attempts.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

int64_t Attempts::save_rescore(const RescoreRecord& rescore) {
    connection_.begin_operation("save a further score in");
    context_.need(Action::kSetStandards);
    UnitOfWork work(connection_);
    Statement there(connection_, "SELECT id FROM attempts WHERE id = ?");
    if (!there.run(rescore.attempt_id).next())
        connection_.fail(Kind::kNotFound,
                         "there is no attempt " + std::to_string(rescore.attempt_id));
    context_.touch("attempt", rescore.attempt_id);
    const assessment::Score& score = rescore.score;
    Statement insert(connection_,
                     "INSERT INTO attempt_scores (attempt_id, points, verdict, rubric_id, "
                     "rubric_version, metric_set_version, preprocessing_version, scored_utc, "
                     "scored_by) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(rescore.attempt_id, score.points, static_cast<int>(score.verdict), score.rubric_id,
               score.rubric_version, score.metric_set_version, rescore.preprocessing_version,
               utc_now(), context_.actor.name);
    const int64_t id = insert.returned_id();
    insert_score(connection_, "attempt_score", "score_id", id, rescore.metrics, score);
    context_.append_audit("attempt.rescore", "attempt " + std::to_string(rescore.attempt_id),
                          score.rubric_id + " version " + std::to_string(score.rubric_version));
    work.commit();
    return id;
}

std::vector<RescoreRecord> Attempts::rescores(int64_t attempt_id) {
    connection_.begin_operation("list the further scores of");
    context_.need_sight_of_attempt(attempt_id);
    Statement query(connection_,
                    "SELECT id, points, verdict, rubric_id, rubric_version, metric_set_version, "
                    "preprocessing_version, scored_utc, scored_by FROM attempt_scores WHERE "
                    "attempt_id = ? ORDER BY id");
    query.run(attempt_id);
    std::vector<RescoreRecord> found;
    while (query.next()) {
        RescoreRecord record;
        record.id = query.integer("id");
        record.attempt_id = attempt_id;
        record.score.points = query.real("points");
        record.score.verdict = static_cast<assessment::Verdict>(query.integer("verdict"));
        record.score.rubric_id = query.text("rubric_id");
        record.score.rubric_version = static_cast<int>(query.integer("rubric_version"));
        record.score.metric_set_version = static_cast<int>(query.integer("metric_set_version"));
        record.metrics.version = record.score.metric_set_version;
        record.preprocessing_version = static_cast<int>(query.integer("preprocessing_version"));
        record.scored_utc = query.text("scored_utc");
        record.scored_by = query.text("scored_by");
        found.push_back(std::move(record));
    }
    for (RescoreRecord& record : found) {
        Statement metric(connection_,
                         "SELECT metric_id, value FROM attempt_score_metrics WHERE score_id = ? "
                         "ORDER BY position");
        metric.run(record.id);
        while (metric.next()) record.metrics.values.push_back({metric.text(0), metric.real(1)});
        Statement reason(
            connection_,
            "SELECT item, reason, points, time_s, critical, meaning FROM attempt_score_reasons "
            "WHERE score_id = ? ORDER BY position");
        reason.run(record.id);
        while (reason.next()) record.score.reasons.push_back(read_reason(reason));
    }
    context_.show_names(found, &RescoreRecord::scored_by);
    return found;
}

}  // namespace placode::db
