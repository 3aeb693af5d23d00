// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a store moves: rows are copied, all of them compared, the copy is checked as a store; the
// move's own entry ends its trail; the old place is closed; the new one is opened. A kill before
// the closing leaves the old place as it was, one behind it leaves only finish_move() to do.

#include "db/store_move.h"

#include <filesystem>

#include "db/accounts.h"
#include "db/foreign_store.h"
#include "db/held_store.h"
#include "db/local_profile.h"
#include "db/move_rows.h"
#include "db/move_target.h"
#include "db/station_role.h"
#include "db/store.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;
using Step = MoveProgress::Step;
using State = StorePlace::State;

/// Thrown out of the middle of the work when somebody has had enough.
struct Stopped {};

class StoreMove {
 public:
    StoreMove(StoreContext& source, const StoreUrl& to, const MoveOptions& options)
        : source_(source), from_(source.connection), to_(to), options_(options) {
        place_.from = report_.from = place_name(from_.url());
        place_.to = report_.to = place_name(to);
    }

    using Check = std::function<std::vector<std::string>(const CheckOptions&)>;

    MoveReport run(const Check& check) {
        from_.begin_operation("move");
        needMovable();
        MoveTarget target(to_, place_.store, source_.options);
        target.need_free();
        report_.went_on = target.underway();
        from_.begin_operation("move");
        count();
        if (options_.dry_run) return report_;
        try {
            tell(Step::kCheckHere);
            needSound(check(stoppedIn(Step::kCheckHere)), from_);
            from_.begin_operation("move");
            work(target);
        } catch (const Stopped&) {
            report_.stopped = true;
        }
        return report_;
    }

 private:
    void needMovable() {
        if (from_.url().engine == to_.engine)
            from_.fail(Kind::kRefused,
                       "a store moves from a file to a server, or back; copy a file with "
                       "`placodectl backup`, and a server with pg_dump");
        if (from_.url().path == ":memory:" || to_.path == ":memory:")
            from_.fail(Kind::kRefused, "a store in memory does not move");
        if (!from_.is_sqlite() && !owns_tables(from_)) from_.fail(Kind::kRefused, kOnlyTheOwner);
        // On a server nobody could sign in to it any more.
        const bool nobody_has_a_password = Accounts(source_).local_profile().has_value();
        from_.begin_operation("move");
        if (nobody_has_a_password) from_.fail(Kind::kRefused, one_persons_store());
        place_.store = first_chain(from_);
        if (place_.store.empty())
            from_.fail(Kind::kRefused, "there is nothing in it yet; begin in the new place");
    }

    void count() {
        tables_ = store_tables(from_, source_.options);
        for (const StoreTable& table : tables_) {
            Statement query(from_, "SELECT COUNT(*) FROM " + table.name);
            (void)query.run().next();
            report_.tables.push_back({table.name, query.integer(0)});
            report_.rows += query.integer(0);
        }
        Statement bytes(from_, "SELECT COALESCE(SUM(LENGTH(content)), 0) FROM recordings");
        if (bytes.run().next()) report_.recording_bytes = bytes.integer(0);
    }

    void needSound(const std::vector<std::string>& problems, Connection& where) const {
        if (!problems.empty())
            where.fail(Kind::kDamaged, "it is not sound (" + problems.front() +
                                           "); nothing was moved; see `placodectl check`");
    }

    /// From here on nobody else writes into the old place until it is closed, or all is over.
    void work(MoveTarget& target) {
        UnitOfWork closed(from_);
        if (!from_.is_sqlite()) {
            std::vector<std::string> names;
            for (const StoreTable& table : tables_) names.push_back(table.name);
            from_.execute("LOCK TABLE " + listed(names) + " IN SHARE ROW EXCLUSIVE MODE");
            // It stands still while the copy is checked.
            from_.execute("SET LOCAL idle_in_transaction_session_timeout = 0");
        }
        {
            Statement last(from_, "SELECT id, chain FROM audit ORDER BY id DESC LIMIT 1");
            (void)last.run().next();
            place_.entry = last.integer("id");
            place_.chain = last.text("chain");
        }
        place_.at_utc = utc_now();
        fill(target);
        place_.state = State::kMoved;
        close_place(from_, place_, tables_);
        closed.commit();
        tell(Step::kFinish, false);
        try {
            report_.old_file = target.finish();
        } catch (const StoreError& error) {
            throw StoreError(error.kind(), std::string(error.what()) +
                                               "; all is copied, and the same command finishes it");
        }
    }

