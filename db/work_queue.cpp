// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/work_queue.h"

#include "db/sql_connection.h"
#include "db/station_role.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

// state: 0 waits, 1 is held until `until`, 2 is done. All times are the server's: the clocks of
// the computers need not agree.
constexpr const char* kTables[]{
    "CREATE SCHEMA IF NOT EXISTS placode_work",
    "CREATE TABLE IF NOT EXISTS placode_work.batches (id BIGINT GENERATED ALWAYS AS IDENTITY, "
    "seal TEXT PRIMARY KEY, build TEXT NOT NULL, manifest TEXT NOT NULL, shards INTEGER NOT NULL, "
    "queued_utc TEXT NOT NULL)",
    "CREATE TABLE IF NOT EXISTS placode_work.inputs (sha256 TEXT PRIMARY KEY, "
    "content BYTEA NOT NULL)",
    "CREATE TABLE IF NOT EXISTS placode_work.batch_inputs (seal TEXT NOT NULL REFERENCES "
    "placode_work.batches (seal) ON DELETE CASCADE, sha256 TEXT NOT NULL REFERENCES "
    "placode_work.inputs (sha256), PRIMARY KEY (seal, sha256))",
    "CREATE TABLE IF NOT EXISTS placode_work.shards (seal TEXT NOT NULL REFERENCES "
    "placode_work.batches (seal) ON DELETE CASCADE, shard INTEGER NOT NULL, "
    "state INTEGER NOT NULL DEFAULT 0, token BIGINT NOT NULL DEFAULT 0, "
    "tries INTEGER NOT NULL DEFAULT 0, until TIMESTAMPTZ, worker TEXT NOT NULL DEFAULT '', "
    "problem TEXT NOT NULL DEFAULT '', result BYTEA, PRIMARY KEY (seal, shard))",
    "CREATE INDEX IF NOT EXISTS shards_to_do ON placode_work.shards (state, seal, shard)",
};
const std::string kStation = kStationRole;

// What a station does: reads all, and changes what it says of a shard.
std::vector<std::string> station_rights() {
    return {"GRANT USAGE ON SCHEMA placode_work TO " + kStation,
            "GRANT SELECT ON ALL TABLES IN SCHEMA placode_work TO " + kStation,
            "GRANT UPDATE (state, token, tries, until, worker, problem, result) ON "
            "placode_work.shards TO " +
                kStation};
}

QByteArray bytes_of(const std::string& text) {
    return {text.data(), static_cast<qsizetype>(text.size())};
}

/// Of a lease that still holds.
constexpr const char* kHeld = " WHERE seal = ? AND shard = ? AND token = ? AND state = 1";

}  // namespace

WorkQueue::WorkQueue(const StoreUrl& url) {
    if (url.engine != Engine::kPostgresql)
        throw StoreError(Kind::kRefused,
                         url.shown +
                             ": a store that is a file has no queue; expected the address of a "
                             "centre's server, postgresql://USER@HOST:PORT/NAME");
    connection_ = std::make_unique<Connection>(url);
}

WorkQueue::~WorkQueue() = default;

void WorkQueue::set_up() {
    connection_->begin_operation("make the queue in");
    UnitOfWork work(*connection_);
    for (const char* each : kTables) connection_->execute(each);
    if (has_station_role(*connection_))
        for (const std::string& each : station_rights()) connection_->execute(each);
    work.commit();
}

void WorkQueue::put(const QueuedBatch& batch, const std::vector<std::string>& inputs,
                    const std::function<std::string(const std::string&)>& read) {
    connection_->begin_operation("queue a batch in");
    // Inputs first, each by itself: a batch of 100,000 recordings is not one transaction.
    for (const std::string& sha256 : inputs) {
        const bool there =
            Statement(*connection_, "SELECT 1 FROM placode_work.inputs WHERE sha256 = ?")
                .run(sha256)
                .next();
        if (there) continue;
        UnitOfWork work(*connection_);
        Statement(*connection_,
                  "INSERT INTO placode_work.inputs (sha256, content) VALUES (?, ?) ON CONFLICT "
                  "DO NOTHING")
            .run(sha256, bytes_of(read(sha256)));
        work.commit();
    }
    UnitOfWork work(*connection_);
    Statement(*connection_,
              "INSERT INTO placode_work.batches (seal, build, manifest, shards, queued_utc) "
              "VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING")
        .run(batch.seal, batch.build, batch.manifest, batch.shards, utc_now());
    for (const std::string& sha256 : inputs)
        Statement(*connection_,
                  "INSERT INTO placode_work.batch_inputs (seal, sha256) VALUES (?, ?) ON CONFLICT "
                  "DO NOTHING")
            .run(batch.seal, sha256);
    Statement(*connection_,
              "INSERT INTO placode_work.shards (seal, shard) SELECT ?, "
              "generate_series(0, CAST(? AS INTEGER) - 1) ON CONFLICT DO NOTHING")
        .run(batch.seal, batch.shards);
    Statement(*connection_,
              "UPDATE placode_work.shards SET tries = 0, problem = '' WHERE seal = ? AND state = 0")
        .run(batch.seal);
    work.commit();
}

void WorkQueue::remove(const std::string& seal) {
    connection_->begin_operation("take a batch out of");
    UnitOfWork work(*connection_);
    Statement gone(*connection_, "DELETE FROM placode_work.batches WHERE seal = ?");
    if (gone.run(seal).affected() == 0)
        connection_->fail(Kind::kNotFound, "no batch " + seal.substr(0, 12) + " is queued");
    Statement(*connection_,
              "DELETE FROM placode_work.inputs i WHERE NOT EXISTS (SELECT FROM "
              "placode_work.batch_inputs b WHERE b.sha256 = i.sha256)")
        .run();
    work.commit();
}

