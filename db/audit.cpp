// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/audit.h"

#include <QDateTime>
#include <algorithm>

#include "db/audit_check.h"
#include "db/erasure.h"
#include "db/named_word.h"
#include "db/store_context.h"
#include "db/store_place.h"

namespace placode::db {
namespace {

AuditRecord read_audit(const Statement& row) {
    return {row.integer("id"),  row.text("at_utc"), row.text("actor"),
            row.text("action"), row.text("object"), row.text("detail")};
}

constexpr const char* kEntries = "SELECT id, at_utc, actor, action, object, detail FROM audit ";

/// What a question that was run has found, with the names that people have now.
std::vector<AuditRecord> read_entries(StoreContext& context, Statement& query) {
    std::vector<AuditRecord> entries;
    while (query.next()) entries.push_back(read_audit(query));
    context.show_names(entries, &AuditRecord::actor);
    return entries;
}

}  // namespace

void StoreContext::sign_head(TrailHead& head) {
    head.at_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    head.station = station.public_key();
    if (!head.station.empty()) head.signature = station.sign(trail_statement(head));
}

Audit::Audit(StoreContext& context) : context_(context), connection_(context.connection) {}

void Audit::write(const std::string& actor, const std::string& action, const std::string& object,
                  const std::string& detail) {
    connection_.begin_operation("write the audit trail of");
    context_.need(Action::kUseStore);
    std::string name = context_.kept_name(actor);
    if (context_.actor.kind != Actor::Kind::kProgram && name != context_.actor.name)
        context_.refuse(Action::kActAs);
    if (context_.actor.kind == Actor::Kind::kProgram) name = context_.without_names(name);
    UnitOfWork work(connection_);
    // What a program reads again stays as it is, whatever somebody's log-in is.
    context_.append_audit_as(name, action, context_.without_names(object),
                             detail == kErasuresUnknown ? detail : context_.without_names(detail));
    work.commit();
}

std::vector<AuditRecord> Audit::trail(int limit) {
    connection_.begin_operation("read the audit trail of");
    context_.need(Action::kViewAudit);
    Statement query(connection_, std::string(kEntries) + "ORDER BY id DESC LIMIT ?");
    return read_entries(context_, query.run(limit));
}

std::vector<AuditRecord> Audit::of_action(const std::string& action) {
    connection_.begin_operation("read the audit trail of");
    context_.need(Action::kViewAudit);
    Statement query(connection_, std::string(kEntries) + "WHERE action = ? ORDER BY id");
    return read_entries(context_, query.run(action));
}

std::vector<int64_t> Audit::naming(const std::vector<std::string>& words) {
    connection_.begin_operation("look for a name in the audit trail of");
    context_.need(Action::kViewAudit);
    Statement query(connection_, "SELECT id, object, detail FROM audit ORDER BY id");
    query.run();
    const std::vector<FoldedText> names(words.begin(), words.end());
    std::vector<int64_t> found;
    while (query.next()) {
        const FoldedText said(query.text(1) + "\n" + query.text(2));
        if (std::any_of(names.begin(), names.end(),
                        [&](const FoldedText& name) { return said.find(name).has_value(); }))
            found.push_back(query.integer(0));
    }
    return found;
}

std::optional<AuditRecord> Audit::first() {
    connection_.begin_operation("read the beginning of the audit trail of");
    context_.need(Action::kUseStore);
    const bool guarded = context_.server.guards();
    Statement query(connection_, guarded ? "SELECT * FROM placode_guard.trail_first()"
                                         : std::string(kEntries) + "ORDER BY id LIMIT 1");
    const std::vector<AuditRecord> found = read_entries(context_, query.run());
    if (found.empty()) return std::nullopt;
    return found.front();
}

std::vector<StationRecord> Audit::stations() {
    connection_.begin_operation("list the stations of");
    context_.need(Action::kViewAudit);
    const std::set<std::string> trusted = trusted_stations(context_);
    const std::string own = context_.station.public_key_if_any();
    Statement query(connection_,
                    "SELECT station, COUNT(*) AS entries, MIN(at_utc) AS first_utc, MAX(at_utc) AS "
                    "last_utc FROM audit WHERE station <> '' GROUP BY station ORDER BY MIN(id)");
    query.run();
    std::vector<StationRecord> found;
    while (query.next()) {
        StationRecord record;
        record.public_key = query.text("station");
        record.entries = query.integer("entries");
        record.first_utc = query.text("first_utc");
        record.last_utc = query.text("last_utc");
        record.own = record.public_key == own;
        record.trusted = trusted.contains(record.public_key);
        found.push_back(std::move(record));
    }
    return found;
}

std::set<std::string> Audit::trusted_keys() {
    connection_.begin_operation("list the stations that are trusted in");
    context_.need(Action::kViewAudit);
    (void)context_.station.public_key();
    return trusted_stations(context_);
}

std::string Audit::own_station() {
    connection_.begin_operation("read the key of this computer for");
    context_.need(Action::kUseStore);
    return context_.station.public_key();
}

Audit::Standing Audit::standing_of(const std::string& public_key) {
    connection_.begin_operation("look for the key of a computer in");
    context_.need(Action::kUseStore);
    if (registered_stations(context_).contains(public_key)) return Standing::kRegistered;
    return connection_.is_sqlite() ? Standing::kOfTheFile : Standing::kUnknown;
}

void Audit::trust_station(const std::string& station) {
    connection_.begin_operation("trust a station in");
    context_.need(Action::kManageUsers);
    std::string key;
    for (const StationRecord& each : stations())
        if (fingerprint(each.public_key) == station) key = each.public_key;
    if (key.empty() && is_public_key(station)) key = station;
    if (key.empty())
        connection_.fail(StoreError::Kind::kNotFound,
                         "no station \"" + station +
                             "\" has written here; `placodectl station list` shows those that "
                             "have, and `placodectl station key` at the other computer its key");
    if (trusted_stations(context_).contains(key))
        connection_.fail(StoreError::Kind::kConflict, "the station is trusted already");
    connection_.begin_operation("trust a station in");
    UnitOfWork work(connection_);
    context_.append_audit("station.trust", "station " + fingerprint(key), key);
    work.commit();
}

void Audit::set_aside(int64_t entry, const std::string& reason) {
    const std::string name = std::to_string(entry);
    connection_.begin_operation("set the entry " + name + " aside in");
    context_.need(Action::kManageUsers);
    if (reason.empty())
        connection_.fail(StoreError::Kind::kRefused,
                         Said::that("an entry is set aside with a reason"));
    const std::string whole = entry_to_set_aside(context_, entry);
    if (whole.empty())
        connection_.fail(StoreError::Kind::kNotFound, "there is no entry " + name +
                                                          " that does not fit; `placodectl check` "
                                                          "names those that do not");
    UnitOfWork work(connection_);
    context_.append_audit("audit.set_aside", "entry " + name, whole);
    context_.append_audit("audit.set_aside.why", "entry " + name, context_.without_names(reason));
    work.commit();
}

TrailHead Audit::head() {
    connection_.begin_operation("read the end of the audit trail of");
    context_.need(Action::kBackup);
    TrailHead head;
    head.store = first_chain(connection_);
    {
        Statement last(connection_, "SELECT id, chain FROM audit ORDER BY id DESC LIMIT 1");
        if (last.run().next()) {
            head.entry = last.integer("id");
            head.chain = last.text("chain");
        }
    }
    context_.sign_head(head);
    return head;
}

void Audit::check_head(const TrailHead& head, std::vector<std::string>& problems) {
    connection_.begin_operation("look into the audit trail of");
    context_.need(Action::kBackup);
    const std::string said = "audit: the statement of " + head.at_utc;
    if (head.station.empty())
        problems.push_back(said + " is not signed");
    else if (!trusted_stations(context_).contains(head.station))
        problems.push_back(said + " was signed by the station " + fingerprint(head.station) +
                           ", which no computer of this store trusts");
    if (first_chain(connection_) != head.store) {
        problems.push_back(said + " is of another store, or the trail was written anew");
        return;
    }
    std::string there;
    Statement entry(connection_, "SELECT chain FROM audit WHERE id = ?");
    if (entry.run(head.entry).next()) there = entry.text("chain");
    if (there != head.chain)
        problems.push_back(said + " knows entry " + std::to_string(head.entry) +
                           ", and the trail does not hold it as it was: it was cut off or written "
                           "anew since then");
}

void Audit::check_chain(std::vector<std::string>& problems, const CheckPace& pace) {
    context_.need(Action::kBackup);
    check_trail(context_, problems, pace);
}

}  // namespace placode::db
