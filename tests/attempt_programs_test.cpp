// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode-sim and recordings on the command line: recorded, killed, damaged, imported.

#include <gmock/gmock.h>
#include <signal.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "curriculum/shipped_definitions.h"
#include "db/recording_file.h"
#include "db/store.h"
#include "tests/leaky_slit.h"
#include "tests/programs_fixture.h"
#include "tests/recorded_attempt.h"

using namespace placode;
using namespace placode::test;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

namespace THIS_TEST {

test::World* const world = test::World::install();

void write_recording(const std::string& path) {
    const auto sink = db::create_recording_file(path);
    sim::RecordingHeader header;
    header.task_id = "diathermy_ring";
    header.task_json = "{}";
    header.tools.emplace_back();
    sink->begin(header);
    for (int half = 0; half < 4; ++half) {
        std::vector<sim::Input> inputs(500);
        std::vector<sim::Sample> samples(50);
        for (size_t i = 0; i < inputs.size(); ++i)
            inputs[i].frame = half * 500 + static_cast<int64_t>(i);
        for (size_t i = 0; i < samples.size(); ++i) {
            samples[i].time_s = half * 0.5 + 0.01 * static_cast<double>(i + 1);
            samples[i].tools[0].tip_m[0] = static_cast<float>(0.001 * samples[i].time_s);
        }
        sink->append(inputs, samples, {});
    }
    sink->finish({sim::EndReason::kFinished, 2.0, 1, 0});
}

void damage_chunk(const std::string& path, int chunk) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    const std::string sql = "UPDATE chunks SET checksum = 'x' WHERE id = " + std::to_string(chunk);
    ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
}

TEST_F(Programs, ADamagedRecordingNamesTheChunkAndCanBeRecovered) {
    const std::string path = file("a.placode");
    write_recording(path);
    EXPECT_EQ(ctl("metrics " + path).status, 0);
    damage_chunk(path, 5);
    const Outcome damaged = ctl("metrics " + path);
    EXPECT_EQ(damaged.status, 2);
    EXPECT_THAT(damaged.err, AllOf(HasSubstr(path), HasSubstr("chunk 5"), HasSubstr("1.00 s"),
                                   HasSubstr("--recover")));
    const Outcome recovered = ctl("--json metrics --recover " + path);
    EXPECT_EQ(recovered.status, 0) << recovered.err;
    EXPECT_THAT(recovered.out, AllOf(HasSubstr("\"interrupted\""), HasSubstr("chunk 5")));
    write_text(path, read_text(path).substr(0, 6000));
    EXPECT_EQ(ctl("score " + path).status, 2);
    EXPECT_EQ(ctl("metrics " + file("missing.placode")).status, 2);
    EXPECT_FALSE(fs::exists(store)) << "metrics need no store";
}

TEST_F(Programs, WhatASlitLeaksIsPrintedAndWrittenStationByStation) {
    const std::string path = file("slit.placode"), csv = file("leaks.csv");
    sim::Recording made = leaky_slit();
    made.header.task_id = "suture_slit";
    made.header.task_json = "{}";
    made.header.tools.emplace_back();
    {
        const auto sink = db::create_recording_file(path);
        sink->begin(made.header);
        sink->append({}, {}, made.events);
        sink->finish({sim::EndReason::kFinished, 30, 1, 0});
    }
    const Outcome done = ctl("--json metrics --leaks " + csv + " " + path);
    ASSERT_EQ(done.status, 0) << done.err;
    const auto json = nlohmann::json::parse(done.out);
    ASSERT_EQ(json["leaks"].size(), 23U);
    double sum = 0;
    for (const auto& station : json["leaks"]) sum += station["leak_12_ml_min"].get<double>();
    EXPECT_NEAR(sum, json["metrics"]["slit_leak_12_ml_min"].get<double>(), 1e-4);
    EXPECT_TRUE(json["leaks"][11]["opened_cmh2o"].is_null()) << "it stayed shut";
    const std::string text = read_text(csv);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 24);
    EXPECT_THAT(text, testing::StartsWith("station,along_mm,"));
    EXPECT_THAT(ctl("metrics " + path).out, HasSubstr("leak_12_ml_min"));
    // Neither a signal nor another task has such a table.
    write_recording(file("a.placode"));
    const Outcome none = ctl("metrics --leaks " + csv + " " + file("a.placode"));
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("does not say what leaks where"));
    EXPECT_EQ(read_text(csv), text) << "nothing was written over it";
    write_text(file("s.csv"), "t_s,T_C\n0,45\n1,45\n");
    EXPECT_EQ(ctl("metrics --leaks " + csv + " " + file("s.csv")).status, 2);
}

