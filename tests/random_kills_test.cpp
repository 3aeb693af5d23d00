// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The three programs are killed at random moments while they write: nothing that was acknowledged
// is lost, every store is sound, and the same command may be given again. RELIABILITY.md has the
// figures of a long run; PLACODE_KILLS_SEED gives other moments.

#include "db/recording_file.h"
#include "tests/bars.h"
#include "tests/kill_rounds.h"

using namespace placode;
using namespace placode::test;
using testing::AnyOf;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();

// What README promises, of the time that the program itself had last told.
constexpr double kLost_s = 0.5;

std::string numbered(const char* word, int n) { return word + std::to_string(n); }

/// Accounts, one a round. `all`: who is there besides the one of the round.
class AccountKills : public RandomKills {
 protected:
    void SetUp() override {
        RandomKills::SetUp();
        add_user("admin", "administrator");
    }
    [[nodiscard]] Work adding(const char* word) {
        Work work;
        work.begin = [this, word](int n) { return start_ctl("user add " + numbered(word, n)); };
        work.is_there = [this, word](int n) {
            auto found = logins(store);
            const bool there = found.erase(numbered(word, n)) > 0;
            EXPECT_EQ(found, all) << "of those before none is missing and none is there twice";
            return there;
        };
        work.again = [this, word](int n, bool was_there) {
            add_once(numbered(word, n), was_there);
            all.insert(numbered(word, n));
        };
        return work;
    }

    std::set<std::string> all{"admin"};
};

TEST_F(AccountKills, AnAccountThatWasAcknowledgedIsThere) {
    kill_often("kills: user add", times(2, 170), adding("user"));
}

TEST_F(RandomKills, ACourseThatWasAssignedIsAssignedOnce) {
    add_user("admin", "administrator");
    size_t before = 0;
    Work work;
    work.begin = [&](int n) {
        add_once(numbered("user", n), false);  // Nobody has the same course twice.
        return start_ctl("course assign first_steps --user " + numbered("user", n));
    };
    work.is_there = [&](int n) {
        const auto all = asked(store, "course assignments");
        const auto own = asked(store, "course assignments --user " + numbered("user", n));
        EXPECT_EQ(all.size(), before + own.size());
        EXPECT_LE(own.size(), 1u);
        return !own.empty();
    };
    work.again = [&](int n, bool was_there) {
        const Outcome assigned = ctl("course assign first_steps --user " + numbered("user", n));
        expect_done_or_known(assigned, was_there, 2, "assigned already");
        ++before;
    };
    kill_often("kills: course assign", times(1, 120), work);
}

TEST_F(RandomKills, AnImportThatSaidItsNumberIsThereAndEachRecordingOnce) {
    add_user("anna", "trainee");
    size_t before = 0;
    std::string name, points;
    Work work;
    work.begin = [&](int n) {
        name = recording(n);
        return start_ctl("import " + name + " --user anna");
    };
    work.is_there = [&](int n) {
        const auto all = asked(store, "attempts --user anna");
        EXPECT_THAT(all.size(), AnyOf(before, before + 1));
        if (all.size() == before) return false;
        const auto score = asked(store, "score " + name);
        EXPECT_EQ(all.back().at("seed"), n);
        EXPECT_EQ(all.back().at("points"), score.at("points")) << "a whole attempt";
        return true;
    };
    work.again = [&](int, bool was_there) {
        const Outcome saved = ctl("import " + name + " --user anna");
        expect_done_or_known(saved, was_there, 2, "has this recording already, as attempt");
        fs::remove(file(name));
        ++before;
    };
    kill_often("kills: import", times(1, 150), work);
}

TEST_F(RandomKills, ABackupIsWholeOrNotThere) {
    add_user("admin", "administrator");
    add_user("anna", "trainee");
    ASSERT_EQ(ctl("course assign first_steps --user anna").status, 0);
    const std::set<std::string> all{"admin", "anna"};
    const auto copy = [&](int n) { return file(numbered("store/first/copy", n)); };
    Work work;
    work.begin = [&](int n) { return start_ctl("backup " + copy(n)); };
    work.is_there = [&](int n) {
        EXPECT_EQ(logins(store), all);
        if (!fs::exists(copy(n))) return false;
        expect_sound(copy(n));
        EXPECT_EQ(logins(copy(n)), all);
        EXPECT_EQ(asked(copy(n), "course assignments").size(), 1u);
        if (!said().empty()) expect_sound(copy(n), "--head " + copy(n) + ".head");
        return true;
    };
    work.again = [&](int n, bool was_there) {
        const Outcome made = ctl("backup " + copy(n));
        expect_done_or_known(made, was_there, 2, "is not overwritten");
        EXPECT_EQ(logins(copy(n)), all);
        EXPECT_FALSE(fs::exists(copy(n) + ".failed"));
    };
    kill_often("kills: backup", times(1, 120), work);
}

