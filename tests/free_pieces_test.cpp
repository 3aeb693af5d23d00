// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a bar of tissue that was cut loose falls, spins and is pushed, against closed forms.
#include "sim/contact/free_pieces.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "sim/core/turn.h"
#include "sim/cutting/piece_fate.h"
#include "sim/world/saved_state.h"
#include "sim/world/scratch.h"
#include "tests/cut_field.h"

namespace placode::sim {
namespace THIS_TEST {

using test::BoxOptions;
using test::upright;

constexpr double kG = 9.81, kHeight = 0.030, kFrame = 1e-3;
const Vec3 kAway(0.03, 0.03, 0.08);

BoxOptions block(double youngs_modulus_pa) {
    BoxOptions options = test::grasped_block(Vec3(0.010, 0.006, 0.0025), {20, 12, 5});
    options.material.youngs_modulus_pa = youngs_modulus_pa;
    options.material.damping_per_s = 0;
    options.over_relaxation = 1.2;
    options.tool.kind = ToolKind::kProbe;
    options.tool.tip_radius_m = 0.001;
    options.tool.tip_length_m = 0.0025;
    return options;
}

/// 6 x 2 x 1.5 mm: 240 vertices.
bool in_bar(const Vec3& p) {
    return std::abs(p.x()) < 0.003 && std::abs(p.y()) < 0.001 && p.z() > -0.0015;
}

/// A tool whose shaft points along `way`.
ToolInput along(const Vec3& way, const Vec3& tip) {
    ToolInput input;
    input.set_pose({tip, Quat::FromTwoVectors(Vec3::UnitZ(), way)});
    input.engaged = 1;
    return input;
}

/// A bar that was cut out of a block, above it and free.
struct Loose : test::CutField {
    explicit Loose(const BoxOptions& options, int threads = 1, int tools = 1)
        : CutField(with_tools(options, tools), threads) {
        cut_out(in_bar);
        rest(200);
        for (int i = 0; i < kMostPieces; ++i) {
            if (state.pieces.list[static_cast<size_t>(i)].tets > 0) let_go(i);
        }
        update_free_vertices(scene.body, state.body);
        for (const int32_t v : bar) {
            state.body.x[static_cast<size_t>(v)].z += static_cast<float>(kHeight);
            state.body.x_start[static_cast<size_t>(v)] = state.body.x[static_cast<size_t>(v)];
        }
    }
    static Scene with_tools(const BoxOptions& options, int tools) {
        Scene scene = test::box_scene(options);
        scene.tools.resize(static_cast<size_t>(tools), options.tool);
        return scene;
    }
    void let_go(int piece) {
        ++pieces;
        stick_piece(scene, state, piece, false);
        list(piece);
    }
    /// Adds its vertices to the bar.
    void list(int piece) {
        std::vector<uint8_t> seen(state.body.x.size(), 0);
        for_tets_of_piece(scene, state, piece, [&](int32_t t) {
            for (const int32_t v : corners(scene.body, state.body, t)) {
                if (seen[static_cast<size_t>(v)]++ == 0) bar.push_back(v);
            }
        });
    }
    /// All tips at places of their own.
    void step_with(const std::vector<Vec3>& tips) {
        std::vector<ToolInput> inputs;
        for (const Vec3& p : tips) inputs.push_back(upright(p));
        hands.resize(inputs.size());
        (void)step(scene, state, inputs, hands);
    }
    void rest(int frames) {
        const std::vector<Vec3> away(scene.tools.size(), kAway);
        for (int i = 0; i < frames; ++i) step_with(away);
    }
    [[nodiscard]] double mass(int32_t v) const {
        return static_cast<double>(mass_of(scene.body, state.body, v));
    }
    [[nodiscard]] Vec3 at(int32_t v) const { return position(state.body, v); }
    [[nodiscard]] Vec3 speed(int32_t v) const {
        return to_vec(state.body.v[static_cast<size_t>(v)]);
    }
    [[nodiscard]] double mass() const {
        double sum = 0;
        for (const int32_t v : bar) sum += mass(v);
        return sum;
    }
    [[nodiscard]] Vec3 centre() const {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : bar) sum += mass(v) * at(v);
        return sum / mass();
    }
    [[nodiscard]] Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : bar) sum += mass(v) * speed(v);
        return sum;
    }
    /// About its centre of mass.
    [[nodiscard]] Vec3 angular_momentum() const {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : bar) sum += mass(v) * (at(v) - centre()).cross(speed(v));
        return sum;
    }
    /// Principal axes of inertia, by columns.
    [[nodiscard]] Mat3 axes() const {
        Mat3 inertia = Mat3::Zero();
        for (const int32_t v : bar) inertia += inertia_of(mass(v), at(v) - centre());
        return Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvectors();
    }
    void move(const Vec3& velocity, const Vec3& spin) {
        const Vec3 middle = centre();
        for (const int32_t v : bar) set_speed(v, velocity + spin.cross(at(v) - middle));
    }
    void set_speed(int32_t v, const Vec3& u) {
        state.body.v[static_cast<size_t>(v)] = {
            static_cast<float>(u.x()), static_cast<float>(u.y()), static_cast<float>(u.z()), 0};
    }
    [[nodiscard]] bool is_finite() const {
        return std::all_of(bar.begin(), bar.end(), [&](int32_t v) {
            return at(v).allFinite() && speed(v).allFinite() && at(v).norm() < 1;
        });
    }
    [[nodiscard]] std::vector<Vec3> places() const {
        std::vector<Vec3> out;
        for (const int32_t v : bar) out.push_back(at(v) - centre());
        return out;
    }
    /// About `axis` since it was at `before` [rad].
    [[nodiscard]] double turned(const Vec3& axis, const std::vector<Vec3>& before) const {
        double sine = 0, cosine = 0;
        for (size_t i = 0; i < bar.size(); ++i) {
            const double m = mass(bar[i]);
            const Vec3 from = before[i] - axis * axis.dot(before[i]);
            Vec3 to = at(bar[i]) - centre();
            to -= axis * axis.dot(to);
            sine += m * axis.dot(from.cross(to));
            cosine += m * from.dot(to);
        }
        return std::atan2(sine, cosine);
    }

    int pieces = 0;
    std::vector<int32_t> bar;
    std::vector<ToolFeedback> hands;
};

