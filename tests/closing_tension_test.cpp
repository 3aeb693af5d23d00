// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The force that brings a wound's edges together: against the closed form of a strip, and less of
// it the farther the skin is undermined.
#include "sim/step/closing_tension.h"

#include <gtest/gtest.h>

#include "sim/step/pull_vertices.h"
#include "sim/step/step.h"
#include "sim/step/undermining_when_let_go.h"
#include "tests/box_scene.h"
#include "tests/undermine_pad.h"

namespace placode::sim {
namespace THIS_TEST {

/// The pad, built once: a test changes only its states.
const std::shared_ptr<const Scene>& pad_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(test::undermine_pad());
    return scene;
}

/// A strip of skin, held at its far end: F = E A u / L.
TEST(ClosingTension, OfAStripIsThatOfABar) {
    test::BoxOptions options;
    options.size_m = Vec3(0.016, 0.002, 0.001);
    options.cells = {32, 4, 2};
    options.material.youngs_modulus_pa = 60e3;
    options.material.poissons_ratio = 0.3;
    options.heat = options.hold_bottom = false;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    constexpr double kDrawn = 2e-4;
    std::vector<PulledVertex> pulled;
    size_t near = 0;
    for (const double end : {0.008, -0.008}) {
        for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
            const Vec3& at = scene.body.mesh().rest[v];
            if (std::abs(at.x() - end) > 1e-9) continue;
            pulled.push_back(
                {static_cast<int32_t>(v), end > 0 ? Vec3(at + Vec3(kDrawn, 0, 0)) : at});
        }
        if (end > 0) near = pulled.size();
    }
    const std::vector<Vec3> force_n = pull_vertices(scene, state, pulled);
    Vec3 drawn = Vec3::Zero(), held = Vec3::Zero();
    for (size_t i = 0; i < force_n.size(); ++i) (i < near ? drawn : held) += force_n[i];
    const double bar = 60e3 * 0.002 * 0.001 * kDrawn / 0.016;
    // Both ends are clamped sideways too, and the strain of 1.25 % counts to the second order.
    EXPECT_NEAR(-drawn.x(), bar, 0.03 * bar);
    EXPECT_NEAR(held.x(), -drawn.x(), 0.01 * bar) << "action and reaction";
    RecordProperty("over_bar", std::to_string(-drawn.x() / bar));
}

TEST(ClosingTension, FallsWithTheReachOfUndermining) {
    const auto& scene = pad_scene();
    double last = 1e9, whole = 0;
    for (const double reach : {0.0, 0.003, 0.006, 0.009}) {
        State state(*scene, 1);
        if (reach > 0) test::part_within(*scene, state, reach);
        while (state.separation.count > 0) separate(*scene, state);
        const ClosingTension now = closing_tension(*scene, state);
        EXPECT_GT(now.n_per_m, 0);
        EXPECT_LT(now.n_per_m, 0.98 * last) << reach;
        RecordProperty("tension_" + std::to_string(static_cast<int>(1e3 * reach)),
                       std::to_string(now.n_per_m));
        last = now.n_per_m;
        if (reach == 0) whole = last;
    }
    EXPECT_LT(last, 0.75 * whole);
}

TEST(ClosingTension, TheLastEventsSayItAndLeaveTheStateAlone) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    test::part_within(*scene, state, 0.004);
    const uint64_t before = state_hash(state);
    const std::vector<Event> events = undermining_when_let_go(*scene, state);
    EXPECT_EQ(state_hash(state), before);
    size_t lines = 0, stations = 0;
    for (const Event& e : events) {
        lines += e.kind == EventKind::kUndermined && e.element >= 0 ? 1 : 0;
        stations += e.kind == EventKind::kClosingTension && e.element >= 0 ? 1 : 0;
        if (e.kind == EventKind::kClosingTension && e.element == -1) {
            EXPECT_LT(e.value, 0.9F * e.value2);
        }
    }
    EXPECT_EQ(lines, scene->plane.rays.size());
    EXPECT_EQ(stations, scene->slit.stations.size());
    State again(*scene, 3);
    test::part_within(*scene, again, 0.004);
    const std::vector<Event> other = undermining_when_let_go(*scene, again);
    ASSERT_EQ(other.size(), events.size());
    for (size_t i = 0; i < events.size(); ++i) EXPECT_EQ(other[i].value, events[i].value) << i;
}

}  // namespace THIS_TEST
}  // namespace placode::sim
