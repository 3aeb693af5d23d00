// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where a slit leaks, read from the events of a recording: stations, bites beside them, the place.
#include "assessment/leak_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "assessment/closure.h"
#include "assessment/loci.h"
#include "assessment/scoring.h"
#include "assessment/tissue_metrics.h"
#include "tests/leaky_slit.h"

namespace placode::assessment {
namespace THIS_TEST {

using test::leaky_slit;
using test::LeakySlit;
using test::upright;
using test::without_burst_list;

constexpr double kMl = 1 / kMlMinPerM3S;

std::optional<LeakPlace> worst(const sim::Recording& recording, LeakStage stage) {
    const auto map = leak_map(recording);
    return map ? worst_leak(*map, stage) : std::nullopt;
}

TEST(LeakMap, StationsRunFromTheLeftEndAndAddUpToTheWhole) {
    const auto map = leak_map(leaky_slit());
    ASSERT_TRUE(map && map->whole);
    ASSERT_EQ(map->stations.size(), 23U);
    EXPECT_FALSE(map->upright);
    // Station 0 of the recording lies right, at -y.
    EXPECT_EQ(map->stations.front().number, 22);
    EXPECT_NEAR(map->stations.front().at_m.y(), 0.0055, 1e-8);
    EXPECT_NEAR(map->stations.front().along_m, 0.0005, 1e-8);
    EXPECT_NEAR(map->stations.back().along_m, 0.0115, 1e-7);
    EXPECT_NEAR(map->length_m, 0.012, 1e-7);
    double length_m = 0;
    PerStage sum{};
    for (const LeakStation& station : map->stations) {
        length_m += station.length_m;
        for (size_t i = 0; i < kLeakStages; ++i) sum[i] += station.leak_m3_s[i];
    }
    EXPECT_NEAR(length_m, 0.011, 1e-7) << "nothing is counted beside the ends";
    for (size_t i = 0; i < kLeakStages; ++i) {
        EXPECT_GT(sum[i], 0);
        EXPECT_NEAR(sum[i] / map->all_m3_s[i], 1, 1e-5) << i;
    }
}

TEST(LeakMap, TheBitesAreSeenFromTheSameEnd) {
    const auto map = leak_map(leaky_slit());
    ASSERT_TRUE(map);
    ASSERT_EQ(map->bites.size(), 3U);
    for (int i = 0; i < 3; ++i) {
        const LeakBite& bite = map->bites[static_cast<size_t>(i)];
        EXPECT_EQ(bite.number, i + 1);
        EXPECT_TRUE(bite.entered && bite.left && bite.done);
        EXPECT_NEAR(bite.along_m(), 0.002 + 0.004 * i, 1e-7) << "bite 1 lies left";
        // In at +x, which the scope shows above.
        EXPECT_NEAR(bite.entry_m.y(), 0.003, 1e-7);
        EXPECT_NEAR(bite.exit_m.y(), -0.003, 1e-7);
    }
}

TEST(LeakMap, TheWorstPlaceLiesBetweenTheBitesWhereMostPasses) {
    const auto place = worst(leaky_slit(), LeakStage::kGood);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->between.before, 2);
    EXPECT_EQ(place->between.after, 3);
    EXPECT_EQ(place->stretch, 2);
    EXPECT_NEAR(place->along_m, 0.008, 1e-7);
    EXPECT_NEAR(place->leak_m3_s / (12 * kMl), 1, 1e-5) << "of the stretch, not of one station";
    EXPECT_NEAR(place->rest_m3_s, 0.4 * kMl, 1e-4 * kMl);
    // At the lower pressure only the first stretch leaks, and it bursts at the last.
    const auto lower = worst(leaky_slit(), LeakStage::kPass),
               burst = worst(leaky_slit(), LeakStage::kLast);
    ASSERT_TRUE(lower && burst);
    EXPECT_EQ(lower->between, (BetweenBites{0, 1, false}));
    EXPECT_EQ(lower->stretch, 0);
    EXPECT_EQ(burst->between, (BetweenBites{3, 0, false}));
    EXPECT_NEAR(burst->along_m, 0.011, 1e-7);
}

/// The stretch is what a bite would have shut, and not its worst station.
TEST(LeakMap, AStationMayLeakMoreThanAnyOtherAndItsStretchLess) {
    LeakySlit slit;
    slit.good_ml_min = std::vector<double>(23, 0);
    slit.good_ml_min[22] = 3;  // the leftmost alone
    for (const size_t i : {7U, 8U, 9U, 10U}) slit.good_ml_min[i] = 2;
    const auto place = worst(leaky_slit(slit), LeakStage::kGood);
    ASSERT_TRUE(place);
    EXPECT_NE(place->between.before, 0) << "8 ml/min pass elsewhere";
    EXPECT_GT(place->leak_m3_s, 5 * kMl);
}

TEST(LeakMap, ASlitThatRunsUpAndDownHasAnUpperEnd) {
    const auto map = leak_map(upright(leaky_slit()));
    ASSERT_TRUE(map);
    EXPECT_TRUE(map->upright);
    EXPECT_GT(map->stations.front().at_m.x(), map->stations.back().at_m.x()) << "+x is up";
    const auto place = worst_leak(*map, LeakStage::kPass);
    ASSERT_TRUE(place);
    EXPECT_STREQ(between_pattern(place->between), " between the upper end and bite %1");
}

TEST(LeakMap, MetricsLociAndReasonsSayThePlace) {
    const sim::Recording recording = leaky_slit();
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_NEAR(*set.find("slit_leak_worst_mm"), 8, 1e-4);
    EXPECT_EQ(*set.find("slit_leak_worst_stretch"), 2);
    EXPECT_NEAR(*set.find("slit_burst_mm"), 11, 1e-4);
    EXPECT_NEAR(*set.find("slit_leak_12_ml_min"), 12.4, 1e-4);
    // +y is left: 8 mm from the left end of a slit from +6 to -6 mm.
    EXPECT_NEAR(locate("slit_leak_worst_mm", 0, recording).at_m->y(), -0.002, 1e-7);
    EXPECT_NEAR(locate("slit_burst_mm", 0, recording).at_m->y(), -0.005, 1e-7);
    EXPECT_EQ(locate("slit_leak_6_ml_min", 0, recording).between, (BetweenBites{0, 1, false}));
    EXPECT_FALSE(locate("slit_gap_widest_mm", 0, recording).between.any());
    Rubric rubric;
    rubric.items.emplace_back();
    rubric.items[0].id = "burst";
    rubric.items[0].metric = "slit_burst_cmh2o";
    rubric.items[0].reason = "It broke through{where} at {value} cmH2O.";
    rubric.items[0].threshold = 12.5;
    rubric.items[0].points_per_unit = 1;
    rubric.items[0].below = true;
    const Score score = score_attempt(rubric, set, recording);
    ASSERT_EQ(score.reasons.size(), 1U);
    EXPECT_EQ(score.reasons[0].text,
              "It broke through between bite 3 and the right end at 10.1 cmH2O.");
    EXPECT_NEAR(score.points, 100 - 2.4, 1e-9) << "a place costs nothing";
}

TEST(LeakMap, BitesThatWentBackAreNamedInTheirOrder) {
    BetweenBites between{3, 2, false};
    EXPECT_STREQ(between_pattern(between), " between bites %1 and %2");
    EXPECT_EQ(between_numbers(between), std::pair(2, 3));
    ReasonMeaning meaning;
    meaning.pattern = "Open{where}.";
    meaning.hour = 11;
    meaning.between = between;
    EXPECT_EQ(english_words(meaning, 0), "Open between bites 2 and 3.");
    meaning.between = {};
    EXPECT_EQ(english_words(meaning, 0), "Open at 11 o'clock.");
    EXPECT_EQ(between_numbers({0, 1, false}), std::pair(1, 0));
}

TEST(LeakMap, OfABiteThatWasNotFinishedNothingIsHeld) {
    sim::Recording recording = leaky_slit();
    std::erase_if(recording.events, [](const sim::Event& e) {
        return e.kind == sim::EventKind::kNeedleThrough && e.hash == 2;
    });
    const auto map = leak_map(recording);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->bites.size(), 3U) << "it is drawn all the same";
    EXPECT_FALSE(map->bites[1].done);
    EXPECT_EQ(worst_leak(*map, LeakStage::kGood)->between, (BetweenBites{1, 3, false}));
}