TEST_F(Programs, ATaskWithAWrongUnitNamesFileAndPlace) {
    const std::string path = file("a.placode");
    write_recording(path);
    std::string task = read_text(PLACODE_SOURCE_DIR "/data/tasks/diathermy_ring.json");
    ASSERT_NE(task.find("\"time_limit_s\""), std::string::npos);
    task.replace(task.find("\"time_limit_s\""), 14, "\"time_limit_min\"");
    write_text(file("task.json"), task);
    const Outcome wrong = ctl("score " + path + " --task " + file("task.json"));
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err,
                AllOf(HasSubstr("task.json"), HasSubstr("time_limit_min"), HasSubstr("/")));
    EXPECT_EQ(ctl("score " + path + " --task no_such_task").status, 2);
}

TEST_F(Programs, TheDemonstrationIsMadeOnceAndACancelledAttemptLeavesNothing) {
    const Outcome first = ctl("--json demo --attempts 0");
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.out, AllOf(HasSubstr("demo-anna"), HasSubstr("\"password\"")));
    const Outcome second = ctl("--json demo --attempts 0");
    EXPECT_EQ(second.status, 0);
    EXPECT_THAT(second.out, HasSubstr("\"created_users\": []"));
    EXPECT_THAT(ctl("user list").out, HasSubstr("active, demonstration"));
    EXPECT_EQ(ctl("--as demo-educator attempts", "PLACODE_PASSWORD=placode-demo").status, 0);
    // Ctrl-C after two seconds: the attempt takes far longer.
    const std::string command = "env TMPDIR='" + folder +
                                "' timeout --preserve-status -s INT 2 '" PLACODE_BIN_DIR
                                "/placodectl' --json --store sqlite:" +
                                store + " demo --task diathermy_ring --attempts 1 > '" +
                                file("out") + "' 2> '" + file("err") + "'";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << read_text(file("err"));
    EXPECT_THAT(read_text(file("out")), HasSubstr("\"cancelled\": true"));
    EXPECT_THAT(ctl("attempts").out, HasSubstr("no attempts"));
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_EQ(entry.path().string().find("placode-demo-"), std::string::npos) << entry;
}

TEST_F(Programs, ADeviceIsTriedAndLetGoAlsoWhereNobodyReadsItsLines) {
    // A pipe without room, whose reader sleeps. What cannot be ended is killed: status 137.
    write_text(file("trial.sh"),
               "mkfifo lines pedal\n"
               "exec 3<>lines\n"
               "head -c 65536 /dev/zero >&3\n"
               "{ sleep 1; echo quit; } | timeout -s KILL 30 '" PLACODE_BIN_DIR
               "/placode-sim' --test-device pedals:pedal > lines\n");
    const Outcome trial = shell("sh trial.sh");
    EXPECT_EQ(trial.status, 0) << trial.err;
    EXPECT_EQ(trial.err, "");
}

TEST_F(Programs, ADeviceThatIsNotThereIsNamedWithWhatThereIs) {
    for (const char* device : {"warp", "openhaptics"}) {
        const Outcome outcome =
            run("placode-sim", std::string("--headless --task diathermy_ring_small --device ") +
                                   device + " --record a.placode");
        EXPECT_EQ(outcome.status, 2) << device;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(device), HasSubstr("script:expert")));
        EXPECT_FALSE(fs::exists(file("a.placode")));
    }
}

TEST_F(Programs, AnAttemptWithAWrongTaskNeverStarts) {
    std::string task = read_text(PLACODE_SOURCE_DIR "/data/tasks/diathermy_ring.json");
    task.replace(task.find("\"time_limit_s\""), 14, "\"time_limit_min\"");
    write_text(file("task.json"), task);
    const std::string rest = " --headless --fast --device script:expert --record a.placode";
    const Outcome wrong = run("placode-sim", "--task task.json" + rest);
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("task.json"), HasSubstr("time_limit_min")));
    EXPECT_FALSE(fs::exists(file("a.placode")));
    EXPECT_EQ(run("placode-sim", "--task nowhere" + rest).status, 2);
    EXPECT_EQ(run("placode-sim", "--fly").status, 2);
}

