// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rods that come to rest, against closed forms; and what one substep keeps.
#include "sim/rod/rod_step.h"

#include <gtest/gtest.h>

#include "count_allocations.h"
#include "rod_line.h"

using namespace placode::sim;
using namespace placode::test;

namespace THIS_TEST {

RodSpec spec_of(int segments, double length_m) {
    RodSpec spec;
    spec.segments = segments;
    spec.length_m = length_m;
    return spec;
}

/// Tip of a clamped horizontal rod of length 1 whose weight is `load` = w L^3 / EI, by shooting on
/// theta'' = load (1 - s) cos theta, theta downwards (no stretch, no shear).
Vec2 heavy_elastica(double load) {
    const auto tip = [&](double slope, double& moment) {
        constexpr int kSteps = 4000;
        const double h = 1.0 / kSteps;
        Vec2 y(0, slope), place(0, 0);
        const auto rate = [&](double s, const Vec2& a) {
            return Vec2(a[1], -load * (1 - s) * std::cos(a[0]));
        };
        for (int i = 0; i < kSteps; ++i) {
            const double s = i * h;
            const Vec2 k1 = rate(s, y), k2 = rate(s + h / 2, y + h / 2 * k1),
                       k3 = rate(s + h / 2, y + h / 2 * k2), k4 = rate(s + h, y + h * k3);
            const double before = y[0];
            y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            const double middle = 0.5 * (before + y[0]);
            place += h * Vec2(std::cos(middle), std::sin(middle));
        }
        moment = y[1];
        return place;
    };
    double low = 0, high = load, moment = 0;
    for (int i = 0; i < 200; ++i) {
        const double slope = 0.5 * (low + high);
        tip(slope, moment);
        (moment > 0 ? high : low) = slope;
    }
    return tip(0.5 * (low + high), moment);
}

/// Tip of the cantilever of 20 mm, settled.
Vec3 cantilever_tip(int segments, double gravity) {
    const Rod rod(spec_of(segments, 0.02));
    RodState state(rod, straight(rod));
    hold_node(state, 0);
    clamp_end(state, 0);
    RodDrive drive;
    drive.h_s = 2e-3;
    drive.gravity_m_s2 = Vec3(0, 0, -gravity);
    EXPECT_TRUE(settle(rod, state, drive, 1e-9));
    return state.x.back();
}

// Euler and Timoshenko: w L^4 / (8 EI) + w L^2 / (2 GA).
TEST(RodStep, CantileverBendsAsBeamTheorySaysAndConvergesWithTheSquare) {
    const RodSpec spec = spec_of(1, 0.02);
    const double w = mass_per_m(spec) * 0.0981, length = spec.length_m;
    const double exact = w * std::pow(length, 4) / (8 * spec.stiffness.bend_n_m2) +
                         w * length * length / (2 * spec.stiffness.shear_n);
    double error[3];
    for (int i = 0; i < 3; ++i) error[i] = -cantilever_tip(10 << i, 0.0981).z() / exact - 1;
    // One over the square of the number of segments, as midpoints give; 1 % from 10 on.
    EXPECT_LT(std::abs(error[0]), 0.0101);
    EXPECT_NEAR(error[0] / error[1], 4, 0.1);
    EXPECT_NEAR(error[1] / error[2], 4, 0.1);
    EXPECT_LT(std::abs(error[2]), 0.001);
}

TEST(RodStep, CantileverSagsFarAsTheElasticaDoes) {
    const RodSpec spec = spec_of(1, 0.02);
    for (const double load : {2.0, 10.0, 50.0}) {
        const double gravity =
            load * spec.stiffness.bend_n_m2 / (mass_per_m(spec) * std::pow(spec.length_m, 3));
        const Vec2 exact = spec.length_m * heavy_elastica(load);
        const Vec3 tip = cantilever_tip(40, gravity);
        // 1 % of the deflection asked for; 0.2 % seen.
        EXPECT_NEAR(-tip.z(), exact[1], 0.003 * exact[1]) << load;
        EXPECT_NEAR(tip.x(), exact[0], 0.003 * exact[1]) << load;
    }
}

TEST(RodStep, CatenaryHangsAsACosh) {
    RodSpec spec = spec_of(100, 0.15);
    spec.stiffness.bend_n_m2 = spec.stiffness.twist_n_m2 = 1e-12;  // boundary layers below 1 mm
    const Rod rod(spec);
    const double span = 0.1;
    // A zigzag of the rod's length between the supports.
    const double rise = std::sqrt(0.15 * 0.15 - span * span) / 2;
    RodState state(rod, along(rod, [&](double s) {
                       return Vec3(span * s, 0, -2 * rise * (0.5 - std::abs(s - 0.5)));
                   }));
    hold_node(state, 0);
    hold_node(state, 100);
    RodDrive drive;
    drive.h_s = 5e-3;
    ASSERT_TRUE(settle(rod, state, drive, 1e-7, 100000));
    // 2 a sinh(span / 2 a) = L.
    double low = 0.01, high = 0.2;
    for (int i = 0; i < 100; ++i) {
        const double a = 0.5 * (low + high);
        (2 * a * std::sinh(span / (2 * a)) > 0.15 ? low : high) = a;
    }
    const double a = low;
    const double sag = a * (std::cosh(span / (2 * a)) - 1);
    for (size_t i = 0; i <= 100; ++i) {
        const Vec3& p = state.x[i];
        const double z = a * (std::cosh((p.x() - span / 2) / a) - std::cosh(span / (2 * a)));
        EXPECT_NEAR(p.z(), z, 0.002 * sag) << i;
    }
    // Horizontal pull w a all along.
    const double pull = mass_per_m(spec) * 9.81 * a;
    EXPECT_NEAR(segment_force(rod, state, 50).x(), pull, 0.002 * pull);
    EXPECT_NEAR(segment_force(rod, state, 3).x(), pull, 0.002 * pull);
}

TEST(RodStep, StretchesAndTwistsByItsModuliWhateverTheDamping) {
    for (const double retardation : {0.0, 1e-4, 1e-2}) {
        RodSpec spec = spec_of(30, 0.03);
        spec.retardation_s = retardation;
        const Rod rod(spec);
        RodState state(rod, straight(rod));
        hold_node(state, 0);
        clamp_end(state, 0);
        clamp_end(state, 1);
        state.end_frame[1] = Quat(Eigen::AngleAxisd(1, Vec3::UnitX())) * state.end_frame[1];
        std::vector<Vec3> pull(31, Vec3::Zero());
        pull.back().x() = 0.5;
        RodDrive drive;
        drive.h_s = 1e-3;
        drive.gravity_m_s2.setZero();
        drive.force_n = pull;
        ASSERT_TRUE(settle(rod, state, drive, 1e-9, 100000));
        EXPECT_NEAR(state.x.back().x(), 0.03 * (1 + 0.5 / spec.stiffness.stretch_n), 1e-9);
        // A turn of 1 rad over 30 segments: 4 tan(phi / 4) is 1e-5 from phi.
        const double moment = spec.stiffness.twist_n_m2 / 0.03;
        for (const int node : {0, 15, 30})
            EXPECT_NEAR(node_moment(rod, state, node).z(), moment, 1e-3 * moment);
    }
}

TEST(RodStep, PinnedColumnBucklesAtEulersLoad) {
    RodSpec spec = spec_of(40, 0.02);
    const Rod rod(spec);
    const double euler = kPi * kPi * spec.stiffness.bend_n_m2 / (0.02 * 0.02);
    RodState state(
        rod, along(rod, [](double s) { return Vec3(0.02 * s, 0, 1e-6 * std::sin(kPi * s)); }));
    hold_node(state, 0);
    hold_node(state, 40);
    RodDrive drive;
    drive.h_s = 2e-3;
    drive.gravity_m_s2.setZero();
    // Shortened by 0.5 %: deflection a = 2 L / pi sqrt(0.005), and the load is above the critical
    // one by (pi a / L)^2 / 8 = 0.25 %.
    state.node_target[40].x() = 0.02 * 0.995;
    ASSERT_TRUE(settle(rod, state, drive, 1e-9, 100000));
    EXPECT_NEAR(state.x[20].z(), 2 * 0.02 / kPi * std::sqrt(0.005), 0.02 * 9e-4);
    const double load = -segment_force(rod, state, 20).x();
    EXPECT_NEAR(load / euler, 1.0025, 0.003);  // 3 % asked for
}

/// Rate at which a twisted ring leaves its plane [1/s]; negative = comes back.
double ring_growth(const Rod& rod, double twist_rad) {
    const double radius = rod.spec().length_m / (2 * kPi);
    const auto on_ring = [&](double s) {
        return Vec3(radius * std::sin(2 * kPi * s), 0, radius * (1 - std::cos(2 * kPi * s)));
    };
    RodState state(rod, along(rod, on_ring));
    const int n = rod.segments();
    // Twist spread evenly, then the ends are closed.
    for (int j = 0; j < n; ++j) {
        const auto i = as_index(j);
        const Vec3 axis = (state.x[i + 1] - state.x[i]).normalized();
        state.q[i] = Quat(Eigen::AngleAxisd(twist_rad * (j + 0.5) / n, axis)) * state.q[i];
    }
    const Quat along_x = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitX());
    state.end_held = {1, 1};
    state.end_frame[0] = along_x;
    // The frames have turned round once with the ring.
    state.end_frame[1] = Quat(Eigen::AngleAxisd(twist_rad, Vec3::UnitX())) *
                         Quat(Eigen::AngleAxisd(-2 * kPi, Vec3::UnitY())) * along_x;
    const Quat last = state.q.back();
    if (last.dot(state.end_frame[1]) < 0) state.end_frame[1].coeffs() *= -1;
    hold_node(state, 0);
    hold_node(state, n);
    RodScratch scratch(rod);
    RodDrive drive;
    drive.h_s = 1e-4;
    drive.gravity_m_s2.setZero();
    // Michell's mode has two waves. (One wave turns the ring about its clamp and costs nothing.)
    for (int i = 1; i < n; ++i)
        state.x[as_index(i)].y() += 1e-5 * radius * (1 - std::cos(4 * kPi * i / n));
    const auto height = [&] {
        Vec2 sum = Vec2::Zero();
        for (int i = 0; i < n; ++i)
            sum += state.x[as_index(i)].y() *
                   Vec2(std::sin(4 * kPi * i / n), std::cos(4 * kPi * i / n));
        return sum.norm();
    };
    for (int i = 0; i < 100; ++i) step_rod(rod, state, drive, scratch);
    const double before = height();
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps; ++i) step_rod(rod, state, drive, scratch);
    return std::log(height() / before) / (kSteps * drive.h_s);
}