// A quarter turn in 50 ms, about each principal axis of inertia, in tissue of two stiffnesses.
// Implicit Euler makes g h^2 n (n + 1) / 2 of g t^2 / 2: 0.5 % more after 200 substeps.
TEST(FreePieces, ABarFallsAndSpinsAsAFreeBodyDoes) {
    for (const double stiffness : {1e4, 6e4}) {
        for (int k = 0; k < 3; ++k) {
            Loose run(block(stiffness));
            ASSERT_EQ(run.pieces, 1);
            ASSERT_EQ(run.bar.size(), 260U);
            constexpr double kT = 0.050, kTurn = 1.5708, kUp = 0.1;
            const Vec3 axis = run.axes().col(k), from = run.centre();
            run.move(Vec3(0.05, -0.03, kUp), kTurn / kT * axis);
            const std::vector<Vec3> before = run.places();
            run.rest(50);
            const Vec3 way = run.centre() - from;
            const double fell = kG * kT * kT / 2 * (1 + 1.0 / 200);
            const double turn = run.turned(axis, before);
            const std::string name = std::to_string(k) + (stiffness < 3e4 ? "_soft" : "_stiff");
            const Vec3 wanted(0.05 * kT, -0.03 * kT, kUp * kT - fell);
            RecordProperty("off_way_ppm_" + name,
                           static_cast<int>(1e6 * (way - wanted).norm() / fell));
            RecordProperty("off_turn_ppm_" + name, static_cast<int>(1e6 * (turn / kTurn - 1)));
            EXPECT_LT((way - wanted).norm(), 0.002 * fell) << name;
            EXPECT_NEAR(turn, kTurn, 0.01 * kTurn) << name;
        }
    }
}

// With the fluid's damping c: g / c^2 (c t - 1 + exp(-c t)) from rest, and w (1 - exp(-c t)) / c.
TEST(FreePieces, FallsAndSpinsThroughFluidAsItsDampingSays) {
    BoxOptions options = block(2e4);
    options.material.damping_per_s = 20;
    Loose run(options);
    const Vec3 axis = run.axes().col(2), from = run.centre();
    constexpr double kC = 20, kT = 0.060, kSpin = 30;
    run.move(Vec3::Zero(), kSpin * axis);
    const std::vector<Vec3> before = run.places();
    run.rest(60);
    const double fell = kG / (kC * kC) * (kC * kT - 1 + std::exp(-kC * kT));
    const double turn = kSpin / kC * (1 - std::exp(-kC * kT));
    RecordProperty("fell_ppm", static_cast<int>(1e6 * ((from - run.centre()).z() / fell - 1)));
    RecordProperty("turn_ppm", static_cast<int>(1e6 * (run.turned(axis, before) / turn - 1)));
    // First order in the substep: h / t = 0.4 % late and h c = 0.5 % before it is damped.
    EXPECT_NEAR((from - run.centre()).z(), fell, 0.01 * fell);
    EXPECT_NEAR(run.turned(axis, before), turn, 0.01 * turn);
}

