// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch through a Slurm of the test's own, one node on loopback, that loses power twice.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "tests/batch_folder.h"
#include "tests/programs_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

class BatchSlurm : public Programs {
 protected:
    void TearDown() override {
        power_off();
        Programs::TearDown();
    }
    [[nodiscard]] Outcome slurm(const std::string& what) const {
        return shell("'" PLACODE_SOURCE_DIR "/scripts/loopback_slurm.sh' " + what + " slurm");
    }
    void power_off() const {
        if (!fs::exists(file("slurm"))) return;
        EXPECT_EQ(slurm("stop").status, 0);
    }
    [[nodiscard]] std::set<std::string> done() const { return shards_in(file("b")); }
    /// Starts Slurm, submits what is missing, waits for so many shards, and turns the power off.
    void work_until(size_t shards) const {
        const Outcome started = slurm("start");
        ASSERT_EQ(started.status, 0) << started.err;
        write_text(file("slurm.sh"), ctl("batch script b --runner slurm").out);
        const Outcome sent = shell("sbatch slurm.sh", "SLURM_CONF=" + file("slurm/slurm.conf"));
        ASSERT_EQ(sent.status, 0) << sent.out << sent.err;
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(8);
        while (done().size() < shards && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        power_off();
    }
    void plan(const std::string& name) const {
        const Outcome planned =
            ctl("batch plan rescore --recordings a/recordings --shard-size 1 --out " + name);
        ASSERT_EQ(planned.status, 0) << planned.err;
    }
};

TEST_F(BatchSlurm, WithoutPowerTwiceItEndsWithTheSameBits) {
    if (shell("env PATH=\"$PATH:/usr/sbin\" sh -c 'command -v slurmctld'").status != 0)
        GTEST_SKIP() << "Slurm is not installed";
    const size_t all = std::getenv("PLACODE_LONG_TESTS") != nullptr ? 200 : 12;
    write_text(file("coarse.json"), kCoarseScene);
    ASSERT_EQ(ctl("batch plan rollouts --out a --tasks touch_targets --policies random --seeds 1-" +
                  std::to_string(all) + " --time-limit 0.3 --scene-changes coarse.json --record")
                  .status,
              0);
    const Outcome recorded = ctl("batch run a --jobs 2");
    ASSERT_EQ(recorded.status, 0) << recorded.err;
    plan("whole");
    ASSERT_EQ(ctl("batch run whole --jobs 2").status, 0);
    ASSERT_EQ(ctl("batch merge whole").status, 0);

    plan("b");
    work_until(all / 6);
    const auto first = done();
    EXPECT_GE(first.size(), all / 6);
    ASSERT_LT(first.size(), all) << "the power went too late to show anything";
    const auto written = fs::last_write_time(file("b/shards/" + *first.begin()));
    work_until(all / 2);
    const auto second = done();
    EXPECT_GE(second.size(), all / 2);
    ASSERT_LT(second.size(), all) << "the power went too late to show anything";
    EXPECT_THAT(ctl("batch merge b").err, HasSubstr("not done yet: shards"));
    work_until(all);
    EXPECT_EQ(done().size(), all);

    EXPECT_EQ(ctl("batch merge b").status, 0);
    EXPECT_EQ(read_text(file("b/result.jsonl")), read_text(file("whole/result.jsonl")));
    EXPECT_EQ(fs::last_write_time(file("b/shards/" + *first.begin())), written)
        << "a shard that was done was done again";
    RecordProperty("shards", static_cast<int>(all));
    RecordProperty("done_at_first_kill", static_cast<int>(first.size()));
    RecordProperty("done_at_second_kill", static_cast<int>(second.size()));
}

}  // namespace THIS_TEST
}  // namespace placode::test
