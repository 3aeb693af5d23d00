// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The programs as people and scripts meet them: exit status, messages, and that bad input changes
// nothing.

#include <gmock/gmock.h>
#include <signal.h>
#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "db/recording_file.h"
#include "db/store.h"
#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

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

}  // namespace

TEST_F(Programs, UsageErrorsHaveStatusTwoAndHelpHasNone) {
    EXPECT_EQ(ctl("").status, 2);
    EXPECT_EQ(ctl("fly").status, 2);
    EXPECT_EQ(ctl("backup").status, 2);
    EXPECT_EQ(ctl("--help").status, 0);
    EXPECT_THAT(ctl("--help").out, AllOf(HasSubstr("user"), HasSubstr("restore")));
    EXPECT_FALSE(fs::exists(store)) << "asking for help made a store";
}

TEST_F(Programs, AccountsAreMadeListedAndDeactivated) {
    add_user("admin", "administrator");
    add_user("anna", "trainee");
    const Outcome list = ctl("user list --json");
    EXPECT_EQ(list.status, 0) << list.err;
    EXPECT_THAT(list.out, AllOf(HasSubstr("\"login\": \"anna\""), HasSubstr("administrator")));
    EXPECT_EQ(ctl("user deactivate anna").status, 0);
    EXPECT_THAT(ctl("user list").out, HasSubstr("deactivated"));
    const Outcome last = ctl("user deactivate admin");
    EXPECT_EQ(last.status, 1);
    EXPECT_THAT(last.err, HasSubstr("last active administrator"));
    EXPECT_THAT(ctl("audit").out, HasSubstr("local administrator ("));
}

TEST_F(Programs, BadAccountsAreRefusedAndNothingIsMade) {
    add_user("anna", "trainee");
    const auto add = [&](const std::string& arguments, const std::string& password) {
        return ctl("user add " + arguments, "PLACODE_NEW_PASSWORD='" + password + "'");
    };
    EXPECT_EQ(add("ANNA", "long enough 1").status, 1);
    EXPECT_EQ(add("bert", "short").status, 1);
    EXPECT_THAT(add("bert", "short").err, HasSubstr("at least 10"));
    const Outcome role = add("bert --role surgeon", "long enough 1");
    EXPECT_EQ(role.status, 2);
    EXPECT_THAT(role.err, AllOf(HasSubstr("surgeon"), HasSubstr("educator")));
    EXPECT_EQ(ctl("user add bert").status, 2) << "no password, no terminal";
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("bert")));
    EXPECT_EQ(ctl("user password bert", "PLACODE_NEW_PASSWORD='long enough 2'").status, 2);
}

TEST_F(Programs, AWrongPasswordIsRefusedAndAfterSixTriesHasToWait) {
    add_user("anna", "trainee");
    const Outcome wrong = ctl("--as anna attempts", "PLACODE_PASSWORD=wrong");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("sign in as anna"), HasSubstr("password is wrong")));
    EXPECT_EQ(ctl("--as anna attempts", kRight).status, 0);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(ctl("--as anna attempts", "PLACODE_PASSWORD=wrong").status, 1);
    const Outcome waits = ctl("--as anna attempts", kRight);
    EXPECT_EQ(waits.status, 1);
    EXPECT_THAT(waits.err, HasSubstr("try again in"));
}

TEST_F(Programs, RightsAreThoseOfTheRole) {
    add_user("anna", "trainee");
    add_user("bert", "trainee");
    add_user("eve", "educator");
    EXPECT_EQ(ctl("--as anna attempts --user bert", kRight).status, 1);
    EXPECT_EQ(ctl("--as eve attempts --user bert", kRight).status, 0);
    for (const char* command : {"user list", "check", "backup copy.db", "audit"}) {
        const Outcome refused = ctl(std::string("--as eve ") + command, kRight);
        EXPECT_EQ(refused.status, 1) << command;
        EXPECT_THAT(refused.err, HasSubstr("an administrator can")) << command;
    }
    EXPECT_FALSE(fs::exists(file("copy.db")));
    EXPECT_THAT(ctl("--as eve export csv --study pilot", kRight).err, HasSubstr("coordinator"));
    EXPECT_EQ(ctl("--as anna user password anna",
                  std::string(kRight) + " PLACODE_NEW_PASSWORD='another one 2'")
                  .status,
              0)
        << "everybody may change the own password";
    EXPECT_EQ(ctl("--as anna user password bert",
                  "PLACODE_PASSWORD='another one 2' PLACODE_NEW_PASSWORD='another one 3'")
                  .status,
              1);
}