TEST_F(RandomKills, ARestoreLeavesTheOldOrTheNewStoreAndKeepsTheOld) {
    add_user("admin", "administrator");
    ASSERT_EQ(ctl("backup " + file("copy.db")).status, 0);
    const std::set<std::string> in_backup{"admin"};
    std::set<std::string> old;
    // The store that was replaced; beside it lies what the trail's end was.
    const auto kept = [&] {
        std::vector<std::string> found;
        for (const auto& each : fs::directory_iterator(fs::path(store).parent_path()))
            if (const std::string path = each.path();
                path.find(".replaced-") != std::string::npos && path.ends_with('Z'))
                found.push_back(path);
        return found;
    };
    Work work;
    work.begin = [&](int n) {
        for (const std::string& each : kept()) fs::remove(each);
        add_once(numbered("user", n), false);
        old = {"admin", numbered("user", n)};
        return start_ctl("restore " + file("copy.db"));
    };
    work.is_there = [&](int) {
        const auto found = logins(store);
        EXPECT_THAT(found, AnyOf(old, in_backup));
        if (found == in_backup) {
            const auto aside = kept();
            EXPECT_EQ(aside.size(), 1u);
            if (!aside.empty()) {
                EXPECT_EQ(logins(aside.front()), old);
            }
        }
        return found == in_backup;
    };
    work.again = [&](int, bool) {
        expect_sound();
        const Outcome restored = ctl("restore " + file("copy.db"));
        EXPECT_EQ(restored.status, 0) << restored.err;
        EXPECT_EQ(logins(store), in_backup);
    };
    kill_often("kills: restore", times(1, 120), work);
}

TEST_F(AccountKills, OfSeveralWritersOneIsKilledAndTheOthersLoseNothing) {
    std::vector<RunningProgram> others;
    const std::vector<std::string> names{"b", "c", "d"};
    const Work one = adding("a");
    Work work = one;
    work.begin = [&](int n) {
        for (const std::string& each : names)
            others.push_back(start_ctl("user add " + each + std::to_string(n), each));
        return one.begin(n);
    };
    work.is_there = [&](int n) {
        for (size_t i = 0; i < others.size(); ++i) {
            EXPECT_EQ(others[i].until({}).status, 0)
                << read_text(file("said/" + names[i] + ".err"));
            all.insert(names[i] + std::to_string(n));
        }
        others.clear();
        return one.is_there(n);
    };
    kill_often("kills: one of four writers", times(1, 100), work);
}

TEST_F(RandomKills, AFirstStartThatWasKilledBeginsAgain) {
    Work work;
    work.begin = [&](int n) {
        new_store(numbered("n", n));
        return start_ctl("user add admin --role administrator");
    };
    work.is_there = [&](int) { return fs::exists(store) && logins(store).contains("admin"); };
    work.again = [&](int, bool was_there) {
        add_once("admin", was_there, "administrator");
        EXPECT_EQ(logins(store), std::set<std::string>{"admin"});
    };
    kill_often("kills: first start", times(2, 100), work);
}

/// The shell makes the store, signs in and opens every page; nobody can click in it here.
TEST_F(RandomKills, TheShellLeavesASoundStore) {
    if (!fs::exists(PLACODE_BIN_DIR "/placode")) GTEST_SKIP() << "built without the shell";
    const int wanted = times(0, 40);
    if (wanted == 0) GTEST_SKIP() << "only in a long run";
    const auto tour = [&](const Moment& moment) {
        return start("placode", "--store sqlite:" + store + " --time-pages admin").until(moment);
    };
    // Where there is no account it ends as soon as the store is made.
    new_store("new");
    const Shot makes = tour({});
    ASSERT_EQ(makes.status, 2) << said();
    add_user("admin", "administrator");
    const Shot signs_in = tour({});
    ASSERT_EQ(signs_in.status, 0) << read_text(file("said/it.err"));
    Bar bar("kills: placode makes a store or signs in");
    int kills = 0;
    for (int n = 0; kills < wanted && n < 4 * wanted && !HasFailure(); ++n) {
        const bool is_new = n % 2 == 0;
        new_store(numbered("s", n));
        if (!is_new) add_user("admin", "administrator");
        Moment moment = moment_of(is_new ? makes : signs_in);
        // It signs in at the beginning, and then only reads.
        if (!is_new) moment.after_s = 0.3 * (moment.after_s < 0 ? signs_in.ran_s : moment.after_s);
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << n);
        const Shot shot = tour(moment);
        EXPECT_TRUE(shot.killed || shot.status == (is_new ? 2 : 0));
        add_once("admin", !is_new, "administrator");
        EXPECT_EQ(logins(store), std::set<std::string>{"admin"});
        expect_sound();
        EXPECT_EQ(ctl("--as admin attempts", kRight).status, 0);
        if (!shot.killed) continue;
        ++kills;
        bar.tried(!HasFailure());
    }
    EXPECT_TRUE(HasFailure() || kills == wanted);
}

