// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A slit under pressure: what passes, what it holds, how its walls give way.
#include "sim/step/watertight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/anatomy/operative_field.h"
#include "sim/contact/self_contact.h"
#include "sim/contact/slit_gap.h"
#include "sim/step/slit_when_let_go.h"
#include "sim/step/step.h"
#include "sim/world/state.h"
#include "tests/slit_pad.h"

namespace placode::sim {
namespace THIS_TEST {

using test::kHalfM, test::kWidthM;
constexpr double kPerMl = 6e7;  // ml/min of m3/s

OperativeFieldSpec pad() {
    OperativeFieldSpec spec = test::pad();
    spec.slit->watertight.emplace();
    return spec;
}

/// The pad, built once: a test changes only its states.
const std::shared_ptr<const Scene>& pad_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(pad());
    return scene;
}

/// So many frames with nobody's hands, under a pressure that may rise with the frame.
template <class Pressure>
void hold(const Scene& scene, State& state, SlitPressure& fluid, int frames,
          Pressure&& pressure_pa) {
    const std::array<ToolInput, kMaxTools> nobody{};
    std::array<ToolFeedback, kMaxTools> feedback{};
    const size_t tools = scene.tools.size();
    for (int i = 0; i < frames; ++i) {
        fluid.push(pressure_pa(i));
        (void)step(scene, state, {nobody.data(), tools}, {feedback.data(), tools});
    }
}

/// Both walls led towards each other until they stand `left_m` apart wherever they stood farther,
/// as threads would, and held there.
void draw_together(const Scene& scene, State& state, double left_m) {
    for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
        const int side = scene.slit.side_of(static_cast<int32_t>(v));
        if (side == 0) continue;
        const Vec3& rest = scene.body.mesh().rest[v];
        const double half = std::abs(rest.x() - 0.009);
        const double goal = std::max(0.0, half - 0.5 * (left_m + kTissueGapM));
        state.body.x[v].x = static_cast<float>(rest.x() + side * goal);
        state.body.x[v].w = 0;
    }
}

struct Result {
    double pass_ml_min = -1, good_ml_min = -1, held_pa = -1, burst_ml_min = -1;
    size_t stations = 0;
    double sum_ml_min = 0;  ///< Of the stations, at the lower pressure.
};
Result read(const std::vector<Event>& events) {
    Result out;
    int wholes = 0;
    for (const Event& e : events) {
        if (e.kind != EventKind::kWatertight) continue;
        const double ml_min = kPerMl * static_cast<double>(e.value);
        if (e.element == -1) {
            ++wholes;
            (wholes == 1 ? out.pass_ml_min : out.good_ml_min) = ml_min;
            EXPECT_NEAR(e.value2, wholes == 1 ? WatertightSpec::kPassPa : WatertightSpec::kGoodPa,
                        3);
        } else if (e.element == -2) {
            out.held_pa = static_cast<double>(e.value2);
            out.burst_ml_min = ml_min;
        } else if (wholes == 1) {
            ++out.stations;
            out.sum_ml_min += ml_min;
        }
    }
    EXPECT_EQ(wholes, 2);
    return out;
}

Result tested(const Scene& scene, State& state) { return read(watertight_events(scene, state)); }

TEST(Watertight, ASlitHeldShutLeaksNothingUpToTheHighestPressure) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    draw_together(*scene, state, 0);
    const Result shut = tested(*scene, state);
    EXPECT_EQ(shut.pass_ml_min, 0);
    EXPECT_EQ(shut.good_ml_min, 0);
    EXPECT_NEAR(shut.held_pa, 3922.7, 0.1);
    EXPECT_EQ(shut.burst_ml_min, 0);
    EXPECT_EQ(shut.stations, scene->slit.stations.size());
}