TEST_F(Programs, AStoreThatIsNotThereIsNotMadeByLooking) {
    const Outcome missing = ctl("check");
    EXPECT_EQ(missing.status, 2);
    EXPECT_THAT(missing.err, AllOf(HasSubstr(store), HasSubstr("no such store")));
    EXPECT_FALSE(fs::exists(store));
    EXPECT_EQ(run("placodectl", "--store mysql://x/y check").status, 2);
}

TEST_F(Programs, ALockedStoreIsNamedAndUnchanged) {
    add_user("anna", "trainee");
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open(store.c_str(), &other), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
    const Outcome locked = ctl("user deactivate anna");
    EXPECT_EQ(locked.status, 1);
    EXPECT_THAT(locked.err, AllOf(HasSubstr("sqlite:" + store), HasSubstr("another program")));
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("deactivated")));
}

TEST_F(Programs, ADamagedStoreIsLeftAsItIsAndABackupTakesItsPlace) {
    add_user("anna", "trainee");
    const std::string copy = file("copy.db");
    ASSERT_EQ(ctl("backup " + copy).status, 0);
    EXPECT_EQ(ctl("backup " + copy).status, 1) << "a backup is never overwritten";
    EXPECT_EQ(ctl("check").status, 0);
    write_text(store, "scrambled eggs");
    const Outcome damaged = ctl("check");
    EXPECT_EQ(damaged.status, 1);
    EXPECT_THAT(damaged.err, AllOf(HasSubstr("not a database"), HasSubstr("placodectl restore")));
    EXPECT_EQ(read_text(store), "scrambled eggs");
    EXPECT_EQ(ctl("restore " + file("nothing.db")).status, 2);
    write_text(file("empty.db"), "");
    EXPECT_EQ(ctl("restore " + file("empty.db")).status, 1);
    EXPECT_EQ(read_text(store), "scrambled eggs");
    const Outcome restored = ctl("restore " + copy);
    EXPECT_EQ(restored.status, 0) << restored.err;
    EXPECT_THAT(restored.out, HasSubstr("the old store is kept as"));
    EXPECT_THAT(ctl("user list").out, HasSubstr("anna"));
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

TEST_F(Programs, ASpeedProfileGivesThePublishedSmoothness) {
    // Minimum-jerk movement, 100 mm in 1 s at 100 Hz. Expected: the code of siva82kb/SPARC.
    std::string csv = "t_s,speed_mm_s\n";
    for (int k = 0; k <= 100; ++k) {
        const double u = k / 100.0;
        csv += std::to_string(k / 100.0) + "," +
               std::to_string(100 * (30 * u * u - 60 * u * u * u + 30 * u * u * u * u)) + "\n";
    }
    write_text(file("a.csv"), csv);
    const Outcome outcome = ctl("metrics --json --raw " + file("a.csv"));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    // 1e-4: std::to_string leaves six decimals of the speed.
    EXPECT_NEAR(number_in(outcome.out, "sparc"), -1.405829, 1e-4);
    EXPECT_NEAR(number_in(outcome.out, "ldlj_speed"), -5.301633, 1e-4);
    EXPECT_NEAR(number_in(outcome.out, "path_length_mm"), 100, 1e-3);
    // The author's own example has a speed without unit.
    const Outcome example =
        ctl("metrics --json --raw " PLACODE_SOURCE_DIR "/tests/data/motion/gaussian_doctest.csv");
    ASSERT_EQ(example.status, 0) << example.err;
    EXPECT_NEAR(number_in(example.out, "sparc"), -1.41403, 1e-5);
    EXPECT_NEAR(number_in(example.out, "ldlj_speed"), -5.81636, 1e-5);
    EXPECT_THAT(example.out, Not(HasSubstr("_mm")));
    // A comma as decimal sign in the user's language changes nothing.
    const Outcome polish = ctl("metrics --json --raw " + file("a.csv"), "LC_ALL=pl_PL.UTF-8");
    EXPECT_EQ(polish.out, outcome.out);
}

TEST_F(Programs, AStraightWayAHeatRampAndAForceHaveTheirClosedForms) {
    std::string way = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n", heat = "t_s,T_C\n",
                force = "t_s,force_N\n";
    for (int k = 0; k <= 200; ++k) {
        const std::string t = std::to_string(k * 0.01);
        const double turn = k * 0.005;  // Half the angle: 2 rad in all.
        way += t + "," + std::to_string(k * 0.3) + "," + std::to_string(k * 0.4) + ",0," +
               std::to_string(std::cos(turn)) + ",0,0," + std::to_string(std::sin(turn)) + "\n";
        heat += t + ",45\n";
        force += t + "," + std::to_string(k * 0.01) + "\n";
    }
    write_text(file("way.csv"), way);
    write_text(file("heat.csv"), heat);
    write_text(file("force.csv"), force);
    const std::string pose = ctl("metrics --json --raw way.csv").out;
    EXPECT_NEAR(number_in(pose, "path_length_mm"), 100, 1e-3);
    EXPECT_NEAR(number_in(pose, "mean_speed_mm_s"), 50, 1e-3);
    EXPECT_NEAR(number_in(pose, "angular_path_deg"), 2 * 180 / M_PI, 0.01);
    EXPECT_NEAR(number_in(pose, "depth_path_mm"), 0, 1e-6);
    // 2 s at 45 C = 2/60 min x 2^2.
    EXPECT_NEAR(number_in(ctl("metrics --json heat.csv").out, "cem43_min"), 8.0 / 60, 1e-9);
    const std::string forces = ctl("metrics --json --threshold 1 force.csv").out;
    EXPECT_NEAR(number_in(forces, "peak_force_n"), 2, 1e-9);
    EXPECT_NEAR(number_in(forces, "impulse_n_s"), 2, 1e-9);
    EXPECT_NEAR(number_in(forces, "excess_impulse_n_s"), 0.5, 1e-4);
}

TEST_F(Programs, TwoHandsAndATremorHaveTheirClosedForms) {
    const double pi = std::acos(-1.0);
    std::string hands = "t_s,speed_left_mm_s,speed_right_mm_s\n", tremor = "t_s,x_mm\n";
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.01 * i;
        hands += std::to_string(t) + "," + std::to_string(40 + 20 * std::cos(2 * pi * t)) + "," +
                 std::to_string(40 + 20 * std::cos(2 * pi * t + pi / 3)) + "\n";
        tremor += std::to_string(t) + "," + std::to_string(0.1 * std::sin(20 * pi * t)) + "\n";
    }
    write_text(file("hands.csv"), hands);
    write_text(file("tremor.csv"), tremor);
    const Outcome two = ctl("--json metrics hands.csv --raw");
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_NEAR(number_in(two.out, "pearson_r"), 0.5, 1e-6);  // cos(60 deg); six decimals.
    EXPECT_NEAR(number_in(two.out, "both_moving_fraction"), 1.0 / 3, 0.02);
    const Outcome shaking = ctl("--json metrics tremor.csv");
    ASSERT_EQ(shaking.status, 0) << shaking.err;
    EXPECT_NEAR(number_in(shaking.out, "tremor_rms_mm"), 0.1 / std::sqrt(2.0), 1e-5);
}

