// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl batch`: shards that are done once, whatever is killed, and one result from them.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>

#include <chrono>
#include <thread>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "batches/manifest.h"
#include "batches/merge.h"
#include "batches/shard.h"
#include "tests/batch_folder.h"
#include "tests/programs_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

class BatchPrograms : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        write_text(file("coarse.json"), kCoarseScene);
    }

    /// Eight attempts of 0.3 s in eight shards.
    [[nodiscard]] Outcome plan(const std::string& name, const std::string& more = "") const {
        return ctl("batch plan rollouts --out " + name +
                   " --tasks touch_targets --policies nothing,random --seeds 1-4 --time-limit 0.3 "
                   "--scene-changes coarse.json --shard-size 1 --record " +
                   more);
    }
    [[nodiscard]] Outcome batch(const std::string& arguments) const {
        return ctl("batch " + arguments);
    }
    /// A batch that is done and merged; its result.
    [[nodiscard]] std::string whole(const std::string& name) const {
        EXPECT_EQ(plan(name).status, 0);
        const Outcome run = batch("run " + name + " --jobs 2");
        EXPECT_EQ(run.status, 0) << run.out << run.err;
        EXPECT_EQ(batch("merge " + name).status, 0);
        return read_text(file(name + "/result.jsonl"));
    }
    [[nodiscard]] int shards_done(const std::string& name) const {
        return static_cast<int>(shards_in(file(name)).size());
    }
    /// Starts the runner and kills it, as power would, once so many shards are there.
    void run_until(const std::string& name, int shards) const {
        const pid_t runner = ::fork();
        if (runner == 0) {
            if (::chdir(folder.c_str()) != 0) ::_exit(126);
            const int nothing = ::open("/dev/null", O_RDWR);
            for (int i = 0; i < 3; ++i) ::dup2(nothing, i);
            ::execl(PLACODE_BIN_DIR "/placodectl", "placodectl", "batch", "run", name.c_str(),
                    "--jobs", "2", nullptr);
            ::_exit(127);
        }
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (shards_done(name) < shards && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ::kill(runner, SIGKILL);
        ::waitpid(runner, nullptr, 0);
    }
};

TEST_F(BatchPrograms, KilledTwiceItGoesOnAndTheResultIsTheSameBitForBit) {
    const std::string reference = whole("a");
    EXPECT_THAT(reference, HasSubstr("\"final_hash\":\"0x"));
    ASSERT_EQ(plan("b").status, 0);
    run_until("b", 1);
    const int first = shards_done("b");
    EXPECT_GE(first, 1);
    EXPECT_LT(first, 8) << "it was killed too late to show anything";
    // Workers run side by side: which shard is done first is theirs to say.
    std::string done;
    for (const auto& entry : fs::directory_iterator(file("b/shards")))
        if (entry.path().extension() == ".jsonl") done = entry.path();
    ASSERT_NE(done, "");
    const auto written = fs::last_write_time(done);
    run_until("b", first + 1);
    const Outcome status = batch("--json status b");
    EXPECT_GE(number_in(status.out, "done"), first + 1);
    EXPECT_EQ(number_in(status.out, "shards"), 8);
    const Outcome early = batch("merge b");
    EXPECT_EQ(early.status, 1);
    EXPECT_THAT(early.err, HasSubstr("not done yet: shards"));
    EXPECT_FALSE(fs::exists(file("b/result.jsonl")));
    const Outcome rest = batch("run b --jobs 1");
    EXPECT_EQ(rest.status, 0) << rest.out << rest.err;
    EXPECT_THAT(rest.out, HasSubstr("8 of 8 shards done, "));
    EXPECT_EQ(batch("merge b").status, 0);
    EXPECT_EQ(read_text(file("b/result.jsonl")), reference);
    EXPECT_EQ(fs::last_write_time(done), written) << "a shard that was done was done again";
}

