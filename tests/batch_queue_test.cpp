// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl batch queue | pull | collect`: a batch that idle computers do through the centre's
// server is the same bit for bit as one that was done here, whoever is killed on the way.

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "batches/queue.h"
#include "tests/coarse_scene.h"
#include "tests/programs_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

class BatchQueue : public Programs {
 protected:
    void SetUp() override {
        if (server().missing()) GTEST_SKIP() << server().problem();
        ASSERT_EQ(server().problem(), "");
        Programs::SetUp();
        database_ = server().new_database();
        const auto store = db::open_store(server().url(database_));
        db::NewUser boss;
        boss.login = "boss";
        boss.display_name = "Boss";
        boss.password = "long enough 1";
        boss.roles = static_cast<db::Roles>(db::Role::kAdministrator) |
                     static_cast<db::Roles>(db::Role::kEducator);
        store->accounts().create(boss);
        server().make_station(database_);
    }
    void TearDown() override {
        if (!folder.empty()) Programs::TearDown();
    }
    static PostgresqlServer& server() {
        static PostgresqlServer one;
        return one;
    }
    /// The address without its password, which programs want elsewhere.
    [[nodiscard]] static std::string bare(std::string url) {
        const size_t begin = url.find(':', url.find("//")), end = url.find('@');
        return url.erase(begin, end - begin);
    }
    [[nodiscard]] std::string environment() const {
        return "PGPASSWORD=" + server().password() + " " + kRight;
    }
    [[nodiscard]] Outcome owner(const std::string& arguments) const {
        return run("placodectl",
                   "--store '" + bare(server().url(database_)) + "' --as boss " + arguments,
                   environment());
    }
    [[nodiscard]] std::string station_line() const {
        return "--store '" + bare(server().station_url(database_)) + "' ";
    }
    [[nodiscard]] Outcome station(const std::string& arguments) const {
        return run("placodectl", station_line() + arguments, environment());
    }
    void plan(const std::string& name, const std::string& seeds = "1-3") const {
        write_text(file("coarse.json"), kCoarseScene);
        const Outcome planned =
            ctl("batch plan rollouts --out " + name +
                " --tasks touch_targets --policies nothing,random --seeds " + seeds +
                " --time-limit 0.3 "
                "--scene-changes coarse.json --shard-size 1");
        ASSERT_EQ(planned.status, 0) << planned.err;
    }
    [[nodiscard]] int done() const {
        db::WorkQueue queue(db::parse_store_url(server().url(database_)));
        const auto states = queue.states();
        return states.empty() ? 0 : states[0].done;
    }

    std::string database_;
};