TEST_F(Programs, MetricsTakeWhatTheyKnowAmongOtherColumns) {
    // 50 mm in 2 s with a tremor of 1 mm at 9 Hz, along one axis; its columns in no order.
    const double pi = std::acos(-1.0);
    std::string shaken = "force_N,x_raw_mm,note_of_mine,t_s\n", plain = "t_s,x_mm\n";
    for (int i = 0; i <= 200; ++i) {
        const double t = 0.01 * i, x = 25 * t + std::sin(18 * pi * t);
        shaken += "2," + std::to_string(x) + ",7," + std::to_string(t) + "\n";
        plain += std::to_string(t) + "," + std::to_string(25 * t) + "\n";
    }
    write_text(file("shaken.csv"), shaken);
    write_text(file("plain.csv"), plain);
    const Outcome both = ctl("--json metrics shaken.csv");
    ASSERT_EQ(both.status, 0) << both.err;
    EXPECT_THAT(both.out, HasSubstr("\"columns_not_used\": [\n    \"note_of_mine\"\n  ]"));
    EXPECT_NEAR(number_in(both.out, "mean_force_n"), 2, 1e-9);
    // Of 9 Hz a filter of 10 Hz, run twice, leaves 1 / (1 + 0.9^4) = 0.6.
    const double filtered = number_in(both.out, "path_length_mm");
    EXPECT_GT(number_in(both.out, "path_length_recorded_mm"), filtered + 1);
    // 0.01: the filter's reflection of 9 samples bends the ends a little.
    EXPECT_NEAR(number_in(ctl("--json metrics plain.csv").out, "path_length_mm"), 50, 0.01);
    EXPECT_NEAR(number_in(ctl("--json metrics plain.csv --raw").out, "mean_speed_mm_s"), 25, 1e-3);
    // Unknown units are not guessed.
    write_text(file("metres.csv"), "t_s,x_m\n0,1\n0.01,2\n0.02,3\n0.03,4\n");
    EXPECT_EQ(ctl("metrics metres.csv").status, 2);
}

