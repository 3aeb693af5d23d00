// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that every shipped rubric keeps, over generated attempts: nothing done is nothing earned,
// more harm never pays, more of what is asked never costs, and every lost point can be looked up.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "assessment/loci.h"
#include "assessment/scoring.h"
#include "assessment/themes.h"
#include "assessment/tissue_metrics.h"
#include "assessment/wanted_metrics.h"
#include "curriculum/definitions.h"
#include "tests/generated_attempts.h"

namespace placode {
namespace THIS_TEST {

using assessment::MetricSet;
using assessment::Score;
using assessment::Verdict;
using test::AttemptMaker;

constexpr int kAttempts = 25;
constexpr double kNoReason = 0.05;  ///< Points below which a line is left out.

/// What the rubric looks at: filtering tracks of an hour that no line asks for takes most of the
/// time. That the score is that of all metrics is asked for below.
MetricSet metrics_for(const curriculum::Task& task, const sim::Recording& recording) {
    return assessment::compute_metrics(recording, assessment::metrics_of(task.rubric));
}

Score score_of(const curriculum::Task& task, const sim::Recording& recording) {
    return assessment::score_attempt(task.rubric, metrics_for(task, recording), recording);
}

sim::Recording done(const curriculum::Task& task, double share) {
    sim::Recording recording = AttemptMaker::idle(task);
    AttemptMaker::ask(recording, share);
    return recording;
}

bool asks_for(const curriculum::Task& task, const std::string& metric) {
    for (const auto& item : task.rubric.items)
        if (item.metric == metric && item.earns > 0) return true;
    return false;
}

std::string told(const Score& score) {
    std::string text;
    for (const auto& reason : score.reasons)
        text += "\n  " + std::to_string(reason.points) + " " + reason.text;
    return text;
}

class ScoringProperties : public testing::TestWithParam<std::string> {
 protected:
    curriculum::Task task = curriculum::load_task(GetParam());
};

TEST_P(ScoringProperties, NothingDoneIsNotAttemptedAndEarnsNothing) {
    const Score score = score_of(task, AttemptMaker::idle(task));
    EXPECT_EQ(score.verdict, Verdict::kNotAttempted);
    EXPECT_EQ(score.points, 0);
    ASSERT_EQ(score.reasons.size(), 1U);
    EXPECT_EQ(score.reasons[0].item, assessment::kNotAttemptedItem);
    EXPECT_EQ(score.reasons[0].points, 100);
}

TEST_P(ScoringProperties, AllDoneWithoutHarmEarnsEverything) {
    const Score score = score_of(task, done(task, 1));
    EXPECT_EQ(score.verdict, Verdict::kPassed) << told(score);
    EXPECT_EQ(score.points, 100) << told(score);
}

TEST_P(ScoringProperties, HalfDoneWithoutHarmEarnsAboutHalfAndNeverPasses) {
    const Score score = score_of(task, done(task, 0.5));
    EXPECT_GE(score.points, 40) << told(score);
    EXPECT_LE(score.points, 60) << told(score);
    EXPECT_NE(score.verdict, Verdict::kPassed);
    for (double share = 0; share < 0.65; share += 0.05)
        EXPECT_NE(score_of(task, done(task, share)).verdict, Verdict::kPassed) << share;
}

TEST_P(ScoringProperties, HarmWithoutWorkEarnsNothing) {
    AttemptMaker maker(4);
    for (size_t harm = 0; harm < AttemptMaker::kHarms; ++harm) {
        sim::Recording recording = AttemptMaker::idle(task);
        maker.harm(recording, harm);
        EXPECT_LT(score_of(task, recording).points, 1e-9) << harm;
    }
}

TEST_P(ScoringProperties, MoreHarmNeverRaisesTheScore) {
    AttemptMaker maker(11);
    for (int i = 0; i < kAttempts; ++i) {
        const sim::Recording before = maker.some(task);
        const Score first = score_of(task, before);
        for (size_t harm = 0; harm < AttemptMaker::kHarms; ++harm) {
            sim::Recording after = before;
            maker.harm(after, harm);
            const Score second = score_of(task, after);
            ASSERT_LE(second.points, first.points + 1e-9)
                << "attempt " << i << ", harm " << harm << told(first) << "\n->" << told(second);
            if (second.verdict == Verdict::kPassed) {
                ASSERT_EQ(first.verdict, Verdict::kPassed);
            }
        }
    }
}

TEST_P(ScoringProperties, MoreOfWhatIsAskedNeverLowersTheScore) {
    AttemptMaker maker(12);
    for (int i = 0; i < kAttempts; ++i) {
        const double less = maker.number(0, 1), more = maker.number(less, 1);
        sim::Recording first = AttemptMaker::idle(task), second = first;
        AttemptMaker::ask(first, less);
        AttemptMaker::ask(second, more);
        // The same harm in both.
        const auto seed = static_cast<uint32_t>(maker.whole(0, 1000000));
        const int harms = maker.whole(0, 6);
        for (sim::Recording* each : {&first, &second}) {
            AttemptMaker same(seed);
            for (int h = 0; h < harms; ++h)
                same.harm(*each, static_cast<size_t>(same.whole(0, AttemptMaker::kHarms - 1)));
        }
        const Score low = score_of(task, first), high = score_of(task, second);
        ASSERT_GE(high.points, low.points - 1e-9)
            << less << " to " << more << told(low) << "\n->" << told(high);
    }
}

/// Nothing happened that could be shown: a line that asks for what was not done at all.
bool can_be_shown(const assessment::RubricItem& item, const MetricSet& metrics) {
    return !(item.below && metrics.find(item.metric).value_or(0) == 0);
}

TEST_P(ScoringProperties, EveryLostPointCanBeLookedUpAndTheyAddUp) {
    AttemptMaker maker(13);
    std::set<std::string> seen;
    for (int i = 0; i < 2 * kAttempts; ++i) {
        const sim::Recording recording = maker.some(task);
        const MetricSet metrics = assessment::compute_metrics(recording);
        const Score score = assessment::score_attempt(task.rubric, metrics, recording);
        const Score by_wanted = score_of(task, recording);
        EXPECT_EQ(by_wanted.points, score.points);
        EXPECT_EQ(by_wanted.verdict, score.verdict);
        EXPECT_EQ(told(by_wanted), told(score));
        double lost = 0;
        for (const auto& reason : score.reasons) {
            lost += reason.points;
            EXPECT_EQ(reason.text.find('{'), std::string::npos) << reason.text;
            const auto item =
                std::find_if(task.rubric.items.begin(), task.rubric.items.end(),
                             [&](const auto& each) { return each.id == reason.item; });
            if (item == task.rubric.items.end() || !metrics.find(item->metric)) continue;
            seen.insert(reason.item);
            const auto locus = assessment::locate(item->metric, item->threshold, recording);
            if (can_be_shown(*item, metrics)) {
                EXPECT_TRUE(locus.at_m.has_value() || locus.time_s >= 0) << reason.text;
            }
            EXPECT_LE(reason.time_s, recording.end.duration_s) << reason.text;
        }
        if (score.points > 0) {
            EXPECT_NEAR(score.points + lost, 100, 1e-9) << told(score);
        } else {
            EXPECT_GE(lost, 100 - 1e-9);
        }
    }
    // The attempts are odd enough to meet most lines.
    EXPECT_GE(2 * seen.size(), task.rubric.items.size());
}

TEST_P(ScoringProperties, AMetricThatIsMissingNeverHelps) {
    AttemptMaker maker(14);
    for (int i = 0; i < 12; ++i) {
        const sim::Recording recording = i == 0 ? done(task, 1) : maker.some(task);
        const MetricSet metrics = metrics_for(task, recording);
        const Score whole = assessment::score_attempt(task.rubric, metrics, recording);
        for (const auto& item : task.rubric.items) {
            MetricSet less = metrics;
            std::erase_if(less.values, [&](const auto& one) { return one.id == item.metric; });
            const Score score = assessment::score_attempt(task.rubric, less, recording);
            EXPECT_LE(score.points, whole.points + 1e-9) << item.id;
            if (score.verdict == Verdict::kPassed) {
                EXPECT_EQ(whole.verdict, Verdict::kPassed) << item.id;
            }
            if (item.critical) {
                EXPECT_NE(score.verdict, Verdict::kPassed) << item.id;
            }
        }
    }
}

TEST_P(ScoringProperties, WhatAnOlderProgramDidNotRecordIsNamedAndIsNoPass) {
    sim::Recording old = done(task, 1);
    std::erase_if(old.events, [](const sim::Event& e) {
        return e.kind == sim::EventKind::kLedgerWritten || e.kind == sim::EventKind::kTakenOut ||
               e.kind == sim::EventKind::kMarkedLost || e.kind == sim::EventKind::kStretchSum;
    });
    const auto unknown = assessment::not_recorded(old);
    const Score score = score_of(task, old);
    for (const auto& item : task.rubric.items) {
        if (std::find(unknown.begin(), unknown.end(), item.metric) == unknown.end()) continue;
        const auto reason = std::find_if(score.reasons.begin(), score.reasons.end(),
                                         [&](const auto& each) { return each.item == item.id; });
        ASSERT_NE(reason, score.reasons.end()) << item.id;
        EXPECT_EQ(reason->points, 0) << "it is not turned into nothing";
        EXPECT_NE(reason->text.find("Not recorded"), std::string::npos);
        EXPECT_EQ(score.verdict, Verdict::kNotYet) << item.id;
    }
    EXPECT_GT(score.points, 0) << told(score);
}

TEST_P(ScoringProperties, PointsFollowTheMetricWithoutCliffs) {
    sim::Recording recording = done(task, 1);
    const MetricSet best = assessment::compute_metrics(recording);
    for (const auto& item : task.rubric.items) {
        EXPECT_EQ(item.points_fixed, 0) << item.id << " jumps";
        // All lines of this metric together.
        double slope = 0, most = item.threshold;
        for (const auto& other : task.rubric.items) {
            if (other.metric != item.metric) continue;
            slope += other.points_per_unit;
            if (other.earns > 0) slope += 100 / other.threshold;
            most = std::max(most, other.threshold);
            if (other.points_per_unit > 0)
                most = std::max(most,
                                other.threshold + 1.2 * other.max_points / other.points_per_unit);
        }
        const double step = most / 400;
        double before = -1;
        for (int k = 0; k <= 420; ++k) {
            MetricSet metrics = best;
            std::erase_if(metrics.values, [&](const auto& one) { return one.id == item.metric; });
            metrics.values.push_back({item.metric, k * step});
            const double points = assessment::score_attempt(task.rubric, metrics, recording).points;
            if (before >= 0) {
                ASSERT_LE(std::abs(points - before), slope * step + kNoReason + 1e-9)
                    << item.id << " at " << k * step;
            }
            before = points;
        }
    }
}

/// A slope can be as steep as a cliff: what is hardly there costs little.
TEST_P(ScoringProperties, ATraceOfABurnCostsLittle) {
    const sim::Recording recording = done(task, 1);
    const auto lost = [&](double percent) {
        MetricSet metrics = assessment::compute_metrics(recording);
        std::erase_if(metrics.values,
                      [](const auto& one) { return one.id == "placode_burned_percent"; });
        metrics.values.push_back({"placode_burned_percent", percent});
        return 100 - assessment::score_attempt(task.rubric, metrics, recording).points;
    };
    EXPECT_LE(lost(0.1), 5);
    EXPECT_LE(lost(0.2), 2 * lost(0.1) + kNoReason + 1e-9) << "in proportion from the beginning";
}

TEST_P(ScoringProperties, WhatDecidesInTheatreDecidesThePass) {
    const auto spoiled = [&](auto spoil) {
        sim::Recording recording = done(task, 1);
        spoil(recording);
        return score_of(task, recording).verdict;
    };
    if (asks_for(task, "marked_gone_percent")) {
        EXPECT_EQ(spoiled([](sim::Recording& r) {
                      std::erase_if(r.events, [](const auto& e) {
                          return e.kind == sim::EventKind::kTakenOut;
                      });
                      AttemptMaker::put(r, sim::EventKind::kTakenOut, 20, 3e-9, 0.77, 0.004, 0.002);
                  }),
                  Verdict::kFailed)
            << "23 % of the marked tissue are left";
    }
    if (asks_for(task, "released_deg")) {
        EXPECT_EQ(spoiled([](sim::Recording& r) {
                      for (sim::Event& e : r.events)
                          if (e.kind == sim::EventKind::kSectorFree && e.value == 7)
                              e.kind = sim::EventKind::kPhase;
                  }),
                  Verdict::kFailed)
            << "one sector holds the placode";
    }
    if (asks_for(task, "ring_completeness_percent")) {
        EXPECT_EQ(spoiled([](sim::Recording& r) { r.samples.back().cut_fraction = 0.94F; }),
                  Verdict::kFailed);
    }
    const auto with = [&](sim::EventKind kind, double value, sim::Tissue tissue) {
        return spoiled([&](sim::Recording& r) {
            AttemptMaker::put(r, kind, 12, value, 0.1, 0.003, 0.001, 0, tissue);
        });
    };
    bool blade = false, current = false;
    for (const auto& tool : task.scene.tools) {
        blade = blade || tool.kind == sim::ToolKind::kScissors;
        current = current || tool.kind == sim::ToolKind::kNeedle;
    }
    if (blade) {
        EXPECT_EQ(with(sim::EventKind::kPlacodeCut, 1e-7, sim::Tissue::kPlacode), Verdict::kFailed);
    }
    EXPECT_EQ(with(sim::EventKind::kTorn, 1e-11, sim::Tissue::kPlacode), Verdict::kFailed);
    if (!task.steps.empty()) return;  // exercises: nobody is operated on
    EXPECT_EQ(with(sim::EventKind::kTorn, 8e-9, sim::Tissue::kSkin), Verdict::kFailed);
    if (current) {
        EXPECT_EQ(with(sim::EventKind::kPlacodeEnergised, 0.2, sim::Tissue::kPlacode),
                  Verdict::kFailed);
    }
}

/// A bite through which the needle was not drawn is none, whatever was ticked off; and whoever ends
/// the attempt with the needle in the tissue has not sewn.
TEST_P(ScoringProperties, NobodyPassesWithABiteLeftOut) {
    const auto bites =
        std::count_if(task.steps.begin(), task.steps.end(), [](const curriculum::TaskStep& step) {
            return step.goal.kind == sim::PracticeKind::kNeedleIn;
        });
    if (bites == 0) return;
    for (int left_out = 0; left_out < bites; ++left_out) {
        sim::Recording recording = done(task, 1);
        int bite = 0;
        std::erase_if(recording.events, [&](const sim::Event& e) {
            return e.kind == sim::EventKind::kNeedleThrough && bite++ == left_out;
        });
        EXPECT_EQ(bite, bites);
        const Score score = score_of(task, recording);
        EXPECT_EQ(score.verdict, Verdict::kFailed) << left_out << told(score);
    }
    sim::Recording pinned = done(task, 1);
    AttemptMaker::put(pinned, sim::EventKind::kNeedleLeftIn, 30, 0, 0, 0.006, 0.002);
    EXPECT_EQ(score_of(task, pinned).verdict, Verdict::kFailed);
    const auto steps = static_cast<double>(task.steps.size());
    const bool drawn = task.steps.back().goal.kind == sim::PracticeKind::kThreadDraw;
    const Score early = score_of(task, done(task, (steps - (drawn ? 2 : 1)) / steps));
    EXPECT_NE(early.verdict, Verdict::kPassed) << told(early);
}

/// Gentleness sees torn and over-stretched tissue from any cause, in every task.
TEST_P(ScoringProperties, TornStretchedAndBuriedTissueCosts) {
    const auto lost = [&](sim::EventKind kind, double value, int element) {
        sim::Recording recording = done(task, 1);
        AttemptMaker::put(recording, kind, 12, value, 0.002, 0.004, 0.003).element = element;
        return 100 - score_of(task, recording).points;
    };
    EXPECT_GE(lost(sim::EventKind::kTorn, 5.9e-9, 7), 1);
    EXPECT_GE(lost(sim::EventKind::kStretchSum, 5e-8, 7), 1);
    EXPECT_GE(lost(sim::EventKind::kBuried, 2, -1), 2);
}

/// Wherever current can burn skin, it costs, beside the line and at the rim of the field alike: no
/// distance from the plan makes it nobody's business.
TEST_P(ScoringProperties, BurnedHealthySkinCostsHoweverFarFromTheLine) {
    const bool current =
        std::any_of(task.scene.tools.begin(), task.scene.tools.end(), [](const auto& tool) {
            return tool.kind == sim::ToolKind::kNeedle || tool.kind == sim::ToolKind::kHook;
        });
    if (!current) return;  // nothing burns here
    for (const double beyond_m : {0.0041, 0.006, 0.03}) {
        const auto burned = [&](double volume_m3) {
            sim::Recording recording = done(task, 1);
            AttemptMaker::put(recording, sim::EventKind::kVaporised, 12, volume_m3, 0.0002,
                              0.006 + beyond_m, 0, 0, sim::Tissue::kSkin);
            return score_of(task, recording);
        };
        const Score little = burned(2.5e-9), much = burned(2e-8);
        EXPECT_LE(little.points, 95) << beyond_m << told(little);
        EXPECT_LE(much.points, 80) << beyond_m << told(much);
        // Exercises: nobody is operated on.
        if (task.steps.empty()) {
            EXPECT_EQ(much.verdict, Verdict::kFailed) << beyond_m;
        }
    }
}

bool judges(const curriculum::Task& task, std::string_view metric) {
    return std::any_of(task.rubric.items.begin(), task.rubric.items.end(),
                       [&](const auto& item) { return item.metric == metric; });
}

/// No amount of a harm is free: the next one costs more, up to the cap of its line.
TEST_P(ScoringProperties, MoreOfOneHarmCostsMore) {
    using sim::EventKind;
    const auto rises = [&](const char* metric, std::initializer_list<double> amounts, auto add) {
        if (!judges(task, metric)) return;
        double before = 0;
        for (const double amount : amounts) {
            sim::Recording recording = done(task, 1);
            add(recording, amount);
            AttemptMaker::sort(recording);
            const Score score = score_of(task, recording);
            EXPECT_GT(100 - score.points, before + kNoReason)
                << metric << " " << amount << told(score);
            before = 100 - score.points;
        }
    };
    const auto lasting = [](EventKind kind, double value2) {
        return [=](sim::Recording& r, double seconds) {
            AttemptMaker::put(r, kind, 29, seconds, value2, 0.004, 0.003);
        };
    };
    rises("over_force_count", {0.05, 1, 2, 3}, lasting(EventKind::kOverForce, 0.05));
    rises("over_traction_count", {0.3, 1, 2, 3}, lasting(EventKind::kOverTraction, 0.02));
    rises("placode_contact_s", {0.5, 2, 5, 9}, lasting(EventKind::kPlacodeContact, 0.005));
    rises("crush_count", {0.1, 0.8, 1.6}, [](sim::Recording& r, double seconds) {
        AttemptMaker::put(r, EventKind::kCrushed, 29.9 - seconds, 2e5, 1, 0.004, 0.003);
    });
    rises("torn_volume_mm3", {1, 4, 9, 16, 19}, [](sim::Recording& r, double mm3) {
        AttemptMaker::put(r, EventKind::kTorn, 12, 1e-9 * mm3, 2, 0.004, 0.003);
    });
    rises("skin_heat_j", {4.8, 9, 15}, [](sim::Recording& r, double joules) {
        AttemptMaker::heat(r, static_cast<int>(std::lround(joules / 0.6)), 0.014, 0);
    });
    rises("trace_error_mm", {1, 4, 7}, [](sim::Recording& r, double stretches) {
        for (int bin = 0; bin < static_cast<int>(stretches); ++bin)
            AttemptMaker::put(r, EventKind::kTraced, 20, 3 * bin, 0.005);
    });
}

/// To stay on the placode costs by the second, wherever a touch of it costs.
TEST_P(ScoringProperties, WhereATouchOfThePlacodeCountsItsTimeDoes) {
    EXPECT_EQ(judges(task, "placode_contacts"), judges(task, "placode_contact_s"));
}

/// Far beyond what a hand tears by mischance nothing else makes up for it.
TEST_P(ScoringProperties, FarTooMuchTornTissueFails) {
    sim::Recording recording = done(task, 1);
    AttemptMaker::put(recording, sim::EventKind::kTorn, 12, 1e-7, 2, 0.004, 0.003);
    const Score score = score_of(task, recording);
    EXPECT_EQ(score.verdict, Verdict::kFailed) << told(score);
}

/// Current held on healthy skin burns it, whether or not any is removed.
TEST_P(ScoringProperties, HeatedHealthySkinCosts) {
    if (!judges(task, "skin_burned_mm3")) return;  // nothing burns here
    sim::Recording recording = done(task, 1);
    AttemptMaker::heat(recording, 60, 0.014, 0);
    const Score score = score_of(task, recording);
    EXPECT_LE(score.points, 80) << told(score);
    // The first exercise fails nobody for it.
    if (task.steps.empty()) {
        EXPECT_EQ(score.verdict, Verdict::kFailed) << told(score);
    }
}

/// "Gentle with tissue, no points lost" is not said over 2 mm3 that tore, nor over a tip in tissue.
TEST_P(ScoringProperties, WhoTearsOrBuriesIsNotCalledGentle) {
    const auto judged = [&](sim::EventKind kind, double value) {
        sim::Recording recording = done(task, 1);
        if (value > 0) AttemptMaker::put(recording, kind, 12, value, 0.002, 0.004, 0.003);
        for (const auto& each :
             assessment::judge_themes(task.rubric, score_of(task, recording).reasons, {}))
            if (each.theme == assessment::Theme::kTissue) return each.judgement;
        return assessment::ThemeResult::Judgement::kNeither;
    };
    using Judgement = assessment::ThemeResult::Judgement;
    EXPECT_EQ(judged(sim::EventKind::kTorn, 0), Judgement::kStrength);
    EXPECT_NE(judged(sim::EventKind::kTorn, 2e-9), Judgement::kStrength);
    EXPECT_NE(judged(sim::EventKind::kBuried, 1), Judgement::kStrength);
}

INSTANTIATE_TEST_SUITE_P(Tasks, ScoringProperties,
                         testing::ValuesIn(curriculum::list_definitions("tasks")),
                         [](const auto& each) { return each.param; });

}  // namespace THIS_TEST
}  // namespace placode
