// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl batch keep`: what a batch found goes into the store as rescoring would have put it
// there, or not at all.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "batches/checksum.h"
#include "tests/programs_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

World* const world = World::install();

constexpr int kAttempts = 3;

class BatchKeep : public Programs {
 protected:
    void SetUp() override {
        ASSERT_NE(world, nullptr);
        Programs::SetUp();
        add_user("anna", "trainee");
        add_user("ewa", "educator");
        for (int seed = 1; seed <= kAttempts; ++seed) {
            const std::string name = std::to_string(seed) + ".placode";
            ASSERT_EQ(run("placode-sim",
                          "--task touch_targets --headless --fast --duration 3 --device "
                          "script:novice --record " +
                              name + " --seed " + std::to_string(seed))
                          .status,
                      0);
            ASSERT_EQ(as("anna", "import " + name + " --user anna").status, 0);
        }
        // A stricter rubric, and a pass mark of the centre.
        Json task = Json::parse(read_text(PLACODE_SOURCE_DIR "/data/tasks/touch_targets.json"));
        task["rubric"]["version"] = 99;
        task["rubric"]["items"][0]["max_points"] = 1;
        write_text(file("strict.json"), task.dump());
    }

    [[nodiscard]] Outcome as(const std::string& who, const std::string& arguments) const {
        return ctl("--as " + who + " " + arguments, kRight);
    }
    /// A batch over the store's attempts, done.
    void batch(const std::string& name) const {
        const Outcome planned =
            as("ewa",
               "batch plan rescore --from-store --shard-size 1 --task strict.json --out " + name);
        ASSERT_EQ(planned.status, 0) << planned.err;
        const Outcome done = ctl("batch run " + name + " --jobs 1");
        ASSERT_EQ(done.status, 0) << done.err;
    }
    /// The further scores of an attempt, without the time and the row's number.
    [[nodiscard]] std::vector<db::RescoreRecord> further(const std::string& path,
                                                         int64_t attempt) const {
        db::StoreOptions options;
        options.cheap_passwords = true;
        const auto opened = db::open_store("sqlite:" + path, options);
        return opened->attempts().rescores(attempt);
    }
    /// Another score in a shard, with the checksum that belongs to it: what a helper that lies
    /// would send.
    void falsify(const std::string& batch, int shard) const {
        const std::string path = file(batch + "/shards/00000" + std::to_string(shard) + ".jsonl");
        const std::string text = read_text(path);
        const size_t end = text.find('\n');
        Json head = Json::parse(text.substr(0, end));
        Json line = Json::parse(text.substr(end + 1));
        line["points"] = line["points"].get<double>() + 1;
        const std::string lines = line.dump() + "\n";
        head["sha256"] = batches::sha256(lines);
        write_text(path, head.dump() + "\n" + lines);
    }
};

TEST_F(BatchKeep, KeepsWhatRescoringWouldHaveSaved) {
    fs::copy_file(store, file("twin.db"));
    batch("b");
    const Outcome dry = as("ewa", "--json batch keep b --dry-run");
    ASSERT_EQ(dry.status, 0) << dry.err;
    EXPECT_EQ(number_in(dry.out, "scored"), kAttempts);
    EXPECT_TRUE(further(store, 1).empty()) << "a dry run saves nothing";
    const Outcome kept = as("ewa", "--json batch keep b");
    ASSERT_EQ(kept.status, 0) << kept.err;
    EXPECT_EQ(number_in(kept.out, "scored"), kAttempts);
    const Outcome here =
        run("placodectl",
            "--store sqlite:" + file("twin.db") + " --as ewa rescore --task strict.json", kRight);
    ASSERT_EQ(here.status, 0) << here.err;
    for (int64_t attempt = 1; attempt <= kAttempts; ++attempt) {
        const auto ours = further(store, attempt), theirs = further(file("twin.db"), attempt);
        ASSERT_EQ(ours.size(), 1U);
        ASSERT_EQ(theirs.size(), 1U);
        EXPECT_EQ(ours[0].score.points, theirs[0].score.points);
        EXPECT_EQ(ours[0].score.verdict, theirs[0].score.verdict);
        EXPECT_EQ(ours[0].score.rubric_version, 99);
        ASSERT_EQ(ours[0].metrics.values.size(), theirs[0].metrics.values.size());
        ASSERT_GT(ours[0].metrics.values.size(), 10U);
        for (size_t i = 0; i < ours[0].metrics.values.size(); ++i) {
            EXPECT_EQ(ours[0].metrics.values[i].id, theirs[0].metrics.values[i].id);
            EXPECT_EQ(ours[0].metrics.values[i].value, theirs[0].metrics.values[i].value);
        }
        ASSERT_EQ(ours[0].score.reasons.size(), theirs[0].score.reasons.size());
        for (size_t i = 0; i < ours[0].score.reasons.size(); ++i) {
            EXPECT_EQ(ours[0].score.reasons[i].text, theirs[0].score.reasons[i].text);
            EXPECT_EQ(ours[0].score.reasons[i].meaning, theirs[0].score.reasons[i].meaning);
        }
    }
    EXPECT_EQ(number_in(as("ewa", "--json batch keep b").out, "scored"), 0) << "once is enough";
    EXPECT_THAT(ctl("check").out, HasSubstr("sound"));
}

TEST_F(BatchKeep, OneFalsifiedScoreInTheSampleKeepsAllOut) {
    batch("b");
    falsify("b", 1);
    const Outcome kept = as("ewa", "batch keep b --check 3");
    EXPECT_EQ(kept.status, 2);
    EXPECT_THAT(kept.err, HasSubstr("attempt 2: the batch says"));
    EXPECT_THAT(kept.err, HasSubstr("nothing of the batch was kept"));
    for (int64_t attempt = 1; attempt <= kAttempts; ++attempt)
        EXPECT_TRUE(further(store, attempt).empty());
}

TEST_F(BatchKeep, RefusesWhatIsNotOfThisStoreOrNotWhole) {
    batch("b");
    EXPECT_EQ(as("anna", "batch keep b").status, 1) << "a trainee";
    fs::remove(file("b/shards/000002.jsonl"));
    const Outcome half = as("ewa", "batch keep b");
    EXPECT_EQ(half.status, 1);
    EXPECT_THAT(half.err, HasSubstr("not done yet: shards 2"));
    ASSERT_EQ(ctl("batch run b --jobs 1").status, 0);
    // The same numbers in another store are other attempts.
    store = file("other.db");
    add_user("ewa", "educator");
    add_user("anna", "trainee");
    for (const char* name : {"3.placode", "2.placode", "1.placode"})
        ASSERT_EQ(as("anna", std::string("import ") + name + " --user anna").status, 0);
    const Outcome mixed = as("ewa", "batch keep b");
    EXPECT_EQ(mixed.status, 2);
    EXPECT_THAT(mixed.err, HasSubstr("another recording than the store keeps"));
    // Recordings out of a folder are nobody's attempts.
    fs::create_directories(file("r"));
    fs::rename(file("1.placode"), file("r/1.placode"));
    ASSERT_EQ(ctl("batch plan rescore --recordings r --out c --task touch_targets").status, 0);
    ASSERT_EQ(ctl("batch run c --jobs 1").status, 0);
    const Outcome nobodys = as("ewa", "batch keep c");
    EXPECT_EQ(nobodys.status, 2);
    EXPECT_THAT(nobodys.err, HasSubstr("its scores are of no store"));
}

}  // namespace THIS_TEST
}  // namespace placode::test
