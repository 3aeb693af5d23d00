// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kills a program at random moments, again and again, and asks each time what is left: what it had
// acknowledged is there, the store is sound, and the same command can be given again.

#include <gmock/gmock.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "sim/core/random.h"
#include "tests/bars.h"
#include "tests/killed_program.h"
#include "tests/programs_fixture.h"

namespace placode::test {

/// One kind of work, done again and again; `n` counts its rounds.
struct Work {
    std::function<RunningProgram(int n)> begin;
    std::function<bool(int n)> is_there;  ///< Whether what round n writes is there, and whole.
    std::function<void(int n, bool was_there)> again;  ///< The same command, now left alone.
};

class RandomKills : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        fs::create_directory(file("said"));
        fs::create_directory(file("store"));
        new_store("first");
        if (const char* other = std::getenv("PLACODE_KILLS_SEED"); other != nullptr)
            seed = std::strtoull(other, nullptr, 10);
        random = sim::SplitMix64(seed);
    }

    /// A folder with nothing in it, where a store and a station's key will be.
    void new_store(const std::string& name) {
        fs::create_directory(file("store/" + name));
        store = file("store/" + name + "/placode.db");
        ::setenv("PLACODE_STATION_KEY", file("store/" + name + "/station.key").c_str(), 1);
    }

    /// @param arguments separated by blanks.
    [[nodiscard]] RunningProgram start(const std::string& program, const std::string& arguments,
                                       const std::string& name = "it") const {
        RunningProgram::Start how;
        how.words = {PLACODE_BIN_DIR "/" + program};
        std::istringstream in(arguments);
        for (std::string word; in >> word;) how.words.push_back(word);
        how.folder = folder;
        how.out = file("said/" + name + ".out");
        how.err = file("said/" + name + ".err");
        how.watched = fs::path(store).parent_path();
        how.environment = {{"HOME", folder},
                           {"XDG_DATA_HOME", file("data")},
                           {"QT_QPA_PLATFORM", "offscreen"},
                           {"PLACODE_NEW_PASSWORD", "long enough 1"},
                           {"PLACODE_PASSWORD", "long enough 1"}};
        return RunningProgram(how);
    }
    [[nodiscard]] RunningProgram start_ctl(const std::string& arguments,
                                           const std::string& name = "it") const {
        return start("placodectl", "--store sqlite:" + store + "?timeout_ms=60000 " + arguments,
                     name);
    }
    [[nodiscard]] std::string said(const std::string& name = "it") const {
        return read_text(file("said/" + name + ".out"));
    }

    /// A third of the moments lie anywhere, the others where it writes.
    [[nodiscard]] Moment moment_of(const Shot& whole) {
        if (random.next() % 3 == 0) return {.after_s = random.uniform(0, 1.1 * whole.ran_s)};
        const auto changes = static_cast<uint64_t>(std::max(whole.changes, 1));
        return {.at_change = 1 + static_cast<int>(random.next() % changes),
                .then_s = random.uniform(0, 0.003)};
    }

    /// Kills it `wanted` times, each time somewhere else. What ends before its moment is no kill.
    void kill_often(const char* name, int wanted, const Work& work) {
        Bar bar(name);
        const Shot whole = work.begin(0).until({});
        ASSERT_EQ(whole.status, 0) << read_text(file("said/it.err"));
        ASSERT_TRUE(work.is_there(0)) << "left alone it does what it is there for";
        work.again(0, true);
        int kills = 0, silent = 0, acknowledged = 0;
        for (int n = 1; kills < wanted && n < 4 * wanted + 8 && !HasFailure(); ++n) {
            const Moment moment = moment_of(whole);
            SCOPED_TRACE(testing::Message()
                         << name << ", seed " << seed << ", round " << n << ": after "
                         << moment.after_s << " s, or at change " << moment.at_change << " of "
                         << whole.changes << " and " << moment.then_s << " s");
            const Shot shot = work.begin(n).until(moment);
            EXPECT_TRUE(shot.killed || shot.status == 0) << read_text(file("said/it.err"));
            const bool acknowledges = shot.status == 0 || !said().empty();
            const bool there = work.is_there(n);
            EXPECT_TRUE(there || !acknowledges) << "acknowledged and lost: " << said();
            work.again(n, there);
            expect_sound();
            if (!shot.killed) continue;
            ++kills;
            if (there) ++(acknowledges ? acknowledged : silent);
            bar.tried(!HasFailure());
        }
        EXPECT_TRUE(HasFailure() || kills == wanted) << "it ended too soon too often";
        std::printf(
            "%s: %d kills; %d left nothing new, %d what was not yet acknowledged, %d what "
            "was\n",
            name, kills, kills - silent - acknowledged, silent, acknowledged);
    }

    void expect_sound() const { expect_sound(store); }
    void expect_sound(const std::string& path, const std::string& more = "") const {
        const Outcome check = run("placodectl", "--store sqlite:" + path + " check " + more);
        EXPECT_EQ(check.status, 0) << check.out << check.err;
    }
    [[nodiscard]] nlohmann::json asked(const std::string& path, const std::string& what) const {
        const Outcome answer = run("placodectl", "--json --store sqlite:" + path + " " + what);
        EXPECT_EQ(answer.status, 0) << answer.err;
        return nlohmann::json::parse(answer.out, nullptr, false);
    }
    [[nodiscard]] std::set<std::string> logins(const std::string& path) const {
        std::set<std::string> found;
        for (const auto& each : asked(path, "user list")) found.insert(each.at("login"));
        return found;
    }
    /// The same command once more: what was there already is refused and said.
    static void expect_done_or_known(const Outcome& outcome, bool was_there, int refused,
                                     const char* words) {
        EXPECT_EQ(outcome.status, was_there ? refused : 0) << outcome.err;
        EXPECT_EQ(outcome.err.find(words) != std::string::npos, was_there) << outcome.err;
    }
    /// Adds one, left alone.
    void add_once(const std::string& login, bool was_there, const std::string& role = "trainee") {
        const Outcome added =
            ctl("user add " + login + " --role " + role, "PLACODE_NEW_PASSWORD='long enough 1'");
        expect_done_or_known(added, was_there, 1, login.c_str());
    }
    /// A short attempt of a script, of its own for each seed.
    [[nodiscard]] std::string recording(int number) const {
        const std::string name = "r" + std::to_string(number) + ".placode";
        const Outcome recorded = run(
            "placode-sim", "--task touch_targets --headless --fast --duration 0.4 --seed " +
                               std::to_string(number) + " --device script:novice --record " + name);
        EXPECT_EQ(recorded.status, 0) << recorded.err;
        return name;
    }

    uint64_t seed = 20261127;
    sim::SplitMix64 random{0};
};

}  // namespace placode::test