TEST(LeakMap, WithoutBitesNoneIsNamed) {
    sim::Recording recording = leaky_slit();
    std::erase_if(recording.events, [](const sim::Event& e) { return e.time_s < 30; });
    const auto place = worst(recording, LeakStage::kGood);
    ASSERT_TRUE(place);
    EXPECT_FALSE(place->between.any());
    EXPECT_NEAR(place->leak_m3_s / (12.4 * kMl), 1, 1e-5) << "one stretch from end to end";
    EXPECT_NEAR(place->along_m, 0.008, 1e-7);
}

/// As the program before this one recorded it.
TEST(LeakMap, AnOlderRecordingHasTheLeaksAndNotTheBurst) {
    const sim::Recording old = without_burst_list(leaky_slit());
    const auto map = leak_map(old);
    ASSERT_TRUE(map);
    EXPECT_FALSE(map->whole || map->burst);
    EXPECT_TRUE(worst_leak(*map, LeakStage::kGood));
    EXPECT_FALSE(worst_leak(*map, LeakStage::kLast));
    MetricSet set;
    add_closure_metrics(old, set.values);
    EXPECT_TRUE(set.find("slit_leak_worst_mm"));
    EXPECT_FALSE(set.find("slit_burst_mm"));
    EXPECT_NEAR(*set.find("slit_burst_cmh2o"), 10.1, 1e-9) << "as before";
    const auto unknown = not_recorded(old), known = not_recorded(leaky_slit());
    EXPECT_EQ(std::count(unknown.begin(), unknown.end(), "slit_burst_mm"), 1);
    EXPECT_EQ(std::count(known.begin(), known.end(), "slit_burst_mm"), 0);
    EXPECT_EQ(locate("slit_burst_cmh2o", 12.5, old).between, (BetweenBites{0, 1, false}))
        << "where it leaks at the lower pressure";
}

