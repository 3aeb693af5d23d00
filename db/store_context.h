// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the parts of a store share: the connection, the options, who acts, and what several of them
// look up. Only db/*.cpp include this.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/access.h"
#include "db/attempts.h"
#include "db/records.h"
#include "db/seals.h"
#include "db/server_session.h"
#include "db/sql_connection.h"
#include "db/station.h"
#include "db/store_options.h"
#include "db/trail_head.h"

namespace placode::db {

/// For whom the store works (db/store.h).
struct Actor {
    enum class Kind : uint8_t { kProgram, kNobody, kAccount };

    /// As the store keeps it: "user 12" for an account, whose name is nowhere but in the table
    /// `persons` and goes with it; else the name of a program.
    std::string name = "unknown";
    Kind kind = Kind::kProgram;
    int64_t account = 0;  ///< kAccount: which.
};

/// An entry of the trail with what proves it.
struct TrailEntry {
    AuditRecord record;
    std::string seals, station;
};

struct StoreContext {
    /// Opens the connection; the tables are open_store()'s matter.
    StoreContext(const StoreUrl& url, const StoreOptions& options);
    ~StoreContext();  ///< The station remembers how far the trail went.
    StoreContext(const StoreContext&) = delete;
    StoreContext& operator=(const StoreContext&) = delete;

    Connection connection;
    ServerSession server{connection};  ///< Who acts, as the server sees it.
    StoreOptions options;
    Actor actor;
    Station station;

    [[nodiscard]] int64_t now_ms() const;

    // --- inside a transaction, so that a change and its trace are one
    /// Under the actor's name.
    void append_audit(const std::string& action, const std::string& object,
                      const std::string& detail);
    void append_audit_as(const std::string& name, const std::string& action,
                         const std::string& object, const std::string& detail);
    /// The object is about to change, or may: called before the first change, and its seals before
    /// and after are written with the transaction (db/seals.h).
    void touch(const std::string& kind, const std::vector<std::string>& key);
    void touch(const std::string& kind, int64_t id) { touch(kind, {std::to_string(id)}); }
    /// The object was made in this transaction.
    void made(const std::string& kind, const std::vector<std::string>& key);
    void made(const std::string& kind, int64_t id) { made(kind, {std::to_string(id)}); }
    /// One transaction at a time writes the trail, and all of a centre do: it is waited for longer
    /// than for a row. What others need not wait for comes before.
    void lock_trail() { connection.lock_table("audit", kTrailPatience); }
    /// Says now that the trail ended there, signed where this computer has a key.
    void sign_head(TrailHead& head);
    /// For a store from before there were seals, and rows that were copied in: seals what has none.
    void seal_the_unsealed();
    void delete_attempt(int64_t id);  ///< With all that hangs on it.

    /// A log-in as the store keeps it; what is none stays.
    [[nodiscard]] std::string kept_name(const std::string& login);
    /// What was kept, for people: the log-in, "user 12" once that account was erased, and a name
    /// that an earlier version wrote out.
    [[nodiscard]] std::string shown_name(const std::string& kept);
    /// As shown_name(), but the name that the person has.
    [[nodiscard]] std::string shown_display_name(const std::string& kept);
    /// What somebody typed as the trail keeps it: whoever is named in it, by log-in or name, has an
    /// account, and its number stands there.
    [[nodiscard]] std::string without_names(const std::string& typed);
    /// shown_name() for rows that were read: PostgreSQL gives one answer at a time, so never within
    /// one.
    template <class Row>
    void show_names(std::vector<Row>& rows, std::string Row::*name) {
        std::map<std::string, std::string> shown;  // A list has few names.
        for (Row& row : rows) {
            const auto [at, first] = shown.try_emplace(row.*name);
            if (first) at->second = shown_name(at->first);
            row.*name = at->second;
        }
    }

    // --- whether who acts may, by the table of db/access.cpp: store_rights.cpp. need_...() throws
    // kRefused. Called at the head of every method, after begin_operation() and before the first
    // question: PostgreSQL gives one answer at a time.
    void become(int64_t account_id);  ///< Who acts from now on.
    [[nodiscard]] bool is_self(int64_t account_id) const noexcept;
    /// Of an account that is closed: none.
    [[nodiscard]] Roles roles_of_actor();
    [[nodiscard]] bool may(Action action, Scope scope = Scope::kOther);
    void need(Action action, Scope scope = Scope::kOther);
    /// One of them, on anybody's data.
    void need_any(std::initializer_list<Action> actions);
    void need_for(Action action, int64_t user_id);  ///< On data of this person.
    void need_for_group(Action action, int64_t group_id);
    /// On what belongs to who made the attempt. One of a study is nobody's: kGroup. One that is not
    /// there is left to the method, which says so.
    void need_for_attempt(Action action, int64_t attempt_id);
    void need_sight_of_attempt(int64_t attempt_id) { need_sight_of_attempts({attempt_id}); }
    /// Of all of them, with as many questions as for one.
    void need_sight_of_attempts(const std::vector<int64_t>& ids);
    /// True when `subject` is in no group, or in one where `of` is educator.
    [[nodiscard]] bool in_reach(int64_t of, int64_t subject);
    [[noreturn]] void refuse(Action action) const;

