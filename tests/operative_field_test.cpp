// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/operative_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "sim/anatomy/field_mesh.h"

namespace placode::sim {
namespace THIS_TEST {

using ::testing::HasSubstr;

OperativeFieldSpec coarse(uint64_t seed = 1) {
    OperativeFieldSpec spec;
    spec.seed = seed;
    spec.edge_ring_m = 0.001;
    spec.edge_placode_m = 0.0012;
    spec.edge_outer_m = 0.0022;
    return spec;
}

OperativeFieldSpec paper() {
    OperativeFieldSpec spec;
    spec.isotropic = true;
    spec.domain_x_m = 0.044;
    spec.domain_y_m = 0.034;
    spec.edge_ring_m = spec.edge_placode_m = spec.edge_outer_m = 0.0009;
    spec.placode_layers_m = spec.ring_layers_m =
        spec.skin_layers_m = {0.00075, 0.00075, 0.00075, 0.00075};
    return spec;
}

FieldMesh mesh_of(const OperativeFieldSpec& spec) {
    return build_field_mesh(spec, FieldShape(spec));
}

// Built once: several tests look at the same default field.
const Scene& default_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(OperativeFieldSpec{});
    return *scene;
}

double least_quality(const TetMesh& mesh) {
    double least = 1;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        EXPECT_GT(rest_volume(mesh, static_cast<int>(t)), 0);
        least = std::min(least, tet_quality(mesh, static_cast<int>(t)));
    }
    return least;
}

double total_volume(const TetMesh& mesh) {
    double sum = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) sum += rest_volume(mesh, static_cast<int>(t));
    return sum;
}

Vec3 centroid(const TetMesh& mesh, size_t t) {
    Vec3 sum = Vec3::Zero();
    for (const int32_t v : mesh.tets[t]) sum += mesh.rest[v] / 4;
    return sum;
}

TEST(OperativeField, DefaultHasAboutFortyTwoThousandSoundTets) {
    const TetMesh& mesh = default_scene().body.mesh();
    EXPECT_GE(mesh.tets.size(), 40000u);
    EXPECT_LE(mesh.tets.size(), 45000u);
    EXPECT_GE(least_quality(mesh), 0.1);
}

TEST(OperativeField, EverySeedGivesSoundTetsInAllResolutions) {
    for (uint64_t seed = 2; seed <= 5; ++seed) {
        OperativeFieldSpec spec;
        spec.seed = seed;
        const FieldMesh field = mesh_of(spec);
        EXPECT_GE(least_quality(field.mesh), 0.1) << "seed " << seed;
        EXPECT_NEAR(static_cast<double>(field.mesh.tets.size()), 42500, 2500) << "seed " << seed;
        EXPECT_GE(least_quality(mesh_of(coarse(seed)).mesh), 0.1) << "coarse, seed " << seed;
    }
    OperativeFieldSpec fine;
    fine.edge_ring_m = 0.0004;
    fine.edge_placode_m = 0.0006;
    fine.edge_outer_m = 0.0014;
    EXPECT_GE(least_quality(mesh_of(fine).mesh), 0.1);
}

TEST(OperativeField, PaperPresetHasFortyThousandTetsOfAboutEqualEdges) {
    const TetMesh mesh = mesh_of(paper()).mesh;
    EXPECT_NEAR(static_cast<double>(mesh.tets.size()), 40000, 2500);
    EXPECT_GE(least_quality(mesh), 0.35);
    std::set<std::pair<int, int>> edges;
    for (const auto& t : mesh.tets) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) edges.insert(std::minmax(t[i], t[j]));
        }
    }
    double sum = 0, square = 0;
    for (const auto& [a, b] : edges) {
        const double length = (mesh.rest[a] - mesh.rest[b]).norm();
        sum += length;
        square += length * length;
    }
    const double mean = sum / static_cast<double>(edges.size());
    const double deviation = std::sqrt(square / static_cast<double>(edges.size()) - mean * mean);
    EXPECT_NEAR(mean, 0.001, 0.0001);
    // Prisms have diagonals: with legs of 1 the longest edge is about 1.4.
    EXPECT_LT(deviation / mean, 0.3);
}