TEST_F(BatchPrograms, WhatShardsTookForecastsALargerBatch) {
    ASSERT_EQ(plan("small").status, 0);
    const Outcome early = batch("forecast small");
    EXPECT_EQ(early.status, 2);
    EXPECT_THAT(early.err, HasSubstr("no shard was done and timed here yet"));
    ASSERT_EQ(batch("run small --jobs 1").status, 0);
    const Outcome found = ctl("--json batch forecast small --items 800 --workers 1,4");
    ASSERT_EQ(found.status, 0) << found.err;
    const auto json = nlohmann::json::parse(found.out);
    EXPECT_EQ(json["measured_shards"], 8);
    EXPECT_EQ(json["check"]["workers"], 1);
    const double one = json["workers"][0]["mean_s"], four = json["workers"][1]["mean_s"];
    EXPECT_NEAR(one / four, 4, 0.2);
    // One worker does shard after shard: what they took and nothing else but the runner's polling.
    const double measured = json["check"]["measured_s"], forecast = json["check"]["forecast_s"];
    EXPECT_LE(forecast, measured * 1.05);
    EXPECT_GE(forecast, measured * 0.5);
    EXPECT_EQ(batch("forecast small --items 0").status, 2);
    EXPECT_EQ(batch("forecast small --lost 95").status, 2);
    // The result knows nothing of it.
    EXPECT_EQ(batch("merge small").status, 0);
    EXPECT_EQ(read_text(file("small/result.jsonl")).find("wall_s"), std::string::npos);
}

TEST_F(BatchPrograms, NormsComeOutOfRollouts) {
    const std::string plan =
        "plan rollouts --out n --tasks touch_targets --policies expert,novice --seeds 1-2 "
        "--time-limit 10 --scene-changes coarse.json --shard-size 2";
    ASSERT_EQ(batch(plan).status, 0);
    const Outcome without = ctl("norms quality touch_targets --batch n");
    EXPECT_EQ(without.status, 2);
    EXPECT_THAT(without.err, HasSubstr("has no metrics of rollouts"));
    fs::remove_all(file("n"));
    ASSERT_EQ(batch(plan + " --metrics").status, 0);
    EXPECT_EQ(ctl("norms quality touch_targets --batch n").status, 1) << "nothing is done yet";
    ASSERT_EQ(batch("run n --jobs 1").status, 0);
    const Outcome found = ctl("--json norms quality touch_targets --batch n");
    ASSERT_EQ(found.status, 0) << found.err;
    const auto of_batch = nlohmann::json::parse(found.out);
    EXPECT_EQ(of_batch["score"]["experts"].get<int>() + of_batch["score"]["novices"].get<int>() +
                  of_batch["score"]["not_attempted"].get<int>(),
              4);
    // The same points stand in the result, a seed a person.
    ASSERT_EQ(batch("merge n").status, 0);
    std::istringstream lines(read_text(file("n/result.jsonl")));
    std::map<std::string, std::vector<double>> points;
    for (std::string line; std::getline(lines, line);) {
        const auto json = nlohmann::json::parse(line);
        if (!json.contains("policy") || json["verdict"] == "not attempted") continue;
        points[json["policy"]].push_back(json["points"]);
    }
    ASSERT_EQ(points["expert"].size(), 2U);
    EXPECT_NEAR(of_batch["score"]["expert_median"].get<double>(),
                (points["expert"][0] + points["expert"][1]) / 2, 1e-9);
    EXPECT_EQ(of_batch["score"]["novices"], points["novice"].size());
    EXPECT_GT(of_batch["metrics"].size(), 10U);
}

TEST_F(BatchPrograms, ADamagedShardIsFoundAndDoneAgain) {
    const std::string reference = whole("a");
    const std::string path = file("a/shards/000003.jsonl");
    std::string text = read_text(path);
    const size_t digit = text.rfind("\"points\":") + 9;
    text[digit] = text[digit] == '7' ? '8' : '7';
    write_text(path, text);
    EXPECT_THAT(batch("status a").out, HasSubstr("000003.jsonl: its checksum does not fit"));
    const Outcome merge = batch("merge a");
    EXPECT_EQ(merge.status, 1);
    EXPECT_THAT(merge.err, HasSubstr("000003.jsonl: its checksum does not fit"));
    EXPECT_THAT(batch("run a").out, HasSubstr("8 of 8 shards done, 7 of them before"));
    EXPECT_EQ(batch("merge a").status, 0);
    EXPECT_EQ(read_text(file("a/result.jsonl")), reference);
    // Cut off in the middle of a line, as a full disk would.
    fs::resize_file(path, fs::file_size(path) / 2);
    EXPECT_EQ(batch("merge a").status, 1);
}

