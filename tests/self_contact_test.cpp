// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Tissue against tissue: a piece that is let go, a flap that is folded over.

#include "sim/contact/self_contact.h"
#include "sim/cutting/grasp.h"
#include "sim/world/add_event.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/cutting/cutting.h"
#include "sim/cutting/separation.h"
#include "sim/world/scratch.h"
#include "tests/cut_field.h"

namespace placode::sim {
namespace THIS_TEST {

using test::Inside;

Scene field_scene(bool listed, int iterations) {
    test::BoxOptions options = test::grasped_block(Vec3(0.010, 0.008, 0.002), {20, 16, 4});
    options.iterations = iterations;
    Scene made = test::box_scene(options);
    made.contact.self_contact = listed;
    return made;
}

struct Field : test::CutField {
    explicit Field(bool listed, int threads = 1, int iterations = 1)
        : CutField(field_scene(listed, iterations), threads) {}

    void move(const Vec3& to, double jaw) {
        const Vec3 from = tip;
        const int frames = static_cast<int>((to - from).norm() / 5e-5) + 1;
        for (int i = 1; i <= frames; ++i)
            run(from + static_cast<double>(i) / frames * (to - from), jaw, 1);
        tip = to;
    }
    void take_hold(const Vec3& where) {
        move(where, 0.6);
        for (double jaw = 0.6; jaw > closed(); jaw -= 0.01) run(where, jaw, 1);
        run(where, closed(), 50);
    }
    [[nodiscard]] double closed() const { return 0.5 * grip_angle(scene.tools[0]); }
    /// Calls visit(x) for the corners of living tets inside of a region at rest.
    template <class Visit>
    void corners_of(const Inside& inside, Visit&& visit) const {
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
            if (!inside(rest_centroid(scene, t))) continue;
            for (const int32_t v : corners(scene.body, state.body, t)) visit(v);
        }
    }
    [[nodiscard]] double lowest(const Inside& inside) const {
        double z = 1;
        corners_of(inside, [&](int32_t v) { z = std::min(z, position(state.body, v).z()); });
        return z;
    }
    /// Corners of tissue inside of a region at rest that stick in tets outside of it.
    [[nodiscard]] int sunken(const Inside& inside) const {
        std::vector<uint8_t> mine(state.body.x.size(), 0);
        corners_of(inside, [&](int32_t v) { mine[static_cast<size_t>(v)] = 1; });
        std::vector<Vec3> places;
        for (size_t v = 0; v < mine.size(); ++v)
            if (mine[v]) places.push_back(position(state.body, static_cast<int>(v)));
        int count = 0;
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            const auto& c = corners(scene.body, state.body, t);
            if (std::any_of(c.begin(), c.end(),
                            [&](int32_t v) { return mine[static_cast<size_t>(v)]; }))
                continue;
            const Vec3 a = position(state.body, c[0]);
            Mat3 edges;
            for (int k = 0; k < 3; ++k)
                edges.col(k) = position(state.body, c[static_cast<size_t>(k + 1)]) - a;
            const Mat3 inverse = edges.inverse();
            for (const Vec3& x : places) {
                const Vec3 w = inverse * (x - a);
                count += w.minCoeff() > 0 && w.sum() < 1 ? 1 : 0;
            }
        }
        return count;
    }
    /// What tissue pushes tissue upwards [N].
    [[nodiscard]] double lift_n(const Inside& inside) const {
        std::vector<uint8_t> mine(state.body.x.size(), 0);
        corners_of(inside, [&](int32_t v) { mine[static_cast<size_t>(v)] = 1; });
        const ContactSet& set = state.scratch->contacts;
        double sum = 0;
        for (int i = 0; i < set.contact_count; ++i) {
            const Contact& c = set.contacts[static_cast<size_t>(i)];
            if (c.side != kTissueSide) continue;
            double gap = c.offset_m;
            for (size_t k = 0; k < 4; ++k)
                gap += c.b[k] * c.n.dot(position(state.body, c.vertex[k]));
            const double force = c.stiffness_n_m * std::max(0.0, -gap) * c.n.z();
            sum += mine[static_cast<size_t>(c.vertex[0])] ? force : -force;
        }
        return sum;
    }
    [[nodiscard]] double mass_kg(const Inside& inside) const {
        double sum = 0;
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            if (inside(rest_centroid(scene, t)))
                sum += scene.body.spec().materials[0].density_kg_m3 *
                       static_cast<double>(scene.body.volume_m3()[static_cast<size_t>(t)]);
        }
        return sum;
    }

    Vec3 tip = Vec3(0, 0, 0.010);
};

