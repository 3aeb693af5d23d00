// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A rod at rest: what is refused, energy and its derivative, what is saved and hashed.
#include "sim/rod/rod.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "rod_line.h"

using namespace placode::sim;
using namespace placode::test;
using ::testing::HasSubstr;

namespace THIS_TEST {

RodSpec bent_spec(int segments) {
    RodSpec spec;
    spec.segments = segments;
    spec.length_m = 0.5e-3 * segments;
    for (int j = 0; j < segments; ++j) spec.segment_m.push_back(j % 2 == 0 ? 0.4e-3 : 0.6e-3);
    for (int j = 1; j < segments; ++j) spec.rest_bend_rad.emplace_back(0.1, -0.05, 0.02 * j);
    return spec;
}

/// A crumpled rod with clamps: every term of the energy is there.
RodState crumpled(const Rod& rod) {
    uint64_t seed = 7;
    const auto random = [&] {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5;
    };
    RodState state(rod, along(rod, [&](double s) {
                       return Vec3(rod.spec().length_m * s, 2e-4 * random(), 2e-4 * random());
                   }));
    clamp_end(state, 0);
    clamp_end(state, 1);
    for (Vec3& x : state.x) x += 1e-5 * Vec3(random(), random(), random());
    for (Quat& q : state.q) {
        const Vec3 axis(random(), random(), random());
        q = Quat(Eigen::AngleAxisd(1.5 * random(), axis.normalized())) * q;
    }
    return state;
}

std::string refusal(RodSpec spec, const std::string& field) {
    try {
        const Rod rod(std::move(spec));
    } catch (const RodError& error) {
        EXPECT_EQ(error.field(), field);
        return error.what();
    }
    return "not refused";
}

/// Bytes of what decides the future, as saved_state.cpp sees it.
struct Bytes {
    std::vector<unsigned char> all;
    template <class T>
    void one(const T& value) {
        if constexpr (kPlainBytes<T>) {
            const auto* p = reinterpret_cast<const unsigned char*>(&value);
            all.insert(all.end(), p, p + sizeof value);
        } else {
            for (const auto& element : value) one(element);
        }
    }
    template <class... T>
    void state(const T&... parts) {
        (one(parts), ...);
    }
};
std::vector<unsigned char> bytes_of(const RodState& state) {
    Bytes bytes;
    fields(state, bytes);
    return bytes.all;
}

TEST(Rod, RefusesWithFieldValueAndRange) {
    RodSpec spec;
    spec.segments = 301;
    EXPECT_THAT(refusal(spec, "segments"), HasSubstr("found 301; expected a whole number from 1"));
    spec.segments = 3;
    spec.radius_m = 0;
    EXPECT_THAT(refusal(spec, "radius_m"), HasSubstr("found 0; expected a number above 0"));
    spec.radius_m = 1e-4;
    spec.stiffness.twist_n_m2 = -1;
    EXPECT_THAT(refusal(spec, "twist_n_m2"), HasSubstr("found -1"));
    spec = RodSpec();
    spec.segments = 2;
    spec.segment_m = {0.1, 0.1};
    EXPECT_THAT(refusal(spec, "segment_m"), HasSubstr("add up to length_m"));
    spec.segment_m.clear();
    spec.rest_bend_rad = {Vec3(1, 1, 1)};
    EXPECT_THAT(refusal(spec, "rest_bend_rad"), HasSubstr("an angle below 1.5"));
    spec.rest_bend_rad.clear();
    spec.drag_per_s = std::nan("");
    EXPECT_THAT(refusal(spec, "drag_per_s"), HasSubstr("found nan; expected 0 or more"));
}

TEST(Rod, FourModuliAreThoseOfARoundSection) {
    // 4/0: docs of the thread give EA 25 N and EI 5.2e-8 N m^2 at 1 GPa.
    const RodStiffness k = round_rod(0.09e-3, 1e9, 0.4);
    EXPECT_NEAR(k.stretch_n, 25.4, 0.1);
    EXPECT_NEAR(k.bend_n_m2, 5.15e-8, 0.01e-8);
    EXPECT_NEAR(k.twist_n_m2 / k.bend_n_m2, 1 / 1.4, 1e-12);
    EXPECT_NEAR(k.shear_n / k.stretch_n, 6 * 1.4 / (7 + 2.4) / 2.8, 1e-12);
}

// Central differences of an energy of 1e-4 J: 1e-6 of the largest entry is what steps of 1e-9 m and
// 1e-6 rad leave.
TEST(Rod, ForcesAndTorquesAreTheDerivativeOfTheEnergy) {
    const Rod rod(bent_spec(6));
    const RodState state = crumpled(rod);
    std::vector<Vec3> force(7), torque(6);
    rod_gradient(rod, state, force, torque);
    double most_force = 0, most_torque = 0;
    for (const Vec3& f : force) most_force = std::max(most_force, f.norm());
    for (const Vec3& t : torque) most_torque = std::max(most_torque, t.norm());
    for (size_t i = 0; i < 7; ++i) {
        for (int a = 0; a < 3; ++a) {
            RodState low = state, high = state;
            low.x[i][a] -= 1e-9;
            high.x[i][a] += 1e-9;
            const double slope = (rod_energy(rod, high) - rod_energy(rod, low)) / 2e-9;
            EXPECT_NEAR(force[i][a], slope, 1e-6 * most_force) << "node " << i << " axis " << a;
        }
    }
    for (size_t j = 0; j < 6; ++j) {
        for (int a = 0; a < 3; ++a) {
            RodState low = state, high = state;
            low.q[j] = Quat(Eigen::AngleAxisd(-1e-6, Vec3::Unit(a))) * low.q[j];
            high.q[j] = Quat(Eigen::AngleAxisd(1e-6, Vec3::Unit(a))) * high.q[j];
            const double slope = (rod_energy(rod, high) - rod_energy(rod, low)) / 2e-6;
            EXPECT_NEAR(torque[j][a], slope, 1e-6 * most_torque) << "frame " << j << " axis " << a;
        }
    }
}

TEST(Rod, EnergyIsThatOfTheAngleNearlyUpToAWholeTurn) {
    RodSpec spec;
    spec.segments = 2;
    const Rod rod(spec);
    const double per_rad2 = 0.5 * spec.stiffness.twist_n_m2 / (0.5 * spec.length_m);
    for (const double angle : {0.1, 0.5, 1.0, 3.0, 5.0}) {
        RodState state(rod, straight(rod));
        state.q[1] = Quat(Eigen::AngleAxisd(0.5 * angle, Vec3::UnitX())) *
                     (Quat(Eigen::AngleAxisd(0.5 * angle, Vec3::UnitX())) * state.q[0]);
        const double seen = std::sqrt(rod_energy(rod, state) / per_rad2);
        EXPECT_NEAR(seen, 4 * std::tan(angle / 4), 1e-9) << angle;
        if (angle <= 1) {
            EXPECT_NEAR(seen, angle, 0.025 * angle * angle * angle) << angle;
        }
    }
}

TEST(Rod, RestsAlongItsRestBend) {
    RodSpec spec;
    spec.segments = 20;
    spec.rest_bend_rad.assign(19, Vec3(0.1, 0, 0));
    const Rod rod(spec);
    RodState state(rod, straight(rod));
    for (size_t j = 1; j < 20; ++j)
        state.q[j] = state.q[j - 1] * Quat(Eigen::AngleAxisd(0.1, Vec3::UnitX()));
    for (size_t j = 0; j < 20; ++j)
        state.x[j + 1] = state.x[j] + rod.length_m()[j] * (state.q[j] * Vec3::UnitZ());
    // Rounding only; straight it would hold 1e-4 J.
    EXPECT_LT(rod_energy(rod, state), 1e-25);
}

TEST(Rod, HashSeesEveryFieldThatIsSaved) {
    const Rod rod(bent_spec(4));
    const RodState state = crumpled(rod);
    const auto saved = bytes_of(state);
    const auto whole = state.x.size() * 73 + state.q.size() * 89 + 2 + 64;
    EXPECT_EQ(saved.size(), whole) << "a field is missing in fields()";
    RodState copy = state;
    EXPECT_EQ(state_hash(copy), state_hash(state));
    const auto differs = [&](auto&& change) {
        RodState other = state;
        change(other);
        EXPECT_NE(state_hash(other), state_hash(state));
        EXPECT_NE(bytes_of(other), saved);
    };
    differs([](RodState& s) { s.x[2].y() += 1e-12; });
    differs([](RodState& s) { s.v[4].x() = 1e-12; });
    differs([](RodState& s) { s.q[3].x() += 1e-12; });
    differs([](RodState& s) { s.w[0].z() = 1e-12; });
    differs([](RodState& s) { s.node_held[1] = 1; });
    differs([](RodState& s) { s.node_target[1].x() += 1e-12; });
    differs([](RodState& s) { s.frame_held[1] = 1; });
    differs([](RodState& s) { s.frame_target[1].x() += 1e-12; });
    differs([](RodState& s) { s.end_held[1] = 0; });
    differs([](RodState& s) { s.end_frame[0].x() += 1e-12; });
}

}  // namespace THIS_TEST