TEST_F(BatchPrograms, AChangedManifestIsRefused) {
    ASSERT_EQ(plan("a").status, 0);
    const std::string path = file("a/manifest.json");
    const std::string before = read_text(path);
    std::string text = before;
    text.replace(text.find("\"seed\":4"), 8, "\"seed\":9");
    write_text(path, text);
    for (const char* order : {"run a", "work a --shard 0", "status a", "merge a"}) {
        const Outcome refused = batch(order);
        EXPECT_EQ(refused.status, 2) << order;
        EXPECT_THAT(refused.err, HasSubstr("manifest.json: was changed")) << order;
    }
    write_text(path, before);
    EXPECT_EQ(batch("work a --shard 0").status, 0);
    // The same plan again changes nothing; another one does not take its place.
    EXPECT_EQ(plan("a").status, 0);
    const Outcome other = plan("a", "--frames-per-step 10");
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, HasSubstr("another batch is there"));
    EXPECT_EQ(read_text(path), before);
    // A shard of another batch is nobody's to write over.
    ASSERT_EQ(plan("b", "--frames-per-step 10").status, 0);
    fs::copy_file(file("b/manifest.json"), path, fs::copy_options::overwrite_existing);
    const Outcome strange = batch("run a");
    EXPECT_EQ(strange.status, 2);
    EXPECT_THAT(strange.err, HasSubstr("is of another batch"));
}

TEST_F(BatchPrograms, RecordingsAreScoredAndSimulatedAgain) {
    (void)whole("a");
    ASSERT_EQ(batch("plan rescore --out s --recordings a/recordings --shard-size 3").status, 0);
    ASSERT_EQ(batch("run s").status, 0);
    const Outcome scored = batch("--json merge s");
    EXPECT_EQ(number_in(scored.out, "items"), 8);
    EXPECT_EQ(number_in(scored.out, "problems"), 0);
    EXPECT_THAT(read_text(file("s/result.jsonl")),
                HasSubstr("{\"item\":0,\"recording\":\"touch_targets-nothing-1.placode\""));
    const std::string plan = "plan replay --recordings a/recordings --shard-size 3 --threads ";
    for (const char* threads : {"1", "2"}) {
        const std::string name = std::string("r") + threads;
        ASSERT_EQ(batch(plan + threads + " --out " + name).status, 0);
        EXPECT_EQ(batch("run " + name).status, 0);
        const Outcome merged = batch("--json merge " + name);
        EXPECT_EQ(number_in(merged.out, "identical"), 8) << merged.out << merged.err;
        EXPECT_EQ(number_in(merged.out, "differ"), 0);
    }
    // The scene was made coarser, so that it is not the published task.
    EXPECT_THAT(read_text(file("r1/result.jsonl")), HasSubstr("\"task_is_published\":false"));
    // A file that is not the planned one any more.
    write_text(file("a/recordings/touch_targets-random-4.placode"), "something else");
    ASSERT_EQ(fs::remove(file("s/shards/000002.jsonl")), true);
    const Outcome changed = batch("run s");
    EXPECT_EQ(changed.status, 1);
    EXPECT_THAT(changed.out, HasSubstr("touch_targets-random-4.placode: is not the file that"));
}

TEST_F(BatchPrograms, ADamagedRecordingIsAResultAndStopsNobody) {
    (void)whole("a");
    fs::resize_file(file("a/recordings/touch_targets-nothing-2.placode"), 4000);
    for (const char* kind : {"rescore", "replay"}) {
        ASSERT_EQ(
            batch(std::string("plan ") + kind + " --recordings a/recordings --out " + kind).status,
            0);
        const Outcome run = batch(std::string("run ") + kind);
        EXPECT_EQ(run.status, 0) << run.out;
        EXPECT_EQ(number_in(batch(std::string("--json merge ") + kind).out, "problems"), 1);
    }
}