TEST_F(Programs, AContourIsComparedWithItsPlan) {
    const double pi = std::acos(-1.0);
    std::string plan = "x_mm,y_mm\n", arc = plan;
    for (int i = 0; i < 720; ++i) {
        const double turn = 2 * pi * i / 720;
        plan +=
            std::to_string(8 * std::cos(turn)) + "," + std::to_string(8 * std::sin(turn)) + "\n";
        // A gap of 25 degrees, half a millimetre outside.
        if (i < 25 || i > 695) continue;
        arc += std::to_string(8.5 * std::cos(turn)) + "," + std::to_string(8.5 * std::sin(turn)) +
               "\n";
    }
    write_text(file("plan.csv"), plan);
    write_text(file("cut.csv"), arc);
    const Outcome good = ctl("--json contour plan.csv cut.csv");
    ASSERT_EQ(good.status, 0) << good.err;
    EXPECT_NEAR(number_in(good.out, "mean_abs_dev_mm"), 0.5, 1e-3);
    EXPECT_NEAR(number_in(good.out, "completeness_percent"), 93.06, 0.3);  // 25 of 360 degrees.
    EXPECT_NEAR(number_in(good.out, "hausdorff_plan_to_cut_mm"), 1.86, 0.05);
    write_text(file("bad.csv"), "x,y\n1,2\n");
    const Outcome bad = ctl("contour plan.csv bad.csv");
    EXPECT_EQ(bad.status, 2);
    EXPECT_THAT(bad.err, AllOf(HasSubstr("bad.csv"), HasSubstr("x_mm,y_mm")));
    EXPECT_EQ(ctl("contour plan.csv cut.csv --tolerance 0").status, 2);
}

TEST_F(Programs, ATimeStampedTwiceIsDroppedAndTold) {
    std::string clean = "t_s,speed_mm_s\n", twice = clean;
    for (int k = 0; k < 60; ++k) {
        const std::string row =
            std::to_string(k * 0.01) + "," + std::to_string(40 * std::sin(k * 0.05)) + "\n";
        clean += row;
        twice += row;
        if (k % 20 == 7) twice += std::to_string(k * 0.01) + ",99\n";
    }
    write_text(file("clean.csv"), clean);
    write_text(file("twice.csv"), twice);
    const Outcome one = ctl("metrics --json clean.csv"), two = ctl("metrics --json twice.csv");
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_EQ(number_in(two.out, "dropped_samples"), 3);
    EXPECT_EQ(number_in(two.out, "sparc"), number_in(one.out, "sparc"));
    EXPECT_EQ(ctl("metrics --json --raw twice.csv").status, 2) << "raw is clean already";
    write_text(file("back.csv"), "t_s,speed_mm_s\n0,1\n0.02,2\n0.01,2\n0.03,1\n0.04,1\n");
    const Outcome back = ctl("metrics back.csv");
    EXPECT_EQ(back.status, 2);
    EXPECT_THAT(back.err, HasSubstr("back.csv:4: t_s"));
    write_text(file("cold.csv"), "t_s,T_C\n0,37\n1,-300\n2,37\n3,37\n");
    EXPECT_THAT(ctl("metrics cold.csv").err, HasSubstr("cold.csv:3: T_C: found -300"));
}

