// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A patch in an operative scene: it lies, hangs, is touched, grasped and carried.
#include "sim/contact/patch_contact.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "sim/verify/newton.h"
#include "sim/world/saved_state.h"
#include "tests/patch_pad.h"

namespace placode::sim {
namespace THIS_TEST {

using test::Lying;

OperativeFieldSpec pad(bool patch = true) { return test::patch_pad(patch); }

std::string refusal(const OperativeFieldSpec& spec) {
    try {
        (void)build_operative_field(spec);
    } catch (const MeshError& error) {
        return error.what();
    }
    return {};
}

TEST(Patch, NoPatchNoSheetAndNothingInTheState) {
    const auto scene = build_operative_field(pad(false));
    EXPECT_FALSE(scene->patch);
    EXPECT_TRUE(scene->body.spec().sheet.empty());
    const State state(*scene, 1);
    EXPECT_TRUE(state.patch.touch.empty());
    EXPECT_TRUE(state.patch.load_n.empty());
}

TEST(Patch, AnySheetThatIsNoPatchIsRefused) {
    const auto scene = build_operative_field(pad());
    EXPECT_THROW(Scene(SoftBody(scene->body.spec())), MeshError);
    EXPECT_NO_THROW(Scene(SoftBody(scene->body.spec()), scene->patch));
}

TEST(Patch, WeighsWhatItsVolumeDoes) {
    const Lying run(pad());
    double mass = 0, area = 0;
    for (int i = 0; i < run.patch().vertex_count; ++i) {
        mass += static_cast<double>(
            run.scene->body.mass_kg()[static_cast<size_t>(run.patch().first_vertex + i)]);
        area += static_cast<double>(run.patch().area_m2[static_cast<size_t>(i)]);
    }
    EXPECT_NEAR(area, 0.008 * 0.006, 1e-9);
    EXPECT_NEAR(mass, 0.008 * 0.006 * 0.0004 * 1050, 1e-9);
    EXPECT_EQ(run.patch().triangles.size(), 96U);
}

TEST(Patch, RefusesWhatItCannotBeAndNamesIt) {
    const auto with = [](auto&& change) {
        OperativeFieldSpec spec = pad();
        change(spec);
        return refusal(spec);
    };
    using Spec = OperativeFieldSpec;
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_EQ(with([](Spec&) {}), "");
    std::string text = with([](Spec& s) { s.patch->thickness_m = 0; });
    EXPECT_TRUE(has(text, "patch.thickness_m = 0, allowed 0.0001 to 0.001")) << text;
    text = with([](Spec& s) { s.patch->material.youngs_modulus_pa = 0; });
    EXPECT_TRUE(has(text, "patch.youngs_modulus_pa = 0, allowed 10000 to")) << text;
    text = with([](Spec& s) { s.patch->edge_m = 0.00035; });
    EXPECT_TRUE(has(text, "patch.edge_m = 0.00035, allowed 0.0004 to 0.002")) << text;
    text = with([](Spec& s) {
        s.patch->thickness_m = 0.0002;
        s.patch->edge_m = 0.0003 / 2;
    });
    EXPECT_TRUE(has(text, "patch.edge_m = 0.00015, allowed 0.0003 to")) << text;
    text = with([](Spec& s) {
        s.patch->length_m = 0.012;
        s.patch->width_m = 0.010;
        s.patch->thickness_m = 0.0002;
        s.patch->edge_m = 0.0003;
    });
    EXPECT_TRUE(has(text, "patch.edge_m = 0.0003 makes more than 1600 triangles; allowed from "))
        << text;
    text = with([](Spec& s) { s.patch->centre_m = Vec2(0.005, 0); });
    EXPECT_TRUE(has(text,
                    "patch.centre_m: a corner lies at x = 0.009 m, outside of the field; allowed "
                    "-0.0088 to 0.0088"))
        << text;
    text = with([](Spec& s) { s.heat = true; });
    EXPECT_TRUE(has(text, "expected heat.enabled: false")) << text;
    text = with([](Spec& s) { s.tools[0].kind = ToolKind::kScissors; });
    EXPECT_TRUE(has(text, "scissors are among the tools")) << text;
    text = with([](Spec& s) { s.solver.method = Method::kXpbd; });
    EXPECT_TRUE(has(text, "needs solver.method vbd")) << text;
}

// Its weight presses it 0.2 um into its contact; the bound is a hundredth of its thickness.
TEST(Patch, ComesDownAndLiesOnTheTissueWithoutDrift) {
    Lying run(pad());
    run.frames(2000);
    EXPECT_LT(run.overlap(), 4e-6);
    // The tissue sinks by up to 15 um under its own weight.
    EXPECT_LT(run.highest(), run.patch().thickness_m / 2 + 1e-6);
    const std::vector<Vec3> before = run.places();
    run.frames(4000);
    EXPECT_LT(run.farthest(before), 2e-6);
    EXPECT_LT(run.overlap(), 4e-6);
    RecordProperty("overlap_nm", static_cast<int>(1e9 * run.overlap()));
    RecordProperty("drift_nm", static_cast<int>(1e9 * run.farthest(before)));
}

TEST(Patch, TheTissueBearsItsWeight) {
    Lying run(pad());
    run.frames(3000);
    Vec3 load = Vec3::Zero();
    for (int32_t i = 0; i < run.state.patch.loaded_count; ++i) {
        const auto v = static_cast<size_t>(run.state.patch.loaded[static_cast<size_t>(i)]);
        for (int k = 0; k < 3; ++k)
            load[k] += static_cast<double>(run.state.patch.load_n[v][static_cast<size_t>(k)]);
    }
    const double weight = 0.008 * 0.006 * 0.0004 * 1050 * 9.81;
    EXPECT_NEAR(load.z(), -weight, 0.01 * weight);
    EXPECT_LT(load.head<2>().norm(), 0.01 * weight);
}

// PLACODE_LONG_TESTS runs the whole minute.
TEST(Patch, StaysWhereItLiesForAMinute) {
    Lying run(pad());
    run.frames(3000);
    const std::vector<Vec3> before = run.places();
    const int seconds = std::getenv("PLACODE_LONG_TESTS") != nullptr ? 60 : 8;
    run.frames(1000 * seconds);
    EXPECT_LT(run.farthest(before), 2e-6 * seconds / 60 + 1e-6);
    EXPECT_GT(run.state.sleep.asleep_count, run.state.sleep.blocks() / 2) << "the tissue sleeps";
}

// Tan 16.7 degrees is 0.3: the pad is tilted by turning gravity. How far it slides is measured in
// patch_modes_test.
TEST(Patch, SlidesBeyondTheAngleOfFrictionAndSticksBelow) {
    const auto slid = [](double degrees, int before_ms, int ms) {
        OperativeFieldSpec spec = pad();
        const double a = degrees * 3.14159265 / 180;
        spec.solver.gravity_m_s2 = 9.81 * Vec3(std::sin(a), 0, -std::cos(a));
        Lying run(spec);
        run.frames(before_ms);
        const double before = run.at(20).x();
        run.frames(ms);
        return run.at(20).x() - before;
    };
    EXPECT_LT(std::abs(slid(15.7, 800, 500)), 2e-6);
    // Its damping leaves it 18 mm/s.
    EXPECT_GT(slid(18.7, 150, 150), 0.002);
}

/// Holds what lies at x below `x_m` of the patch's vertices.
void clamp(Lying& run, double x_m) {
    for (int i = 0; i < run.patch().vertex_count; ++i) {
        if (run.at(i).x() < x_m)
            run.state.body.x[static_cast<size_t>(run.patch().first_vertex + i)].w = 0;
    }
    update_free_vertices(run.scene->body, run.state.body);
}

// High over the tissue, two columns held: the same sheet in double precision, solved by Newton.
TEST(Patch, AHeldStripSagsAsNewtonSays) {
    OperativeFieldSpec spec = pad();
    spec.patch->width_m = 0.004;
    spec.patch->height_m = 0.004;
    Lying run(spec);
    clamp(run, -0.0025);
    const ReferenceBody reference(run.scene->body.spec());
    StaticProblem problem;
    problem.body = &reference;
    problem.held.assign(static_cast<size_t>(reference.rest().size()), 1);
    problem.held_at = reference.rest();
    problem.force_n = Coordinates::Zero(reference.rest().size());
    const int first = run.patch().first_vertex, count = run.patch().vertex_count;
    for (int v = first; v < first + count; ++v) {
        if (run.state.body.x[static_cast<size_t>(v)].w == 0) continue;
        for (int k = 0; k < 3; ++k) problem.held[static_cast<size_t>(3 * v + k)] = 0;
        problem.force_n[3 * v + 2] = -9.81 * reference.mass_kg()[static_cast<size_t>(v)];
    }
    Coordinates x = reference.rest();
    ASSERT_TRUE(solve_static(problem, x).converged);
    run.frames(4000);
    double error = 0, size = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 wanted = x.segment<3>(3 * (first + i)),
                   rest = reference.rest().segment<3>(3 * (first + i));
        error += (run.at(i) - wanted).squaredNorm();
        size += (wanted - rest).squaredNorm();
    }
    RecordProperty("error_ppm", static_cast<int>(1e6 * std::sqrt(error / size)));
    EXPECT_GT(std::sqrt(size), 1e-4);
    EXPECT_LT(std::sqrt(error / size), 0.01);
}

/// Takes it by its left edge, lifts it off, carries it 2 mm aside, lays it down and lets go.
struct Carried : Lying {
    explicit Carried(int threads = 1, const OperativeFieldSpec& spec = pad())
        : Lying(spec, threads) {}
    void take() {
        frames(500);
        go(Vec3(-0.003, 0, 0.004), 0.6, 100);
        go(Vec3(-0.003, 0, 0.00045), 0.6, 200);
        go(Vec3(-0.003, 0, 0.00045), 0.02, 200);
    }
    void lift() { go(Vec3(-0.003, 0, 0.010), 0.02, 1000); }
    void lay_down() {
        go(Vec3(-0.003, 0.002, 0.010), 0.02, 300);
        go(Vec3(-0.003, 0.002, 0.00045), 0.02, 1000);
        go(Vec3(-0.003, 0.002, 0.00045), 0.6, 200);
        go(Vec3(-0.003, 0.002, 0.010), 0.6, 300);
    }
};

TEST(Patch, IsTakenLiftedCarriedAndLaidDown) {
    Carried run;
    run.take();
    const Grasp& held = run.state.grasps[0];
    ASSERT_GT(held.count, 0);
    for (int i = 0; i < held.count; ++i)
        EXPECT_TRUE(run.patch().owns(held.held[static_cast<size_t>(i)].vertex)) << "tissue held";
    run.lift();
    run.frames(1500);
    EXPECT_GT(run.lowest(), 0.001) << "all of it has come off";
    const double weight = 0.008 * 0.006 * 0.0004 * 1050 * 9.81;
    EXPECT_NEAR(held.force_n.z(), -weight, 0.03 * weight) << "the jaws bear it";
    EXPECT_EQ(run.state.patch.loaded_count, 0) << "the tissue does not";
    run.lay_down();
    EXPECT_EQ(held.count, 0);
    run.frames(3000);
    EXPECT_LT(run.overlap(), 4e-6);
    EXPECT_LT(run.highest(), 0.001);
    double y = 0;
    for (int i = 0; i < run.patch().vertex_count; ++i)
        y += run.at(i).y() / run.patch().vertex_count;
    EXPECT_NEAR(y, 0.002, 0.0005);
}

TEST(Patch, SameBitsOnOneTwoAndThreeThreadsAndAfterSaveAndLoad) {
    std::array<uint64_t, 3> hash{};
    for (int threads = 1; threads <= 3; ++threads) {
        Carried run(threads);
        run.take();
        if (threads == 2) {
            const std::vector<uint8_t> saved = save_state(*run.scene, run.state);
            run.frames(7);
            load_state(*run.scene, run.state, saved);
        }
        run.lift();
        run.lay_down();
        hash[static_cast<size_t>(threads - 1)] = state_hash(run.state);
    }
    EXPECT_EQ(hash[0], hash[1]);
    EXPECT_EQ(hash[0], hash[2]);
}

/// A blunt probe instead of the grasper.
OperativeFieldSpec probed(OperativeFieldSpec spec) {
    spec.tools[0] = {};
    spec.tools[0].kind = ToolKind::kProbe;
    spec.tools[0].tip_radius_m = 0.001;
    spec.tools[0].tip_length_m = 0.0025;
    return spec;
}

// The probe presses patch and tissue in by a millimetre and is drawn back.
TEST(Patch, IsPressedIntoTheTissueAndDoesNotFallThrough) {
    Lying run(probed(pad()));
    run.frames(500);
    run.go(Vec3(0, 0, 0.003), 0, 100);
    run.go(Vec3(0, 0, -0.001), 0, 200);
    run.frames(300);
    EXPECT_GT(run.state.tools[0].force_n.norm(), 0.002);
    EXPECT_GT(run.lowest(), -0.0015);
    run.go(Vec3(0, 0, 0.006), 0, 200);
    run.frames(3000);
    EXPECT_LT(run.overlap(), 4e-6);
    EXPECT_LT(run.highest(), run.patch().thickness_m / 2 + 1e-4);
}

// Over a hole of 4 x 8 mm, pushed through it and dragged about.
TEST(Patch, PushedThroughAHoleItStaysFinite) {
    OperativeFieldSpec spec = probed(pad());
    spec.domain_x_m = 0.032;
    spec.contact.self_contact = true;
    spec.slit = FieldSlit{Vec2(0.009, -0.004), Vec2(0.009, 0.004), 0.004, 3, 0.0008};
    spec.patch->centre_m = Vec2(0.009, 0);
    spec.patch->length_m = 0.009;
    Lying run(spec);
    run.frames(500);
    EXPECT_GT(run.lowest(), -0.001) << "it spans the hole";
    run.go(Vec3(0.009, 0, 0.003), 0, 100);
    run.go(Vec3(0.009, 0, -0.003), 0, 200);
    run.go(Vec3(0.004, 0.002, -0.003), 0, 100);
    run.go(Vec3(0.013, -0.003, 0.002), 0, 100);
    run.frames(500);
    for (int i = 0; i < run.patch().vertex_count; ++i) {
        ASSERT_TRUE(run.at(i).allFinite());
        EXPECT_LT(run.at(i).norm(), 0.05);
    }
    EXPECT_EQ(run.state.body.flags & kNotFinite, 0U);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