// Michell 1889: a ring, straight before it was bent, leaves its plane at the twist
// 2 pi sqrt(3) EI / GJ. Source: Goriely 2006, "Twisted elastic rings and the rediscoveries of
// Michell's instability".
TEST(RodStep, TwistedRingWrithesAtMichellsTwist) {
    for (const double ratio : {0.7142857, 1.0}) {
        RodSpec spec = spec_of(100, 0.06);
        spec.stiffness.twist_n_m2 = ratio * spec.stiffness.bend_n_m2;
        spec.drag_per_s = 2000;  // creeps: the rate is nearly linear in the twist
        const Rod rod(spec);
        const double michell = 2 * kPi * std::sqrt(3) / ratio;
        double low = 0.8 * michell, high = 1.2 * michell;
        EXPECT_LT(ring_growth(rod, low), 0);
        EXPECT_GT(ring_growth(rod, high), 0);
        for (int i = 0; i < 8; ++i) {
            const double middle = 0.5 * (low + high);
            (ring_growth(rod, middle) > 0 ? high : low) = middle;
        }
        EXPECT_NEAR(0.5 * (low + high) / michell, 1, 0.02) << ratio;  // 5 % asked for
    }
}

TEST(RodStep, FreeRodKeepsItsMomentum) {
    const Rod rod(spec_of(60, 0.03));
    RodState state(rod, straight(rod));
    for (size_t i = 0; i < state.v.size(); ++i)
        state.v[i] = Vec3(0.02, 0, 0.03) + Vec3(0, 0, 20).cross(state.x[i] - Vec3(0.015, 0, 0));
    for (Vec3& w : state.w) w.z() = 20;
    RodDrive drive;
    drive.gravity_m_s2.setZero();
    RodScratch scratch(rod);
    const RodMotion before = rod_motion(rod, state);
    double energy = before.kinetic_j + rod_energy(rod, state);
    for (int i = 0; i < 400; ++i) {
        step_rod(rod, state, drive, scratch);
        const double now = rod_motion(rod, state).kinetic_j + rod_energy(rod, state);
        EXPECT_LE(now, energy * (1 + 1e-9)) << i;
        energy = now;
    }
    const RodMotion after = rod_motion(rod, state);
    const double p = before.momentum_kg_m_s.norm(), l = before.angular_kg_m2_s.norm();
    // Linear: rounding. Angular: implicit Euler takes some off a turning body.
    EXPECT_LT((after.momentum_kg_m_s - before.momentum_kg_m_s).norm(), 1e-9 * p);
    EXPECT_LT((after.angular_kg_m2_s - before.angular_kg_m2_s).norm(), 0.02 * l);
}