TEST_F(Programs, ARecordingIsNeverOverwrittenAndADamagedOneIsNotReplayed) {
    const std::string path = file("a.placode");
    write_recording(path);
    const std::string before = read_text(path);
    const Outcome taken = run("placode-sim",
                              "--task diathermy_ring_small --headless --fast --duration 0.1 "
                              "--device script:expert --record a.placode");
    EXPECT_NE(taken.status, 0);
    EXPECT_THAT(taken.err, HasSubstr("not overwritten"));
    EXPECT_EQ(read_text(path), before);
    damage_chunk(path, 3);
    const Outcome damaged = run("placode-sim", "--headless --fast --device play:a.placode");
    EXPECT_EQ(damaged.status, 2);
    EXPECT_THAT(damaged.err, AllOf(HasSubstr("a.placode"), HasSubstr("chunk 3")));
}

TEST_F(Programs, AnAttemptIsRecordedMeasuredAndScored) {
    const Outcome attempt = run("placode-sim",
                                "--task diathermy_ring_small --headless --fast --duration 0.5 "
                                "--device script:expert --seed 7 --record a.placode");
    ASSERT_EQ(attempt.status, 0) << attempt.err;
    const Outcome score = ctl("score --json a.placode");
    ASSERT_EQ(score.status, 0) << score.err;
    EXPECT_NEAR(number_in(score.out, "duration_s"), 0.5, 0.0011);  // Whole frames of 1 ms.
    EXPECT_EQ(number_in(score.out, "seed"), 7);
    EXPECT_THAT(score.out, AllOf(HasSubstr("\"demonstration\": true"), HasSubstr("\"reasons\"")));
    const Outcome same = ctl("score a.placode --task diathermy_ring_small");
    EXPECT_EQ(same.status, 0);
    EXPECT_EQ(same.out.find("another task"), std::string::npos);
    const Outcome other = ctl("score a.placode --task touch_targets");
    EXPECT_NE(other.out.find("the recording is of another task: diathermy_ring_small\n"),
              std::string::npos)
        << other.out;
}

TEST_F(Programs, AKilledAttemptLosesAtMostHalfASecond) {
    // Killed at moments that differ from attempt to attempt; in real time, as a trainee would lose
    // it. The status lines (ten a second) say how far it had come.
    for (const int extra_ms : {0, 110, 170}) {
        const std::string name = "killed" + std::to_string(extra_ms) + ".placode";
        const std::string command = "cd '" + folder + "' && HOME='" + folder +
                                    "' exec '" PLACODE_BIN_DIR
                                    "/placode-sim' --task diathermy_ring_small --headless "
                                    "--device script:novice --status --record " +
                                    name;
        int pipe_ends[2];
        ASSERT_EQ(::pipe(pipe_ends), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            ::dup2(pipe_ends[1], STDOUT_FILENO);
            ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            ::_exit(127);
        }
        ::close(pipe_ends[1]);
        std::FILE* lines = ::fdopen(pipe_ends[0], "r");
        double reported_s = 0;
        bool killed = false;
        for (std::array<char, 4096> line; std::fgets(line.data(), line.size(), lines);) {
            reported_s = nlohmann::json::parse(line.data()).at("t_s");
            if (killed || reported_s < 1.2) continue;
            ::usleep(static_cast<useconds_t>(extra_ms) * 1000);
            ::kill(child, SIGKILL);
            killed = true;
        }
        std::fclose(lines);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(killed && WIFSIGNALED(status)) << "ended before it could be killed";
        const sim::Recording recording = db::read_recording_file(file(name));
        EXPECT_EQ(recording.end.reason, sim::EndReason::kInterrupted);
        EXPECT_GE(recording.end.duration_s, reported_s - 0.5) << extra_ms;
        EXPECT_GE(recording.inputs.size(), (reported_s - 0.5) * 1000);
    }
}