    // --- looked up by several parts; need_...() throws kNotFound
    [[nodiscard]] UserRecord need_user(int64_t id);
    [[nodiscard]] std::optional<UserRecord> find_user(int64_t id);
    /// Of whom an attempt is saved: number, and whether it is a demonstration account. Who saves a
    /// study's attempts sees no names.
    [[nodiscard]] UserRecord need_owner(int64_t id);
    void need_group(int64_t id);
    /// An active educator or administrator, by log-in or, where nobody has that log-in, by name or
    /// as kept ("user 12"): who may be a proctor.
    [[nodiscard]] std::optional<UserRecord> find_staff(const std::string& login_or_name);
    /// Whose attempt it is; account 0 where it is a study's. nullopt: it is not there.
    [[nodiscard]] std::optional<AttemptOwner> owner_of_attempt(int64_t id);
    /// The same of many, as many as are there.
    [[nodiscard]] std::vector<AttemptOwner> owners_of_attempts(const std::vector<int64_t>& ids);
    /// version 0 = the newest.
    [[nodiscard]] std::optional<DefinitionRecord> find_definition(const std::string& kind,
                                                                  const std::string& id,
                                                                  int version);

    // --- participants of studies: store_context_studies.cpp
    void need_participant(const std::string& study_id, const std::string& code);
    /// Throws unless this participant may go on: there, not withdrawn, not locked, consented where
    /// that is needed. `step` is the one that gives the consent, or empty.
    void need_active_participant(const std::string& study_id, const std::string& code,
                                 const std::string& step);
    [[nodiscard]] bool is_locked(const std::string& study_id, const std::string& code);
    /// Throws kRefused while the record is locked.
    void need_unlocked(const std::string& study_id, const std::string& code);

 private:
    /// Who acts has these roles; the groups are asked only where they make a difference.
    [[nodiscard]] bool may_for(Roles roles, Action action, int64_t user_id);
    /// What `persons` says of a kept name in this column; the kept name where it says nothing.
    [[nodiscard]] std::string person_of(const std::string& kept, const char* column);
    static constexpr int kTrailPatience = 12;  ///< A minute, where a row is waited for 5 s.
    void write_trail();
    void write_entry(TrailEntry entry, std::string& previous);
    void remember_trail() noexcept;

    // Of the transaction that is under way.
    std::vector<AuditRecord> entries_;
    std::map<SealedObject, std::string> touched_;  ///< With the seal before.
    std::optional<Station::Head> last_entry_;
    /// The newest entry of this program that was committed: one that was rolled back and remembered
    /// would make check() say that the trail was cut off.
    std::optional<Station::Head> written_;
};

/// Most attempts have none.
inline void show_proctors(StoreContext& context, std::span<AttemptRecord> attempts) {
    std::map<std::string, std::string> shown;
    for (AttemptRecord& each : attempts) {
        if (each.exam.proctor.empty()) continue;
        const auto [at, first] = shown.try_emplace(each.exam.proctor);
        if (first) at->second = context.shown_display_name(at->first);
        each.exam.proctor = at->second;
    }
}

/// The account with this key of a log-in, 0 = none; one question of a server that hides names.
[[nodiscard]] int64_t account_of(Connection& connection, const std::string& key,
                                 bool only_active = false);
[[nodiscard]] bool any_account(Connection& connection);
/// The end of the trail; entry 0: there is none.
[[nodiscard]] Station::Head end_of_trail(Connection& connection);

/// SELECT ... FROM accounts a JOIN persons p ..., for read_user().
[[nodiscard]] const std::string& user_columns();
[[nodiscard]] UserRecord read_user(const Statement& row);

/// SELECT ... FROM definitions, for read_definition().
[[nodiscard]] const std::string& definition_columns();
[[nodiscard]] DefinitionRecord read_definition(const Statement& row);

/// The chain of an audit entry after the one whose chain is `previous`.
[[nodiscard]] std::string audit_chain(const std::string& previous, const TrailEntry& entry);
/// What a station signs of an entry.
[[nodiscard]] std::string signed_text(const std::string& chain);

/// How the audit trail names an account: "user 12". No name: the trail is kept longer than the
/// person may be.
[[nodiscard]] std::string user_object(int64_t id);

}  // namespace placode::db
