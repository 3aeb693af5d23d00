// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl metrics, contour and stats on files of signals and tables: closed forms and published
// values, and what bad files get.

#include <gmock/gmock.h>

#include <cmath>

#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

test::World* const world = test::World::install();

TEST_F(Programs, ATableOfAnotherSpreadsheetIsNamedAsWhatItIs) {
    const std::pair<std::string, const char*> tables[]{
        {"\xef\xbb\xbft_s;speed_mm_s\r\n0,00;1,5\r\n0,01;2,5\r\n", "found semicolons between"},
        {"t_s\tspeed_mm_s\n0\t1\n0.01\t2\n", "found tabs between"},
        {std::string("\xff\xfet\0,\0v\0\n\0", 10), "found UTF-16; expected UTF-8"}};
    for (const auto& [text, said] : tables) {
        write_text(file("a.csv"), text);
        for (const char* command : {"metrics a.csv", "stats alpha a.csv"}) {
            const Outcome refused = ctl(command);
            EXPECT_EQ(refused.status, 2) << command;
            EXPECT_THAT(refused.err, HasSubstr(std::string("a.csv: line 1: ") + said)) << command;
        }
    }
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
    write_text(file("gap.csv"), "A,B\n\n1,2\n3,four\n");
    EXPECT_THAT(ctl("stats alpha gap.csv").err, HasSubstr("line 4")) << "the line of the file";
    write_text(file("open.csv"), "A,B\n1,\"2\n");
    EXPECT_THAT(ctl("stats alpha open.csv").err,
                HasSubstr("open.csv: line 2, column 2: a quoted cell is not closed"));
    EXPECT_EQ(ctl("stats nothing " + table).status, 2);
    // Two scores lie on a line: how far its slope may be off, nobody can tell.
    write_text(file("two.csv"), "score\n70\n80\n");
    const Outcome two = ctl("--json stats learning-curve two.csv");
    EXPECT_EQ(two.status, 0) << two.err;
    EXPECT_THAT(two.out, HasSubstr("\"last10_slope_ci95\": null"));
    EXPECT_EQ(number_in(two.out, "mean_last10"), 75);
}

TEST_F(Programs, ReverseKeyedItemsAreTurnedRoundOnTheScaleThatIsReported) {
    // Nobody answered 1: on 2 to 5 the item B would be 5, 5 and 4.
    write_text(file("items.csv"), "A,B\n5,2\n4,2\n5,3\n");
    for (const char* scale : {"", " --scale 1:5"}) {
        const Outcome likert =
            ctl("--json stats likert items.csv --reverse B" + std::string(scale));
        ASSERT_EQ(likert.status, 0) << likert.err;
        const size_t at = likert.out.find("scale_mean");
        ASSERT_NE(at, std::string::npos) << likert.out;
        EXPECT_NEAR(number_in(likert.out.substr(at), "mean"), 25.0 / 6, 1e-9) << scale;
        EXPECT_NEAR(number_in(likert.out, "chisq"), 2, 1e-9) << scale;
        EXPECT_NEAR(number_in(likert.out, "p"), 0.157299207050285, 1e-9) << scale;
        EXPECT_NEAR(number_in(likert.out, "kendall_W"), 2.0 / 3, 1e-9) << scale;
    }
}

}  // namespace THIS_TEST