// A terminal that is closed, a connection that breaks.
TEST_F(Programs, AHangUpEndsAnAttemptAsInterrupted) {
    const std::string name = file("hang_up.placode");
    const Outcome ended = shell(
        "bash -c '\"" PLACODE_BIN_DIR
        "/placode-sim\" --task diathermy_ring_small --headless --device script:novice "
        "--record \"" +
        name + "\" & while [ ! -s \"" + name + "\" ]; do sleep 0.1; done; kill -HUP $!; wait $!'");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out + ended.err, HasSubstr("interrupted"));
    EXPECT_EQ(db::read_recording_file(name).end.reason, sim::EndReason::kInterrupted);
}

TEST_F(Programs, ARecordingBecomesAnAttemptOfAPerson) {
    ASSERT_EQ(ctl("demo --attempts 0").status, 0);
    const Outcome attempt = run("placode-sim",
                                "--task diathermy_ring_small --headless --fast --duration 0.3 "
                                "--device script:expert --record b.placode");
    ASSERT_EQ(attempt.status, 0) << attempt.err;
    const Outcome saved = ctl("--json import b.placode --user demo-anna");
    ASSERT_EQ(saved.status, 0) << saved.err;
    EXPECT_EQ(number_in(saved.out, "attempt"), 1);
    EXPECT_THAT(ctl("attempts --user demo-anna").out, HasSubstr("diathermy_ring_small"));
    EXPECT_EQ(ctl("import b.placode --user nobody").status, 2);
    // Nobody waits for what is only practice; at night all of it is simulated again, once.
    EXPECT_THAT(ctl("verify").out, HasSubstr("no attempt waits"));
    EXPECT_THAT(ctl("verify --all").out, HasSubstr("1 attempt gave the same, 0 attempts differ"));
    EXPECT_THAT(ctl("verify --all").out, HasSubstr("no attempt waits"));
}

TEST_F(Programs, WhatAnotherBuildRecordedSaysWhichOneItWaitsFor) {
    ::setenv("PLACODE_STATION_KEY", file("station.key").c_str(), 1);  // of all programs here
    add_user("anna", "trainee");
    db::AttemptResult result;
    result.header.task_id = "diathermy_ring_small";
    result.header.task_version = curriculum::shipped_task("diathermy_ring_small")->version;
    result.header.build = "placode 0.0\x1b[2J of another kind";
    result.end.reason = sim::EndReason::kFinished;
    const auto direct = db::open_store("sqlite:" + store);
    (void)save_recorded(*direct, 1, result, folder);
    const Outcome left = ctl("verify --all");
    EXPECT_THAT(left.out, HasSubstr("waits for placode 0.0?[2J of another kind; this is placode "));
    EXPECT_THAT(left.out, HasSubstr("1 could not be simulated again"));
    EXPECT_THAT(ctl("--json verify --all").out,
                HasSubstr("\"waits_for\": \"placode 0.0?[2J of another kind\""));
    ::unsetenv("PLACODE_STATION_KEY");
}

TEST_F(Programs, PicturesOfAnAttemptAreTimedAtEveryQuality) {
    const std::string recording = " --recording a.placode";
    ASSERT_EQ(run("placode-sim",
                  "--task touch_targets --device script:expert --headless --fast --duration 2"
                  " --record a.placode")
                  .status,
              0);
    const Outcome done = run("placodectl",
                             "--json bench picture --size 96x64 --pictures 10 --out "
                             "times.json --save shots" +
                                 recording);
    ASSERT_EQ(done.status, 0) << done.err;
    const auto json = nlohmann::json::parse(done.out);
    EXPECT_EQ(json, nlohmann::json::parse(read_text(file("times.json"))));
    EXPECT_DOUBLE_EQ(json.at("from_s").get<double>(), 1) << "the middle of the attempt";
    EXPECT_FALSE(json.at("renderer").get<std::string>().empty());
    const auto& rows = json.at("rows");
    ASSERT_GE(rows.size(), 5U);
    EXPECT_TRUE(rows.front().at("shadows").get<bool>()) << "the richest comes first";
    EXPECT_TRUE(rows.back().at("plain").get<bool>());
    for (const auto& row : rows) {
        EXPECT_EQ(row.at("width"), 96);
        EXPECT_GE(row.at("pictures").get<int>(), 10);
        EXPECT_GT(row.at("median_ms").get<double>(), 0);
        EXPECT_GE(row.at("p99_ms").get<double>(), row.at("median_ms").get<double>());
    }
    const auto shots = std::distance(fs::directory_iterator(file("shots")), {});
    EXPECT_EQ(static_cast<size_t>(shots), rows.size()) << "one for each quality";
    const std::pair<const char*, const char*> bad[]{
        {" --size 96", "WxH"},         {" --size 9x9", "64"},
        {" --size 96x64x3", "WxH"},    {" --pictures 3", "10 to 1000"},
        {" --seconds 0", "--seconds"}, {" --from 99", "ends at 2.0 s"}};
    for (const auto& [argument, reason] : bad) {
        const Outcome refused = run("placodectl", "bench picture" + recording + argument);
        EXPECT_EQ(refused.status, 2) << argument;
        EXPECT_THAT(refused.err, HasSubstr(reason)) << argument;
    }
}