TEST(OperativeField, IsConformingWithAClosedManifoldSurface) {
    const TetMesh& mesh = default_scene().body.mesh();
    // Surface throws for a face of three tets; a crack would leave open triangles inside.
    const auto triangles = default_scene().surface.rest_triangles();
    std::map<std::pair<int, int>, int> edges;
    std::set<int> vertices;
    double volume = 0;
    for (const SurfaceTriangle& triangle : triangles) {
        const auto& v = triangle.vertex;
        for (int i = 0; i < 3; ++i) EXPECT_EQ(++edges[std::pair(v[i], v[(i + 1) % 3])], 1);
        vertices.insert(v.begin(), v.end());
        volume += mesh.rest[v[0]].dot(mesh.rest[v[1]].cross(mesh.rest[v[2]])) / 6;
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    // Euler characteristic of one sphere: a crack or a second piece changes it.
    EXPECT_EQ(static_cast<int>(vertices.size()) - static_cast<int>(edges.size() / 2) +
                  static_cast<int>(triangles.size()),
              2);
    EXPECT_NEAR(volume, total_volume(mesh), 1e-9 * volume);
}

TEST(OperativeField, VolumeIsThatOfTheLayers) {
    const OperativeFieldSpec spec;
    const FieldShape shape(spec);
    double sum = 0;
    const double step = 0.0002;
    for (double x = -spec.domain_x_m / 2 + step / 2; x < spec.domain_x_m / 2; x += step) {
        for (double y = -spec.domain_y_m / 2 + step / 2; y < spec.domain_y_m / 2; y += step) {
            const auto thick = shape.column(Vec2(x, y)).thickness_m;
            sum += step * step * std::accumulate(thick.begin(), thick.end(), 0.0);
        }
    }
    // Thickness is linear on a triangle; the error is that of interpolating the blends.
    EXPECT_NEAR(total_volume(default_scene().body.mesh()), sum, 0.005 * sum);
}

TEST(OperativeField, LabelsTissuesWhereTheyBelong) {
    const Scene& scene = default_scene();
    const TetMesh& mesh = scene.body.mesh();
    const OperativeFieldSpec spec;
    const FieldShape shape(spec);
    std::array<int, kTissueCount> count{};
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        ++count[static_cast<size_t>(mesh.tissue[t])];
        const Vec3 c = centroid(mesh, t);
        const double d_p = shape.placode().signed_distance(c.head<2>());
        const double d_s = shape.skin().signed_distance(c.head<2>());
        // The label is that of the prism's centroid, at most one edge away from the tet's.
        const double slack = 0.0005;
        switch (mesh.tissue[t]) {
            case Tissue::kPlacode:
                EXPECT_LT(d_p, slack);
                break;
            case Tissue::kZone:
                EXPECT_TRUE(d_p > -slack && d_s < slack);
                break;
            case Tissue::kThinSkin:
                EXPECT_TRUE(d_s > -slack && d_s < spec.thin_skin_width_m + slack);
                break;
            case Tissue::kSkin:
                EXPECT_GT(d_s, spec.thin_skin_width_m - slack);
                break;
            case Tissue::kSubcutis:
            case Tissue::kMuscle:
                EXPECT_GT(d_s, -slack);
                break;
            case Tissue::kGel:
            case Tissue::kDura:
                EXPECT_LT(d_s, slack);
                break;
        }
    }
    for (const int n : count) EXPECT_GT(n, 500);
    // Upwards through the middle: dura, gel, placode, placode.
    EXPECT_EQ(shape.tissue(0, -0.003, -0.008), Tissue::kPlacode);
    EXPECT_EQ(shape.tissue(3, -0.003, -0.008), Tissue::kDura);
}