// While it spins, swings and tumbles, for 0.2 s. What is lost is rounding: positions are floats, so
// that speeds are known to a thousandth of a millimetre per second.
TEST(FreePieces, MomentumAndAngularMomentumAreKept) {
    BoxOptions options = block(1e4);
    options.gravity = Vec3::Zero();
    Loose run(options);
    run.move(Vec3(0.05, -0.02, 0.03), Vec3(8, 15, -12));
    for (const int32_t v : run.bar) {  // bent, and drawn out
        const double x = (run.at(v) - run.centre()).x();
        run.set_speed(v, run.speed(v) + Vec3(20 * x, 0, 1e4 * x * x - 0.03));
    }
    const Vec3 p = run.momentum(), l = run.angular_momentum();
    for (int i = 0; i < 10; ++i) {
        run.rest(20);
        EXPECT_LT((run.momentum() - p).norm(), 0.005 * p.norm()) << i;
        EXPECT_LT((run.angular_momentum() - l).norm(), 0.01 * l.norm()) << i;
    }
    RecordProperty("momentum_ppb", static_cast<int>(1e9 * (run.momentum() - p).norm() / p.norm()));
    RecordProperty("angular_ppm",
                   static_cast<int>(1e6 * (run.angular_momentum() - l).norm() / l.norm()));
}

// A round tip comes down beside its middle, pushes it away and sets it spinning: all of its
// momentum is from the force that the hand has felt.
TEST(FreePieces, IsPushedByTheForceThatTheHandFeels) {
    BoxOptions options = block(2e4);
    options.gravity = Vec3::Zero();
    Loose run(options);
    const Vec3 top = run.centre() + Vec3(0.001, 0.0004, 0.0008);
    Vec3 given = Vec3::Zero();
    double most = 0;
    for (int i = 0; i < 120; ++i) {
        run.step_with({top + Vec3(0, 0, 0.0015 - 4e-5 * std::min(i, 80))});
        given -= kFrame * run.hands[0].force_n;
        most = std::max(most, (run.momentum() - given).norm());
    }
    ASSERT_GT(given.norm(), 0.02 * run.mass()) << "it was pushed";
    EXPECT_GT(run.angular_momentum().norm(), 0);
    RecordProperty("off_ppm", static_cast<int>(1e6 * most / given.norm()));
    EXPECT_LT(most, 0.01 * given.norm());
}

// Cut in two as it falls: each half is a piece and falls on with what it had.
TEST(FreePieces, IsPartedAsItFalls) {
    Loose run(block(2e4));
    const Vec3 from = run.centre(), axis = run.axes().col(2);
    run.move(Vec3(0, 0, 0.2), 10 * axis);
    const Vec3 turning = run.angular_momentum();
    run.rest(10);
    ASSERT_TRUE(run.state.scratch->free_pieces.any);
    run.cut_out([](const Vec3& p) { return in_bar(p) && p.x() < 0; });
    run.rest(50);
    int pieces = 0;
    for (const FreePieces::Body& body : run.state.scratch->free_pieces.bodies)
        pieces += body.count > 0 ? 1 : 0;
    EXPECT_EQ(pieces, 2);
    run.bar.clear();
    for (int i = 0; i < kMostPieces; ++i) {
        if (run.state.pieces.list[static_cast<size_t>(i)].tets > 0) run.list(i);
    }
    const double t = 0.060, fell = kG * t * t / 2 * (1 + 1.0 / 240) - 0.2 * t;
    EXPECT_NEAR((from - run.centre()).z(), fell, 0.002 * kG * t * t / 2);
    RecordProperty(
        "parted_turning_ppm",
        static_cast<int>(1e6 * (run.angular_momentum() - turning).norm() / turning.norm()));
    EXPECT_LT((run.angular_momentum() - turning).norm(), 0.01 * turning.norm()) << "of both";
}

/// What the tests of bits do with a bar: it falls and tumbles onto a probe and slides off it.
struct Tumbling {
    explicit Tumbling(int threads) : run(block(2e4), threads) {
        run.move(Vec3(0.02, 0, 0.1), Vec3(20, 9, -14));
        tip = run.centre() + Vec3(0.006, 0.0002, -0.010);
    }
    void frame() { frame(run.state); }
    void frame(State& state) const {
        const ToolInput input = along(Vec3::UnitX(), tip);
        ToolFeedback hand;
        (void)step(run.scene, state, {&input, 1}, {&hand, 1});
    }
    Loose run;
    Vec3 tip;
};

constexpr int kTumble = 120;  // frames

TEST(FreePieces, TheSameBitsOnOneTwoAndThreeThreads) {
    std::array<uint64_t, 3> hash{};
    bool touched = false;
    for (int threads = 1; threads <= 3; ++threads) {
        Tumbling tumbling(threads);
        for (int i = 0; i < kTumble; ++i) {
            tumbling.frame();
            touched = touched || tumbling.run.state.tools[0].in_contact != 0;
        }
        EXPECT_TRUE(tumbling.run.is_finite());
        hash[static_cast<size_t>(threads - 1)] = whole_hash(tumbling.run.state);
    }
    EXPECT_TRUE(touched) << "it fell past the probe";
    EXPECT_EQ(hash[0], hash[1]);
    EXPECT_EQ(hash[0], hash[2]);
}

