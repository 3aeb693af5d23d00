// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A plane below the skin parts where it is pulled harder than it holds.
#include "sim/cutting/plane_parting.h"

#include <gtest/gtest.h>

#include "sim/cutting/cutting.h"
#include "sim/step/step.h"
#include "tests/undermine_pad.h"

namespace placode::sim {
namespace THIS_TEST {

const Scene& pad() {
    static const auto scene = build_operative_field(test::undermine_pad());
    return *scene;
}

/// All of the tissue stretched upwards by a factor, from its bed.
void stretch(State& state, double factor) {
    for (size_t v = 0; v < pad().body.mesh().rest.size(); ++v)
        state.body.x[v].z = static_cast<float>(factor * pad().body.mesh().rest[v].z());
}

void frames(State& state, int count) {
    std::array<ToolInput, kMaxTools> nobody{};
    std::array<ToolFeedback, kMaxTools> feedback{};
    const size_t tools = pad().tools.size();
    for (int i = 0; i < count; ++i)
        (void)step(pad(), state, {nobody.data(), tools}, {feedback.data(), tools});
}

TEST(PlaneParting, FacesLieBelowTheSubcutisOutsideTheLesionAndTheWound) {
    const DissectionPlane& plane = pad().plane;
    ASSERT_GT(plane.faces.size(), 300U);
    double area = 0;
    for (const DissectionPlane::Face& face : plane.faces) {
        if (face.middle_m.head<2>().norm() > 0.006) {  // nearer to the lesion layers blend
            EXPECT_NEAR(face.middle_m.z(), -0.0016, 5e-7);
        }
        EXPECT_EQ(face.side, face.middle_m.y() > 0 ? 1 : -1);
        for (const int32_t t : face.above)
            EXPECT_EQ(pad().body.mesh().tissue[static_cast<size_t>(t)], Tissue::kSubcutis);
        area += static_cast<double>(face.area_m2);
    }
    const double wound = 3.14159265 * 0.006 * 0.002, lesion = 3.14159265 * 0.0022 * 0.0022;
    EXPECT_NEAR(area, 0.044 * 0.028 - wound - lesion, 0.01 * area);
    // From every station to both sides, ten millimetres at least.
    EXPECT_EQ(plane.rays.size(), 2 * pad().slit.stations.size());
    for (const DissectionPlane::Ray& ray : plane.rays) {
        EXPECT_GT(ray.stretches.back().until_m, 0.0095);
        EXPECT_EQ(ray.side, ray.out.y() > 0 ? 1 : -1);
    }
}

TEST(PlaneParting, TractionIsThatOfTheStretchedLayer) {
    State state(pad(), 1);
    const double a = 1.3;
    stretch(state, a);
    const Material& m = pad().body.spec().materials[static_cast<size_t>(Tissue::kSubcutis)];
    const NeoHookean n = neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
    // Confined: (lambda + mu)(a - 1) exactly.
    const double expected = (n.lambda_pa + n.mu_pa) * (a - 1);
    Vec3 normal;
    for (int face = 0; face < 20; ++face) {
        const Vec3 pull = traction_on(pad(), state, face, normal);
        EXPECT_NEAR(normal.z(), 1, 1e-5);
        EXPECT_NEAR(pull.z(), expected, 1e-3 * expected);
        EXPECT_LT(pull.head<2>().norm(), 1e-2 * expected);
    }
}

TEST(PlaneParting, WhatIsPulledLessOrPressedStaysAndWhatIsPulledMoreParts) {
    const Material& m = pad().body.spec().materials[static_cast<size_t>(Tissue::kSubcutis)];
    const NeoHookean n = neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
    const double limit = 1 + pad().plane.strength_pa / (n.lambda_pa + n.mu_pa);
    for (const double factor : {0.7, 1.0, 0.98 * limit, 1.02 * limit}) {
        State state(pad(), 1);
        stretch(state, factor);
        state.frame = 0;
        // As often as it takes, without letting it move.
        for (int i = 0; i < 64; ++i) {
            ++state.frame;
            part_plane(pad(), state);
        }
        const double whole = undermined_m2(pad(), state, 1) + undermined_m2(pad(), state, -1);
        if (factor > limit)
            EXPECT_GT(whole, 1e-3) << factor;
        else
            EXPECT_EQ(whole, 0) << factor;
    }
}

TEST(PlaneParting, WhatWasPartedIsCountedFromTheEdge) {
    State state(pad(), 1);
    EXPECT_EQ(undermined_m(pad(), state, 10), 0);
    test::part_within(pad(), state, 0.004);
    double least = 1, most = 0;
    for (size_t ray = 0; ray < pad().plane.rays.size(); ++ray) {
        const double depth = undermined_m(pad(), state, static_cast<int>(ray));
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    EXPECT_GT(least, 0.002) << "up to an edge of the mesh less";
    EXPECT_LT(most, 0.006);
    EXPECT_NEAR(undermined_m2(pad(), state, 1), undermined_m2(pad(), state, -1), 1e-5);
    // Of what is to be freed, straight beside the wound, about half; nothing too far.
    for (const int side : {1, -1}) {
        const UnderminedArea area = undermined_area(pad(), state, side);
        EXPECT_NEAR(area.wanted_m2, 0.012 * DissectionPlane::kWantedM, 0.2 * area.wanted_m2);
        EXPECT_NEAR(area.freed_m2, 0.5 * area.wanted_m2, 0.15 * area.wanted_m2);
        EXPECT_EQ(area.beyond_m2, 0);
    }
    test::part_within(pad(), state, 0.020);
    EXPECT_GT(undermined_area(pad(), state, 1).beyond_m2, 0);
    // Nothing falls apart.
    frames(state, 100);
    EXPECT_EQ(state.pieces.out, 0);
    EXPECT_EQ(state.pieces.crumbs, 0);
    EXPECT_EQ(state.flags, 0U);
}

TEST(PlaneParting, WhatIsTornAwayFreesNothing) {
    const DissectionPlane& plane = pad().plane;
    for (const bool above : {true, false}) {
        State state(pad(), 1);
        for (const DissectionPlane::Face& face : plane.faces) {
            const auto tet = static_cast<size_t>(face.above[0]);
            take_out(pad(), state,
                     above ? face.above[0]
                           : pad().surface.neighbours()[tet][static_cast<size_t>(face.face)]);
        }
        for (const int side : {1, -1}) {
            const UnderminedArea area = undermined_area(pad(), state, side);
            EXPECT_GT(area.wanted_m2, 5e-5);
            EXPECT_EQ(area.freed_m2, 0);
            EXPECT_GT(area.beyond_m2, 0) << "what is torn too far away is harm all the same";
            EXPECT_EQ(undermined_m2(pad(), state, side), 0);
        }
        EXPECT_EQ(undermined_m(pad(), state, 10), 0);
    }
}

TEST(PlaneParting, AFieldWithoutAWayThereIsRefused) {
    OperativeFieldSpec spec = test::undermine_pad();
    spec.slit->layers = 2;
    EXPECT_THROW((void)build_operative_field(spec), MeshError);
    spec = test::undermine_pad();
    spec.plane->strength_pa = 0;
    EXPECT_THROW((void)build_operative_field(spec), MeshError);
    spec = test::undermine_pad();
    spec.tools[0].kind = ToolKind::kProbe;
    EXPECT_THROW((void)build_operative_field(spec), MeshError) << "a probe has no jaws to spread";
}

}  // namespace THIS_TEST
}  // namespace placode::sim