std::vector<QueueState> WorkQueue::states() {
    connection_->begin_operation("look at the queue in");
    std::vector<QueueState> found;
    Statement batches(*connection_,
                      "SELECT b.seal, b.build, b.queued_utc, b.shards, "
                      "COUNT(*) FILTER (WHERE s.state = 2) AS done, "
                      "COUNT(*) FILTER (WHERE s.state = 1 AND s.until > now()) AS held "
                      "FROM placode_work.batches b JOIN placode_work.shards s ON s.seal = b.seal "
                      "GROUP BY b.id, b.seal, b.build, b.queued_utc, b.shards ORDER BY b.id");
    batches.run();
    while (batches.next())
        found.push_back({batches.text("seal"),
                         batches.text("build"),
                         batches.text("queued_utc"),
                         static_cast<int>(batches.integer("shards")),
                         static_cast<int>(batches.integer("done")),
                         static_cast<int>(batches.integer("held")),
                         {}});
    for (QueueState& each : found) {
        Statement failed(*connection_,
                         "SELECT shard, problem FROM placode_work.shards WHERE seal = ? AND state "
                         "< 2 AND tries >= ? AND (state = 0 OR until <= now()) ORDER BY shard");
        failed.run(each.seal, kMostTries);
        while (failed.next()) {
            const std::string problem = failed.text("problem");
            each.failed.push_back("shard " + std::to_string(failed.integer("shard")) + ": " +
                                  (problem.empty() ? "its computers went silent" : problem));
        }
    }
    return found;
}

std::optional<WorkLease> WorkQueue::take(const std::string& build, const std::string& worker,
                                         int lease_s) {
    connection_->begin_operation("take work out of");
    UnitOfWork work(*connection_);
    // Rows that another transaction is at are passed over: nobody waits for anybody.
    std::optional<WorkLease> lease;
    {
        Statement taken(
            *connection_,
            "UPDATE placode_work.shards t SET state = 1, token = t.token + 1, tries = t.tries + 1, "
            "worker = ?, until = now() + CAST(? AS INTEGER) * INTERVAL '1 second' "
            "FROM (SELECT s.seal, s.shard FROM placode_work.shards s JOIN placode_work.batches b "
            "ON "
            "b.seal = s.seal WHERE b.build = ? AND s.tries < ? AND (s.state = 0 OR (s.state = 1 "
            "AND "
            "s.until <= now())) ORDER BY b.id, s.shard LIMIT 1 FOR UPDATE OF s SKIP LOCKED) n "
            "WHERE t.seal = n.seal AND t.shard = n.shard RETURNING t.seal, t.shard, t.token");
        taken.run(worker, lease_s, build, kMostTries);
        if (taken.next())
            lease = WorkLease{taken.text("seal"), static_cast<int>(taken.integer("shard")),
                              taken.integer("token")};
    }
    work.commit();
    return lease;
}

QueuedBatch WorkQueue::batch(const std::string& seal) {
    connection_->begin_operation("read a batch of");
    Statement query(*connection_,
                    "SELECT seal, build, manifest, shards FROM placode_work.batches WHERE seal = "
                    "?");
    if (!query.run(seal).next())
        connection_->fail(Kind::kNotFound, "no batch " + seal.substr(0, 12) + " is queued");
    return {query.text("seal"), query.text("build"), query.text("manifest"),
            static_cast<int>(query.integer("shards"))};
}

std::string WorkQueue::input(const std::string& sha256) {
    connection_->begin_operation("read an input of");
    Statement query(*connection_, "SELECT content FROM placode_work.inputs WHERE sha256 = ?");
    if (!query.run(sha256).next())
        connection_->fail(Kind::kNotFound, "the input " + sha256.substr(0, 12) + " is not queued");
    return query.bytes("content").toStdString();
}

bool WorkQueue::renew(const WorkLease& lease, int lease_s) {
    connection_->begin_operation("go on with work of");
    UnitOfWork work(*connection_);
    Statement held(*connection_,
                   std::string("UPDATE placode_work.shards SET until = now() + CAST(? AS INTEGER) "
                               "* INTERVAL '1 second'") +
                       kHeld);
    const bool ours = held.run(lease_s, lease.seal, lease.shard, lease.token).affected() == 1;
    work.commit();
    return ours;
}

bool WorkQueue::finish(const WorkLease& lease, const std::string& result) {
    connection_->begin_operation("put a result into");
    UnitOfWork work(*connection_);
    // Also by who was too slow, as long as nobody else has: the work is done.
    Statement done(*connection_,
                   "UPDATE placode_work.shards SET state = 2, result = ?, problem = '' WHERE seal "
                   "= ? AND shard = ? AND state < 2");
    const bool first = done.run(bytes_of(result), lease.seal, lease.shard).affected() == 1;
    work.commit();
    return first;
}

void WorkQueue::give_back(const WorkLease& lease, const std::string& problem) {
    connection_->begin_operation("give work back to");
    UnitOfWork work(*connection_);
    Statement(*connection_,
              std::string("UPDATE placode_work.shards SET state = 0, problem = ?, tries = tries - "
                          "CAST(? AS INTEGER)") +
                  kHeld)
        .run(problem, problem.empty() ? 1 : 0, lease.seal, lease.shard, lease.token);
    work.commit();
}

std::string WorkQueue::result(const std::string& seal, int shard) {
    connection_->begin_operation("read a result of");
    Statement query(*connection_,
                    "SELECT result FROM placode_work.shards WHERE seal = ? AND shard = ? AND state "
                    "= 2");
    return query.run(seal, shard).next() ? query.bytes("result").toStdString() : std::string();
}

}  // namespace placode::db