TEST_F(Programs, ABadSignalFileNamesLineAndColumn) {
    const auto fails = [&](const std::string& csv) {
        write_text(file("a.csv"), csv);
        const Outcome outcome = ctl("metrics a.csv");
        EXPECT_EQ(outcome.status, 2) << csv;
        return outcome.err;
    };
    EXPECT_THAT(fails("t_s,speed_m_s\n0,1\n"),
                AllOf(HasSubstr("a.csv:1"), HasSubstr("speed_m_s"), HasSubstr("t_s,speed_mm_s")));
    EXPECT_THAT(fails("t_s,speed_mm_s\n0,1\n0.01,1;5\n"),
                AllOf(HasSubstr("a.csv:3: speed_mm_s"), HasSubstr("1;5")));
    EXPECT_THAT(fails("t_s,speed_mm_s\n0,1\n0.01\n"), HasSubstr("a.csv:3: found 1 columns"));
    EXPECT_THAT(fails("t_s,T_C\n0,37\n2,37\n1,37\n3,37\n"), HasSubstr("a.csv:4: t_s: found 1"));
    EXPECT_THAT(fails(""), HasSubstr("a.csv"));
    EXPECT_EQ(ctl("metrics a.txt").status, 2);
}

TEST_F(Programs, ASignalBeyondAllMeasureIsRefusedWithTheRange) {
    const auto asked = [&](const std::string& csv, const char* more = "") {
        write_text(file("a.csv"), csv);
        return ctl("--json metrics a.csv" + std::string(more));
    };
    // A gap of months would be resampled at 100 Hz: the memory ran full.
    Outcome outcome = asked("t_s,speed_mm_s\n0,1\n0.01,2\n0.02,1\n10000000,2\n10000000.01,1\n");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out + outcome.err,
                AllOf(HasSubstr("a.csv:6: t_s"), HasSubstr("at most 3600 s")));
    // Squares of these are no numbers; JSON said null.
    outcome =
        asked("t_s,x_mm,y_mm,z_mm\n0,1,1,1\n0.01,1e300,1,1\n0.02,1,1,1\n0.03,2,1,1\n", " --raw");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out + outcome.err,
                AllOf(HasSubstr("a.csv:3: x_mm: found 1e+300"), HasSubstr("1e+06 mm")));
    outcome = asked("t_s,T_C\n0,37\n1,1e300\n2,37\n3,37\n");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("less than 1000 degrees Celsius"));
    outcome = asked("t_s,force_N\r\n0,0\r\n1,-2e4\r\n2,0\r\n3,0\r\n");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("a.csv:3: force_N"));
    // Speeds that are hardly there: their square is 0, and a quotient of it no number.
    outcome =
        asked("t_s,speed_mm_s\n0,4e-324\n0.01,1e-320\n0.02,0\n0.03,1e-310\n0.04,0\n", " --raw");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, Not(HasSubstr("null")));
}

TEST_F(Programs, ErrorsAreOneJsonDocumentToo) {
    const Outcome outcome = ctl("--json check");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out, AllOf(testing::StartsWith("{"), HasSubstr("\"error\""),
                                   HasSubstr("\"exit_status\": 2")));
}