TEST(OperativeField, LayersAreAsThickAsWritten) {
    const OperativeFieldSpec spec;
    const FieldShape shape(spec);
    const FieldColumn middle = shape.column(Vec2(0, 0)), ring = shape.column(Vec2(0, 0.0055)),
                      edge = shape.column(Vec2(0, 0.0094)), skin = shape.column(Vec2(0, 0.0135));
    for (int l = 0; l < kFieldLayers; ++l) {
        EXPECT_DOUBLE_EQ(middle.thickness_m[l], spec.placode_layers_m[l]);
        EXPECT_DOUBLE_EQ(ring.thickness_m[l], spec.ring_layers_m[l]);
        EXPECT_DOUBLE_EQ(skin.thickness_m[l], spec.skin_layers_m[l]);
        // Atrophic skin is half as thick, the tissue below it is not.
        EXPECT_DOUBLE_EQ(edge.thickness_m[l], spec.skin_layers_m[l] * (l < 2 ? 0.5 : 1));
    }
}

TEST(OperativeField, ContourKeepsInsideTheZoneForManySeeds) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const OperativeFieldSpec spec = coarse(seed);
        const FieldShape shape(spec);
        const FieldMesh field = build_field_mesh(spec, shape);
        const SurfaceLine line = laid_on_surface(field, shape.contour(), 240);
        double shortest = 1, longest = 0;
        for (size_t i = 0; i < line.points.size(); ++i) {
            const Vec2 p = line.points[i].head<2>();
            const double d_p = shape.placode().signed_distance(p);
            EXPECT_GT(d_p, 0.0005) << "seed " << seed;
            // Chords between outline points cut corners by a few micrometres.
            EXPECT_NEAR(d_p, spec.contour_offset_m, 0.00002) << "seed " << seed;
            EXPECT_LT(shape.skin().signed_distance(p), -0.0003) << "seed " << seed;
            const double step = (line.points[(i + 1) % 240] - line.points[i]).norm();
            shortest = std::min(shortest, step);
            longest = std::max(longest, step);
        }
        EXPECT_LT(longest / shortest, 1.1) << "seed " << seed;
    }
}

TEST(OperativeField, LandmarksLieOnTheRestSurface) {
    const Scene& scene = default_scene();
    const TetMesh& mesh = scene.body.mesh();
    const FieldGeometry& g = scene.geometry;
    ASSERT_GE(g.planned_contour.size(), 200u);
    ASSERT_EQ(scene.contour_anchors.size(), g.planned_contour.size());
    std::set<std::array<int32_t, 3>> surface;
    for (const SurfaceTriangle& triangle : scene.surface.rest_triangles()) {
        std::array<int32_t, 3> v = triangle.vertex;
        std::sort(v.begin(), v.end());
        surface.insert(v);
    }
    for (size_t i = 0; i < scene.contour_anchors.size(); ++i) {
        const ContourAnchor& anchor = scene.contour_anchors[i];
        Vec3 p = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(scene.field.depth_m[anchor.vertex[k]], 0);
            EXPECT_GE(anchor.weight[k], -1e-5F);
            p += anchor.weight[k] * mesh.rest[anchor.vertex[k]];
        }
        EXPECT_LT((p - g.planned_contour[i]).norm(), 1e-9);
        std::array<int32_t, 3> v = anchor.vertex;
        std::sort(v.begin(), v.end());
        EXPECT_EQ(surface.count(v), 1u) << "anchor " << i << " is not on the surface";
    }
    EXPECT_EQ(g.placode_edge.size(), g.skin_edge.size());
    EXPECT_DOUBLE_EQ(g.target_depth_m, 0.0005);
    double volume = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (mesh.tissue[t] == Tissue::kPlacode) volume += rest_volume(mesh, static_cast<int>(t));
    }
    EXPECT_DOUBLE_EQ(g.placode_volume_m3, volume);
    // 16 x 6 mm ellipse, 1.2 mm thick, up to the wobble and the thinner rim.
    EXPECT_NEAR(g.placode_volume_m3, 3.14159 * 0.008 * 0.003 * 0.0012, 1.5e-8);
}