// First mode of a clamped rod, 1.8751^2 / L^2 sqrt(EI / rho A), with substeps of 1/400 of a period.
TEST(RodStep, ClampedRodSwingsAtItsFrequency) {
    RodSpec spec = spec_of(40, 0.02);
    spec.retardation_s = 0;
    const Rod rod(spec);
    const double omega = 1.875104 * 1.875104 / (0.02 * 0.02) *
                         std::sqrt(spec.stiffness.bend_n_m2 / mass_per_m(spec));
    RodState state(rod, straight(rod));
    hold_node(state, 0);
    clamp_end(state, 0);
    for (size_t i = 0; i < state.v.size(); ++i) state.v[i].z() = 1e-3 * std::pow(i / 40.0, 2);
    RodDrive drive;
    drive.gravity_m_s2.setZero();
    drive.h_s = 2 * kPi / omega / 400;
    RodScratch scratch(rod);
    std::vector<double> crossings;
    double last = 0;
    for (int i = 1; crossings.size() < 4; ++i) {
        step_rod(rod, state, drive, scratch);
        const double z = state.x.back().z();
        if (i > 1 && last * z < 0) crossings.push_back((i - z / (z - last)) * drive.h_s);
        last = z;
    }
    const double seen = kPi * 2 / (crossings[3] - crossings[1]);
    EXPECT_NEAR(seen / omega, 1, 0.01);
}