TEST_F(Programs, AttemptsAndAnswersLeaveTheStoreAsCsvAndPdf) {
    ASSERT_NE(world, nullptr);
    const std::string recording = file("a.placode");
    ASSERT_EQ(run("placode-sim",
                  "--task diathermy_ring_small --headless --fast --duration 0.3 --device "
                  "script:expert --record a.placode")
                  .status,
              0);
    const std::string zofia = "Zażółć, \"Zofia\"";
    {
        const auto direct = db::open_store("sqlite:" + store);
        const int64_t user = direct->create_user({"zofia", zofia, "long enough 1", 1, true});
        direct->create_user({"carl", "Carl", "long enough 1", 4, true});
        db::AttemptResult result;
        const sim::Recording read = db::read_recording_file(recording);
        result.header = read.header;
        result.end = read.end;
        result.events = read.events;
        result.metrics = assessment::compute_metrics(read);
        result.score.points = 12.5;
        result.recording_file = recording;
        direct->save_attempt(user, result);
        db::AnswerRecord answers;
        answers.study_id = "pilot/1";
        answers.participant = direct->new_participant("pilot/1");
        answers.questionnaire_id = "face_validity";
        answers.answers = {{"A", "5"}, {"B", "4"}};
        direct->save_answers(answers);
    }
    const Outcome attempts = ctl("--as zofia attempts --json", kRight);
    EXPECT_EQ(attempts.status, 0) << attempts.err;
    EXPECT_EQ(number_in(attempts.out, "points"), 12.5);
    const Outcome user = ctl("--as zofia export csv --user zofia --out exported", kRight);
    EXPECT_EQ(user.status, 0) << user.err;
    EXPECT_THAT(read_text(file("exported/user_1_attempts.csv")),
                AllOf(HasSubstr("12.5"), HasSubstr("path_length_mm")));
    const Outcome study = ctl("--as carl export csv --study pilot/1 --out exported", kRight);
    EXPECT_EQ(study.status, 0) << study.err;
    EXPECT_THAT(read_text(file("exported/pilot_1_face_validity.csv")), HasSubstr("P001-"));
    EXPECT_EQ(ctl("--as carl export csv --study none", kRight).status, 2);
    EXPECT_EQ(ctl("export csv").status, 2) << "neither study nor user";
    const Outcome report = ctl("--as zofia report attempt 1 --out a.pdf", kRight);
    EXPECT_EQ(report.status, 0) << report.err;
    EXPECT_THAT(read_text(file("a.pdf")), testing::StartsWith("%PDF-"));
    EXPECT_EQ(ctl("--as carl report attempt 1 --out b.pdf", kRight).status, 1);
    EXPECT_FALSE(fs::exists(file("b.pdf")));
    EXPECT_EQ(ctl("report attempt 99 --out b.pdf").status, 2);
    EXPECT_EQ(ctl("report attempt first --out b.pdf").status, 2);
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("export.csv"), HasSubstr("report.pdf")));
}

