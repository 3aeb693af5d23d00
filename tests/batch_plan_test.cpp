// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl batch plan` over recordings: asked to stop it plans nothing, and what another batch
// took out of a store stays.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "batches/checksum.h"
#include "tests/stopped_program.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

class BatchPlan : public Programs {
 protected:
    /// The only attempt of a new store.
    void fill_store(const std::string& name, int seed) {
        store = file(name);
        const std::string recording = std::to_string(seed) + ".placode";
        ASSERT_EQ(run("placode-sim",
                      "--task touch_targets --headless --fast --duration 3 --device script:novice "
                      "--record " +
                          recording + " --seed " + std::to_string(seed))
                      .status,
                  0);
        add_user("anna", "trainee");
        add_user("ewa", "educator");
        const Outcome imported = ctl("--as anna import " + recording + " --user anna", kRight);
        ASSERT_EQ(imported.status, 0) << imported.err;
    }
    [[nodiscard]] Outcome plan(const std::string& more) const {
        return ctl("--as ewa batch plan rescore --from-store --task touch_targets " + more, kRight);
    }
};

TEST_F(BatchPlan, AskedToStopItPlansNothing) {
    // Checksums of 4 GB, most of it holes: seconds, if nobody stopped them.
    fs::create_directories(file("in"));
    write_text(file("in/0.placode"), "no recording");
    fs::resize_file(file("in/0.placode"), 20'000'000);
    for (int i = 1; i < 200; ++i)
        fs::create_hard_link(file("in/0.placode"), file("in/" + std::to_string(i) + ".placode"));
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome ended = stopped(
            folder, {"batch", "plan", "rescore", "--recordings", "in", "--out", "b"}, signal);
        EXPECT_EQ(ended.status, 1) << signal;
        EXPECT_THAT(ended.err, HasSubstr("batch plan: stopped")) << signal;
        EXPECT_FALSE(fs::exists(file("b/manifest.json"))) << signal;
    }
}

TEST_F(BatchPlan, LeavesTheRecordingsOfAnotherBatchAsTheyAre) {
    fill_store("one.db", 1);
    const Outcome planned = plan("--out b");
    ASSERT_EQ(planned.status, 0) << planned.err;
    const std::string place = file("b/recordings/attempt-000000001.placode");
    const std::string kept = batches::sha256_of_file(place);
    EXPECT_EQ(plan("--out b").status, 0) << "the same plan again is the same batch";
    fill_store("two.db", 2);
    const Outcome refused = plan("--out b");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("--out b: b/recordings/attempt-000000001.placode is another "
                                       "recording"));
    EXPECT_EQ(batches::sha256_of_file(place), kept);
    EXPECT_FALSE(fs::exists(place + ".part"));
    const Outcome done = ctl("batch run b --jobs 1");
    EXPECT_EQ(done.status, 0) << done.out << done.err;
    EXPECT_THAT(read_text(file("b/shards/000000.jsonl")), testing::Not(HasSubstr("problem")));
    const Outcome apart = plan("--out c");
    EXPECT_EQ(apart.status, 0) << apart.err;
}

}  // namespace THIS_TEST
}  // namespace placode::test