/// What the program has told on its standard output, one JSON object a line.
struct Told {
    double time_s = 0;
    bool recorded = false;
};
Told told(const std::string& lines) {
    Told last;
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line) && !in.eof();) {
        const auto object = nlohmann::json::parse(line);
        last.time_s = object.at("t_s");
        last.recorded = object.value("recorded", false);
    }
    return last;
}

class RecordingKills : public RandomKills {
 protected:
    void SetUp() override {
        RandomKills::SetUp();
        add_user("anna", "trainee");
    }
    /// In real time, as a trainee would lose it, and with an end within reach.
    [[nodiscard]] Shot record(const std::string& path, int number, Moment moment) const {
        return start("placode-sim",
                     "--task touch_targets --headless --status --duration 1 "
                     "--device script:novice --seed " +
                         std::to_string(number) + " --record " + path)
            .until(moment);
    }
    /// What is left of a recording can be read, scored and imported once, as what it is.
    void expect_usable(const std::string& path, const sim::Recording& recording) {
        const auto score = asked(store, "score " + path);
        EXPECT_EQ(score.at("duration_s"), recording.end.duration_s);
        const bool ended = recording.end.reason != sim::EndReason::kInterrupted;
        EXPECT_EQ(score.at("end") != "interrupted", ended);
        EXPECT_EQ(ctl("import " + path + " --user anna").status, 0);
        EXPECT_THAT(ctl("import " + path + " --user anna").err,
                    HasSubstr("has this recording already"));
        ++attempts;
        const auto all = asked(store, "attempts --user anna");
        EXPECT_EQ(static_cast<int>(all.size()), attempts);
        EXPECT_EQ(all.back().at("end") != "interrupted", ended);
    }
    /// @return what was lost of the time that it had told [s].
    double look(const std::string& path, const Told& last) {
        EXPECT_EQ(db::leftover_recordings(fs::path(path).parent_path()).size(),
                  fs::exists(path) ? 1u : 0u)
            << "the next start offers it";
        try {
            const sim::Recording recording = db::read_recording_file(path);
            EXPECT_FALSE(last.recorded && recording.end.reason == sim::EndReason::kInterrupted);
            if (recording.end.duration_s > 0) expect_usable(path, recording);
            return last.time_s - recording.end.duration_s;
        } catch (const db::StoreError& error) {
            // Before the first commit there is nothing to read, and that is said.
            const Outcome score = ctl("score " + path);
            EXPECT_EQ(score.status, 2) << error.what();
            EXPECT_THAT(score.err, HasSubstr(path));
            return last.time_s;
        }
    }

    int attempts = 0;
};

TEST_F(RecordingKills, ARecordingIsThereUpToHalfASecond) {
    const std::string name = file("store/first/a.placode");
    const Shot whole = record(name, 0, {});
    ASSERT_EQ(whole.status, 0);
    ASSERT_TRUE(told(said()).recorded);
    ASSERT_LE(look(name, told(said())), 0.001);
    fs::remove(name);
    Bar bar("kills: placode-sim records");
    const int wanted = times(1, 100);
    int kills = 0, ended = 0;
    double most_lost_s = 0;
    for (int n = 1; kills < wanted && n < 4 * wanted + 8 && !HasFailure(); ++n) {
        const Shot shot = record(name, n, moment_of(whole));
        const Told last = told(said());
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << n << ": killed after "
                                        << shot.ran_s << " s at " << last.time_s << " s");
        EXPECT_TRUE(shot.killed || shot.status == 0);
        const double lost_s = look(name, last);
        EXPECT_LE(lost_s, kLost_s);
        expect_sound();
        for (const auto& each : fs::directory_iterator(fs::path(name).parent_path()))
            if (each.path().string().find("a.placode") != std::string::npos) fs::remove(each);
        if (!shot.killed) continue;
        ++kills;
        ended += last.recorded ? 1 : 0;
        most_lost_s = std::max(most_lost_s, lost_s);
        bar.tried(!HasFailure());
    }
    EXPECT_TRUE(HasFailure() || kills == wanted);
    std::printf("kills: placode-sim records: %d kills, %d behind its end; at most %.2f s lost\n",
                kills, ended, most_lost_s);
}

}  // namespace THIS_TEST
