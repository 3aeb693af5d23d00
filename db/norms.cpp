// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/norms.h"

#include <map>

#include "curriculum/norm_pack.h"
#include "db/attempt_rows.h"
#include "db/attempts.h"
#include "db/password.h"
#include "db/signature.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

Norms::Norms(StoreContext& context) : context_(context), connection_(context.connection) {}

std::string Norms::centre_name() {
    connection_.begin_operation("read the centre's name from");
    context_.need(Action::kUseStore);
    Statement query(connection_, "SELECT centre FROM centre_key");
    return query.run().next() ? query.text(0) : std::string();
}

void Norms::trust_centre(const std::string& public_key, const std::string& centre) {
    connection_.begin_operation("trust a centre in");
    context_.need(Action::kSetStandards);
    if (const auto problem = name_problem(centre)) connection_.fail(Kind::kRefused, *problem);
    UnitOfWork work(connection_);
    Statement(connection_,
              "INSERT INTO trusted_centres (public_key, centre, added_by, added_utc) VALUES (?, ?, "
              "?, ?)")
        .run(public_key, centre, context_.actor.name, utc_now());
    context_.made("centre", {public_key});
    context_.append_audit("norms.trust", centre, fingerprint(public_key));
    work.commit();
}

std::map<std::string, std::string> Norms::trusted_centres() {
    connection_.begin_operation("list trusted centres of");
    context_.need(Action::kSetStandards);
    Statement query(connection_, "SELECT public_key, centre FROM trusted_centres");
    query.run();
    std::map<std::string, std::string> found;
    while (query.next()) found[query.text(0)] = query.text(1);
    return found;
}

int64_t Norms::save(const curriculum::SignedNorms& norms) {
    connection_.begin_operation("keep a norm pack in");
    context_.need(Action::kSetStandards);
    const curriculum::NormPack pack = curriculum::load_norm_pack(norms.content, "norm pack");
    if (!signature_is_right(norms.content, norms.signature, norms.public_key))
        connection_.fail(
            Kind::kRefused,
            Said::that("its signature is wrong: the pack was changed after it was signed"));
    const auto trusted = trusted_centres();
    const auto known = trusted.find(norms.public_key);
    if (known == trusted.end())
        connection_.fail(Kind::kRefused,
                         Said::that("its centre \"%1\" with the key %2 is not trusted here")
                             .with(pack.centre)
                             .with(fingerprint(norms.public_key)));
    // A centre that is trusted signs in its own name only.
    if (known->second != pack.centre)
        connection_.fail(
            Kind::kRefused,
            Said::that("it says to be of \"%1\", but its key %2 is trusted here as that of \"%3\"")
                .with(pack.centre)
                .with(fingerprint(norms.public_key))
                .with(known->second));
    UnitOfWork work(connection_);
    Statement there(connection_, "SELECT id FROM norm_packs WHERE signature = ?");
    if (there.run(norms.signature).next()) return there.integer(0);
    Statement insert(connection_,
                     "INSERT INTO norm_packs (task_id, centre, content, signature, public_key, "
                     "in_use, added_by, added_utc) VALUES (?, ?, ?, ?, ?, 0, ?, ?) RETURNING id");
    insert.run(pack.task_id, pack.centre, norms.content, norms.signature, norms.public_key,
               context_.actor.name, utc_now());
    const int64_t id = insert.returned_id();
    context_.made("norm pack", id);
    context_.append_audit("norms.keep", "norm pack " + std::to_string(id),
                          pack.task_id + " of " + pack.centre);
    work.commit();
    return id;
}

std::vector<NormPackRecord> Norms::list(const std::string& task_id) {
    connection_.begin_operation("list norm packs of");
    context_.need(Action::kUseStore);
    Statement query(connection_,
                    "SELECT id, content, signature, public_key, in_use, added_by, added_utc FROM "
                    "norm_packs WHERE ? = '' OR task_id = ? ORDER BY id");
    query.run(task_id, task_id);
    std::vector<NormPackRecord> found;
    while (query.next()) {
        NormPackRecord record;
        record.id = query.integer("id");
        record.norms = {query.text("content"), query.text("signature"), query.text("public_key")};
        record.pack = curriculum::load_norm_pack(record.norms.content, "norm pack");
        record.in_use = query.integer("in_use") != 0;
        record.added_by = query.text("added_by");
        record.added_utc = query.text("added_utc");
        found.push_back(std::move(record));
    }
    context_.show_names(found, &NormPackRecord::added_by);
    return found;
}

void Norms::use(int64_t id) {
    connection_.begin_operation("use the norm pack " + std::to_string(id) + " in");
    context_.need(Action::kSetStandards);
    UnitOfWork work(connection_);
    Statement query(connection_, "SELECT task_id FROM norm_packs WHERE id = ?");
    if (!query.run(id).next()) connection_.fail(Kind::kNotFound, "there is no such norm pack");
    const std::string task = query.text(0);
    std::vector<int64_t> packs;
    Statement of_task(connection_, "SELECT id FROM norm_packs WHERE task_id = ?");
    of_task.run(task);
    while (of_task.next()) packs.push_back(of_task.integer(0));
    for (const int64_t each : packs) context_.touch("norm pack", each);
    Statement(connection_,
              "UPDATE norm_packs SET in_use = CASE WHEN id = ? THEN 1 ELSE 0 END WHERE "
              "task_id = ?")
        .run(id, task);
    context_.append_audit("norms.use", "norm pack " + std::to_string(id), task);
    work.commit();
}

std::vector<MeasuredAttempt> Norms::measured_attempts(int64_t user_id, const std::string& task_id) {
    std::vector<MeasuredAttempt> found;
    // Which asks whether they may be seen.
    for (AttemptRecord& record : Attempts(context_).list(user_id, task_id)) {
        if (!record.study.study.empty()) continue;
        MeasuredAttempt measured;
        measured.metrics.version = record.metric_set_version;
        measured.record = std::move(record);
        found.push_back(std::move(measured));
    }
    std::map<int64_t, size_t> places;
    for (size_t i = 0; i < found.size(); ++i) places[found[i].record.id] = i;
    connection_.begin_operation("read metrics from");
    const AttemptConditions where = conditions_of(user_id, 0, task_id);
    Statement metric(connection_,
                     "SELECT m.attempt_id, m.metric_id, m.value FROM attempts t JOIN "
                     "attempt_metrics m ON m.attempt_id = t.id" +
                         where.sql + " ORDER BY m.attempt_id, m.position");
    metric.run_list(where.values);
    while (metric.next()) {
        const auto place = places.find(metric.integer("attempt_id"));
        if (place != places.end())
            found[place->second].metrics.values.push_back(
                {metric.text("metric_id"), metric.real("value")});
    }
    return found;
}

}  // namespace placode::db