TEST(RodStep, FallsFreely) {
    const Rod rod(spec_of(50, 0.025));
    RodState state(rod, straight(rod));
    RodDrive drive;
    RodScratch scratch(rod);
    for (int i = 0; i < 400; ++i) step_rod(rod, state, drive, scratch);
    // Implicit Euler: g t (t + h) / 2.
    const double fall = 9.81 * 0.1 * (0.1 + drive.h_s) / 2;
    for (const Vec3& x : state.x) EXPECT_NEAR(x.z(), -fall, 1e-9 * fall);
}

TEST(RodStep, HandsHoldNodesAndFramesExactly) {
    const Rod rod(spec_of(31, 0.03));
    RodState state(rod, straight(rod));
    hold_node(state, 10);
    state.frame_held[10] = 1;
    RodScratch scratch(rod);
    const RodDrive drive;
    for (int i = 0; i < 200; ++i) {
        state.node_target[10] += Vec3(0, 1e-5, 2e-5);
        state.frame_target[10] =
            Quat(Eigen::AngleAxisd(2e-3, Vec3::UnitZ())) * state.frame_target[10];
        const RodReport report = step_rod(rod, state, drive, scratch);
        ASSERT_FALSE(report.not_finite);
        ASSERT_EQ(state.x[10], state.node_target[10]);
        ASSERT_EQ(state.q[10].coeffs(), state.frame_target[10].coeffs());
    }
    for (int i = 0; i < 400; ++i) step_rod(rod, state, drive, scratch);
    // Node 11 goes where the held frame points.
    const Vec3 along_frame = state.q[10] * Vec3::UnitZ();
    EXPECT_GT((state.x[11] - state.x[10]).normalized().dot(along_frame), 0.999);
}

TEST(RodStep, SameInputSameBitsAndNothingIsAllocatedOrLocked) {
    const Rod rod(spec_of(300, 0.15));
    const auto hang = [&] {
        RodState state(rod, straight(rod));
        hold_node(state, 0);
        clamp_end(state, 0);
        hold_node(state, 300);
        return state;
    };
    RodState one = hang(), other = hang();
    RodScratch scratch(rod), another(rod);
    const RodDrive drive;
    const long allocations = placode::test::allocations, locks = placode::test::locks;
    for (int i = 0; i < 200; ++i) {
        one.node_target[300] -= Vec3(1e-4, 0, 0);
        step_rod(rod, one, drive, scratch);
    }
    EXPECT_EQ(placode::test::allocations, allocations);
    EXPECT_EQ(placode::test::locks, locks);
    for (int i = 0; i < 200; ++i) {
        other.node_target[300] -= Vec3(1e-4, 0, 0);
        // Scratch may be lost between any two substeps.
        if (i == 100) another = RodScratch(rod);
        step_rod(rod, other, drive, another);
    }
    EXPECT_EQ(state_hash(one), state_hash(other));
    EXPECT_LT(one.x[150].z(), -0.01) << "it should have sagged";
}

TEST(RodStep, StaysFiniteInBadHands) {
    const Rod rod(spec_of(100, 0.05));
    RodState state(rod, straight(rod));
    hold_node(state, 0);
    hold_node(state, 100);
    RodScratch scratch(rod);
    const RodDrive drive;
    // 10 m/s back and forth, pulled to three times the length and pushed through the other end.
    for (int i = 0; i < 4000; ++i) {
        state.node_target[100].x() = 0.05 + 0.1 * std::sin(0.025 * i);
        const RodReport report = step_rod(rod, state, drive, scratch);
        ASSERT_FALSE(report.not_finite) << i;
        for (const Vec3& x : state.x) ASSERT_LT(x.norm(), 0.5) << i;
    }
    state.node_target[100].x() = 0.03;
    EXPECT_TRUE(settle(rod, state, drive, 1e-6, 40000));
    for (int j = 0; j < 100; ++j) {
        const double length = (state.x[as_index(j) + 1] - state.x[as_index(j)]).norm();
        EXPECT_NEAR(length, 0.5e-3, 1e-6) << j;
    }
    state.v[50].x() = std::nan("");
    EXPECT_TRUE(step_rod(rod, state, drive, scratch).not_finite);
    EXPECT_TRUE(state.x[50].allFinite());
    EXPECT_FALSE(step_rod(rod, state, drive, scratch).not_finite) << "it goes on";
}

}  // namespace THIS_TEST