TEST(OperativeField, VertexDataKnowDistancesAndDepth) {
    const Scene& scene = default_scene();
    const size_t vertices = scene.body.mesh().rest.size();
    ASSERT_EQ(scene.field.to_placode_m.size(), vertices);
    ASSERT_EQ(scene.field.to_skin_m.size(), vertices);
    ASSERT_EQ(scene.field.depth_m.size(), vertices);
    for (size_t v = 0; v < vertices; ++v) {
        EXPECT_GE(scene.field.depth_m[v], 0);
        EXPECT_LE(scene.field.depth_m[v], 0.0026F);
        EXPECT_GT(scene.field.to_placode_m[v], scene.field.to_skin_m[v]);
    }
}

TEST(OperativeField, DistanceToAnOutlineIsEuclidean) {
    const Outline circle(Vec2(0.001, 0), 0.004, 0.004, {0, 0, 0}, {0, 0, 0});
    // A polygon of 480 sides deviates from its circle by r (1 - cos(pi / 480)) = 0.09 um.
    EXPECT_NEAR(circle.signed_distance(Vec2(0.001, 0.007)), 0.003, 1e-7);
    EXPECT_NEAR(circle.signed_distance(Vec2(0.001, -0.001)), -0.003, 1e-7);
    const Outline ellipse(Vec2::Zero(), 0.008, 0.003, {0, 0, 0}, {0, 0, 0});
    for (const Vec2& p : ellipse.offset(0.0015)) {
        EXPECT_NEAR(ellipse.signed_distance(p), 0.0015, 2e-6);
    }
}

TEST(OperativeField, SameSeedSameMeshOtherSeedOtherMesh) {
    const FieldMesh a = mesh_of(coarse(4)), b = mesh_of(coarse(4)), c = mesh_of(coarse(5));
    EXPECT_EQ(a.mesh.tets, b.mesh.tets);
    EXPECT_EQ(a.mesh.tissue, b.mesh.tissue);
    EXPECT_TRUE(a.mesh.rest == b.mesh.rest);
    EXPECT_FALSE(a.mesh.rest == c.mesh.rest);
}

TEST(OperativeField, BedCarriesTheWrittenStiffnessPerArea) {
    const OperativeFieldSpec spec = coarse();
    const auto scene = build_operative_field(spec);
    const SoftBodySpec& body = scene->body.spec();
    const std::set<int> fixed(body.fixed.begin(), body.fixed.end());
    double normal = 0, side = 0, area = 0;
    for (const AnchorSpring& spring : body.springs) {
        EXPECT_EQ(fixed.count(spring.vertex), 0u);
        EXPECT_TRUE(spring.anchor == body.mesh.rest[spring.vertex]);
        EXPECT_NEAR(spring.normal.norm(), 1, 1e-12);
        normal += spring.normal_n_m;
        if (spring.normal_n_m > 0) {
            EXPECT_NEAR(spring.tangent_n_m / spring.normal_n_m, 1.3 / 11, 1e-9);
            EXPECT_GT(std::abs(spring.normal.z()), 0.5) << "the bed lies below";
            area += spring.normal_n_m / spec.bed_normal_pa_m;
        } else {
            side += spring.tangent_n_m;
        }
    }
    // The bottom without the held canal floor; the held vertices on the sides take half an edge of
    // the outermost triangles with them, at most a whole one; slopes add at most 3 %.
    const double around = 2 * (spec.domain_x_m + spec.domain_y_m);
    const double plane = spec.domain_x_m * spec.domain_y_m - 3.14159 * 0.008 * 0.003;
    EXPECT_GT(area, plane - 1.1 * spec.edge_outer_m * around);
    EXPECT_LT(area, 1.03 * plane - 0.4 * spec.edge_outer_m * around);
    // Side area x stiffness: 2.5 mm high, of which the lower half of the last layer is the bed's.
    EXPECT_NEAR(side, 3e6 * around * (0.0025 - 0.00045), 0.01 * side);
    // All vertices on the sides are held.
    for (size_t v = 0; v < body.mesh.rest.size(); ++v) {
        const Vec3& p = body.mesh.rest[v];
        if (std::abs(p.x()) > 0.0199999 || std::abs(p.y()) > 0.0149999) {
            EXPECT_EQ(fixed.count(static_cast<int>(v)), 1u);
        }
    }
}