TEST_F(BatchPrograms, AShardHasOneWorkerAndOneBuild) {
    ASSERT_EQ(plan("a").status, 0);
    const int held = ::open(file("a/shards/000001.jsonl.part").c_str(), O_RDWR | O_CREAT, 0666);
    ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
    const Outcome busy = batch("work a --shard 1");
    EXPECT_EQ(busy.status, 1);
    EXPECT_THAT(busy.err, HasSubstr("shard 1: another process is at it"));
    // Without a number it does all the others.
    EXPECT_THAT(batch("work a").out, HasSubstr("7 shards done here"));
    ::close(held);
    EXPECT_THAT(batch("work a").out, HasSubstr("1 shard done here"));
    EXPECT_THAT(batch("work a --shard 1").out, HasSubstr("had been done before"));
    const auto manifest = batches::read_manifest(file("a"));
    fs::remove(file("a/shards/000001.jsonl"));
    try {
        (void)batches::do_shard(file("a"), manifest, 1, "another build", {}, {});
        ADD_FAILURE() << "another build was let in";
    } catch (const batches::BatchError& error) {
        EXPECT_THAT(error.what(), HasSubstr("planned with " + manifest.build));
    }
    EXPECT_EQ(batches::batch_status(file("a"), manifest).missing, std::vector<int>{1});
}

TEST_F(BatchPrograms, BadOrdersAreNamed) {
    const std::pair<const char*, const char*> orders[] = {
        {"status nowhere", "nowhere: holds no manifest.json"},
        {"plan rollouts --out x --tasks touch_targets --policies nothing --seeds 3-1", "\"3-1\""},
        {"plan rollouts --out x --tasks touch_targets --policies clever --seeds 1", "\"clever\""},
        {"plan rollouts --out x --tasks touch_target --policies nothing --seeds 1", "touch_target"},
        {"plan rollouts --out x --seeds 1", "expected --tasks, --policies and --seeds"},
        {"plan rescore --out x --recordings nowhere", "nowhere: is no folder"},
        {"plan rescore --out x --recordings . --seeds 1", "option of another kind"},
        {"plan rescore --out x", "expected one of --recordings FOLDER and --from-store"},
    };
    for (const auto& [order, words] : orders) {
        const Outcome refused = batch(order);
        EXPECT_EQ(refused.status, 2) << order;
        EXPECT_THAT(refused.err, HasSubstr(words)) << order;
        EXPECT_FALSE(fs::exists(file("x/manifest.json"))) << order;
    }
    ASSERT_EQ(plan("a").status, 0);
    const Outcome shard = batch("work a --shard 8");
    EXPECT_EQ(shard.status, 2);
    EXPECT_THAT(shard.err, HasSubstr("expected 0 to 7"));
}

TEST_F(BatchPrograms, TheScriptsDoTheShards) {
    const std::string reference = whole("a");
    ASSERT_EQ(plan("p").status, 0);
    write_text(file("slurm.sh"), batch("script p --runner slurm --jobs 2").out);
    EXPECT_THAT(read_text(file("slurm.sh")), HasSubstr("#SBATCH --array=0-7%2\n"));
    // As Slurm starts it for one number of the array.
    EXPECT_EQ(shell("env SLURM_ARRAY_TASK_ID=5 bash slurm.sh").status, 0);
    EXPECT_TRUE(fs::exists(file("p/shards/000005.jsonl")));
    EXPECT_EQ(shards_done("p"), 1);
    // Again, it asks for what is left.
    EXPECT_THAT(batch("script p --runner slurm").out, HasSubstr("#SBATCH --array=0-4,6-7\n"));
    const Outcome done = batch("script a --runner slurm");
    EXPECT_EQ(done.status, 2);
    EXPECT_THAT(done.err, HasSubstr("every shard is done"));
    write_text(file("parallel.sh"), batch("script p --runner parallel --jobs 2").out);
    EXPECT_EQ(shell("bash -n parallel.sh").status, 0);
    if (shell("sh -c 'parallel --version | grep -q GNU'").status != 0)
        GTEST_SKIP() << "GNU parallel is not installed: its script was only read";
    EXPECT_EQ(shell("bash parallel.sh").status, 0);
    EXPECT_EQ(batch("merge p").status, 0);
    EXPECT_EQ(read_text(file("p/result.jsonl")), reference);
}

TEST(BatchParts, RangesAreSaidShortly) {
    EXPECT_EQ(batches::ranges_text({}), "");
    EXPECT_EQ(batches::ranges_text({4}), "4");
    EXPECT_EQ(batches::ranges_text({0, 1, 2, 5, 7, 8}), "0 to 2, 5 and 7 to 8");
}

TEST(BatchParts, TheChecksumIsThatOfSha256sum) {
    EXPECT_EQ(batches::sha256("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace THIS_TEST
}  // namespace placode::test