TEST_F(Programs, TheStudyOfThePaperRunsAndLeavesInEveryFormat) {
    add_user("carl", "coordinator");
    const auto carl = [&](const std::string& arguments) {
        return ctl("--as carl " + arguments, kRight);
    };
    const Outcome made = carl("study demo");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("14 SIMULATED participants"));
    EXPECT_EQ(carl("study demo").status, 2) << "never twice";
    const Outcome status = carl("--json study status face_content_validity");
    EXPECT_EQ(number_in(status.out, "total"), 8);
    EXPECT_EQ(number_in(status.out, "done"), 3) << "consent and two questionnaires";
    EXPECT_THAT(status.out, HasSubstr("\"next\": \"briefing\""));

    // A person's way through the protocol, and what is refused on it.
    const Outcome enrolled = carl("study enrol face_content_validity");
    const std::string code = enrolled.out.substr(0, 6);
    EXPECT_EQ(code.substr(0, 4), "P015") << enrolled.out;
    const std::string answer = "study answer face_content_validity " + code + " ";
    EXPECT_THAT(carl(answer + "sus sus01=5").err, HasSubstr("needs an answer"));
    const std::string sus =
        "sus sus01=5 sus02=4 sus03=2 sus04=1 sus05=2 sus06=3 sus07=2 sus08=4 sus09=5 sus10=2";
    EXPECT_THAT(carl(answer + sus).err, HasSubstr("has not consented"));
    const std::string consent = "study consent face_content_validity " + code + " --agreed read";
    EXPECT_THAT(carl(consent).err, HasSubstr("\"voluntary\" is required"));
    EXPECT_EQ(carl(consent + " voluntary data").status, 0);
    const Outcome answered = carl("--json " + answer + sus);
    EXPECT_EQ(answered.status, 0) << answered.err;
    EXPECT_EQ(number_in(answered.out, "sus_score"), 55);
    EXPECT_EQ(carl("study step face_content_validity " + code + " nap").status, 2);
    EXPECT_EQ(carl("study step face_content_validity P015-Z briefing").status, 2);
    EXPECT_EQ(carl("study step face_content_validity " + code + " briefing").status, 0);
    EXPECT_EQ(
        carl("study withdraw face_content_validity " + code + " --mode stop --reason 'not given'")
            .status,
        0);
    EXPECT_EQ(carl(answer + sus).status, 2) << "nothing more is recorded";

    for (const char* format : {"csv", "spss", "redcap", "fhir", "odm", "xapi", "bundle"}) {
        const Outcome exported = carl(std::string("--json export ") + format +
                                      " --study face_content_validity --out " + format);
        EXPECT_EQ(exported.status, 0) << exported.err;
        EXPECT_THAT(exported.out, AllOf(HasSubstr("\"read_back\": \"identical\""),
                                        HasSubstr("\"demonstration\": true"),
                                        HasSubstr("\"participants_left_out\": 1")));
    }
    EXPECT_EQ(carl("export motion-bids --study face_content_validity").status, 2) << "no attempts";
    const Outcome report = carl("--json report study face_content_validity --out study.pdf");
    EXPECT_EQ(report.status, 0) << report.err;
    EXPECT_THAT(read_text(file("study.pdf")), testing::StartsWith("%PDF-"));
    EXPECT_TRUE(fs::exists(file("study_figures/likert_face_validity_1.svg")));
    EXPECT_EQ(carl("report study none --out none.pdf").status, 2);
    EXPECT_FALSE(fs::exists(file("none.pdf")));
    EXPECT_EQ(carl("export word --study face_content_validity").status, 2);
    const std::string wide = read_text(file("csv/face_content_validity_face_validity.csv"));
    EXPECT_THAT(wide, Not(HasSubstr(code)));
    // Names of persons: a coordinator may not, and the reason is needed.
    EXPECT_THAT(carl("export csv --study face_content_validity --identifying 'audit of 2026'").err,
                HasSubstr("personal data"));
    EXPECT_EQ(ctl("export csv --study face_content_validity --identifying no").status, 2);
    EXPECT_EQ(ctl("export csv --study face_content_validity --out n --identifying 'audit of 2026'")
                  .status,
              0);
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("WITH IDENTIFYING FIELDS: audit of 2026"),
                                        HasSubstr("study.withdraw")));
    EXPECT_THAT(carl("questionnaire list").out, AllOf(HasSubstr("sus"), HasSubstr("first use")));
    write_text(file("q.json"), R"({"id":"sus","version":1,"title":{"en":"x"},"items":[
        {"id":"a","kind":"text","text":{"en":"x"}}]})");
    EXPECT_THAT(carl("questionnaire publish q.json").err, HasSubstr("next version"));
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

// --- placode-sim -------------------------------------------------------------------------------

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
    EXPECT_EQ(ctl("score a.placode --task diathermy_ring_small").status, 0);
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

TEST_F(Programs, StatisticsAnswerWithNAndNameTheWrongCell) {
    const std::string table =
        std::string(PLACODE_SOURCE_DIR) + "/tests/data/statistics/likert_bfi.csv";
    const Outcome alpha = ctl("--json stats alpha " + table + " --reverse A1 --scale 1:6");
    ASSERT_EQ(alpha.status, 0) << alpha.err;
    EXPECT_EQ(number_in(alpha.out, "n"), 80);
    EXPECT_NEAR(number_in(alpha.out, "raw"), 0.645699152542373, 1e-9);  // psych::alpha
    write_text(file("bad.csv"), "A,B\n1,2\n3,four\n5,6\n");
    const Outcome bad = ctl("stats alpha bad.csv");
    EXPECT_EQ(bad.status, 2);
    EXPECT_THAT(bad.err, AllOf(HasSubstr("bad.csv"), HasSubstr("line 3"), HasSubstr("column B"),
                               HasSubstr("four")));
    EXPECT_EQ(ctl("stats nothing " + table).status, 2);
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
}