TEST(OperativeField, PreTensionLeavesNoStressAlongTheNormal) {
    const OperativeFieldSpec spec = coarse();
    const auto scene = build_operative_field(spec);
    const SoftBodySpec& body = scene->body.spec();
    ASSERT_EQ(body.rest_scale.size(), body.mesh.tets.size());
    for (size_t t = 0; t < body.mesh.tets.size(); ++t) {
        const Tissue tissue = body.mesh.tissue[t];
        const double a = 1 / body.rest_scale[t][0], c = 1 / body.rest_scale[t][1];
        const bool skin = tissue == Tissue::kSkin || tissue == Tissue::kThinSkin;
        EXPECT_NEAR(a, skin ? 1.08 : tissue == Tissue::kZone ? 1.12 : 1, 1e-6);
        // First Piola stress along the normal: mu c + lambda (J - gamma) a^2 = 0.
        const NeoHookean m =
            neo_hookean(spec.materials[static_cast<size_t>(tissue)].youngs_modulus_pa,
                        spec.materials[static_cast<size_t>(tissue)].poissons_ratio);
        const double stress = m.mu_pa * c + m.lambda_pa * (a * a * c - m.gamma) * a * a;
        EXPECT_NEAR(stress / m.lambda_pa, 0, 1e-6);  // float
    }
    OperativeFieldSpec slack = coarse();
    slack.skin_prestretch = slack.zone_prestretch = 1;
    EXPECT_TRUE(build_operative_field(slack)->body.spec().rest_scale.empty());
}

TEST(OperativeField, TethersSpanTheGelUnderThePlacode) {
    OperativeFieldSpec spec = coarse();
    spec.tethers = 24;
    const auto scene = build_operative_field(spec);
    const SoftBodySpec& body = scene->body.spec();
    ASSERT_EQ(body.tethers.size(), 24u);
    std::set<int> tops;
    for (const Tether& tether : body.tethers) {
        tops.insert(tether.vertex[0]);
        EXPECT_LT(scene->field.to_placode_m[tether.vertex[0]], 0);
        EXPECT_NEAR(scene->field.depth_m[tether.vertex[0]], 0.0012, 1e-6);
        EXPECT_NEAR(tether.rest_m, 0.0007, 1e-6);
        EXPECT_DOUBLE_EQ(tether.break_n, 0.020);
    }
    EXPECT_EQ(tops.size(), 24u);
    EXPECT_TRUE(default_scene().body.spec().tethers.empty());
}

TEST(OperativeField, MaterialsAreThoseOfTheReference) {
    const MaterialTable table = default_materials();
    const auto modulus = [&](Tissue t) { return table[static_cast<size_t>(t)].youngs_modulus_pa; };
    EXPECT_EQ(modulus(Tissue::kSkin), 60e3);
    EXPECT_EQ(modulus(Tissue::kThinSkin), 35e3);
    EXPECT_EQ(modulus(Tissue::kSubcutis), 3e3);
    EXPECT_EQ(modulus(Tissue::kMuscle), 15e3);
    EXPECT_EQ(modulus(Tissue::kZone), 25e3);
    EXPECT_EQ(modulus(Tissue::kPlacode), 3e3);
    EXPECT_EQ(modulus(Tissue::kGel), 500);
    EXPECT_EQ(table[static_cast<size_t>(Tissue::kPlacode)].injury_stretch, 1.3);
    for (const Material& m : table) {
        EXPECT_LT(m.injury_stretch, m.fail_stretch);
        EXPECT_EQ(m.friction, 0.08);
    }
}

