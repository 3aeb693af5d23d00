// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A move that is killed, stopped, or finds other rows than it wrote: until the end the old place is
// the store, and the same call ends with the same result.

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <csignal>

#include "sim/core/random.h"
#include "tests/moving_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using Step = db::MoveProgress::Step;

namespace THIS_TEST {

/// Runs `work` in a process of its own, which ends as it wants or is killed. True: killed.
bool killed(const std::function<void()>& work, int after_us = 0) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            work();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            ::_exit(1);
        }
        ::_exit(0);
    }
    if (after_us > 0) {
        std::this_thread::sleep_for(std::chrono::microseconds(after_us));
        ::kill(child, SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
    return WIFSIGNALED(status);
}

class MoveFaults : public MoveTest {
 protected:
    /// As the command does: the last step alone where the old place is closed.
    static db::MoveReport move_on(const std::string& from, const std::string& to,
                                  const db::StoreOptions& options,
                                  const db::MoveOptions& how = {}) {
        if (const auto finished = db::finish_move(from, to)) return *finished;
        return db::open_store(from, options)->move_to(to, how);
    }
    /// Killed at its n-th call of the progress; returns how many there were.
    [[nodiscard]] bool killed_at(int n, const std::string& from, const std::string& to) const {
        return killed([&] {
            int calls = 0;
            db::MoveOptions how;
            how.progress = [&](const db::MoveProgress&) {
                if (++calls == n) ::raise(SIGKILL);
                return true;
            };
            (void)move_on(from, to, options, how);
        });
    }
    [[nodiscard]] int calls_of(const std::string& from, const std::string& to) const {
        int calls = 0;
        db::MoveOptions how;
        how.progress = [&](const db::MoveProgress&) { return ++calls > 0; };
        (void)open(from)->move_to(to, how);
        return calls;
    }
    /// One of both is the store, and never both.
    void expect_one_place(const std::string& from, const std::string& to) const {
        const auto opens = [&](const std::string& url) {
            try {
                return open(url)->accounts().any();
            } catch (const StoreError&) {
                return false;
            }
        };
        // A file that is not there yet must not be made by looking.
        const bool there =
            to.starts_with("postgresql:") || fs::exists(db::parse_store_url(to).path);
        EXPECT_FALSE(opens(from) && there && opens(to));
    }
    static int rounds() { return std::getenv("PLACODE_LONG_TESTS") != nullptr ? 100 : 10; }

    [[nodiscard]] std::string new_server() const {
        return World::get().server().url(World::get().server().new_database(kSortedAsPeopleDo));
    }
    /// Kills a move again and again, then lets it end, and compares.
    void kill_and_go_on(bool to_a_server) {
        fill(file);
        if (to_a_server) {
            calls_ = calls_of(copyOf(file), new_server());
        } else {
            (void)move(copyOf(file), server);
            calls_ = calls_of(server, "sqlite:" + folder.file("count.db"));
        }
        ASSERT_GT(calls_, 50);
        sim::SplitMix64 random(20261126);
        int dead = 0;
        for (int round = 0; round < rounds() && !HasFailure(); ++round) {
            const std::string here = "sqlite:" + folder.file("r" + std::to_string(round) + ".db");
            std::string from = copyOf(file), to = new_server();
            if (!to_a_server) {
                (void)move(from, to);
                std::swap(from, to);
                to = here;
            }
            const AllRows before = rows(from);
            for (int kills = 0; kills < 2; ++kills) {
                const bool by_time = random.next() % 3 == 0;
                dead += by_time ? killed([&] { (void)move_on(from, to, options); },
                                         1 + static_cast<int>(random.next() % 400000))
                                : killed_at(1 + static_cast<int>(random.next() % calls_), from, to);
                expect_one_place(from, to);
            }
            (void)move_on(from, to, options);
            expect_same(before, rows(to), 1);
            expect_sound(to);
            EXPECT_THAT(failure_of([&] { (void)open(from); }).what(),
                        HasSubstr("the store was moved to"));
            (void)move_on(from, to, options);  // Once more: all is done.
            fs::remove(db::parse_store_url(to_a_server ? from : to).path);
        }
        RecordProperty("killed", dead);
        EXPECT_GT(dead, rounds() / 2);
    }
    [[nodiscard]] std::string copyOf(const std::string& url) {
        const std::string path = folder.file("copy" + std::to_string(++copies_) + ".db");
        if (!fs::exists(folder.file("original.db")))
            fs::copy_file(db::parse_store_url(url).path, folder.file("original.db"));
        fs::copy_file(folder.file("original.db"), path);
        return "sqlite:" + path;
    }

    int calls_ = 0, copies_ = 0;
};

TEST_F(MoveFaults, KilledAnywhereOnTheWayToAServerItEndsTheSame) { kill_and_go_on(true); }

TEST_F(MoveFaults, KilledAnywhereOnTheWayToAFileItEndsTheSame) { kill_and_go_on(false); }

TEST_F(MoveFaults, KilledBehindTheClosingOnlyTheLastStepIsLeft) {
    fill(file);
    const AllRows before = rows(file);
    std::string from = file, to = server;
    for (int path = 0; path < 2; ++path) {
        EXPECT_TRUE(killed([&] {
            db::MoveOptions how;
            how.progress = [](const db::MoveProgress& at) {
                return at.step != Step::kFinish || ::raise(SIGKILL) == 0;
            };
            (void)open(from)->move_to(to, how);
        }));
        EXPECT_THAT(failure_of([&] { (void)open(from); }).what(), HasSubstr("was moved to"));
        if (to == server) {
            EXPECT_THAT(failure_of([&] { (void)open(to); }).what(),
                        AllOf(HasSubstr("that is not finished"), HasSubstr("store move --to")));
        }
        EXPECT_FALSE(db::finish_move(from, "sqlite:" + folder.file("elsewhere.db")));
        EXPECT_TRUE(db::finish_move(from, to));
        expect_same(before, rows(to), static_cast<size_t>(path) + 1);
        expect_sound(to);
        from = server;
        to = file;  // Where the old file lies, which is kept.
    }
}

TEST_F(MoveFaults, WhatChangedBetweenTwoTriesIsMoved) {
    fill(file);
    db::MoveOptions stop;
    stop.progress = [](const db::MoveProgress& at) {
        return at.step != Step::kCompare || at.table != "recordings";
    };
    EXPECT_TRUE(open(file)->move_to(server, stop).stopped);
    EXPECT_EQ(open(file)->accounts().sign_in("anna", "wrong again").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(open(file)->accounts().sign_in("bert", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_TRUE(open(file)->move_to(server, stop).stopped) << "goes on with the rows that are new";
    {
        const auto store = open(file);
        store->attempts().save(store->accounts().create(trainee("new")), make_result());
        store->accounts().erase(full.anna, true);
    }
    const AllRows before = rows(file);
    const db::MoveReport report = open(file)->move_to(server);
    EXPECT_TRUE(report.went_on);
    expect_same(before, rows(server), 1);
    expect_sound(server);
}

TEST_F(MoveFaults, AStopKeepsWhatIsThereAndTheOldPlaceIsTheStore) {
    fill(file);
    const AllRows before = rows(file);
    db::MoveOptions stop;
    stop.progress = [](const db::MoveProgress& at) { return at.table != "audit"; };
    EXPECT_TRUE(open(file)->move_to(server, stop).stopped);
    EXPECT_EQ(rows(file), before);
    expect_sound(file);
    EXPECT_EQ(rows(server)["attempt_events"], before.at("attempt_events"));
    open(file)->accounts().create(trainee("goes_on"));
}

TEST_F(MoveFaults, ARowThatWasAlteredInTheNewPlaceIsFoundAndNamed) {
    fill(file);
    struct Case {
        const char *sql, *said;
    };
    const std::vector<Case> cases{
        {"UPDATE attempts SET points = points - 1 WHERE id = 1", "attempts, id 1: points differs"},
        {"UPDATE attempt_metrics SET value = 0 WHERE position = 4", "position 4: value differs"},
        {"UPDATE recordings SET checksum = 'x'", "recordings, attempt_id 1: checksum differs"},
        {"DELETE FROM answer_items WHERE item = (SELECT MIN(item) FROM answer_items)",
         "is missing"},
        {"INSERT INTO training_groups (id, name, name_key, created_utc) VALUES (77, 'x', 'x', '')",
         "training_groups, id 77 was added"},
        {"UPDATE persons SET display_name = '' WHERE account_id = 2",
         "persons, account_id 2: display_name differs"}};
    for (const Case& each : cases) {
        bool done = false;
        db::MoveOptions how;
        how.progress = [&](const db::MoveProgress& at) {
            if (at.step == Step::kCompare && !std::exchange(done, true)) {
                RawConnection pen = raw(server);
                EXPECT_TRUE(pen.run(each.sql)) << pen.problem();
            }
            return true;
        };
        const AllRows before = rows(file);
        const auto error = failure_of([&] { (void)open(file)->move_to(server, how); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kDamaged);
        EXPECT_THAT(error.what(), AllOf(HasSubstr(each.said), HasSubstr("nothing was moved")));
        EXPECT_EQ(rows(file), before);
    }
    const AllRows before = rows(file);
    (void)open(file)->move_to(server);
    expect_same(before, rows(server), 1);
    expect_sound(server);
}

TEST_F(MoveFaults, WhileItMovesNobodyElseWrites) {
    fill(file);
    std::string from = file, to = server;
    for (int path = 0; path < 2; ++path) {
        const auto other = db::open_store(from + "?timeout_ms=100", options);
        bool tried = false;
        db::MoveOptions how;
        how.progress = [&](const db::MoveProgress& at) {
            if (at.step != Step::kCopy || std::exchange(tried, true)) return true;
            EXPECT_EQ(failure_of([&] { other->accounts().create(trainee("late")); }).kind(),
                      StoreError::Kind::kLocked);
            EXPECT_FALSE(other->accounts().list().empty()) << "reading goes on";
            return true;
        };
        (void)open(from)->move_to(to, how);
        EXPECT_TRUE(tried);
        from = server;
        to = "sqlite:" + folder.file("back.db");
    }
}

}  // namespace THIS_TEST
