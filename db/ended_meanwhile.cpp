// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/ended_meanwhile.h"

#include <array>
#include <string_view>
#include <tuple>
#include <utility>

#include "db/raw_sqlite.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr std::array<const char*, 3> kEnds{"user.erase", "study.withdraw", "study.retention"};
constexpr const char* kTrust = "station.trust";
constexpr const char* kDoubt = "store.restore.doubt";
constexpr size_t kMostNamed = 20;
constexpr size_t kLongestNamed = 100;  ///< [bytes]: whoever wrote it chose what it says.

bool ends_something(const std::string& action) {
    for (const char* each : kEnds)
        if (action == each) return true;
    return false;
}

SqlitePointer opened(const std::string& path) {
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    SqlitePointer owner(database);
    if (code != SQLITE_OK) return nullptr;
    distrust_schema(database);
    return owner;
}

struct ReadEntry {
    TrailEntry entry;
    std::string chain, signature;
};

ReadEntry read_entry(const RawStatement& row) {
    return {{{row.integer(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5)},
             row.text(7),
             row.text(8)},
            row.text(6),
            row.text(9)};
}

/// Follows a trail as check() does (db/audit_check.cpp): one that does not fit hides nothing.
class EndsReader {
 public:
    EndsReader(Believed believed, Meanwhile& found)
        : believed_(std::move(believed)), found_(found) {}

    void follow(const ReadEntry& row) {
        const AuditRecord& record = row.entry.record;
        const bool trusts = record.action == kTrust,
                   wanted = trusts || ends_something(record.action);
        const bool fits = (wanted || held_) && row.chain == audit_chain(previous_, row.entry);
        settle(fits);
        previous_ = row.chain;
        same_store_ = same_store_ || row.chain == believed_.store;
        const std::string& station = row.entry.station;
        any_signed_ = any_signed_ || !station.empty();
        if (!wanted) return;
        const bool proved = fits && believed_.stations.contains(station) &&
                            signature_is_right(signed_text(row.chain), row.signature, station);
        if (trusts && proved) believed_.stations.insert(record.detail);
        if (trusts) return;
        if (fits && !any_signed_ && believed_.without_signature)
            held_ = record;
        else
            take(record, proved);
    }
    /// After the last one.
    void end() {
        settle(true);
        if (!same_store_) found_ = {};
    }

 private:
    /// Of one that nobody signed the next one says whether it was there.
    void settle(bool next_fits) {
        if (const auto entry = std::exchange(held_, std::nullopt)) take(*entry, next_fits);
    }
    void take(const AuditRecord& entry, bool proved) {
        if (!proved)
            found_.doubted.push_back(entry);
        else if (entry.action == kEnds.front())
            found_.people.push_back(entry);
        else
            found_.records.push_back(entry);
    }

    Believed believed_;
    Meanwhile& found_;
    std::string previous_;
    std::optional<AuditRecord> held_;
    bool any_signed_ = false, same_store_ = false;
};

}  // namespace

std::optional<Meanwhile> ended_meanwhile(const std::string& path, Believed believed) {
    const SqlitePointer database = opened(path);
    if (!database) return std::nullopt;
    RawStatement row(database.get(),
                     "SELECT id, at_utc, actor, action, object, detail, chain, seals, station, "
                     "signature FROM audit ORDER BY id");
    if (row.prepared() != SQLITE_OK)  // From before there were signatures.
        row = RawStatement(database.get(),
                           "SELECT id, at_utc, actor, action, object, detail, chain, '', '', '' "
                           "FROM audit ORDER BY id");
    if (row.prepared() != SQLITE_OK) return std::nullopt;
    Meanwhile found;
    EndsReader reader(std::move(believed), found);
    int step = row.step();
    if (step != SQLITE_ROW) return std::nullopt;
    for (; step == SQLITE_ROW; step = row.step()) reader.follow(read_entry(row));
    if (step != SQLITE_DONE) return std::nullopt;
    reader.end();
    // A store from before there were withdrawals has no such table.
    RawStatement why(database.get(), "SELECT study_id, code, reason FROM withdrawals");
    while (why.prepared() == SQLITE_OK && why.step() == SQLITE_ROW)
        found.reasons[why.text(0) + " " + why.text(1)] = why.text(2);
    return found;
}

bool has_signed_entries(const std::string& path) {
    const SqlitePointer database = opened(path);
    if (!database) return false;
    RawStatement any(database.get(), "SELECT 1 FROM audit WHERE station <> '' LIMIT 1");
    return any.prepared() == SQLITE_OK && any.step() == SQLITE_ROW;
}

void name_doubted(Store& store, const std::string& actor, const std::vector<AuditRecord>& doubted) {
    std::set<std::tuple<int64_t, std::string, std::string>> known;
    for (const char* action : kEnds)
        for (const AuditRecord& entry : store.audit().of_action(action))
            known.insert({entry.id, entry.action, entry.object});
    size_t count = 0;
    for (const AuditRecord& each : doubted) {
        if (known.contains({each.id, each.action, each.object}) || ++count > kMostNamed) continue;
        store.audit().write(actor, kDoubt, "entry " + std::to_string(each.id),
                            each.action + " " + each.object.substr(0, kLongestNamed));
    }
    if (count > kMostNamed)
        store.audit().write(actor, kDoubt, "further entries", std::to_string(count - kMostNamed));
}

std::vector<std::string> not_believed(Store& store) {
    const std::vector<AuditRecord> restores = store.audit().of_action("store.restore");
    std::vector<std::string> lines;
    if (restores.empty()) return lines;
    for (const AuditRecord& entry : store.audit().of_action(kDoubt))
        if (entry.id > restores.back().id) lines.push_back(entry.object + ": " + entry.detail);
    return lines;
}

}  // namespace placode::db
