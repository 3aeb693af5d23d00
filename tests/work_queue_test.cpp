// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/work_queue.h"

#include <gmock/gmock.h>

#include "tests/store_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

constexpr const char* kBuild = "1.0, avx512";
constexpr int kLeaseS = 60;

class WorkQueueTest : public testing::Test {
 protected:
    void SetUp() override {
        if (server().missing()) GTEST_SKIP() << server().problem();
        ASSERT_EQ(server().problem(), "");
        database_ = server().new_database();
        // The group of the stations comes with a store.
        (void)db::open_store(server().url(database_));
        server().make_station(database_);
        owner_ = std::make_unique<db::WorkQueue>(db::parse_store_url(server().url(database_)));
        owner_->set_up();
    }
    static PostgresqlServer& server() {
        static PostgresqlServer one;
        return one;
    }
    /// Of a station, which owns nothing.
    [[nodiscard]] std::unique_ptr<db::WorkQueue> station() const {
        return std::make_unique<db::WorkQueue>(
            db::parse_store_url(server().station_url(database_)));
    }
    void put(const std::string& seal, int shards, const std::vector<std::string>& inputs = {},
             const std::string& build = kBuild) {
        owner_->put({seal, build, "manifest of " + seal, shards}, inputs,
                    [&](const std::string& sha) {
                        ++read_;
                        return std::string("bytes\0of ", 9) + sha;
                    });
    }
    void expire_leases() const {
        RawConnection raw = server().connect(database_);
        ASSERT_TRUE(raw.run("UPDATE placode_work.shards SET until = now() WHERE state = 1"))
            << raw.problem();
    }

    std::string database_;
    std::unique_ptr<db::WorkQueue> owner_;
    int read_ = 0;
};

TEST_F(WorkQueueTest, EveryShardIsDoneByOneComputer) {
    put("a", 3, {"x", "y"});
    const auto first = station(), second = station();
    const auto one = first->take(kBuild, "one", kLeaseS),
               two = second->take(kBuild, "two", kLeaseS),
               three = first->take(kBuild, "one", kLeaseS);
    ASSERT_TRUE(one && two && three);
    EXPECT_EQ((std::set<int>{one->shard, two->shard, three->shard}), (std::set<int>{0, 1, 2}));
    EXPECT_FALSE(second->take(kBuild, "two", kLeaseS));
    EXPECT_EQ(first->batch("a").manifest, "manifest of a");
    EXPECT_EQ(first->input("y"), std::string("bytes\0of y", 10));
    EXPECT_TRUE(first->finish(*one, std::string("re\0sult", 7)));
    EXPECT_TRUE(second->renew(*two, kLeaseS));
    EXPECT_EQ(owner_->result("a", one->shard), std::string("re\0sult", 7));
    EXPECT_EQ(owner_->result("a", two->shard), "");
    const auto state = owner_->states();
    ASSERT_EQ(state.size(), 1U);
    EXPECT_EQ(state[0].done, 1);
    EXPECT_EQ(state[0].held, 2);
    EXPECT_TRUE(state[0].failed.empty());
}

TEST_F(WorkQueueTest, OnlyTheSameBuildTakesAShard) {
    put("a", 1);
    EXPECT_FALSE(station()->take("1.0, avx2", "other", kLeaseS));
    EXPECT_TRUE(station()->take(kBuild, "same", kLeaseS));
}

TEST_F(WorkQueueTest, WhoGoesSilentLosesTheShard) {
    put("a", 1);
    const auto slow = station(), other = station();
    const auto lost = slow->take(kBuild, "slow", kLeaseS);
    ASSERT_TRUE(lost);
    EXPECT_FALSE(other->take(kBuild, "other", kLeaseS));
    expire_leases();
    const auto taken = other->take(kBuild, "other", kLeaseS);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->shard, lost->shard);
    EXPECT_FALSE(slow->renew(*lost, kLeaseS)) << "it is told to stop";
    slow->give_back(*lost, "late");  // Says nothing of what it does not hold.
    EXPECT_TRUE(other->renew(*taken, kLeaseS));
    // Whoever is first is kept; both computed the same.
    EXPECT_TRUE(slow->finish(*lost, "result"));
    EXPECT_FALSE(other->finish(*taken, "result"));
    EXPECT_EQ(owner_->states()[0].done, 1);
}

TEST_F(WorkQueueTest, WhatFailsIsTriedElsewhereAndThenLeft) {
    put("a", 1);
    const auto worker = station();
    for (int i = 0; i < db::WorkQueue::kMostTries; ++i) {
        const auto lease = worker->take(kBuild, "w", kLeaseS);
        ASSERT_TRUE(lease) << i;
        worker->give_back(*lease, "task differs");
    }
    EXPECT_FALSE(worker->take(kBuild, "w", kLeaseS));
    ASSERT_EQ(owner_->states()[0].failed.size(), 1U);
    EXPECT_EQ(owner_->states()[0].failed[0], "shard 0: task differs");
    put("a", 1);  // Queued again, it is tried again.
    const auto again = worker->take(kBuild, "w", kLeaseS);
    ASSERT_TRUE(again);
    // Stopped by its person, it costs no try.
    worker->give_back(*again, "");
    for (int i = 0; i < db::WorkQueue::kMostTries; ++i) {
        EXPECT_TRUE(worker->take(kBuild, "w", kLeaseS)) << i;
        expire_leases();
    }
    EXPECT_FALSE(worker->take(kBuild, "w", kLeaseS)) << "it ends every computer's program";
    EXPECT_THAT(owner_->states()[0].failed[0], HasSubstr("went silent"));
}

TEST_F(WorkQueueTest, InputsAreKeptOnceAndGoWithTheLastBatch) {
    put("a", 1, {"x", "y"});
    put("b", 1, {"y", "z"});
    EXPECT_EQ(read_, 3) << "y was there";
    owner_->remove("a");
    EXPECT_THROW((void)owner_->input("x"), db::StoreError);
    EXPECT_EQ(owner_->input("y").size(), 10U);
    EXPECT_THROW(owner_->remove("a"), db::StoreError);
    EXPECT_EQ(owner_->states().size(), 1U);
}

TEST_F(WorkQueueTest, AStationPutsAndRemovesNothing) {
    put("a", 1, {"x"});
    const auto theirs = station();
    EXPECT_THROW(theirs->set_up(), db::StoreError);
    EXPECT_THROW(theirs->put({"b", kBuild, "m", 1}, {}, {}), db::StoreError);
    EXPECT_THROW(theirs->remove("a"), db::StoreError);
    RawConnection raw = server().connect_station(database_);
    for (const char* attack :
         {"UPDATE placode_work.batches SET manifest = ''", "DELETE FROM placode_work.shards",
          "UPDATE placode_work.inputs SET content = ''",
          "UPDATE placode_work.shards SET shard = 7"})
        EXPECT_FALSE(raw.run(attack)) << attack;
    EXPECT_EQ(owner_->states().size(), 1U);
}

TEST(WorkQueue, AStoreThatIsAFileHasNone) {
    try {
        db::WorkQueue queue(db::parse_store_url("sqlite:/tmp/x.db"));
        FAIL();
    } catch (const db::StoreError& error) {
        EXPECT_THAT(error.what(), HasSubstr("postgresql://"));
    }
}

}  // namespace THIS_TEST
}  // namespace placode::test
