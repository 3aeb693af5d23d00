// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators in a kinematic world: a flat ring that parts where an energised tip passes
// slowly. No tissue mechanics, so that only behaviour is tested.
#include "haptics/operators/operator_model.h"
#include "haptics/operators/operator_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/catalogue/open_device.h"
#include "haptics/servo.h"
#include "sim/cutting/pieces.h"

namespace placode::haptics {
namespace THIS_TEST {

constexpr int kPoints = 100;
constexpr double kFrameS = 1e-3;

struct FlatWorld {
    FlatWorld() {
        for (int i = 0; i < kPoints; ++i) {
            const double a = 2 * std::numbers::pi * i / kPoints;
            contour.emplace_back(0.0095 * std::cos(a), 0.0045 * std::sin(a), 0.001);
        }
        normal.assign(kPoints, Vec3::UnitZ());
        cut.assign(kPoints, 0);
        energy.assign(kPoints, 0);
    }
    // Distance of a point in the plane to the contour, negative inside (towards the placode).
    [[nodiscard]] double deviation(const Vec3& p) const {
        double nearest = 1;
        for (int i = 0; i < kPoints; ++i) {
            const Vec3 a = contour[i], b = contour[(i + 1) % kPoints];
            const Vec3 ab = b - a, ap = Vec3(p.x() - a.x(), p.y() - a.y(), 0);
            const double w = std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (ap - w * ab).norm());
        }
        const bool inside = std::pow(p.x() / 0.0095, 2) + std::pow(p.y() / 0.0045, 2) < 1;
        return inside ? -nearest : nearest;
    }
    /// What a person sees of it now.
    [[nodiscard]] Perception seen() const {
        Perception seen;
        seen.contour = contour;
        seen.contour_normal = normal;
        seen.contour_cut = cut;
        seen.in_contact = in_contact;
        return seen;
    }
    void step(const Vec3& tip, bool pedal) {
        in_contact = tip.z() < 0.001;
        if (!pedal || !in_contact) return;
        for (int i = 0; i < kPoints; ++i) {
            const double d = std::hypot(tip.x() - contour[i].x(), tip.y() - contour[i].y());
            // As in the simulation, an incision up to 1 mm beside the line counts. 1 to 2 mm at
            // 3 mm/s are 0.3 to 0.7 s; less than half of that parts the tissue.
            if (d < 0.001) energy[i] += kFrameS;
            if (energy[i] > 0.15) cut[i] = 1;
        }
    }
    std::vector<Vec3> contour, normal;
    std::vector<uint8_t> cut;
    std::vector<double> energy;
    bool in_contact = false;
};

struct Outcome {
    double time_s = 0, cut_fraction = 0, mean_deviation_m = 0, deviation_spread_m = 0,
           worst_inward_m = 0;
    double energy_in_air_s = 0, longest_dwell_s = 0, jerk = 0;
    bool finished = false, finite = true;
    Vec3 last = Vec3::Zero();
};

// Device, trocar and servo in the loop, as in an attempt.
Outcome perform(const std::string& level, uint64_t seed) {
    std::vector<sim::ToolSpec> tools(2);
    tools[1].kind = sim::ToolKind::kScope;
    tools[1].pivot_m = Vec3(-0.045, 0, 0.075);
    DeviceConfig config;
    config.name = "script:" + level;
    config.seed = seed;
    config.tools = tools;
    Servo servo(open_device(config), tools, default_trocars(tools, config.name), {});
    FlatWorld world;
    std::array<sim::ToolInput, 2> inputs{};
    std::array<sim::ToolFeedback, 2> feedback{};
    Outcome out;
    double deviations = 0, signed_sum = 0, squares = 0, samples = 0, dwell = 0;
    Vec3 dwell_at = Vec3::Zero(), p1 = Vec3::Zero(), p2 = Vec3::Zero(), p3 = Vec3::Zero();
    for (int i = 1; i < 120'000 && !servo.finish_requested(); ++i) {
        Perception seen = world.seen();
        seen.time_s = i * kFrameS;
        seen.tools = feedback;
        servo.devices().perceive(seen);
        servo.tick(int64_t{i} * 1'000'000, inputs, feedback);
        const Vec3 tip = inputs[0].pose().p;
        out.finite = out.finite && tip.allFinite();
        const bool pedal = inputs[0].pedals == sim::kPedalCut;
        world.step(tip, pedal);
        feedback[0].proxy = inputs[0].pose();
        feedback[0].time_s = i * kFrameS;
        if (pedal && world.in_contact) {
            const double d = world.deviation(tip);
            deviations += std::abs(d);
            signed_sum += d;
            squares += d * d;
            samples += 1;
        }
        if (world.in_contact)
            out.worst_inward_m = std::max(out.worst_inward_m, -world.deviation(tip));
        if (pedal && !world.in_contact) out.energy_in_air_s += kFrameS;
        dwell = pedal && (tip - dwell_at).norm() < 0.5e-3 ? dwell + kFrameS : 0;
        if (dwell == 0) dwell_at = tip;
        out.longest_dwell_s = std::max(out.longest_dwell_s, dwell);
        if (i > 3) out.jerk += (tip - 3 * p1 + 3 * p2 - p3).norm();
        p3 = p2;
        p2 = p1;
        p1 = tip;
        out.time_s = i * kFrameS;
        out.last = tip;
    }
    out.finished = servo.finish_requested();
    out.cut_fraction = static_cast<double>(std::count(world.cut.begin(), world.cut.end(), 1)) /
                       static_cast<double>(kPoints);
    out.mean_deviation_m = samples > 0 ? deviations / samples : 1;
    if (samples > 0)
        out.deviation_spread_m =
            std::sqrt(std::max(0.0, squares / samples - std::pow(signed_sum / samples, 2)));
    return out;
}

TEST(Operator, ExpertCompletesTheRingCleanly) {
    for (const uint64_t seed : {1u, 2u, 3u}) {
        const Outcome expert = perform("expert", seed);
        EXPECT_TRUE(expert.finished);
        EXPECT_EQ(expert.cut_fraction, 1) << "seed " << seed;
        EXPECT_LT(expert.mean_deviation_m, 7e-4);
        EXPECT_LT(expert.worst_inward_m, 0.5e-3);
        EXPECT_LT(expert.longest_dwell_s, 1.0);
        EXPECT_LT(expert.energy_in_air_s, 0.3);
        EXPECT_GT(expert.time_s, 10);
        EXPECT_LT(expert.time_s, 40);
    }
}

TEST(Operator, LevelsDifferByWhatTheyDo) {
    for (const uint64_t seed : {1u, 2u}) {
        const Outcome expert = perform("expert", seed), middle = perform("intermediate", seed),
                      novice = perform("novice", seed);
        // The expert is off the line on purpose, outwards; what counts is how steady the hand is.
        EXPECT_LT(expert.deviation_spread_m, middle.deviation_spread_m);
        EXPECT_LT(middle.deviation_spread_m, novice.deviation_spread_m);
        EXPECT_LT(expert.worst_inward_m, middle.worst_inward_m);
        EXPECT_LT(expert.time_s, middle.time_s);
        EXPECT_LT(expert.time_s, novice.time_s);
        EXPECT_GT(middle.cut_fraction, novice.cut_fraction);
        EXPECT_GT(novice.worst_inward_m, 2e-3) << "slips onto the placode";
        EXPECT_LT(middle.worst_inward_m, 1.5e-3);
        EXPECT_GT(novice.energy_in_air_s, expert.energy_in_air_s + 1.0);
        EXPECT_GT(novice.longest_dwell_s, expert.longest_dwell_s);
        EXPECT_LT(expert.jerk / expert.time_s, novice.jerk / novice.time_s);
        EXPECT_TRUE(novice.finished);
        EXPECT_LT(novice.time_s, 100);
    }
}

TEST(Operator, RepeatsItselfBitForBitBySeed) {
    for (const char* level : {"expert", "novice"}) {
        const Outcome a = perform(level, 7), b = perform(level, 7), c = perform(level, 8);
        EXPECT_EQ(a.time_s, b.time_s);
        EXPECT_EQ(a.last, b.last);
        EXPECT_EQ(a.jerk, b.jerk);
        EXPECT_NE(a.jerk, c.jerk);
        EXPECT_TRUE(a.finite && c.finite);
    }
}

TEST(Operator, GivesUpWithoutAContour) {
    OperatorModel model(operator_profile(OperatorLevel::kExpert), 1, Vec3(0, 0, 0.015));
    OperatorAction action;
    for (int i = 0; i < 10'000 && !action.finish; ++i) {
        model.see({}, {});
        action = model.act(kFrameS);
        ASSERT_TRUE(action.tip_m.allFinite());
        ASSERT_EQ(action.pedals, 0);
    }
    EXPECT_TRUE(action.finish);
}

TEST(Operator, GivesUpWhereNothingCuts) {
    // Energy without effect: the generator is broken. The operator must not go on for ever.
    FlatWorld world;
    OperatorModel model(operator_profile(OperatorLevel::kExpert), 1, Vec3(0, 0, 0.015));
    OperatorAction action;
    double time = 0;
    for (; time < 150 && !action.finish; time += kFrameS) {
        Perception seen = world.seen();
        seen.in_contact = action.tip_m.z() < 0.001;
        model.see(seen, {});
        action = model.act(kFrameS);
    }
    EXPECT_TRUE(action.finish);
    EXPECT_LT(time, operator_profile(OperatorLevel::kExpert).patience_s + 5);
}

TEST(Operator, LetsAPlaceCoolBeforeItGoesOverItAgain) {
    // A tenth of the ring never parts, so that the needle must come back to it.
    FlatWorld world;
    OperatorProfile profile = operator_profile(OperatorLevel::kExpert);
    ASSERT_GT(profile.cool_s, 5);
    OperatorModel model(profile, 1, Vec3(0, 0, 0.015));
    OperatorAction action;
    double last_s = -1, shortest_s = 1e9;
    int returns = 0;
    for (double time = 0; time < 150 && !action.finish; time += kFrameS) {
        model.see(world.seen(), {});
        action = model.act(kFrameS);
        world.step(action.tip_m, action.pedals != 0);
        for (int i = 0; i < kPoints / 10; ++i) world.cut[i] = world.energy[i] = 0;
        const double angle = std::atan2(action.tip_m.y() / 0.0045, action.tip_m.x() / 0.0095);
        const bool near = std::abs(angle - 2 * std::numbers::pi * 5 / kPoints) < 0.04;
        if (action.pedals == 0 || !world.in_contact || !near) continue;
        if (last_s >= 0 && time - last_s > 1) {
            ++returns;
            shortest_s = std::min(shortest_s, time - last_s);
        }
        last_s = time;
    }
    EXPECT_TRUE(action.finish);
    EXPECT_GE(returns, 2);
    // One second less: the near field of the test is wider than a point of the line.
    EXPECT_GT(shortest_s, profile.cool_s - 1);
}

/// A ring of which every point is cut at the start, and a placode that hangs on in one sector, with
/// those beside it, until the needle has worked there for a second.
struct Bridge {
    static constexpr int kSector = 30;
    std::array<uint8_t, sim::kSectors> free{};
    double worked_s = 0, elsewhere_s = 0, time_s = 0;