TEST(Watertight, AnOpenSlitLeaksLikeAnOrificeAndBurstsAtOnce) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    settle(*scene, state, 0.1);
    const Result open = tested(*scene, state);
    // 0.6 of the ellipse, less the 50 um that contact keeps walls apart; fluid rubs on them, too,
    // and presses them apart.
    const double area_m2 = std::numbers::pi * kHalfM * kWidthM / 2 - 2 * kHalfM * kTissueGapM;
    const double torricelli = kPerMl * 0.6 * area_m2 * std::sqrt(2 * 588.4 / 1005);
    EXPECT_NEAR(open.pass_ml_min, torricelli, 0.06 * torricelli);
    EXPECT_GT(open.good_ml_min, open.pass_ml_min);
    EXPECT_NEAR(open.sum_ml_min, open.pass_ml_min, 1e-3 * open.pass_ml_min);
    EXPECT_LT(open.held_pa, 10);
    RecordProperty("open_ml_min", std::to_string(open.pass_ml_min));
}

/// Shut at the surface alone, the lower half of the walls bears the pressure.
TEST(Watertight, PressurePushesTheWallsApartByWhatItsAreaAsks) {
    const auto& scene = pad_scene();
    const auto moved = [&](double pressure_pa) {
        State state(*scene, 1);
        SlitPressure fluid(*scene, state);
        draw_together(*scene, state, 0);
        // The walls' lower row is free.
        for (const Slit::Station& s : scene->slit.stations)
            for (const int32_t v : {s.left[1], s.right[1]})
                state.body.x[static_cast<size_t>(v)].w =
                    State(*scene, 1).body.x[static_cast<size_t>(v)].w;
        hold(*scene, state, fluid, 600, [&](int) { return pressure_pa; });
        EXPECT_EQ(fluid.flow_m3_s(), 0);
        double sum = 0;
        for (const Slit::Station& s : scene->slit.stations)
            sum += (position(state.body, s.right[1]) - position(state.body, s.left[1])).x();
        return sum / static_cast<double>(scene->slit.stations.size());
    };
    const double none = moved(0), some = moved(300), twice = moved(600);
    EXPECT_GT(some, none);
    EXPECT_NEAR((twice - none) / (some - none), 2, 0.2) << "tissue is linear for small ways";
}

TEST(Watertight, GapAndFlowAreFoundTogether) {
    // Walls that give way let more through than the gap at rest says.
    const auto& scene = pad_scene();
    const auto flow_ml_min = [&](bool stiff) {
        State state(*scene, 1);
        draw_together(*scene, state, 0.1e-3);
        if (!stiff) {
            // Held at every fourth station only, like stitches 2 mm apart.
            const State rest(*scene, 1);
            for (size_t i = 0; i < scene->slit.stations.size(); ++i) {
                if (i % 4 == 0) continue;
                const Slit::Station& s = scene->slit.stations[i];
                for (const int32_t v : {s.left[0], s.left[1], s.right[0], s.right[1]})
                    state.body.x[static_cast<size_t>(v)].w = rest.body.x[static_cast<size_t>(v)].w;
            }
        }
        settle(*scene, state, 0.3);
        return tested(*scene, state);
    };
    const Result stiff = flow_ml_min(true), soft = flow_ml_min(false);
    EXPECT_GT(stiff.pass_ml_min, 0);
    EXPECT_GT(soft.pass_ml_min, stiff.pass_ml_min);
    EXPECT_LT(soft.held_pa, stiff.held_pa);
    RecordProperty("stiff_ml_min", std::to_string(stiff.pass_ml_min));
    RecordProperty("soft_ml_min", std::to_string(soft.pass_ml_min));
}

