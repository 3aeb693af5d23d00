// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/tissue_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/cutting/attempt_progress.h"
#include "sim/ledger/damage.h"
#include "tests/reference_data.h"

namespace placode::assessment {
namespace THIS_TEST {

using namespace testing_data;

std::vector<Vec3> polyline(const std::string& file) {
    const auto x = column(file, "x_mm"), y = column(file, "y_mm");
    std::vector<Vec3> points;
    for (size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i], 0);
    return points;
}

TEST(TissueMetrics, ContoursCompareAsTheReference) {
    const auto expected = json("tissue/contour_expected.json");
    const std::vector<Vec3> plan = polyline("tissue/contour_plan.csv");
    for (const char* name : {"concentric", "offset", "arc_with_gap"}) {
        const auto& values = expected[name];
        const ContourComparison c =
            compare_contours(plan, polyline(std::string("tissue/contour_") + name + ".csv"), 1);
        EXPECT_NEAR(c.mean_abs, values["mean_abs_dev_mm"].get<double>(), 1e-9) << name;
        EXPECT_NEAR(c.rms, values["rms_mm"].get<double>(), 1e-9) << name;
        EXPECT_NEAR(c.max, values["max_mm"].get<double>(), 1e-9) << name;
        EXPECT_NEAR(c.hausdorff_cut_to_plan,
                    values["directed_hausdorff_pointset_cut_to_plan"].get<double>(), 1e-9);
        EXPECT_NEAR(c.hausdorff_plan_to_cut,
                    values["directed_hausdorff_pointset_plan_to_cut"].get<double>(), 1e-9);
        EXPECT_NEAR(c.hausdorff, values["symmetric_hausdorff_pointset"].get<double>(), 1e-9);
    }
}

TEST(TissueMetrics, AGapOf25DegreesIsFound) {
    const auto expected = json("tissue/contour_expected.json")["closed_form"];
    const ContourComparison gap = compare_contours(polyline("tissue/contour_plan.csv"),
                                                   polyline("tissue/contour_arc_with_gap.csv"), 1);
    // The plan is a 720-gon and the cut another one: half a segment of it each end.
    EXPECT_NEAR(gap.completeness, expected["arc_completeness_angular"].get<double>(), 2e-4);
    EXPECT_NEAR(gap.largest_gap, expected["largest_gap_arc_mm_on_plan"].get<double>(), 0.01);
    EXPECT_EQ(gap.gaps, 1);
    EXPECT_GT(gap.mean_signed, 0.49);
    const ContourComparison whole = compare_contours(polyline("tissue/contour_plan.csv"),
                                                     polyline("tissue/contour_concentric.csv"), 1);
    EXPECT_NEAR(whole.completeness, 1, 1e-9);
    EXPECT_EQ(whole.gaps, 0);
    // Out of tolerance, nothing counts.
    EXPECT_EQ(compare_contours(polyline("tissue/contour_plan.csv"),
                               polyline("tissue/contour_concentric.csv"), 0.4)
                  .completeness,
              0);
}

TEST(TissueMetrics, SignedDistanceIsNegativeInsideWhicheverWayTheLineRuns) {
    std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (int path = 0; path < 2; ++path) {
        const ClosedContour contour(square);
        EXPECT_DOUBLE_EQ(contour.length(), 4);
        EXPECT_DOUBLE_EQ(contour.nearest({0.5, 0.25}).offset, -0.25);
        EXPECT_DOUBLE_EQ(contour.nearest({0.5, -0.25}).offset, 0.25);
        EXPECT_DOUBLE_EQ(contour.nearest({1.3, 1.4}).offset, 0.5);
        EXPECT_NEAR((contour.at(contour.nearest({1.2, 0.25}).arc) - Vec2(1, 0.25)).norm(), 0,
                    1e-12);
        std::reverse(square.begin(), square.end());
    }
}

TEST(TissueMetrics, ArcCoverUnitesOverlapsAndPassesTheEnd) {
    ArcCover cover(10);
    EXPECT_EQ(cover.result().gaps, 1);
    EXPECT_EQ(cover.result().largest_gap, 10);
    cover.add(9, 11);
    cover.add(0.5, 2);
    cover.add(4, 5);
    const ArcCover::Result r = cover.result();
    EXPECT_NEAR(r.covered, 0.4, 1e-12);  // 9..12 and 4..5
    EXPECT_EQ(r.gaps, 2);
    EXPECT_NEAR(r.largest_gap, 4, 1e-12);
    EXPECT_NEAR(r.gap_middle, 7, 1e-12);
    cover.add(-3, 30);
    EXPECT_EQ(cover.result().covered, 1);
    EXPECT_EQ(cover.result().gaps, 0);
}

TEST(TissueMetrics, ThermalDoseAndArrheniusAreTheReference) {
    const auto expected = json("tissue/thermal_expected.json");
    const auto& skin = expected["parameters"]["skin_HenriquesMoritz1947"];
    const double a = skin["A_per_s"], ea = skin["Ea_J_mol"];
    for (const auto& row : expected["constant"]) {
        const std::vector<double> time{0, row["duration_s"]};
        const std::vector<double> temperature(2, row["T_C"].get<double>());
        const double dose = row["cem43_min"], omega = row["Omega_skin_HenriquesMoritz1947"];
        EXPECT_NEAR(cem43_min(time, temperature), dose, 1e-9 * dose);
        EXPECT_NEAR(arrhenius_damage(time, temperature, a, ea), omega, 1e-9 * omega);
    }
    const auto& ramp = expected["ramp"][0];
    const auto time = column("tissue/thermal_ramp0_100hz.csv", "t_s");
    const auto temperature = column("tissue/thermal_ramp0_100hz.csv", "T_C");
    const double dose = ramp["cem43_trapz_100hz"];
    EXPECT_NEAR(cem43_min(time, temperature), dose, 1e-9 * dose);
    EXPECT_NEAR(arrhenius_damage(time, temperature, a, ea),
                ramp["Omega_trapz_100hz_skin_HenriquesMoritz1947"].get<double>(), 1e-9);
}

TEST(TissueMetrics, ForceSummaryOfASquaredSine) {
    std::vector<double> time, force;
    for (int k = 0; k <= 4000; ++k) {
        time.push_back(k * 0.001);
        const double s = std::sin(std::numbers::pi * time.back() / 4);
        force.push_back(2 * s * s);
    }
    const auto expected = json("tissue/force_expected.json");
    const ForceSummary f = summarise_force(time, force, 1);
    EXPECT_NEAR(f.peak_n, 2, 1e-12);
    EXPECT_NEAR(f.mean_n, 1, 1e-9);
    EXPECT_NEAR(f.rms_n, expected["rms_N"].get<double>(), 1e-9);
    EXPECT_NEAR(f.impulse_n_s, 4, 1e-9);
    EXPECT_NEAR(f.over_s, expected["time_over_threshold_s_exact"].get<double>(), 2e-3);
    // Lines between samples: h^2 / 12 times the change of slope, pi, is 2.6e-7.
    EXPECT_NEAR(f.excess_impulse_n_s, expected["excess_impulse_Ns_exact"].get<double>(), 3e-7);
}

TEST(TissueMetrics, ForceBeyondALimitIsMeasuredFromWhereItsLineCrosses) {
    const std::vector<double> time{0, 1, 2, 3}, force{0, 2, 0, 1};
    const ForceSummary f = summarise_force(time, force, 1);
    EXPECT_DOUBLE_EQ(f.over_s, 1);
    EXPECT_DOUBLE_EQ(f.excess_impulse_n_s, 0.5);
    EXPECT_DOUBLE_EQ(summarise_force(time, force, 0).excess_impulse_n_s, f.impulse_n_s);
}

// --- of a recording ---------------------------------------------------------------------------

constexpr double kRadius = 0.006;

std::vector<Vec3> circle(double radius_m) {
    std::vector<Vec3> points;
    for (int i = 0; i < 360; ++i) {
        const double a = i * std::numbers::pi / 180;
        points.emplace_back(radius_m * std::cos(a), radius_m * std::sin(a), 0);
    }
    return points;
}

/// A ring cut `offset_m` outside the plan, from `from` to `to` degrees, to `depth_m`.
sim::Recording ring(double from, double to, double offset_m, float depth_m = 0.00038f) {
    sim::Recording recording;
    recording.header.tools.resize(1);
    recording.header.geometry.planned_contour = circle(kRadius);
    recording.header.geometry.placode_edge = circle(kRadius - 0.0015);
    recording.header.geometry.skin_edge = circle(kRadius + 0.0025);
    recording.header.geometry.placode_volume_m3 = 60e-9;
    recording.samples.resize(2);
    recording.samples[1].time_s = 0.01;
    for (double degrees = from; degrees <= to; degrees += 2) {
        sim::Event event;
        event.kind = sim::EventKind::kVaporised;
        event.time_s = degrees / 10;
        event.tissue = sim::Tissue::kZone;
        event.value = 0.009e-9f;
        event.value2 = depth_m;
        const double a = degrees * std::numbers::pi / 180;
        event.rest_position_m = {static_cast<float>((kRadius + offset_m) * std::cos(a)),
                                 static_cast<float>((kRadius + offset_m) * std::sin(a)), 0};
        recording.events.push_back(event);
    }
    return recording;
}

ArcCover::Result covered(const sim::Recording& recording) {
    return analyse_incision(recording)->cover;
}

TEST(TissueMetrics, TheRingIsAsCompleteAsThePictureShowedIt) {
    sim::Recording recording = ring(0, 359, 0);
    EXPECT_EQ(compute_metrics(recording).find("ring_completeness_percent"), 0)
        << "what was removed does not decide it";
    recording.samples[1].cut_fraction = 0.875F;
    EXPECT_EQ(compute_metrics(recording).find("ring_completeness_percent"), 87.5);
    EXPECT_FALSE(compute_metrics(recording).find("largest_gap_mm")) << "no ledger of gaps";
    // Frames after the last sample, from the same number.
    sim::Event end;
    end.kind = sim::EventKind::kRingGap;
    end.value2 = 0.9375F;
    recording.events.push_back(end);
    EXPECT_EQ(compute_metrics(recording).find("ring_completeness_percent"), 93.75);
    EXPECT_EQ(compute_metrics(recording).find("largest_gap_mm"), 0);
}

TEST(TissueMetrics, ResectedIsWhatWasDrawnOutHoweverManyPiecesLeave) {
    sim::Recording recording = ring(0, 359, 0);
    recording.header.tools[0].kind = sim::ToolKind::kScissors;
    const auto add = [&](sim::EventKind kind, float value, float value2) {
        sim::Event event;
        event.kind = kind;
        event.value = value;
        event.value2 = value2;
        recording.events.push_back(event);
    };
    // As an older program wrote it: each piece knows of itself and of what had gone before.
    add(sim::EventKind::kPieceOut, 2e-9F, 0.5F);
    add(sim::EventKind::kPieceOut, 2e-9F, 0.6F);
    EXPECT_FALSE(compute_metrics(recording).find("resected_percent"));
    const auto unknown = not_recorded(recording);
    EXPECT_NE(std::find(unknown.begin(), unknown.end(), "resected_percent"), unknown.end());
    add(sim::EventKind::kLedgerWritten, 1, 0);
    add(sim::EventKind::kTakenOut, 0, 0);
    add(sim::EventKind::kTakenOut, 1e-9F, 0.25F);
    add(sim::EventKind::kTakenOut, 3.5e-9F, 0.875F);
    EXPECT_FALSE(compute_metrics(recording).find("marked_gone_percent")) << "broken off";
    add(sim::EventKind::kMarkedLost, 0.5e-9F, 0.0625F);
    const MetricSet m = compute_metrics(recording);
    EXPECT_EQ(m.find("resected_percent"), 87.5);
    EXPECT_EQ(m.find("marked_lost_percent"), 6.25);
    EXPECT_EQ(m.find("marked_gone_percent"), 93.75);
    const auto known = not_recorded(recording);
    EXPECT_EQ(std::find(known.begin(), known.end(), "resected_percent"), known.end());
}

TEST(TissueMetrics, ABuriedTipIsCountedWhereTheLedgerWouldTell) {
    sim::Recording recording = ring(0, 359, 0);
    EXPECT_FALSE(compute_metrics(recording).find("buried_s"));
    sim::Event event;
    event.kind = sim::EventKind::kLedgerWritten;
    event.value = sim::kLedgerVersion;
    recording.events.push_back(event);
    EXPECT_EQ(compute_metrics(recording).find("buried_s"), 0);
    event.kind = sim::EventKind::kBuried;
    event.value = 1.5F;
    event.value2 = 0.002F;
    recording.events.push_back(event);
    event.value = 0.5F;
    recording.events.push_back(event);
    EXPECT_EQ(compute_metrics(recording).find("buried_s"), 2);
    EXPECT_EQ(compute_metrics(recording).find("buried_count"), 2);
}

TEST(TissueMetrics, CuttingAstrayIsNeverMadeGoodOnTheOtherSide) {
    sim::Recording inward = ring(0, 359, -0.0012);
    const double before = *compute_metrics(inward).find("off_line_mm");
    const sim::Recording outward = ring(0, 359, 0.0036);
    inward.events.insert(inward.events.end(), outward.events.begin(), outward.events.end());
    EXPECT_GE(*compute_metrics(inward).find("off_line_mm"), before)
        << "a mean between two faults is no line";
}

TEST(TissueMetrics, AWholeRingIsCompleteAndItsOffsetIsMeasured) {
    const MetricSet metrics = compute_metrics(ring(0, 359, 0.0002));
    EXPECT_NEAR(covered(ring(0, 359, 0.0002)).covered * 100, 100, 1e-9);
    EXPECT_NEAR(covered(ring(0, 359, 0.0002)).largest_gap * 1e3, 0, 1e-9);
    // A 360-gon lies within R (1 - cos 0.5 deg) = 0.0002 mm of its circle.
    EXPECT_NEAR(*metrics.find("contour_deviation_mm"), 0.2, 0.001);
    EXPECT_NEAR(*metrics.find("contour_signed_mm"), 0.2, 0.001);
    EXPECT_EQ(*metrics.find("off_line_mm"), 0);
    EXPECT_EQ(*metrics.find("outside_band_mm"), 0);
    EXPECT_EQ(*metrics.find("toward_placode_mm"), 0);
    EXPECT_EQ(*metrics.find("placode_cut_mm3"), 0);
}

TEST(TissueMetrics, AGapAShallowCutAndAnInwardCutAreSeen) {
    const ArcCover::Result gap = covered(ring(0, 328, 0));
    // From 328 to 360 degrees, less half an element at each end (cbrt(6 sqrt 2 V) = 0.424 mm).
    const double open_mm = 32 * std::numbers::pi / 180 * 6 - 0.424;
    EXPECT_NEAR(gap.largest_gap * 1e3, open_mm, 0.01);
    EXPECT_NEAR(100 * gap.covered, 100 * (1 - open_mm / (2 * std::numbers::pi * 6)), 0.05);

    EXPECT_EQ(covered(ring(0, 359, 0, 0.0001f)).covered, 0);

    const MetricSet inward = compute_metrics(ring(0, 359, -0.0012));
    EXPECT_NEAR(*inward.find("toward_placode_mm"), 2 * std::numbers::pi * 6, 0.01);
    EXPECT_NEAR(*inward.find("contour_signed_mm"), -1.2, 0.001);
    EXPECT_EQ(covered(ring(0, 359, -0.0012)).covered, 0);  // beyond the tolerance of 1 mm
    EXPECT_NEAR(*inward.find("off_line_mm"), 2 * std::numbers::pi * 6, 0.01);

    const MetricSet outward = compute_metrics(ring(0, 359, 0.0036));
    EXPECT_NEAR(*outward.find("outside_band_mm"), 2 * std::numbers::pi * 6, 0.01);
}

TEST(TissueMetrics, BurnedSkinCountsBeyondTheEdgeHoweverFarItIs) {
    sim::Recording recording = ring(0, 359, 0);
    const auto burned = [&](double radius_m, sim::Tissue tissue) {
        sim::Recording more = recording;
        sim::Event event;
        event.kind = sim::EventKind::kVaporised;
        event.value = 2e-9F;
        event.tissue = tissue;
        event.rest_position_m = {0, static_cast<float>(radius_m), 0};
        more.events.push_back(event);
        return *compute_metrics(more).find("skin_burned_mm3");
    };
    const double edge_m = recording.header.geometry.skin_edge[0].norm();
    EXPECT_EQ(*compute_metrics(recording).find("skin_burned_mm3"), 0);
    EXPECT_EQ(burned(edge_m + 0.0009, sim::Tissue::kSkin), 0) << "a kerf may reach so far";
    EXPECT_NEAR(burned(edge_m + 0.0011, sim::Tissue::kThinSkin), 2, 1e-6);
    EXPECT_NEAR(burned(0.05, sim::Tissue::kSkin), 2, 1e-6);
    EXPECT_EQ(burned(0.05, sim::Tissue::kSubcutis), 0);
    EXPECT_NEAR(burned(std::nan(""), sim::Tissue::kSkin), 2, 1e-6) << "it says not where";
    recording.header.geometry.skin_edge.clear();
    EXPECT_NEAR(burned(0, sim::Tissue::kSkin), 2, 1e-6) << "no lesion, no excuse";
}

/// Spells above the force limit, each from and to [s].
double over_force(const std::vector<std::pair<double, double>>& spells, int tool = 0) {
    sim::Recording recording;
    recording.samples.resize(1);
    for (const auto& [from_s, to_s] : spells) {
        sim::Event event;
        event.time_s = to_s;
        event.kind = sim::EventKind::kOverForce;
        event.value = static_cast<float>(to_s - from_s);
        event.tool = static_cast<int8_t>(tool);
        recording.events.push_back(event);
    }
    return *compute_metrics(recording).find("over_force_count");
}

TEST(TissueMetrics, ASpellAboveTheLimitCountsOnceAndOnceMoreForEachTwoSeconds) {
    EXPECT_EQ(over_force({}), 0);
    EXPECT_NEAR(over_force({{10, 10.1}}), 1.05, 1e-6);
    EXPECT_NEAR(over_force({{10, 70}}), 31, 1e-5);
    EXPECT_NEAR(over_force({{10, 10.1}, {20, 20.1}}), 2.1, 1e-6);
    EXPECT_NEAR(over_force({{20, 20.1}, {10, 10.1}}), 2.1, 1e-6) << "in whatever order";
    EXPECT_NEAR(over_force({{10, 11}, {11.3, 12}}), 1 + 0.5 + 0.1 + 0.35, 1e-6);
    EXPECT_NEAR(over_force({{10, 12}, {11, 12}, {10.5, 11.5}}), 2, 1e-6) << "the same two seconds";
    EXPECT_NEAR(over_force({{10, std::nan("")}, {10, 12}}), 2, 1e-6);
}

/// As a recording has them: spells that overlap are one.
std::vector<std::pair<double, double>> joined(std::vector<std::pair<double, double>> spells) {
    std::sort(spells.begin(), spells.end());
    std::vector<std::pair<double, double>> whole;
    for (const auto& [from_s, to_s] : spells) {
        if (whole.empty() || from_s > whole.back().second)
            whole.emplace_back(from_s, to_s);
        else
            whole.back().second = std::max(whole.back().second, to_s);
    }
    return whole;
}

TEST(TissueMetrics, NeitherAPauseNorPressingOnThroughOneLowersTheCount) {
    std::mt19937 random(7);
    const auto number = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    for (int i = 0; i < 300; ++i) {
        std::vector<std::pair<double, double>> spells;
        for (double at = 1; spells.size() < 6; at = spells.back().second + number(0.05, 5))
            spells.emplace_back(at, at + number(0.05, 6));
        const double before = over_force(spells);
        // More of it, wherever: in a pause, across spells, beside them.
        const double from = number(0, 40);
        auto more = spells;
        more.emplace_back(from, from + number(0.05, 8));
        EXPECT_GE(over_force(joined(more)), before - 1e-5);
        // A pause within a spell, the time above the limit being the same.
        const size_t which = i % spells.size();
        auto [begin, end] = spells[which];
        const double middle = number(begin, end), pause = number(0.05, 5);
        auto split = spells;
        split[which].second = middle;
        for (size_t k = which + 1; k < split.size(); ++k) {
            split[k].first += pause;
            split[k].second += pause;
        }
        split.emplace_back(middle + pause, end + pause);
        EXPECT_GE(over_force(split), before - 1e-5);
    }
}

TEST(TissueMetrics, JawsThatStayShutOnCrushedTissueCrushOn) {
    sim::Recording recording;
    recording.header.tools.resize(1);
    recording.header.tools[0].kind = sim::ToolKind::kGrasper;
    for (int i = 0; i <= 1000; ++i) {
        sim::Sample sample;
        sample.time_s = 0.01 * i;
        sample.tools[0].jaw_rad = i < 100 ? 0.2F : 0.1F;
        recording.samples.push_back(sample);
    }
    const auto count = [&] { return *compute_metrics(recording).find("crush_count"); };
    const auto add = [&](sim::EventKind kind, double time_s) {
        sim::Event event;
        event.kind = kind;
        event.time_s = time_s;
        event.tool = 0;
        recording.events.push_back(event);
    };
    EXPECT_EQ(count(), 0);
    add(sim::EventKind::kCrushed, 2);
    EXPECT_NEAR(count(), 1 + 8 / 2.0, 0.02) << "to the end";
    for (size_t i = 600; i < 800; ++i) recording.samples[i].tools[0].jaw_rad = 0.12F;
    EXPECT_NEAR(count(), 1 + 6 / 2.0, 0.02) << "eased for two seconds";
    add(sim::EventKind::kReleased, 5);
    EXPECT_NEAR(count(), 1 + 3 / 2.0, 0.02);
    add(sim::EventKind::kCrushed, 9.9);
    EXPECT_NEAR(count(), 2 + 3.1 / 2.0, 0.02);
}

TEST(TissueMetrics, EnergyThatReachesHealthySkinCountsWhereverItIs) {
    sim::Recording recording = ring(0, 359, 0);
    const double edge_m = recording.header.geometry.skin_edge[0].norm();
    const auto joules = [&](double radius_m, sim::Tissue tissue) {
        sim::Recording more = recording;
        for (int i = 0; i < 200; ++i) {
            sim::Sample& sample = more.samples.emplace_back();
            sample.time_s = 0.02 + 0.01 * i;
            sim::ToolSample& tool = sample.tools[0];
            tool.power_w = 6;
            tool.touched = tissue;
            tool.tip_m = {0, static_cast<float>(radius_m), 0};
        }
        return *compute_metrics(more).find("skin_heat_j");
    };
    EXPECT_EQ(joules(edge_m + 0.0009, sim::Tissue::kSkin), 0) << "a kerf may reach so far";
    EXPECT_NEAR(joules(edge_m + 0.0011, sim::Tissue::kThinSkin), 12, 1e-6);
    EXPECT_NEAR(joules(0.05, sim::Tissue::kSkin), 12, 1e-6);
    EXPECT_EQ(joules(0.05, sim::Tissue::kZone), 0);
}

TEST(TissueMetrics, LedgerAndSamplesBecomeMetrics) {
    sim::Recording recording = ring(0, 359, 0);
    const auto add = [&](sim::EventKind kind, float value, float value2,
                         sim::Tissue tissue = sim::Tissue::kZone) {
        sim::Event event;
        event.kind = kind;
        event.value = value;
        event.value2 = value2;
        event.tissue = tissue;
        recording.events.push_back(event);
    };
    add(sim::EventKind::kPlacodeContact, 0.5f, 0.012f);
    add(sim::EventKind::kPlacodeContact, 0.25f, 0.030f);
    add(sim::EventKind::kDwell, 1.5f, 0);
    add(sim::EventKind::kOverForce, 0.2f, 0.6f);
    add(sim::EventKind::kTorn, 2e-9f, 1.7f, sim::Tissue::kSkin);
    add(sim::EventKind::kVaporised, 1e-9f, 0.0004f, sim::Tissue::kPlacode);
    add(sim::EventKind::kEnergyOn, 12, 0);
    add(sim::EventKind::kEnergyOff, 2, 9.5f);
    recording.samples.assign(100, {});
    for (size_t k = 0; k < recording.samples.size(); ++k) {
        sim::Sample& sample = recording.samples[k];
        sample.time_s = 0.01 * static_cast<double>(k);
        sample.tools[0].tip_m = {k < 30 ? 0.005f : 0.0065f, 0, 0};  // 0.5 or 2 mm off the placode
        sample.tools[0].pedals = k < 50 ? sim::kPedalCut : 0;
        sample.tools[0].in_contact = k < 40;
        sample.tools[0].force_n = {0, 0, k == 10 ? 0.05f : 0.01f};
        sample.placode_peak_c = k < 50 ? 37.0f + static_cast<float>(k) : 37.0f;
        sample.placode_peak_cem43_min = 3;
        sample.placode_burned_m3 = 0.6e-9f;
    }
    const MetricSet m = compute_metrics(recording);
    EXPECT_EQ(*m.find("placode_contacts"), 2);
    EXPECT_NEAR(*m.find("placode_contact_s"), 0.75, 1e-6);
    EXPECT_NEAR(*m.find("placode_peak_force_mn"), 30, 1e-4);
    EXPECT_NEAR(*m.find("dwell_s"), 1.5, 1e-6);
    EXPECT_NEAR(*m.find("over_force_s"), 0.2, 1e-6);
    EXPECT_NEAR(*m.find("over_force_count"), 1.1, 1e-6);
    EXPECT_NEAR(*m.find("peak_force_mn"), 600, 1e-3);
    EXPECT_NEAR(*m.find("torn_skin_mm3"), 2, 1e-6);
    EXPECT_NEAR(*m.find("placode_cut_mm3"), 1, 1e-6);
    EXPECT_NEAR(*m.find("energy_j"), 9.5, 1e-6);
    EXPECT_NEAR(*m.find("energy_on_s"), 0.5, 1e-9);
    EXPECT_NEAR(*m.find("energy_in_air_s"), 0.1, 1e-9);
    EXPECT_NEAR(*m.find("energy_near_placode_s"), 0.3, 1e-9);
    EXPECT_NEAR(*m.find("placode_peak_c"), 86, 1e-4);
    EXPECT_NEAR(*m.find("placode_peak_cem43_min"), 3, 1e-6);
    EXPECT_NEAR(*m.find("placode_burned_percent"), 1, 1e-5);
    // In the order of the definitions, each once.
    size_t at = 0;
    const auto definitions = metric_definitions();
    for (const Metric& metric : m.values) {
        while (at < definitions.size() && definitions[at].id != metric.id) ++at;
        EXPECT_LT(at, definitions.size()) << metric.id;
        ++at;
    }
}

TEST(TissueMetrics, HeatThatAddsUpAtOnePlaceIsOnePlace) {
    sim::Recording recording = ring(0, 359, 0);
    double before = 0;
    const auto places = [&](double x_mm, double y_mm) {
        sim::Event event;
        event.kind = sim::EventKind::kPlacodeOverheated;
        event.value = 6;
        event.rest_position_m = {static_cast<float>(x_mm * 1e-3), static_cast<float>(y_mm * 1e-3),
                                 0};
        recording.events.push_back(event);
        const double now = *compute_metrics(recording).find("placode_overheated");
        EXPECT_GE(now, before) << "more heat was less harm";
        return before = now;
    };
    // The same spot four times: one vertex of the mesh after the other becomes too warm.
    EXPECT_EQ(places(-2.2, 3.9), 1);
    EXPECT_EQ(places(-1.9, 4.2), 1);
    EXPECT_EQ(places(-1.7, 3.8), 1);
    EXPECT_EQ(places(-2.4, 4.3), 1);
    EXPECT_EQ(places(2.2, 3.9), 2) << "the other side";
    EXPECT_EQ(places(0, 4), 3) << "between both";
}

TEST(TissueMetrics, GrasperAndScissorsAreSummedFromTheirEvents) {
    using sim::EventKind;
    sim::Recording recording;
    recording.header.sample_s = 0.01;
    recording.header.tools.resize(2);
    recording.header.tools[0].kind = sim::ToolKind::kScissors;
    recording.header.tools[1].kind = sim::ToolKind::kGrasper;
    const auto add = [&](double t, EventKind kind, int tool, float value, float value2,
                         sim::Tissue tissue = sim::Tissue::kZone) {
        sim::Event e;
        e.time_s = t;
        e.kind = kind;
        e.tool = static_cast<int8_t>(tool);
        e.value = value;
        e.value2 = value2;
        e.tissue = tissue;
        recording.events.push_back(e);
    };
    add(1.0, EventKind::kGrasped, 1, 6, 0.2F);
    add(1.2, EventKind::kSnipped, 0, 3e-6F, 0.001F);
    add(1.3, EventKind::kSnipped, 0, 2e-6F, 0.001F, sim::Tissue::kThinSkin);
    add(1.4, EventKind::kPlacodeCut, 0, 0.5e-6F, 0.001F, sim::Tissue::kPlacode);
    add(1.5, EventKind::kCrushed, 1, 2e5F, 0.4F);
    add(2.0, EventKind::kPieceOut, 1, 3e-9F, 0.8F);
    add(2.0, sim::EventKind::kTakenOut, -1, 2.5e-9F, 0.75F);
    add(3.0, EventKind::kReleased, 1, 2, 0.025F);
    for (int i = 0; i < 400; ++i) {
        sim::Sample sample;
        sample.time_s = 0.01 * i;
        // Lifted by 1 mm from 1.5 s to 2.5 s.
        const bool up = sample.time_s >= 1.5 - 1e-9 && sample.time_s < 2.5 - 1e-9;
        sample.tools[1].tip_m[2] = up ? 0.001F : 0.0F;
        recording.samples.push_back(sample);
    }
    const MetricSet m = compute_metrics(recording);
    EXPECT_NEAR(*m.find("lift_hold_s"), 1.0, 0.011);
    EXPECT_EQ(*m.find("snips"), 2);
    EXPECT_NEAR(*m.find("skin_snip_mm2"), 2, 1e-5);
    EXPECT_NEAR(*m.find("placode_snip_mm2"), 0.5, 1e-6);
    EXPECT_EQ(*m.find("pieces_out"), 1);
    EXPECT_NEAR(*m.find("resected_mm3"), 3, 1e-5);
    EXPECT_NEAR(*m.find("resected_percent"), 75, 1e-4);
    EXPECT_EQ(*m.find("grasps"), 1);
    EXPECT_NEAR(*m.find("crush_count"), 1 + 1.5 / 2, 0.01) << "from 1.5 to 3 s";
    EXPECT_NEAR(*m.find("peak_traction_mn"), 25, 1e-4);
    // In the order of the definitions, each once.
    size_t at = 0;
    const auto definitions = metric_definitions();
    for (const Metric& metric : m.values) {
        while (at < definitions.size() && definitions[at].id != metric.id) ++at;
        EXPECT_LT(at, definitions.size()) << metric.id;
        ++at;
    }
}

TEST(TissueMetrics, SpreadAndOverStretchAreSummedFromTheirEvents) {
    sim::Recording recording = ring(0, 359, 0);
    recording.header.tools.resize(1);  // a needle
    EXPECT_EQ(not_recorded(recording).size(), 11u);
    EXPECT_FALSE(compute_metrics(recording).find("over_stretch_mm3_s"));
    EXPECT_FALSE(compute_metrics(recording).find("thermal_spread_mm"));
    const auto add = [&](sim::EventKind kind, float value, float value2, int element) {
        sim::Event event;
        event.kind = kind;
        event.value = value;
        event.value2 = value2;
        event.element = element;
        recording.events.push_back(event);
    };
    add(sim::EventKind::kStretchSum, 0, 0, -1);
    add(sim::EventKind::kLedgerWritten, sim::kLedgerVersion, 0, -1);
    add(sim::EventKind::kRingGap, 0, 1, -1);
    add(sim::EventKind::kThermalSpread, 4, 0, -1);  // says how many rays follow, and is none
    EXPECT_TRUE(not_recorded(recording).empty());
    EXPECT_EQ(compute_metrics(recording).find("over_stretch_mm3_s"), 0);
    EXPECT_FALSE(compute_metrics(recording).find("max_stretch"));
    EXPECT_FALSE(compute_metrics(recording).find("thermal_spread_mm")) << "no ray, no width";
    add(sim::EventKind::kOverStretch, 1.4f, 0, 5);
    add(sim::EventKind::kStretchSum, 2e-10f, 1.5f, 5);
    add(sim::EventKind::kStretchSum, 3e-10f, 1.7f, 6);
    for (int i = 1; i <= 4; ++i)
        add(sim::EventKind::kThermalSpread, 1e-4f * static_cast<float>(i), i == 4 ? NAN : 2e-4f, i);
    const MetricSet m = compute_metrics(recording);
    EXPECT_NEAR(*m.find("over_stretch_mm3_s"), 0.5, 1e-6);
    EXPECT_NEAR(*m.find("max_stretch"), 1.7, 1e-6);
    EXPECT_EQ(*m.find("over_stretch_count"), 1);
    EXPECT_NEAR(*m.find("thermal_spread_mm"), 0.25, 1e-6);
    EXPECT_NEAR(*m.find("thermal_spread_p95_mm"), 0.385, 1e-6);  // type 7: 0.3 + 0.85 x 0.1
    EXPECT_NEAR(*m.find("thermal_spread_max_mm"), 0.4, 1e-6);
    EXPECT_NEAR(*m.find("dose_spread_max_mm"), 0.2, 1e-6);
}

TEST(TissueMetrics, ADoseBeyondAllNumbersIsStillAMetric) {
    sim::Recording recording = ring(0, 359, 0);
    recording.samples[1].placode_peak_cem43_min = INFINITY;
    EXPECT_EQ(compute_metrics(recording).find("placode_peak_cem43_min"), 1e6);
}

TEST(TissueMetrics, OddRecordingsDoNotThrow) {
    EXPECT_TRUE(compute_metrics({}).values.empty());
    sim::Recording recording = ring(0, 10, 0);
    recording.events[0].rest_position_m = {NAN, NAN, NAN};
    recording.events[1].value = NAN;
    recording.header.tools.resize(9);
    EXPECT_FALSE(compute_metrics(recording).values.empty());
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
