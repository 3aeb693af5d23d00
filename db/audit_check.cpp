// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/audit_check.h"

#include <QVariant>
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

constexpr const char* kSignedEntries =
    "SELECT id, at_utc, actor, action, object, detail, chain, seals, station, signature FROM "
    "audit ";

/// Of all that an entry says, so that what was set aside is that and nothing else.
std::string whole_entry(const SignedEntry& entry) {
    return audit_chain(entry.chain + '\x1f' + entry.signature, entry.entry);
}

/// The chain fits `previous`, and who is said to have written it has signed it.
bool is_proved(const SignedEntry& entry, const std::string& previous) {
    return !entry.entry.station.empty() && entry.chain == audit_chain(previous, entry.entry) &&
           signature_is_right(signed_text(entry.chain), entry.signature, entry.entry.station);
}

std::vector<SignedEntry> entries_of(Connection& connection, const std::string& where,
                                    const std::vector<QVariant>& values) {
    Statement query(connection, kSignedEntries + where);
    query.run_list(values);
    std::vector<SignedEntry> found;
    while (query.next()) found.push_back(read_entry(query));
    return found;
}

std::string chain_before(Connection& connection, const SignedEntry& entry) {
    Statement before(connection, "SELECT chain FROM audit WHERE id < ? ORDER BY id DESC LIMIT 1");
    return before.run(entry.entry.record.id).next() ? before.text(0) : std::string();
}

struct FollowingEntry {
    SignedEntry entry;
    std::string before;  ///< Chain of the entry before it, also of one that was not asked for.

    [[nodiscard]] bool proved() const { return is_proved(entry, before); }
};

/// The first entries, or those that trust a station. On a guarded server who has not signed in
/// reads no row: there a function of the server gives them.
std::vector<FollowingEntry> following_entries(StoreContext& context, bool of_trust) {
    Connection& connection = context.connection;
    std::vector<FollowingEntry> found;
    if (context.server.guards()) {
        Statement query(connection,
                        "SELECT * FROM placode_guard.trail_entries(CAST(? AS INTEGER) <> 0)");
        query.run(of_trust ? 1 : 0);
        while (query.next()) found.push_back({read_entry(query), query.text("before")});
        return found;
    }
    const char* const where = of_trust ? "WHERE action = 'station.trust' ORDER BY id"
                                       : "WHERE id > 0 AND station <> '' ORDER BY id LIMIT 8";
    for (SignedEntry& each : entries_of(connection, where, {})) {
        std::string before = chain_before(connection, each);
        found.push_back({std::move(each), std::move(before)});
    }
    return found;
}

/// Who began the store: of the first entries the one that is proved, and that the next one goes on
/// from. One that was put before the first has no such next one.
std::string first_station(StoreContext& context) {
    const auto begin = following_entries(context, false);
    for (size_t i = 0; i < begin.size(); ++i) {
        const bool goes_on =
            i + 1 == begin.size() ||
            begin[i + 1].entry.chain == audit_chain(begin[i].entry.chain, begin[i + 1].entry.entry);
        if (goes_on && begin[i].proved()) return begin[i].entry.entry.station;
    }
    return {};
}

/// The entries that trust a station and are proved. Anybody who may add rows can say so; only who
/// is trusted can sign it.
std::vector<FollowingEntry> proved_trust(StoreContext& context) {
    auto said = following_entries(context, true);
    std::erase_if(said, [](const FollowingEntry& each) { return !each.proved(); });
    return said;
}

class TrailCheck {
 public:
    TrailCheck(StoreContext& context, std::vector<std::string>& problems, const CheckPace& pace)
        : context_(context),
          problems_(problems),
          pace_(pace),
          trusted_(trusted_stations(context)),
          heads_(context.station.heads()) {
        for (const SignedEntry& each :
             entries_of(context.connection, "WHERE action = 'audit.set_aside'", {}))
            if (trusted_.contains(each.entry.station) &&
                is_proved(each, chain_before(context.connection, each)))
                set_aside_.insert(each.entry.record.detail);
    }