TEST(FreePieces, WhatIsSavedGoesOnAndScratchMayBeLost) {
    Tumbling tumbling(1);
    State& state = tumbling.run.state;
    for (int i = 0; i < kTumble / 3; ++i) tumbling.frame();
    const auto saved = save_state(tumbling.run.scene, state);
    State other(tumbling.run.scene, 2);
    load_state(tumbling.run.scene, other, saved);
    for (int i = 0; i < kTumble / 2; ++i) {
        tumbling.frame();
        if (i % 2 == 0)
            other.scratch = std::make_unique<State::Scratch>(tumbling.run.scene);
        else
            other.scratch->forget();
        tumbling.frame(other);
        ASSERT_EQ(whole_hash(other), whole_hash(state)) << i;
    }
    EXPECT_TRUE(state.scratch->free_pieces.any);
}

// Between its ends.
TEST(FreePieces, StaysWholeBetweenTwoInstruments) {
    BoxOptions options = block(2e4);
    options.gravity = Vec3::Zero();
    Loose run(options, 1, 2);
    const Vec3 c = run.centre();
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        const double s = 0.0031 - 1e-5 * std::min(i, 40);
        const std::vector<ToolInput> inputs{along(Vec3::UnitX(), c - Vec3(s, 0, 0)),
                                            along(-Vec3::UnitX(), c + Vec3(s, 0, 0))};
        run.hands.resize(2);
        (void)step(run.scene, run.state, inputs, run.hands);
        ASSERT_TRUE(run.is_finite()) << i;
        ASSERT_EQ(run.state.flags & kNotFinite, 0U) << i;
        most = std::max(most, std::min(-run.hands[0].force_n.x(), run.hands[1].force_n.x()));
    }
    EXPECT_GT(most, 1e-3) << "both press";
}

// A column of cells of 4 um: nothing is known of its spin but rounding.
TEST(FreePieces, APieceOfNeedleThinTetsStaysFinite) {
    BoxOptions options = block(2e4);
    options.graded = [](int axis, double x) {
        if (axis == 2) return x;
        const double cell = 0.0005, k = std::round(x / cell);
        return k == 0 || k == 1 ? (k == 0 ? 0.0 : 4e-6) : x;
    };
    Scene scene = test::box_scene(options);
    test::CutField field(std::move(scene), 1);
    const auto thin = [](const Vec3& p) {
        return p.x() > 0 && p.x() < 4e-6 && p.y() > 0 && p.y() < 4e-6 && p.z() > -0.0015;
    };
    field.cut_out(thin);
    State& state = field.state;
    for (int i = 0; i < 200 && state.pieces.crumbs == 0; ++i) field.run(kAway, 0, 1);
    ASSERT_EQ(state.pieces.crumbs, 1);
    state.pieces.list[0].leaving = 0;  // as if it had been let go
    ASSERT_GT(state.pieces.list[0].tets, 0);
    std::vector<int32_t> vertices;
    for_tets_of_piece(field.scene, state, 0, [&](int32_t t) {
        for (const int32_t v : corners(field.scene.body, state.body, t)) vertices.push_back(v);
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    ASSERT_GT(vertices.size(), 6U);
    for (const int32_t v : vertices) {
        state.body.x[static_cast<size_t>(v)].z += static_cast<float>(kHeight);
        state.body.v[static_cast<size_t>(v)] = {0.1F, 0.02F, 0.1F, 0};
    }
    for (int i = 0; i < 60; ++i) {
        field.run(kAway, 0, 1);
        for (const int32_t v : vertices) {
            ASSERT_TRUE(position(state.body, v).allFinite()) << i;
            ASSERT_LT(position(state.body, v).norm(), 0.1) << i;
        }
    }
    EXPECT_TRUE(state.scratch->free_pieces.any);
}

// What lies still, and sleeps around it, is no free body.
TEST(FreePieces, LeavesAloneWhatRestsAndWhatJawsHold) {
    Loose run(block(2e4));
    run.rest(2);
    EXPECT_TRUE(run.state.scratch->free_pieces.any);
    stick_piece(run.scene, run.state, 0, true);
    const std::vector<Vec3> before = run.places();
    const Vec3 centre = run.centre();
    run.rest(400);
    EXPECT_FALSE(run.state.scratch->free_pieces.any);
    EXPECT_EQ(run.places(), before);
    EXPECT_EQ(run.centre(), centre);
    stick_piece(run.scene, run.state, 0, false);
    run.state.body.x[static_cast<size_t>(run.bar[7])].w = 0;  // as in jaws
    run.rest(1);
    EXPECT_FALSE(run.state.scratch->free_pieces.any);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