TEST(LeakMap, WithoutATestOrWithHalfOfOneThereIsNone) {
    EXPECT_FALSE(leak_map({}));
    sim::Recording untested = leaky_slit();
    std::erase_if(untested.events,
                  [](const sim::Event& e) { return e.kind == sim::EventKind::kWatertight; });
    EXPECT_FALSE(leak_map(untested));
    sim::Recording broken = leaky_slit();
    const auto end = std::find_if(broken.events.begin(), broken.events.end(), [](const auto& e) {
        return e.kind == sim::EventKind::kWatertight && e.element == -2;
    });
    broken.events.erase(end, broken.events.end());
    EXPECT_FALSE(leak_map(broken));
    MetricSet set;
    add_closure_metrics(broken, set.values);
    EXPECT_FALSE(set.find("slit_leak_worst_mm"));
}

TEST(LeakMap, WhatHeldBurstNowhere) {
    LeakySlit slit;
    slit.burst = false;
    slit.pass_ml_min = slit.good_ml_min = slit.last_ml_min = std::vector<double>(23, 0);
    const sim::Recording recording = leaky_slit(slit);
    const auto map = leak_map(recording);
    ASSERT_TRUE(map && map->whole);
    EXPECT_FALSE(map->burst);
    for (const LeakStage stage : {LeakStage::kPass, LeakStage::kGood, LeakStage::kLast})
        EXPECT_FALSE(worst_leak(*map, stage));
    MetricSet set;
    add_closure_metrics(recording, set.values);
    EXPECT_FALSE(set.find("slit_leak_worst_mm") || set.find("slit_burst_mm"));
}

TEST(LeakMap, OddNumbersEndNothing) {
    const float odd[]{std::numeric_limits<float>::quiet_NaN(),
                      std::numeric_limits<float>::infinity(), -1};
    for (const float number : odd) {
        for (const int what : {0, 1, 2}) {
            sim::Recording recording = leaky_slit();
            for (sim::Event& e : recording.events) {
                if (e.element != 11) continue;
                (what == 0 ? e.value : what == 1 ? e.value2 : e.rest_position_m[1]) = number;
            }
            MetricSet set;
            EXPECT_NO_THROW(add_closure_metrics(recording, set.values));
            EXPECT_NO_THROW((void)locate("slit_burst_mm", 0, recording));
        }
    }
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