    void run() {
        {
            Statement query(context_.connection, std::string(kSignedEntries) + "ORDER BY id");
            query.run();
            while (query.next()) {
                if (pace_) pace_(CheckProgress::Step::kTrail);
                follow(read_entry(query));
            }
        }
        if (bad_ > kMostNamed)
            problems_.push_back("audit: " + std::to_string(bad_ - kMostNamed) +
                                " more entries that do not fit");
        checkHeads();
        checkObjects();
    }

 private:
    /// One that does not fit hides nothing: what it says of objects is not believed, and the
    /// program has gone on from it.
    void follow(const SignedEntry& entry) {
        const bool fits = entry.chain == audit_chain(previous_, entry.entry);
        previous_ = entry.chain;
        std::erase(heads_, Station::Head{entry.entry.record.id, entry.chain});
        if (!fits) {
            refuse(entry, " or the one before it was changed or removed");
            return;
        }
        if (!checkSignature(entry)) return;
        for (const auto& [object, change] : seals_of_text(entry.entry.seals)) {
            std::string& last = sealed_.try_emplace(object, kNoObject).first->second;
            if (last != change.before)
                report(object, "changed before entry " + std::to_string(entry.entry.record.id));
            last = change.after;
        }
    }

    void refuse(const SignedEntry& entry, const std::string& what) {
        if (!set_aside_.empty() && set_aside_.contains(whole_entry(entry))) return;
        if (++bad_ <= kMostNamed) problems_.push_back(entry_name(entry) + what);
    }

    bool checkSignature(const SignedEntry& entry) {
        const std::string& station = entry.entry.station;
        if (station.empty() && !any_signed_) return true;  // from before there were signatures
        if (station.empty()) {
            refuse(entry, " is not signed, and earlier ones are");
            return false;
        }
        any_signed_ = true;
        if (!signature_is_right(signed_text(entry.chain), entry.signature, station)) {
            refuse(entry, " has a signature that is not right");
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
        const auto now = all_seals(context_.connection, [this] {
            if (pace_) pace_(CheckProgress::Step::kObjects);
        });
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
    const CheckPace& pace_;
    std::set<std::string> trusted_, reported_, set_aside_;
    std::map<SealedObject, std::string> sealed_;
    std::string previous_;
    std::vector<Station::Head> heads_;  ///< What this computer remembers and was not met yet.
    bool any_signed_ = false;
    size_t found_ = 0, bad_ = 0;
};

/// Those of `trusted`, whom one of them trusted, and so on.
std::set<std::string> with_whom_they_trust(StoreContext& context, std::set<std::string> trusted) {
    const std::vector<FollowingEntry> said = proved_trust(context);
    for (bool more = true; more;) {
        more = false;
        for (const FollowingEntry& each : said)
            more = (trusted.contains(each.entry.entry.station) &&
                    trusted.insert(each.entry.entry.record.detail).second) ||
                   more;
    }
    return trusted;
}

}  // namespace

std::set<std::string> registered_stations(StoreContext& context) {
    std::set<std::string> first;
    if (const std::string key = first_station(context); !key.empty()) first.insert(key);
    return with_whom_they_trust(context, std::move(first));
}

std::set<std::string> trusted_stations(StoreContext& context) {
    std::set<std::string> trusted = registered_stations(context);
    // Whoever owns a file owns all in it. A server's word is not this computer's to give.
    const std::string own =
        context.connection.is_sqlite() ? context.station.public_key_if_any() : std::string();
    if (own.empty() || trusted.contains(own)) return trusted;
    trusted.insert(own);
    return with_whom_they_trust(context, std::move(trusted));
}

bool is_trusted_station(StoreContext& context, const std::string& key) {
    (void)context.station.public_key();
    return trusted_stations(context).contains(key);
}

std::string entry_to_set_aside(StoreContext& context, int64_t entry) {
    const auto found = entries_of(context.connection, "WHERE id = ?", {QVariant(qlonglong{entry})});
    if (found.empty() || is_proved(found.front(), chain_before(context.connection, found.front())))
        return {};
    return whole_entry(found.front());
}

void check_trail(StoreContext& context, std::vector<std::string>& problems, const CheckPace& pace) {
    const Snapshot snapshot(context.connection);
    TrailCheck(context, problems, pace).run();
}

}  // namespace placode::db
