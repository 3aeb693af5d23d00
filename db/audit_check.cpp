// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/audit_check.h"

#include <algorithm>
#include <set>

#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr size_t kMostNamed = 20;  ///< Objects; a store that was rewritten has thousands.

/// All that is read between its two ends is of one moment.
class Snapshot {
 public:
    explicit Snapshot(Connection& connection) : connection_(connection) {
        connection_.execute(
            connection_.is_sqlite() ? "BEGIN" : "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
    }
    ~Snapshot() {
        try {
            connection_.execute("COMMIT");
        } catch (const StoreError&) {
            // Nothing was changed.
        }
    }
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;

 private:
    Connection& connection_;
};

struct SignedEntry {
    TrailEntry entry;
    std::string chain, signature;
};

SignedEntry read_entry(const Statement& row) {
    SignedEntry found;
    found.entry.record = {row.integer("id"),  row.text("at_utc"), row.text("actor"),
                          row.text("action"), row.text("object"), row.text("detail")};
    found.chain = row.text("chain");
    found.entry.seals = row.text("seals");
    found.entry.station = row.text("station");
    found.signature = row.text("signature");
    return found;
}

std::string entry_name(const SignedEntry& entry) {
    return "audit: entry " + std::to_string(entry.entry.record.id);
}

class TrailCheck {
 public:
    TrailCheck(StoreContext& context, std::vector<std::string>& problems)
        : context_(context),
          problems_(problems),
          trusted_(trusted_stations(context)),
          heads_(context.station.heads()) {}

    void run() {
        Statement query(context_.connection,
                        "SELECT id, at_utc, actor, action, object, detail, chain, seals, station, "
                        "signature FROM audit ORDER BY id");
        query.run();
        while (query.next())
            if (!follow(read_entry(query))) return;
        checkHeads();
        checkObjects();
    }

 private:
    /// False at the first entry that does not fit: none after it can be judged.
    bool follow(const SignedEntry& entry) {
        if (entry.chain != audit_chain(previous_, entry.entry)) {
            problems_.push_back(entry_name(entry) + " or the one before it was changed or removed");
            return false;
        }
        previous_ = entry.chain;
        std::erase(heads_, Station::Head{entry.entry.record.id, entry.chain});
        if (!checkSignature(entry)) return false;
        for (const auto& [object, change] : seals_of_text(entry.entry.seals)) {
            std::string& last = sealed_.try_emplace(object, kNoObject).first->second;
            if (last != change.before)
                report(object, "changed before entry " + std::to_string(entry.entry.record.id));
            last = change.after;
        }
        return true;
    }

    bool checkSignature(const SignedEntry& entry) {
        const std::string& station = entry.entry.station;
        if (station.empty() && !any_signed_) return true;  // from before there were signatures
        if (station.empty()) {
            problems_.push_back(entry_name(entry) + " is not signed, and earlier ones are");
            return false;
        }
        any_signed_ = true;
        if (!signature_is_right(signed_text(entry.chain), entry.signature, station)) {
            problems_.push_back(entry_name(entry) + " has a signature that is not right");
            return false;
        }
        if (!trusted_.contains(station) && reported_.insert(station).second)
            problems_.push_back(entry_name(entry) + " was written by the station " +
                                fingerprint(station) +
                                ", which no other one trusts; if it is one of yours, run "
                                "`placodectl station trust " +
                                fingerprint(station) + "` at a station that is");
        return true;
    }

    /// Whatever was remembered and not found on the way.
    void checkHeads() {
        std::set<int64_t> said;
        for (const Station::Head& head : heads_)
            if (said.insert(head.entry).second)
                problems_.push_back("audit: this computer wrote entry " +
                                    std::to_string(head.entry) +
                                    ", and the trail does not hold it as it was: it was cut off or "
                                    "written anew, or an older copy was put in the store's place "
                                    "without `placodectl restore`");
    }

    void checkObjects() {
        if (sealed_.empty()) return;  // from before there were seals
        const auto now = all_seals(context_.connection);
        for (const auto& [object, seal] : sealed_) {
            const auto there = now.find(object);
            if (there == now.end() ? seal != kNoObject : seal != there->second)
                report(object, there == now.end()  ? "removed"
                               : seal == kNoObject ? "put back"
                                                   : "changed");
        }
        for (const auto& [object, seal] : now)
            if (!sealed_.contains(object)) report(object, "added");
        if (found_ > kMostNamed)
            problems_.push_back("seals: " + std::to_string(found_ - kMostNamed) + " more objects");
    }

    void report(const SealedObject& object, const std::string& what) {
        if (++found_ <= kMostNamed)
            problems_.push_back("seals: " + object.name() + " was " + what +
                                " without this program");
    }

    StoreContext& context_;
    std::vector<std::string>& problems_;
    std::set<std::string> trusted_, reported_;
    std::map<SealedObject, std::string> sealed_;
    std::string previous_;
    std::vector<Station::Head> heads_;  ///< What this computer remembers and was not met yet.
    bool any_signed_ = false;
    size_t found_ = 0;
};

}  // namespace

std::set<std::string> trusted_stations(StoreContext& context) {
    std::set<std::string> trusted;
    const bool guarded = context.server.guards();
    Statement first(context.connection,
                    guarded ? "SELECT station FROM placode_guard.trail_founder()"
                            : "SELECT station FROM audit WHERE station <> '' ORDER BY id LIMIT 1");
    if (first.run().next()) trusted.insert(first.text(0));
    if (const std::string own = context.station.public_key_if_any(); !own.empty())
        trusted.insert(own);
    std::vector<std::pair<std::string, std::string>> said;
    Statement query(
        context.connection,
        guarded ? "SELECT station, detail FROM placode_guard.trail_trust()"
                : "SELECT station, detail FROM audit WHERE action = 'station.trust' ORDER BY id");
    query.run();
    while (query.next()) said.emplace_back(query.text(0), query.text(1));
    for (bool more = true; more;) {
        more = false;
        for (const auto& [by, whom] : said)
            more = (trusted.contains(by) && trusted.insert(whom).second) || more;
    }
    return trusted;
}

void check_trail(StoreContext& context, std::vector<std::string>& problems) {
    const Snapshot snapshot(context.connection);
    TrailCheck(context, problems).run();
}

}  // namespace placode::db