// 3 x 3 x 1 mm in the left half of the block.
bool in_patch(const Vec3& p) {
    return std::abs(p.x() + 0.0025) < 0.0015 && std::abs(p.y()) < 0.0015 && p.z() > -0.001;
}

/// Cuts the patch out, carries it to the right half and opens the jaws over it.
void drop_patch(Field& field) {
    field.cut_out(in_patch);
    field.run(field.tip, 0.6, 200);
    field.take_hold(Vec3(-0.0025, 0, 0.0001));
    ASSERT_GT(field.state.grasps[0].count, 0);
    field.move(Vec3(-0.0025, 0, 0.004), field.closed());
    field.move(Vec3(0.002, 0, 0.004), field.closed());
    field.move(Vec3(0.002, 0, 0.0025), field.closed());
}

TEST(SelfContact, TheFieldCarriesThePiecesWeight) {
    // Converged, so that forces within a substep balance: with one iteration they lag behind the
    // start guess by k h^2 g for every vertex, several times the weight of so light a piece.
    Field field(true, 1, 30);
    drop_patch(field);
    double lift = 0;
    int looks = 0;
    for (int i = 0; i < 1000 && looks < 20; ++i) {
        field.run(field.tip, 0.6, 1);
        if (field.state.pieces.list[0].calm < 10) continue;
        lift += field.lift_n(in_patch);
        ++looks;
    }
    ASSERT_EQ(looks, 20);
    const double weight = 9.81 * field.mass_kg(in_patch);
    EXPECT_NEAR(lift / looks, weight, 0.05 * weight);
}

TEST(SelfContact, APieceThatIsLetGoLiesOnTheField) {
    Field field(true);
    drop_patch(field);
    for (int i = 0; i < 1000 && !field.state.pieces.list[0].resting; ++i)
        field.run(field.tip, 0.6, 1);
    ASSERT_TRUE(field.state.pieces.list[0].resting);
    EXPECT_NEAR(field.lowest(in_patch), 0, 6e-5);  // the gap that is kept is 0.05 mm
}

TEST(SelfContact, ItIsTheSameOnOneAndTwoThreads) {
    Field one(true, 1), two(true, 2);
    drop_patch(one);
    drop_patch(two);
    one.run(one.tip, 0.6, 200);
    two.run(two.tip, 0.6, 200);
    EXPECT_EQ(state_hash(one.state), state_hash(two.state));
    int pairs = 0;
    for (const int32_t n : one.state.self_contact.count) pairs += n;
    EXPECT_GT(pairs, 0);
}

TEST(SelfContact, AFlapThatIsFoldedOverDoesNotSinkIn) {
    // Cut free on three sides and below, it hangs at x = -1 mm and is folded to the right.
    const auto flap = [](const Vec3& p) {
        return p.x() > -0.0042 && p.x() < -0.001 && std::abs(p.y()) < 0.0015 && p.z() > -0.0005;
    };
    const auto hinge = [](const Vec3& p) { return p.x() > -0.00125; };
    const auto fold = [&](bool listed) {
        Field field(listed);
        field.cut_out(flap, hinge);
        field.take_hold(Vec3(-0.0038, 0, 0.0001));
        EXPECT_GT(field.state.grasps[0].count, 0);
        for (const Vec3& offset : {Vec3(-0.003, 0, 0.002), Vec3(-0.001, 0, 0.003),
                                   Vec3(0.0005, 0, 0.0022), Vec3(0.0012, 0, 0.0006)})
            field.move(offset, field.closed());
        field.run(field.tip, field.closed(), 300);
        return field.sunken([&](const Vec3& p) { return flap(p) && p.x() < -0.002; });
    };
    EXPECT_EQ(fold(true), 0);
    EXPECT_GT(fold(false), 4) << "else the test shows nothing";
}

TEST(SelfContact, AQuietFieldCostsNoPairs) {
    Field field(true);
    field.run(field.tip, 0.6, 50);
    for (const int32_t n : field.state.self_contact.count) EXPECT_EQ(n, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