TEST(OperativeField, SceneCarriesToolsHeatColoursAndNotes) {
    OperativeFieldSpec spec = coarse();
    spec.id = "ring";
    spec.tools.resize(2);
    spec.tools[1].kind = ToolKind::kScope;
    spec.heat = false;
    const auto scene = build_operative_field(spec);
    EXPECT_EQ(scene->id, "ring");
    ASSERT_EQ(scene->tools.size(), 2u);
    EXPECT_EQ(scene->tools[1].kind, ToolKind::kScope);
    EXPECT_FALSE(scene->heat.has_value());
    EXPECT_TRUE(default_scene().heat.has_value());
    EXPECT_GT(scene->colour_linear[static_cast<size_t>(Tissue::kPlacode)][0], 0.4F);
    ASSERT_GE(scene->notes.size(), 2u);
    EXPECT_THAT(scene->notes[0], HasSubstr(std::to_string(scene->body.tet_count()) + " tets"));
    EXPECT_THAT(scene->notes[1], HasSubstr("quality"));
}

struct Degenerate {
    const char* names;
    std::function<void(OperativeFieldSpec&)> spoil;
};

TEST(OperativeField, RefusesDegenerateSpecsByFieldValueAndRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Degenerate> cases{
        {"placode_a_m = 0.013", [](auto& s) { s.placode_a_m = 0.013; }},
        {"placode_b_m = 0.0079", [](auto& s) { s.placode_b_m = 0.0079; }},
        {"edge_ring_m = 0", [](auto& s) { s.edge_ring_m = 0; }},
        {"edge_outer_m = -0.001", [](auto& s) { s.edge_outer_m = -0.001; }},
        {"edge_placode_m = nan", [nan](auto& s) { s.edge_placode_m = nan; }},
        {"ring_layers_m[1] = -0.001", [](auto& s) { s.ring_layers_m[1] = -0.001; }},
        {"skin_layers_m[0] = 0", [](auto& s) { s.skin_layers_m[0] = 0; }},
        {"skin_edge_a_m = 0.03", [](auto& s) { s.skin_edge_a_m = 0.03; }},
        {"domain_x_m = 0", [](auto& s) { s.domain_x_m = 0; }},
        {"dome_height_m = 0.006", [](auto& s) { s.dome_height_m = 0.006; }},
        {"wobble = 0.5", [](auto& s) { s.wobble = 0.5; }},
        {"contour_offset_m = 0.0001", [](auto& s) { s.contour_offset_m = 0.0001; }},
        {"asymmetry_m = 0.004", [](auto& s) { s.asymmetry_m = 0.004; }},
        {"skin_prestretch = 0.5", [](auto& s) { s.skin_prestretch = 0.5; }},
        {"tethers = -1", [](auto& s) { s.tethers = -1; }},
        {"tools = 5", [](auto& s) { s.tools.resize(5); }},  // one more than kMaxTools
        {"materials.gel.poissons_ratio = 0.5",
         [](auto& s) { s.materials[static_cast<size_t>(Tissue::kGel)].poissons_ratio = 0.5; }},
    };
    for (const Degenerate& c : cases) {
        OperativeFieldSpec spec = coarse();
        c.spoil(spec);
        try {
            (void)build_operative_field(spec);
            ADD_FAILURE() << c.names << " was accepted";
        } catch (const MeshError& error) {
            EXPECT_THAT(error.what(), HasSubstr(c.names));
            EXPECT_THAT(error.what(), HasSubstr("allowed"));
        }
    }
}

TEST(OperativeField, RefusesEdgesThatWouldNeedEndlessTets) {
    OperativeFieldSpec spec;
    spec.edge_ring_m = spec.edge_placode_m = spec.edge_outer_m = 0.0001;
    try {
        (void)build_operative_field(spec);
        ADD_FAILURE() << "accepted";
    } catch (const MeshError& error) {
        EXPECT_THAT(error.what(), HasSubstr("edge_ring_m"));
        EXPECT_THAT(error.what(), HasSubstr("allowed"));
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
