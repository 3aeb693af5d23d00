// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is cut and what is out: one number for picture and ledger.

#include "sim/cutting/attempt_progress.h"
#include "sim/cutting/grasp.h"
#include "sim/world/add_event.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/step/snapshot.h"
#include "tests/cut_field.h"

namespace placode::sim {
namespace THIS_TEST {

bool in_patch(const Vec3& p) {
    return std::abs(p.x()) < 0.0015 && std::abs(p.y()) < 0.0015 && p.z() > -0.001;
}

/// A block whose patch in the middle is marked, and some tissue far from it.
Scene marked_scene() {
    Scene scene = test::box_scene(test::grasped_block(Vec3(0.008, 0.008, 0.002), {16, 16, 4}));
    scene.marked.assign(static_cast<size_t>(scene.body.tet_count()), 0);
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        const Vec3 at = rest_centroid(scene, t);
        if (!in_patch(at) && !(at.y() > 0.0035)) continue;
        scene.marked[static_cast<size_t>(t)] = 1;
        scene.marked_volume_m3 += static_cast<double>(scene.body.volume_m3()[t]);
    }
    return scene;
}

struct Field : test::CutField {
    Field() : CutField(marked_scene(), 1) {}
    void move(const Vec3& from, const Vec3& to, double jaw) {
        const int frames = static_cast<int>((to - from).norm() / 1e-4) + 1;
        for (int i = 1; i <= frames; ++i)
            run(from + static_cast<double>(i) / frames * (to - from), jaw, 1);
    }
    /// Takes hold in the middle, or beside it, and draws it out of the field.
    void draw_out(double height_m = 0.040, double x_m = 0) {
        const Vec3 away(x_m, 0, 0.010), touch(x_m, 0, 0.0001), out(x_m, 0, height_m);
        move(away, touch, 0.6);
        const double closed = 0.5 * grip_angle(scene.tools[0]);
        for (double jaw = 0.6; jaw > closed; jaw -= 0.01) run(touch, jaw, 1);
        run(touch, closed, 50);
        move(touch, out, closed);
        run(out, closed, 100);
    }
    [[nodiscard]] Event last(EventKind kind) const {
        Event found;
        for (const Event& e : events)
            if (e.kind == kind) found = e;
        return found;
    }
};

TEST(Reached, APieceIsOutWith62PercentOfTheWayToThePortLeft) {
    // The port is 80 mm above: at 30.4 mm, 62 % of that is left.
    for (const double height_m : {0.029, 0.032}) {
        Field field;
        field.cut_out(in_patch);
        field.run(Vec3(0, 0, 0.01), 0.6, 200);
        field.draw_out(height_m);
        EXPECT_EQ(field.state.pieces.out, height_m > 0.0304 ? 1 : 0) << height_m;
    }
}

TEST(Reached, TornAndBurnedTissueIsNotTakenOut) {
    Field field;
    field.run(Vec3(0, 0, 0.01), 0.6, 5);
    EXPECT_EQ(field.last(EventKind::kTakenOut).kind, EventKind::kTakenOut)
        << "said at the first frame";
    EXPECT_EQ(field.last(EventKind::kTakenOut).value2, 0);
    EXPECT_EQ(field.last(EventKind::kLedgerWritten).value, kLedgerVersion);
    // A fifth of the patch tears before it is cut out.
    double patch = 0, torn = 0;
    for (int t = 0; t < field.scene.body.tet_count(); ++t) {
        const Vec3 at = rest_centroid(field.scene, t);
        if (!in_patch(at)) continue;
        const auto volume = static_cast<double>(field.scene.body.volume_m3()[t]);
        patch += volume;
        if (!(at.x() > 0.0009)) continue;
        remove_tissue(field.scene, field.state, t, EventKind::kTorn, 0, 2);
        torn += volume;
    }
    ASSERT_GT(torn, 0.1 * patch);
    field.cut_out(in_patch);
    field.run(Vec3(0, 0, 0.01), 0.6, 200);
    EXPECT_EQ(taken_out_share(field.scene, field.state), 0) << "it still lies there";
    field.draw_out();
    ASSERT_EQ(field.state.pieces.out, 1);
    const double marked = field.scene.marked_volume_m3;
    const double share = taken_out_share(field.scene, field.state);
    EXPECT_NEAR(share, (patch - torn) / marked, 1e-6);
    EXPECT_NEAR(field.state.pieces.marked_lost_m3, torn, 1e-6 * torn);
    EXPECT_NEAR(field.state.pieces.marked_gone_m3, patch, 1e-6 * patch);
    // One number: picture, ledger while it runs, ledger at the end.
    Snapshot snapshot;
    fill_snapshot(field.scene, field.state, snapshot);
    EXPECT_NEAR(gone_share(field.scene, field.state), patch / marked, 1e-6);
    EXPECT_EQ(snapshot.resected_fraction, static_cast<float>(gone_share(field.scene, field.state)));
    EXPECT_EQ(field.last(EventKind::kTakenOut).value2, static_cast<float>(share));
    const auto closing = reached_events(field.scene, field.state);
    ASSERT_GE(closing.size(), 2U);
    EXPECT_EQ(closing[0].kind, EventKind::kTakenOut);
    EXPECT_EQ(closing[0].value2, static_cast<float>(share));
    EXPECT_GT(closing[0].rest_position_m[1], 0.003F) << "where the rest hangs";
    EXPECT_EQ(closing[1].kind, EventKind::kMarkedLost);
    EXPECT_NEAR(closing[1].value2, torn / marked, 1e-6);
    EXPECT_NEAR(closing[0].value2 + closing[1].value2, snapshot.resected_fraction, 1e-6);
}

// The largest number that a single piece told missed what left together with it, or after it.
TEST(Reached, PiecesThatLeaveTogetherOrOneAfterTheOtherAddUp) {
    double patch = 0;
    for (const bool together : {true, false}) {
        Field field;
        if (patch == 0)
            for (int t = 0; t < field.scene.body.tet_count(); ++t)
                if (in_patch(rest_centroid(field.scene, t)))
                    patch += static_cast<double>(field.scene.body.volume_m3()[t]);
        field.cut_out([](const Vec3& p) { return in_patch(p) && p.x() < 0; });
        field.cut_out(in_patch);
        field.run(Vec3(0, 0, 0.01), 0.6, 200);
        field.draw_out(0.040, together ? 0 : -0.0011);
        EXPECT_EQ(field.state.pieces.out, together ? 2 : 1);
        if (!together) field.draw_out(0.040, 0.0011);
        ASSERT_EQ(field.state.pieces.out, 2);
        const double share = taken_out_share(field.scene, field.state);
        EXPECT_NEAR(share, patch / field.scene.marked_volume_m3, 1e-6);
        EXPECT_EQ(field.last(EventKind::kTakenOut).value2, static_cast<float>(share));
        EXPECT_EQ(reached_events(field.scene, field.state).at(0).value2, static_cast<float>(share));
    }
}

TEST(Reached, WhereNothingIsMarkedThereIsNoShare) {
    const Scene scene = test::box_scene(test::grasped_block(Vec3(0.008, 0.008, 0.002), {4, 4, 2}));
    const State state(scene, 1);
    EXPECT_EQ(taken_out_share(scene, state), -1);
    EXPECT_EQ(gone_share(scene, state), -1);
    EXPECT_EQ(ring_share(state), 0);
    EXPECT_TRUE(reached_events(scene, state).empty());
}

TEST(Reached, GapsOfTheRingAreToldWithLengthAndPlace) {
    Scene scene = test::box_scene(test::grasped_block(Vec3(0.008, 0.008, 0.002), {4, 4, 2}));
    for (int i = 0; i < 72; ++i) {
        const double a = i * 5 * M_PI / 180;
        scene.geometry.planned_contour.emplace_back(0.003 * std::cos(a), 0.003 * std::sin(a), 0);
    }
    State state(scene, 1);
    state.progress.cut.assign(72, 1);
    // One over the beginning of the line, one around 90 degrees.
    for (const int i : {70, 71, 0, 1, 18}) state.progress.cut[static_cast<size_t>(i)] = 0;
    state.progress.cut_count = 67;
    const auto events = reached_events(scene, state);
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].element, -1);
    EXPECT_EQ(events[0].value, 2);
    EXPECT_EQ(events[0].value2, static_cast<float>(67.0 / 72));
    EXPECT_EQ(events[0].value2, static_cast<float>(ring_share(state)));
    const double step = 2 * 0.003 * std::sin(2.5 * M_PI / 180);
    EXPECT_NEAR(events[1].value, step, 1e-8);
    EXPECT_NEAR(events[1].rest_position_m[1], 0.003, 1e-6);
    EXPECT_NEAR(events[2].value, 4 * step, 1e-8);
    EXPECT_NEAR(events[2].rest_position_m[0], 0.003, 2e-5);
    // Nothing cut is one gap as long as the line.
    state.progress.cut.assign(72, 0);
    state.progress.cut_count = 0;
    const auto open = reached_events(scene, state);
    ASSERT_EQ(open.size(), 2U);
    EXPECT_NEAR(open[1].value, 72 * step, 1e-7);
    state.progress.cut.assign(72, 1);
    EXPECT_EQ(reached_events(scene, state).size(), 1U);
    for (const Event& each : events) EXPECT_TRUE(only_in_recording(each.kind));
}

}  // namespace THIS_TEST
}  // namespace placode::sim