TEST_F(Programs, AnAttemptBeginsAtAStageAndTheExpertIsAskedOnce) {
    std::string task = read_text(PLACODE_SOURCE_DIR "/data/tasks/touch_targets.json");
    const std::string rubric = "\"rubric\": {";
    ASSERT_NE(task.find(rubric), std::string::npos);
    task.insert(task.find(rubric),
                "\"stages\": [{\"before_step\": 2, \"title\": {\"en\": \"the "
                "third target\", \"pl\": \"trzeci cel\"}}], ");
    write_text(file("task.json"), task);
    const std::string begin = "--task " + file("task.json") +
                              " --device script:expert --headless --fast --threads 1 --duration 3 ";
    const std::string caches = "XDG_CACHE_HOME='" + folder + "/caches'";
    const auto attempt = [&](const std::string& name) {
        return run("placode-sim", begin + "--stage 1 --record " + file(name), caches);
    };
    const Outcome first = attempt("a.placode");
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.err, AllOf(HasSubstr("Preparing stage: the third target, 0 %"),
                                 HasSubstr("Preparing stage: the third target, 90 %")));
    const Outcome second = attempt("b.placode");
    ASSERT_EQ(second.status, 0) << second.err;
    EXPECT_EQ(second.err, "") << "it lies in the cache";
    const auto a = db::read_recording_file(file("a.placode"));
    const auto b = db::read_recording_file(file("b.placode"));
    EXPECT_EQ(a.header.stage, 1);
    EXPECT_GT(a.header.given_frames, 500);
    EXPECT_EQ(a.header.given_hash, b.header.given_hash);
    EXPECT_EQ(a.end.final_hash, b.end.final_hash);
    // What lies there and is damaged is made anew.
    for (const auto& entry : fs::directory_iterator(folder + "/caches/placode/stages"))
        write_text(entry.path().string(), "nonsense");
    const Outcome third = attempt("c.placode");
    ASSERT_EQ(third.status, 0) << third.err;
    EXPECT_THAT(third.err, HasSubstr("Preparing stage"));
    EXPECT_EQ(db::read_recording_file(file("c.placode")).end.final_hash, a.end.final_hash);
    // Here and, without its cache, anywhere else it replays exactly.
    for (const std::string& cache : {caches, "XDG_CACHE_HOME='" + folder + "/none'"}) {
        const Outcome replay =
            run("placode-sim", "--device play:" + file("a.placode") + " --headless --fast", cache);
        EXPECT_EQ(replay.status, 0) << replay.err;
        EXPECT_THAT(replay.out, HasSubstr("replay: identical"));
    }
    const Outcome score = ctl("score " + file("a.placode"));
    EXPECT_EQ(score.status, 0) << score.err;
    EXPECT_THAT(score.out,
                AllOf(HasSubstr("score 0.0 of 100"), HasSubstr("Not scored: begun at stage 1")));
}

TEST_F(Programs, AStageThatIsNotThereIsAnsweredWithThoseThatAre) {
    const Outcome wrong = run("placode-sim",
                              "--task suture_run --device script:expert --headless "
                              "--fast --stage 3 --record " +
                                  file("a.placode"));
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("has no stage 3"),
                                 HasSubstr("0 (the beginning), 1 (bite 2), 2 (bite 3)")));
    EXPECT_FALSE(fs::exists(file("a.placode")));
    const Outcome none = run("placode-sim",
                             "--task diathermy_ring --device script:expert "
                             "--headless --fast --stage 1");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("known: 0 (the beginning)"));
}

}  // namespace THIS_TEST