/// The pressure rises much faster than in theatre: at the pressure where the slit burst, held until
/// everything is at rest, the leak is the one that counts as burst.
TEST(Watertight, ThePressureRisesSlowlyEnough) {
    OperativeFieldSpec spec = pad();
    spec.slit->watertight->burst_m3_s = 60 / kPerMl;
    const auto scene = build_operative_field(spec);
    const auto prepare = [&](State& state) {
        const State rest(*scene, 1);
        draw_together(*scene, state, 0.08e-3);
        for (size_t i = 0; i < scene->slit.stations.size(); ++i) {
            if (i % 5 == 0) continue;
            const Slit::Station& s = scene->slit.stations[i];
            for (const int32_t v : {s.left[0], s.left[1], s.right[0], s.right[1]})
                state.body.x[static_cast<size_t>(v)].w = rest.body.x[static_cast<size_t>(v)].w;
        }
        settle(*scene, state, 0.3);
    };
    State fast(*scene, 1);
    prepare(fast);
    const Result result = tested(*scene, fast);
    ASSERT_GT(result.held_pa, 10);
    ASSERT_LT(result.held_pa, 3900);
    RecordProperty("burst_pa", std::to_string(result.held_pa));

    State slow(*scene, 1);
    prepare(slow);
    SlitPressure fluid(*scene, slow);
    hold(*scene, slow, fluid, 1500,
         [&](int i) { return result.held_pa * std::min(1.0, i / 800.0); });
    EXPECT_NEAR(kPerMl * fluid.flow_m3_s(), 60, 0.05 * 60);
    EXPECT_EQ(slow.flags & kNotFinite, 0U);
}

TEST(Watertight, TheSameOnOtherNumbersOfThreadsAndTheAttemptGoesOnAsIfNobodyHadTested) {
    const auto& scene = pad_scene();
    State one(*scene, 1), two(*scene, 2);
    const std::vector<Event> from_one = slit_when_let_go(*scene, one),
                             from_two = slit_when_let_go(*scene, two);
    ASSERT_EQ(from_one.size(), from_two.size());
    int watertight = 0;
    for (size_t i = 0; i < from_one.size(); ++i) {
        EXPECT_EQ(from_one[i].value, from_two[i].value);
        EXPECT_EQ(from_one[i].value2, from_two[i].value2);
        EXPECT_EQ(from_one[i].element, from_two[i].element);
        watertight += from_one[i].kind == EventKind::kWatertight ? 1 : 0;
    }
    EXPECT_EQ(watertight, 3 * (1 + static_cast<int>(scene->slit.stations.size())));
    EXPECT_EQ(one.frame, 0);
    const auto untested = build_operative_field(test::pad());
    State state(*untested, 1);
    EXPECT_TRUE(watertight_events(*untested, state).empty());
}

/// What the stations say, pressure by pressure.
struct StationList {
    double pressure_pa = 0, sum_ml_min = 0;
    std::vector<double> leak_ml_min, gap_m;
};
std::vector<StationList> lists_of(const std::vector<Event>& events, size_t stations) {
    std::vector<StationList> lists;
    for (const Event& e : events) {
        if (e.element < 0) continue;
        const auto value = static_cast<double>(e.value);
        if (e.kind == EventKind::kWatertight) {
            if (lists.empty() || lists.back().leak_ml_min.size() == stations)
                lists.push_back({static_cast<double>(e.value2), 0, {}, {}});
            lists.back().leak_ml_min.push_back(kPerMl * value);
            lists.back().sum_ml_min += kPerMl * value;
        } else if (e.kind == EventKind::kSlitPressed) {
            EXPECT_EQ(static_cast<double>(e.value2), lists.back().pressure_pa);
            EXPECT_EQ(lists.back().gap_m.size() + 1, lists.back().leak_ml_min.size());
            lists.back().gap_m.push_back(value);
        }
    }
    return lists;
}

