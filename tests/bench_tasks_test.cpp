// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl bench tasks`: an entry, what refutes a forged one, the leader board.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "batches/benchmark.h"
#include "batches/checksum.h"
#include "db/recording_file.h"
#include "tests/programs_fixture.h"

namespace placode::test {
namespace THIS_TEST {

using batches::Json;
using testing::HasSubstr;

/// A field of about 1,500 tets: the whole benchmark in seconds.
constexpr const char* kProtocol = R"({
  "id": "short", "version": 1, "frames_per_step": 20,
  "scene_changes": {"edge_ring_m": 0.0014, "edge_placode_m": 0.0018, "edge_outer_m": 0.0032,
                    "solver": {"substeps": 2}},
  "seeds": [1, 2],
  "tasks": [{"task": "touch_targets", "budget_s": 60}, {"task": "trace_contour", "budget_s": 1}]
})";

class BenchTasks : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        write_text(file("short.json"), kProtocol);
    }
    [[nodiscard]] Outcome bench(const std::string& arguments) const {
        return ctl("bench tasks --protocol short.json " + arguments);
    }
    /// The expert's entry as "e": performed once, whichever test asks first.
    void enter_expert() const {
        static const TemporaryFolder made;
        const bool again = fs::exists(made.path() / "entry.json");
        if (!again) {
            const Outcome entered = bench("--policy expert --out e --json");
            ASSERT_EQ(entered.status, 0) << entered.err;
        }
        const fs::path mine = file("e");
        fs::copy(again ? made.path() : mine, again ? mine : made.path(),
                 fs::copy_options::recursive);
    }
    [[nodiscard]] Json entry(const std::string& folder) const {
        return Json::parse(read_text(file(folder + "/entry.json")));
    }
    void write_entry(const std::string& folder, const Json& json) const {
        write_text(file(folder + "/entry.json"), json.dump(2));
    }
    /// A copy of the entry "e" in which somebody has changed the first recording, and its checksum
    /// along with it.
    void forge(const std::string& folder,
               const std::function<void(sim::Recording&)>& change) const {
        fs::remove_all(file(folder));
        fs::copy(file("e"), file(folder), fs::copy_options::recursive);
        Json json = entry(folder);
        Json& first = json["attempts"][0];
        const std::string path = file(folder + "/" + first["recording"].get<std::string>());
        sim::Recording recording = db::read_recording_file(path);
        change(recording);
        batches::write_recording(recording, path);
        first["sha256"] = batches::sha256_of_file(path);
        write_entry(folder, json);
    }
    void expect_refuted(const std::string& folder, const std::string& words) const {
        const Outcome verified = bench("--verify " + folder + "/entry.json");
        EXPECT_EQ(verified.status, 1) << words;
        EXPECT_THAT(verified.out, HasSubstr(words));
        EXPECT_THAT(verified.out, HasSubstr("not genuine"));
    }
};

TEST_F(BenchTasks, AnExpertsEntryIsGenuine) {
    ASSERT_NO_FATAL_FAILURE(enter_expert());
    const Json json = entry("e");
    EXPECT_EQ(json["attempts"].size(), 4U);
    EXPECT_TRUE(json["complete"].get<bool>());
    EXPECT_EQ(json["tasks"][0]["passed"], 2) << "the expert touches all targets in time";
    EXPECT_EQ(json["tasks"][1]["passed"], 0) << "nobody traces a contour in a second";
    EXPECT_GT(json["tasks"][0]["points"].get<double>(), 80);
    EXPECT_EQ(
        json["score"].get<double>(),
        (json["tasks"][0]["points"].get<double>() + json["tasks"][1]["points"].get<double>()) / 2);
    const Outcome genuine = bench("--verify e/entry.json");
    EXPECT_EQ(genuine.status, 0) << genuine.out << genuine.err;
    EXPECT_THAT(genuine.out, HasSubstr("genuine: every attempt, simulated again"));
    const Outcome folder_of_it = bench("--verify e --no-replay");
    EXPECT_EQ(folder_of_it.status, 0) << folder_of_it.out << folder_of_it.err;
}