    Bridge() {
        free.fill(1);
        for (int s = kSector - 3; s <= kSector + 3; ++s) free[s] = 0;
    }
    void work(const OperatorProfile& profile) {
        FlatWorld world;
        world.cut.assign(kPoints, 1);
        world.cut[0] = 0;  // else there is nothing to come for
        OperatorModel model(profile, 1, Vec3(0, 0, 0.015));
        OperatorAction action;
        for (; time_s < 150 && !action.finish; time_s += kFrameS) {
            Perception seen = world.seen();
            seen.time_s = time_s;
            seen.sector_free = free;
            seen.released = free[kSector] != 0 ? 1 : 65.0F / sim::kSectors;
            model.see(seen, {});
            action = model.act(kFrameS);
            world.step(action.tip_m, action.pedals != 0);
            if (action.pedals == 0 || !world.in_contact || world.cut[0] == 0) continue;
            const int off = std::abs(sim::sector_of(action.tip_m) - kSector);
            (off <= 3 ? worked_s : elsewhere_s) += kFrameS;
            if (worked_s > 1) free.fill(1);
        }
    }
};

TEST(Operator, TheExpertGoesBackToWhatHoldsThePlacode) {
    Bridge bridge;
    bridge.work(operator_profile(OperatorLevel::kExpert));
    EXPECT_EQ(bridge.free[Bridge::kSector], 1);
    EXPECT_LT(bridge.worked_s, 1.1) << "no more energy once it is free";
    EXPECT_LT(bridge.elsewhere_s, 1.0) << "what is left of the cut at the first point";
    EXPECT_LT(bridge.time_s, operator_profile(OperatorLevel::kExpert).patience_s);
}

TEST(Operator, OthersLeaveWhenTheLineIsCut) {
    OperatorProfile profile = operator_profile(OperatorLevel::kExpert);
    profile.seeks_bridges = false;
    Bridge bridge;
    bridge.work(profile);
    EXPECT_GT(bridge.elsewhere_s, 0);
    EXPECT_EQ(bridge.worked_s, 0);
}

TEST(Operator, DoesNotJumpWhereTheLineFoldsOver) {
    // A flap's edge: over a tenth of the ring the surface looks outwards and down.
    FlatWorld world;
    for (int i = 20; i < 20 + kPoints / 10; ++i) {
        const Vec3 out = Vec3(world.contour[i].x(), world.contour[i].y(), 0).normalized();
        world.normal[i] = (out - 0.3 * Vec3::UnitZ()).normalized();
    }
    OperatorModel model(operator_profile(OperatorLevel::kExpert), 1, Vec3(0, 0, 0.015));
    OperatorAction action;
    Vec3 before = Vec3::Zero();
    double fastest_m_s = 0, fastest_free_m_s = 0, worst_inward_m = 0;
    for (double time = 0; time < 150 && !action.finish; time += kFrameS) {
        model.see(world.seen(), {});
        action = model.act(kFrameS);
        world.step(action.tip_m, action.pedals != 0);
        const double speed_m_s = time > 0 ? (action.tip_m - before).norm() / kFrameS : 0;
        fastest_free_m_s = std::max(fastest_free_m_s, speed_m_s);
        if (action.pedals != 0) {
            fastest_m_s = std::max(fastest_m_s, speed_m_s);
            worst_inward_m = std::max(worst_inward_m, -world.deviation(action.tip_m));
        }
        before = action.tip_m;
    }
    EXPECT_TRUE(action.finish);
    EXPECT_LT(fastest_m_s, 0.04) << "30 mm/s, and tremor";
    EXPECT_LT(fastest_free_m_s, 0.1)
        << "a stroke's peak; 0.7 mm in a frame would be seven times it";
    EXPECT_LT(worst_inward_m, 2e-4);
}

TEST(Operator, GivesNoEnergyWithMetalBesideThePlacode) {
    for (const double gap_m : {2e-4, 1e-3}) {
        FlatWorld world;
        OperatorModel model(operator_profile(OperatorLevel::kExpert), 1, Vec3(0, 0, 0.015));
        OperatorAction action;
        int energised = 0;
        for (int i = 0; i < 20'000; ++i) {
            Perception seen = world.seen();
            seen.placode_metal_gap_m.fill(gap_m);
            model.see(seen, {});
            action = model.act(kFrameS);
            world.step(action.tip_m, false);
            energised += action.pedals != 0 ? 1 : 0;
        }
        EXPECT_EQ(energised > 0, gap_m > 5e-4) << gap_m;
    }
}

TEST(Operator, SurvivesAContourThatIsNotFinite) {
    FlatWorld world;
    for (auto& normal : world.normal) normal.setConstant(std::nan(""));
    OperatorModel model(operator_profile(OperatorLevel::kNovice), 1, Vec3(0, 0, 0.015));
    for (int i = 0; i < 20'000; ++i) {
        Perception seen = world.seen();
        seen.in_contact = i > 6000;
        model.see(seen, {});
        ASSERT_TRUE(model.act(kFrameS).tip_m.allFinite());
    }
}

TEST(OperatorRandom, HasTheMomentsItClaims) {
    OperatorRandom random(42);
    double sum = 0, square = 0, low = 1, high = 0;
    constexpr int n = 100'000;
    for (int i = 0; i < n; ++i) {
        const double x = random.normal(), u = random.uniform();
        sum += x;
        square += x * x;
        low = std::min(low, u);
        high = std::max(high, u);
    }
    // Standard errors: 0.003 for the mean, 0.005 for the variance; four of them are allowed.
    EXPECT_NEAR(sum / n, 0, 0.013);
    EXPECT_NEAR(square / n, 1, 0.02);
    EXPECT_GE(low, 0);
    EXPECT_LT(high, 1);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