/// Held at every fourth station only, it gives way between them, the middle of a stretch first.
TEST(Watertight, EveryStationSaysWhatItLeaksAtEachPressureAndWhenItOpens) {
    const auto& scene = pad_scene();
    const size_t stations = scene->slit.stations.size();
    State state(*scene, 1);
    const State rest(*scene, 1);
    draw_together(*scene, state, 0);
    for (size_t i = 0; i < stations; ++i) {
        if (i % 6 == 0) continue;
        const Slit::Station& s = scene->slit.stations[i];
        for (const int32_t v : {s.left[0], s.left[1], s.right[0], s.right[1]})
            state.body.x[static_cast<size_t>(v)].w = rest.body.x[static_cast<size_t>(v)].w;
    }
    settle(*scene, state, 0.3);
    const std::vector<Event> events = watertight_events(*scene, state);
    const Result whole = read(events);
    const std::vector<StationList> lists = lists_of(events, stations);
    ASSERT_EQ(lists.size(), 3U);
    EXPECT_NEAR(lists[0].sum_ml_min, whole.pass_ml_min, 1e-4 * whole.pass_ml_min + 1e-9);
    EXPECT_NEAR(lists[1].sum_ml_min, whole.good_ml_min, 1e-4 * whole.good_ml_min + 1e-9);
    EXPECT_NEAR(lists[2].sum_ml_min, whole.burst_ml_min, 1e-4 * whole.burst_ml_min + 1e-9);
    EXPECT_EQ(lists[2].pressure_pa, whole.held_pa);
    for (const StationList& list : lists)
        for (size_t i = 0; i < stations; ++i)
            EXPECT_EQ(list.leak_ml_min[i] > 0, list.gap_m[i] > 0) << i;
    std::vector<const Event*> opened;
    for (const Event& e : events)
        if (e.kind == EventKind::kSlitOpened) opened.push_back(&e);
    ASSERT_EQ(opened.size(), stations + 1);
    EXPECT_EQ(opened[0]->element, -1);
    EXPECT_EQ(opened[0]->value, static_cast<float>(stations));
    ASSERT_EQ(opened[0]->value2, 1) << "it burst";
    const double open_ml_min = 10 * kOpenShare;
    for (size_t i = 0; i < stations; ++i) {
        const Event& e = *opened[i + 1];
        EXPECT_EQ(e.element, static_cast<int32_t>(i));
        // What is open at a pressure has opened by then.
        for (const StationList& list : lists)
            if (list.leak_ml_min[i] > open_ml_min) {
                EXPECT_EQ(e.value2, 1) << i;
                EXPECT_LE(static_cast<double>(e.value), list.pressure_pa) << i;
            }
        // The middle of a stretch gives way before either of its ends, which are held.
        if (i % 6 == 3 && i + 3 < stations) {
            EXPECT_LE(e.value, opened[i - 2]->value) << i;
            EXPECT_LE(e.value, opened[i + 4]->value) << i;
            EXPECT_GE(lists[2].leak_ml_min[i], lists[2].leak_ml_min[i - 3]) << i;
            EXPECT_GE(lists[2].leak_ml_min[i], lists[2].leak_ml_min[i + 3]) << i;
        }
    }
}

TEST(Watertight, WhatIsHeldShutOpensNowhere) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    draw_together(*scene, state, 0);
    int opened = 0, shut = 0;
    for (const Event& e : watertight_events(*scene, state)) {
        if (e.kind == EventKind::kSlitPressed) {
            EXPECT_EQ(e.value, 0);
        }
        if (e.kind != EventKind::kSlitOpened) continue;
        if (e.element < 0) {
            EXPECT_EQ(e.value2, 0) << "it has not burst";
            continue;
        }
        (e.value2 > 0 ? opened : shut) += 1;
        EXPECT_NEAR(e.value, 3922.7, 0.1) << "it held to the end";
    }
    EXPECT_EQ(opened, 0);
    EXPECT_EQ(shut, static_cast<int>(scene->slit.stations.size()));
}

TEST(Watertight, TornWallsAreNeitherTightNorBlownAbout) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    draw_together(*scene, state, 0);
    const auto middle = static_cast<size_t>(nearest_station(*scene, Vec2(0.009, 0)));
    for (int level = 0; level < scene->slit.layers; ++level) {
        const int32_t wall = scene->slit.stations[middle].left[static_cast<size_t>(level)];
        for (const int32_t t : scene->body.tets_of(wall)) remove_tet(scene->body, state.body, t);
    }
    update_free_vertices(scene->body, state.body);
    const Result torn = tested(*scene, state);
    EXPECT_GT(torn.pass_ml_min, 1);
    EXPECT_LT(torn.held_pa, 3900);
    EXPECT_EQ(state.flags & kNotFinite, 0U);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