TEST_F(BenchTasks, ForgedEntriesAreRefuted) {
    ASSERT_NO_FATAL_FAILURE(enter_expert());
    const Json json = entry("e");
    fs::copy(file("e"), file("points"), fs::copy_options::recursive);
    Json forged = json;
    forged["attempts"][0]["points"] = 99.5;
    write_entry("points", forged);
    expect_refuted("points", "says other points, verdict or hash than its recording");
    forged = json;
    forged["score"] = 100;
    write_entry("points", forged);
    expect_refuted("points", "its score is not the mean over its tasks");
    // What the board prints beside the points.
    forged = json;
    forged["tasks"][1]["passed"] = 2;
    write_entry("points", forged);
    expect_refuted("points", "other numbers of attempts or passes of trace_contour");
    forged = json;
    forged["tasks"][0]["attempts"] = 5;
    write_entry("points", forged);
    expect_refuted("points", "other numbers of attempts or passes of touch_targets");
    forged = json;
    forged["attempts"].erase(3);
    write_entry("points", forged);
    expect_refuted("points", "attempts are left out");

    forge("f", [](sim::Recording& r) { r.samples[40].tools[0].force_n[2] += 0.01F; });
    expect_refuted("f", "simulated again it differs: a sample");
    forge("f", [](sim::Recording& r) { r.header.seed = 7; });
    expect_refuted("f", "is of another task, scene or seed");
    forge("f", [](sim::Recording& r) {
        const size_t at = r.header.task_json.find("\"time_limit_s\":");
        ASSERT_NE(at, std::string::npos);
        r.header.task_json.insert(at + 15, "1");
    });
    expect_refuted("f", "is of another task, scene or seed");
    forge("f", [](sim::Recording& r) {
        for (size_t i = 100; i < r.inputs.size(); ++i)
            for (auto& tool : r.inputs[i].tools) {
                sim::Pose pose = tool.pose();
                pose.p.x() += 0.005;
                tool.set_pose(pose);
            }
    });
    expect_refuted("f", "a tip moves faster than an environment lets it, in frame 100");
    write_text(file("f/touch_targets-1.placode"), "nothing");
    expect_refuted("f", "its checksum differs");
}

TEST_F(BenchTasks, OtherOperatorsEnterByTheirRecordingsAndTheBoardRanks) {
    ASSERT_NO_FATAL_FAILURE(enter_expert());
    ASSERT_EQ(bench("--policy nothing --out n").status, 0);
    ASSERT_EQ(bench("--policy random --seeds 8,9 --out h --tasks trace_contour").status, 0);
    EXPECT_TRUE(entry("h")["held_out_seeds"].get<bool>());
    EXPECT_FALSE(entry("h")["complete"].get<bool>());
    // The expert's recordings as somebody else's.
    fs::create_directory(file("x"));
    for (const auto& one : fs::directory_iterator(file("e")))
        if (one.path().extension() == ".placode") fs::copy(one.path(), file("x"));
    EXPECT_THAT(bench("--recordings x").err, HasSubstr("expected --name"));
    ASSERT_EQ(bench("--recordings x --name 'My | policy'").status, 0);
    EXPECT_EQ(entry("x")["score"], entry("e")["score"]);
    Json forged = entry("n");
    forged["name"] = "forger";
    fs::copy(file("n"), file("z"), fs::copy_options::recursive);
    forged["attempts"][0]["points"] = 100;
    write_entry("z", forged);

    const Outcome board =
        bench("--board board.md --entries h/entry.json z/entry.json n/entry.json x/entry.json");
    ASSERT_EQ(board.status, 0) << board.err;
    const std::string text = read_text(file("board.md"));
    const size_t first = text.find("| 1 | My   policy |"), second = text.find("| 2 | nothing |"),
                 held = text.find("| - | random |"), refuted = text.find("| - | forger |");
    ASSERT_NE(refuted, std::string::npos) << text;
    EXPECT_LT(first, second);
    EXPECT_LT(second, held);
    EXPECT_LT(held, refuted);
    EXPECT_THAT(text, HasSubstr("held out (2) | replayed |"));
    EXPECT_THAT(text, HasSubstr("| refuted |"));
    // Named by its folder, too.
    ASSERT_EQ(bench("--board quick.md --no-replay --entries n").status, 0);
    EXPECT_THAT(read_text(file("quick.md")), HasSubstr("| not replayed |"));
}