TEST_F(BatchQueue, IdleComputersDoItAndTheResultIsTheSame) {
    plan("here");
    ASSERT_EQ(ctl("batch run here --jobs 2").status, 0);
    ASSERT_EQ(ctl("batch merge here").status, 0);
    plan("there");
    const Outcome queued = owner("batch queue there");
    ASSERT_EQ(queued.status, 0) << queued.err;
    EXPECT_THAT(queued.out, HasSubstr("6 shards queued"));
    // One computer is killed as power would do it, at its second shard.
    const std::string line = "(cd '" + folder + "'; exec env HOME='" + folder + "' " +
                             environment() + " '" PLACODE_BIN_DIR "/placodectl' " + station_line() +
                             "batch pull > /dev/null 2>&1) & echo $! > '" + file("pid") + "'";
    ASSERT_EQ(std::system(line.c_str()), 0);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (done() < 1 && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_EQ(std::system(("kill -9 $(cat '" + file("pid") + "')").c_str()), 0);
    EXPECT_LT(done(), 6) << "it was killed too late to show anything";
    EXPECT_EQ(owner("batch collect there").status, 1) << "some are missing";
    RawConnection raw = server().connect(database_);
    ASSERT_TRUE(raw.run("UPDATE placode_work.shards SET until = now() WHERE state = 1"));
    const Outcome pulled = station("batch pull");
    EXPECT_EQ(pulled.status, 0) << pulled.out << pulled.err;
    EXPECT_THAT(station("batch queued").out, HasSubstr("6 of 6 shards done, 0 at work"));
    const Outcome collected = owner("batch collect there");
    EXPECT_EQ(collected.status, 0) << collected.out << collected.err;
    ASSERT_EQ(ctl("batch merge there").status, 0);
    EXPECT_EQ(read_text(file("there/result.jsonl")), read_text(file("here/result.jsonl")));
    EXPECT_EQ(owner("batch queue there --remove").status, 0);
    EXPECT_THAT(station("batch queued").out, HasSubstr("nothing is queued"));
}

TEST_F(BatchQueue, RecordingsAndATaskOfOnesOwnGoAlong) {
    fs::create_directories(file("recordings"));
    for (int seed = 1; seed <= 2; ++seed) {
        // By then it has touched something and lost points.
        const Outcome made = run(
            "placode-sim",
            "--task touch_targets --device script:novice --headless --fast --duration 8 --seed " +
                std::to_string(seed) + " --record recordings/" + std::to_string(seed) + ".placode");
        ASSERT_EQ(made.status, 0) << made.err;
    }
    std::string mine = read_text(PLACODE_SOURCE_DIR "/data/tasks/touch_targets.json");
    const size_t version = mine.find("\"version\": ");
    ASSERT_NE(version, std::string::npos);
    mine.insert(version + 11, "9");
    write_text(file("mine.json"), mine);
    const std::string plan =
        "batch plan rescore --recordings recordings --shard-size 1 --task "
        "mine.json --out ";
    for (const char* name : {"here", "there"}) {
        const Outcome planned = ctl(plan + name);
        ASSERT_EQ(planned.status, 0) << planned.err;
    }
    ASSERT_EQ(ctl("batch run here --jobs 1").status, 0);
    ASSERT_EQ(ctl("batch merge here").status, 0);
    ASSERT_EQ(owner("batch queue there").status, 0);
    // Nothing of it is on the computer that does it.
    fs::rename(file("recordings"), file("gone"));
    fs::rename(file("mine.json"), file("gone.json"));
    const Outcome pulled = station("--json batch pull");
    EXPECT_EQ(pulled.status, 0) << pulled.out << pulled.err;
    EXPECT_EQ(number_in(pulled.out, "done"), 2);
    EXPECT_EQ(owner("batch collect there").status, 0);
    ASSERT_EQ(ctl("batch merge there").status, 0);
    EXPECT_EQ(read_text(file("there/result.jsonl")), read_text(file("here/result.jsonl")));
}

TEST_F(BatchQueue, RolloutsOfATaskOfOnesOwnTakeTheCopyThatWentAlong) {
    write_text(file("coarse.json"), kCoarseScene);
    const std::string published = read_text(PLACODE_SOURCE_DIR "/data/tasks/touch_targets.json");
    std::string mine = published;
    const std::string settle = "\"settle_s\": 0.3";
    ASSERT_NE(mine.find(settle), std::string::npos);
    mine.replace(mine.find(settle), settle.size(), "\"settle_s\": 0.1");
    write_text(file("mine.json"), mine);
    for (const char* name : {"here", "there"}) {
        const Outcome planned =
            ctl("batch plan rollouts --tasks mine.json --policies nothing,random --seeds 1 "
                "--time-limit 0.3 --scene-changes coarse.json --shard-size 1 --out " +
                std::string(name));
        ASSERT_EQ(planned.status, 0) << planned.err;
    }
    ASSERT_EQ(ctl("batch run here --jobs 1").status, 0);
    ASSERT_EQ(ctl("batch merge here").status, 0);
    ASSERT_EQ(owner("batch queue there").status, 0);
    // Once without the file, once with another one of its name.
    fs::remove(file("mine.json"));
    const Outcome pulled = station("--json batch pull");
    EXPECT_EQ(pulled.status, 0) << pulled.out << pulled.err;
    EXPECT_EQ(number_in(pulled.out, "done"), 2);
    EXPECT_EQ(owner("batch collect there").status, 0);
    ASSERT_EQ(ctl("batch merge there").status, 0);
    EXPECT_EQ(read_text(file("there/result.jsonl")), read_text(file("here/result.jsonl")));
    ASSERT_EQ(owner("batch queue there --remove").status, 0);
    fs::remove_all(file("there/shards"));
    fs::create_directory(file("there/shards"));
    write_text(file("mine.json"), mine);
    ASSERT_EQ(owner("batch queue there").status, 0);
    write_text(file("mine.json"), published);
    EXPECT_EQ(station("batch pull").status, 0);
    EXPECT_EQ(owner("batch collect there").status, 0);
    ASSERT_EQ(ctl("batch merge there").status, 0);
    EXPECT_EQ(read_text(file("there/result.jsonl")), read_text(file("here/result.jsonl")));
}

TEST_F(BatchQueue, AComputerWithoutRoomCostsNoShardATry) {
    plan("a");
    ASSERT_EQ(owner("batch queue a").status, 0);
    const batches::Manifest manifest = batches::read_manifest(file("a"));
    db::WorkQueue queue(db::parse_store_url(server().station_url(database_)));
    batches::PullOrder order;
    order.build = manifest.build;
    order.worker = "one without room";
    order.folder = file("full");
    // The manifest cannot be written where a folder is; a full disk says the same.
    fs::create_directories(order.folder / manifest.seal.substr(0, 16) / "manifest.json" / "x");
    for (int i = 0; i <= db::WorkQueue::kMostTries; ++i) {
        const batches::PullOutcome outcome = batches::pull_shards(queue, order);
        EXPECT_TRUE(outcome.stopped);
        EXPECT_EQ(outcome.done, 0);
        ASSERT_EQ(outcome.failed.size(), 1U);
        EXPECT_THAT(outcome.failed[0], HasSubstr("shard 0: "));
        EXPECT_THAT(outcome.failed[0], HasSubstr("cannot be written"));
    }
    EXPECT_TRUE(queue.states()[0].failed.empty());
    EXPECT_EQ(queue.states()[0].held, 0);
    order.folder = file("room");
    EXPECT_EQ(batches::pull_shards(queue, order).done, 6);
}

TEST_F(BatchQueue, AfterABatchThatIsDamagedTheOneBeforeItGoesOn) {
    plan("a");
    plan("b", "4-6");
    ASSERT_EQ(owner("batch queue a").status, 0);
    ASSERT_EQ(owner("batch queue b").status, 0);
    const batches::Manifest first = batches::read_manifest(file("a"));
    const std::string first_is = " WHERE seal = '" + first.seal + "'",
                      second_is = " WHERE seal <> '" + first.seal + "'";
    RawConnection raw = server().connect(database_);
    ASSERT_TRUE(raw.run("UPDATE placode_work.batches SET manifest = '{}'" + second_is));
    // The last shard of the first is held, until one of the second has failed.
    ASSERT_TRUE(
        raw.run("UPDATE placode_work.shards SET state = 1, until = now() + INTERVAL '1 "
                "hour'" +
                first_is + " AND shard = 5"));
    db::WorkQueue queue(db::parse_store_url(server().station_url(database_)));
    batches::PullOrder order;
    order.build = first.build;
    order.worker = "one";
    order.folder = file("room");
    order.go_on = [&] {
        const std::string failed = raw.value("SELECT COUNT(*) FROM placode_work.shards" +
                                             second_is + " AND problem <> ''");
        if (failed != "0") {
            EXPECT_TRUE(
                raw.run("UPDATE placode_work.shards SET state = 0" + first_is + " AND token = 0"));
        }
        return true;
    };
    const batches::PullOutcome outcome = batches::pull_shards(queue, order);
    EXPECT_EQ(outcome.done, 6);
    EXPECT_FALSE(outcome.stopped);
    EXPECT_TRUE(queue.states()[0].failed.empty());
    EXPECT_EQ(queue.states()[1].failed.size(), 6U);
}

TEST_F(BatchQueue, RefusesWhatCannotBeDoneElsewhereAndWhoMayNot) {
    plan("a");
    const Outcome file_store = ctl("batch queue a");
    EXPECT_EQ(file_store.status, 2);
    EXPECT_THAT(file_store.err, HasSubstr("postgresql://"));
    // A station has no account that may, and no right to add a batch.
    EXPECT_NE(station("batch queue a").status, 0);
    ASSERT_EQ(ctl("batch plan rollouts --out b --tasks touch_targets --policies nothing --seeds 1 "
                  "--time-limit 0.3 --record")
                  .status,
              0);
    const Outcome kept = owner("batch queue b");
    EXPECT_EQ(kept.status, 2);
    EXPECT_THAT(kept.err, HasSubstr("--record"));
    EXPECT_EQ(station("batch pull --lease 1").status, 2);
}

}  // namespace THIS_TEST
}  // namespace placode::test
