// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the audit trail is written: all entries of a transaction at its end, the last one with the
// seals of what changed, each chained to the one before and signed by the station.

#include <cassert>
#include <string_view>

#include "db/packing.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr size_t kSealsOfAnEntry = 1000;

}  // namespace

Station::Head end_of_trail(Connection& connection) {
    const bool guarded = connection.hides_passwords();
    Statement last(connection, guarded ? "SELECT id, chain FROM placode_guard.trail_end()"
                                       : "SELECT id, chain FROM audit ORDER BY id DESC LIMIT 1");
    if (!last.run().next()) return {};
    return {last.integer("id"), last.text("chain")};
}

StoreContext::StoreContext(const StoreUrl& url, const StoreOptions& set)
    : connection(url), options(set), station(url) {
    connection.watch_transactions(
        [this] {
            entries_.clear();
            touched_.clear();
            last_entry_.reset();
        },
        [this] { write_trail(); },
        [this] {
            if (last_entry_) written_ = last_entry_;
        });
}

StoreContext::~StoreContext() { remember_trail(); }

void StoreContext::append_audit(const std::string& action, const std::string& object,
                                const std::string& detail) {
    append_audit_as(actor.name, action, object, detail);
}

void StoreContext::append_audit_as(const std::string& name, const std::string& action,
                                   const std::string& object, const std::string& detail) {
    entries_.push_back({0, utc_now(), name, action, object, detail});
}

void StoreContext::touch(const std::string& kind, const std::vector<std::string>& key) {
    SealedObject object{kind, key};
    if (touched_.contains(object)) return;
    // Until the commit: another computer that changes another row of the same object meanwhile
    // would make both seals wrong. A lock of the object alone, with this one at the end, would have
    // others wait less, also while an exam begins or a replay is kept. But who touches two objects
    // would meet who touches them the other way round; and a program of before, which takes this
    // lock first, would wait for a row of somebody who waits for this lock.
    lock_trail();
    std::string before = seal_of(connection, object);
    touched_.emplace(std::move(object), std::move(before));
}

void StoreContext::made(const std::string& kind, const std::vector<std::string>& key) {
    touched_.emplace(SealedObject{kind, key}, kNoObject);
}

void StoreContext::write_trail() {
    if (entries_.empty() && touched_.empty()) return;
    // Before the lock, because it takes most of the questions: nobody else sees, or hangs anything
    // on, what this transaction has made, and for what it touches it holds the lock since touch().
    SealChanges seals;
    for (const auto& [object, before] : touched_) {
        std::string after = seal_of(connection, object);
        if (after != before) seals[object] = {before, std::move(after)};
    }
    if (entries_.empty() && seals.empty()) return;
    if (entries_.empty()) append_audit("store.seal", "", "");
    lock_trail();
    std::string previous = end_of_trail(connection).chain;
    for (size_t i = 0; i < entries_.size(); ++i)
        write_entry({entries_[i], i + 1 == entries_.size() ? seals_text(seals) : "", {}}, previous);
    entries_.clear();
    touched_.clear();
}

void StoreContext::write_entry(TrailEntry entry, std::string& previous) {
    entry.station = station.public_key();
    const AuditRecord& row = entry.record;
    const std::string chain = audit_chain(previous, entry);
    const bool guarded = connection.hides_passwords();
    Statement insert(
        connection, guarded
                        ? "SELECT placode_guard.add_entry(?, ?, ?, ?, ?, ?, ?, ?, ?)"
                        : "INSERT INTO audit (at_utc, actor, action, object, detail, chain, seals, "
                          "station, signature) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(row.at_utc, row.actor, row.action, row.object, row.detail, chain, entry.seals,
               entry.station, station.sign(signed_text(chain)));
    last_entry_ = Station::Head{insert.returned_id(), chain};
    previous = chain;
}

void StoreContext::seal_the_unsealed() {
    SealChanges known;
    {
        Statement query(connection, "SELECT seals FROM audit WHERE seals <> ''");
        query.run();
        while (query.next())
            for (const auto& [object, seal] : seals_of_text(query.text(0))) known[object] = seal;
    }
    SealChanges fresh;
    std::string previous = end_of_trail(connection).chain;
    const auto write = [&] {
        if (fresh.empty()) return;
        const std::string objects = std::to_string(fresh.size()) + " objects";
        write_entry({{0, utc_now(), "placode", "store.seal", objects, ""}, seals_text(fresh), {}},
                    previous);
        fresh.clear();
    };
    for (const auto& [object, seal] : all_seals(connection)) {
        if (known.contains(object)) continue;
        fresh[object] = {kNoObject, seal};
        if (fresh.size() == kSealsOfAnEntry) write();
    }
    write();
}

/// Only further on: where the trail does not hold what is remembered, check() has to say so.
void StoreContext::remember_trail() noexcept {
    if (!written_) return;
    try {
        const bool guarded = connection.hides_passwords();
        for (const Station::Head& before : station.heads()) {
            Statement there(connection, guarded ? "SELECT chain FROM placode_guard.trail_chain(?)"
                                                : "SELECT chain FROM audit WHERE id = ?");
            if (!there.run(before.entry).next() || there.text(0) != before.chain) return;
            if (before.entry > written_->entry) return;
        }
        station.remember(*written_);
    } catch (const std::exception&) {
        // A store that is gone has nothing to remember.
    }
}

std::string audit_chain(const std::string& previous, const TrailEntry& entry) {
    // Unit separators, so that no two different rows give the same text.
    std::string text = previous;
    const AuditRecord& row = entry.record;
    for (const std::string* part : {&row.at_utc, &row.actor, &row.action, &row.object, &row.detail})
        text += '\x1f' + *part;
    // Entries from before there were seals keep their chain.
    if (!entry.seals.empty() || !entry.station.empty())
        text += '\x1f' + entry.seals + '\x1f' + entry.station;
    return checksum_hex(text);
}

std::string signed_text(const std::string& chain) { return "placode audit 1\n" + chain; }

}  // namespace placode::db