TEST_F(BenchTasks, TheBoardRefusesWhatItCannotPrintBeforeItReplays) {
    ASSERT_EQ(bench("--policy nothing --out n --tasks trace_contour").status, 0);
    const Json made = entry("n");
    const auto expect_named = [&](const Json& json, const std::string& place) {
        fs::create_directories(file("o"));
        write_entry("o", json);
        const Outcome board = bench("--board board.md --entries n/entry.json o/entry.json");
        EXPECT_EQ(board.status, 2) << place << board.err;
        EXPECT_THAT(board.err, HasSubstr("o/entry.json: " + place));
        EXPECT_FALSE(fs::exists(file("board.md"))) << place;
    };
    for (const char* key : {"name", "score", "complete", "held_out_seeds", "seeds", "build"}) {
        Json json = made;
        json["benchmark"] = "another";
        json.erase(key);
        expect_named(json, std::string("/") + key);
    }
    Json json = made;
    json["benchmark"] = "another";
    json["tasks"][0]["passed"] = "all";
    expect_named(json, "/tasks/0/passed");
    json["tasks"][0] = 3;
    expect_named(json, "/tasks/0/task");
    // Of another benchmark, but whole: it stands on the board as refuted.
    json = made;
    json["benchmark"] = "another";
    write_entry("o", json);
    ASSERT_EQ(bench("--board board.md --entries n/entry.json o/entry.json").status, 0);
    EXPECT_THAT(read_text(file("board.md")), HasSubstr("| refuted |"));
}

TEST_F(BenchTasks, BadOrdersAreNamed) {
    const std::pair<const char*, const char*> orders[] = {
        {"", "expected one of --policy NAME"},
        {"--policy expert", "expected --out FOLDER"},
        {"--policy clever --out x", "clever"},
        {"--policy nothing --out x --seeds 1-", "\"1-\""},
        {"--policy nothing --out x --tasks sb_dissection",
         "\"sb_dissection\" is not in the benchmark short; expected some of touch_targets, "
         "trace_contour"},
        {"--policy nothing --out x --tasks touch_targts,trace_contour",
         "expected some of touch_targets, trace_contour; did you mean \"touch_targets\"?"},
        {"--verify short.json", "short.json: is no entry to a benchmark"},
        {"--recordings . --name me", "holds no recordings"},
        {"--verify nothing", "nothing: cannot be read"},
        {"--verify empty", "empty/entry.json: cannot be read"},
        {"--board b.md --entries empty", "empty/entry.json: cannot be read"},
    };
    fs::create_directory(file("empty"));
    const Outcome folder_as_protocol = ctl("bench tasks --protocol empty --policy nothing --out q");
    EXPECT_EQ(folder_as_protocol.status, 2);
    EXPECT_THAT(folder_as_protocol.err, HasSubstr("empty: is a folder; expected a file"));
    for (const auto& [order, words] : orders) {
        const Outcome refused = bench(order);
        EXPECT_NE(refused.status, 0) << order;
        EXPECT_THAT(refused.err, HasSubstr(words)) << order;
    }
    // What another policy left in the folder is not taken for one's own.
    ASSERT_EQ(bench("--policy nothing --out n --tasks trace_contour").status, 0);
    const Outcome other = bench("--policy random --out n --tasks trace_contour");
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, HasSubstr("holds what another policy"));
    std::string text = kProtocol;
    text.replace(text.find("\"budget_s\": 60"), 14, "\"budget_s\": -6");
    write_text(file("short.json"), text);
    EXPECT_THAT(bench("--policy nothing --out q").err, HasSubstr("short.json: /tasks"));
}

TEST(BenchTasksProtocol, AnEnvironmentsOperatorHasEveryStepAsAScriptHas) {
    // Or a recording of it could not be replayed: the replay counts the steps by its device.
    const curriculum::Task task = curriculum::load_task("familiarisation");
    EXPECT_EQ(curriculum::steps_for(task, "environment").size(), task.steps.size());
    EXPECT_LT(curriculum::steps_for(task, "haply").size(), task.steps.size());
}

TEST(BenchTasksProtocol, TheShippedOneCanBeUsed) {
    const batches::Protocol protocol = batches::read_protocol(batches::shipped_protocol());
    EXPECT_EQ(protocol.tasks.size(), 7U);
    EXPECT_EQ(protocol.sha256.size(), 64U);
}

}  // namespace THIS_TEST
}  // namespace placode::test