    /// The new place holds all that the old one does, and the entry of the move.
    void fill(MoveTarget& target) {
        auto opened = target.open(place_);
        if (!goesOn(opened->connection)) opened = target.open_empty(std::move(opened), place_);
        StoreContext& there = *opened;
        Store store(std::move(opened));
        {
            UnitOfWork work(there.connection);
            set_place(there.connection, place_);
            // No seal says whether these have changed since.
            for (const char* table : {"sign_in_failures", "account_pins"})
                there.connection.execute(std::string("DELETE FROM ") + table);
            work.commit();
        }
        copy(there.connection);
        compare(there.connection);
        tell(Step::kCheckThere);
        const auto problems = store.check(stoppedIn(Step::kCheckThere)).value();
        there.connection.begin_operation("move to");
        if (!problems.empty()) throwAway(there.connection, problems.front());
        UnitOfWork work(there.connection);
        there.append_audit_as(source_.actor.name, "store.move", place_.to, "from " + place_.from);
        place_.state = State::kReady;
        set_place(there.connection, place_);
        work.commit();
    }

    /// Whether the rows that are there are the beginning of what is here now. All that changed
    /// since then has written its seals into the trail.
    bool goesOn(Connection& there) {
        const auto begun = place_of(there);
        if (!begun || begun->state != State::kArriving) return false;
        {
            Statement entry(from_, "SELECT chain FROM audit WHERE id = ?");
            if (!entry.run(begun->entry).next() || entry.text(0) != begun->chain) return false;
        }
        Statement changes(from_, "SELECT COUNT(*) FROM audit WHERE id > ? AND seals <> ''");
        return changes.run(begun->entry).next() && changes.integer(0) == 0;
    }

    void copy(Connection& there) {
        done_ = 0;
        for (const StoreTable& table : tables_) {
            Statement query(there, "SELECT COUNT(*) FROM " + table.name);
            if (query.run().next()) done_ += query.integer(0);
        }
        for (const StoreTable& table : tables_)
            copy_rows(from_, there, table, [&](int64_t rows) {
                done_ += rows;
                tell(Step::kCopy, true, table.name);
            });
        for (const StoreTable& table : tables_)
            if (const int64_t last = counter_of(from_, table); last > 0) {
                UnitOfWork work(there);
                set_counter(there, table, last);
                work.commit();
            }
    }

    void compare(Connection& there) {
        done_ = 0;
        for (const StoreTable& table : tables_) {
            const std::string found = first_difference(from_, there, table, [&](int64_t rows) {
                done_ += rows;
                tell(Step::kCompare, true, table.name);
            });
            if (!found.empty()) throwAway(there, found);
            if (counter_of(from_, table) != counter_of(there, table))
                throwAway(there, table.name + ": the number of the next row differs");
        }
    }

    /// Somebody, or a disk, has changed the copy.
    [[noreturn]] void throwAway(Connection& there, const std::string& why) {
        StorePlace place = place_;
        place.chain.clear();
        UnitOfWork work(there);
        set_place(there, place);
        work.commit();
        there.fail(Kind::kDamaged, "what was copied is not what is in " + place_.from + " (" + why +
                                       "); nothing was moved, and the same command begins anew");
    }

    void tell(Step step, bool may_stop = true, const std::string& table = "") {
        if (!options_.progress) return;
        const bool rows = step == Step::kCopy || step == Step::kCompare;
        if (!options_.progress({step, table, rows ? done_ : 0, rows ? report_.rows : 0}) &&
            may_stop)
            throw Stopped{};
    }

    /// Of a check that takes long.
    [[nodiscard]] CheckOptions stoppedIn(Step step) {
        return {{}, [this, step](const CheckProgress&) { tell(step); }};
    }

    StoreContext& source_;
    Connection& from_;
    StoreUrl to_;
    const MoveOptions& options_;
    std::vector<StoreTable> tables_;
    StorePlace place_;
    MoveReport report_;
    int64_t done_ = 0;
};

}  // namespace

MoveReport Store::move_to(const std::string& url, const MoveOptions& options) {
    context_->connection.begin_operation("move");
    context_->need(Action::kBackup);
    return StoreMove(*context_, parse_store_url(url), options).run([this](const CheckOptions& how) {
        return check(how).value();
    });
}

std::optional<MoveReport> finish_move(const std::string& from_url, const std::string& to_url) {
    const StoreUrl from = parse_store_url(from_url), to = parse_store_url(to_url);
    // Only looked at: SQLite would make a file that is not there.
    if (from.engine == Engine::kSqlite &&
        (!std::filesystem::is_regular_file(from.path) || !is_marked_as_store(from.path)))
        return std::nullopt;
    if (from.engine == Engine::kSqlite) need_own_schema(from.path, "move " + from.shown);
    Connection connection(from);
    connection.begin_operation("move");
    const auto place = place_of(connection);
    if (!place || place->state != State::kMoved || !same_place(place->to, place_name(to)))
        return std::nullopt;
    if (!connection.is_sqlite() && !owns_tables(connection))
        connection.fail(Kind::kRefused, kOnlyTheOwner);
    MoveReport report;
    report.from = place->from;
    report.to = place->to;
    report.went_on = true;
    report.old_file = MoveTarget(to, place->store, {}).finish();
    return report;
}

}  // namespace placode::db
