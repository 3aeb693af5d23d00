// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/operative_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/anatomy/field_irrigation.h"
#include "sim/anatomy/field_mesh.h"
#include "sim/anatomy/field_patch.h"
#include "sim/anatomy/field_plane.h"
#include "sim/anatomy/field_sac.h"
#include "sim/anatomy/field_supports.h"
#include "sim/anatomy/field_suture.h"
#include "sim/anatomy/resection.h"

namespace placode::sim {

namespace {

constexpr int kLandmarkPoints = 240;  // about 0.2 mm on the default contour

// Linear RGB, converted from the sRGB palette of the interface.
constexpr std::array<std::array<float, 3>, kTissueCount> kColourLinear{{
    {0.694F, 0.258F, 0.238F},  // skin at 25 weeks #d98b86
    {0.584F, 0.130F, 0.144F},  // thin skin edge #c9656a
    {0.791F, 0.571F, 0.275F},  // subcutis #e6c78f
    {0.270F, 0.028F, 0.025F},  // muscle #8e2f2c
    {0.807F, 0.479F, 0.423F},  // junctional zone #e8b8ae
    {0.479F, 0.060F, 0.050F},  // placode #b8453f
    {0.392F, 0.144F, 0.122F},  // CSF and gel #a86a62
    {0.791F, 0.716F, 0.631F},  // dura #e6dcd0
}};

// In-plane and normal scale of the rest shape of a layer that is stretched in its plane by `a` and
// free to thin: c = (lambda + mu) a^2 / (mu + lambda a^4) is the equibiaxial closed form in which
// the stress along the normal vanishes, so that the built thickness is the strained one.
std::array<float, 2> rest_scale_of(const Material& material, double a) {
    const NeoHookean m = neo_hookean(material.youngs_modulus_pa, material.poissons_ratio);
    const double c = (m.lambda_pa + m.mu_pa) * a * a / (m.mu_pa + m.lambda_pa * a * a * a * a);
    return {static_cast<float>(1 / a), static_cast<float>(1 / c)};
}

// Normal of the surface over a column: across the wall of a sac, else upright.
Vec3f normal_over(const FieldMesh& field, const std::array<int32_t, 4>& tet) {
    Vec3 sum = Vec3::Zero();
    for (const int32_t v : tet) {
        const auto& levels = field.columns[field.column[v]].level_m;
        sum += (levels[0] - levels[2]).normalized();
    }
    return sum.normalized().cast<float>();
}

void pre_tension(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    const TetMesh& mesh = field.mesh;
    if (spec.skin_prestretch == 1 && spec.zone_prestretch == 1 && spec.placode_prestretch == 1)
        return;
    for (const Tissue tissue : mesh.tissue) {
        double stretch = 1;
        if (tissue == Tissue::kSkin || tissue == Tissue::kThinSkin) stretch = spec.skin_prestretch;
        if (tissue == Tissue::kZone) stretch = spec.zone_prestretch;
        if (tissue == Tissue::kPlacode) stretch = spec.placode_prestretch;
        body.rest_scale.push_back(
            rest_scale_of(spec.materials[static_cast<size_t>(tissue)], stretch));
    }
    if (!spec.cystic) return;
    for (const auto& tet : mesh.tets) body.rest_normal.push_back(normal_over(field, tet));
}

void add_landmarks(const OperativeFieldSpec& spec, const FieldShape& shape, const FieldMesh& field,
                   Scene& scene) {
    SurfaceLine contour = laid_on_surface(field, shape.contour(), kLandmarkPoints);
    scene.geometry.planned_contour = std::move(contour.points);
    scene.contour_anchors = std::move(contour.anchors);
    scene.geometry.placode_edge =
        laid_on_surface(field, shape.placode().points(), kLandmarkPoints).points;
    scene.geometry.skin_edge =
        laid_on_surface(field, shape.skin().points(), kLandmarkPoints).points;
    // Both upper layers of the ring are zone: through them is through.
    scene.geometry.target_depth_m = spec.ring_layers_m[0] + spec.ring_layers_m[1];
    for (size_t t = 0; t < field.mesh.tets.size(); ++t) {
        if (field.mesh.tissue[t] != Tissue::kPlacode) continue;
        scene.geometry.placode_volume_m3 += rest_volume(field.mesh, static_cast<int>(t));
    }
    for (size_t v = 0; v < field.mesh.rest.size(); ++v) {
        const FieldColumn& column = field.columns[field.column[v]];
        scene.field.to_placode_m.push_back(static_cast<float>(column.to_placode_m));
        scene.field.to_skin_m.push_back(static_cast<float>(column.to_skin_m));
        double depth = 0;
        for (int l = 0; l < field.level[v]; ++l) depth += column.thickness_m[l];
        scene.field.depth_m.push_back(static_cast<float>(depth));
    }
    // A patch is no part of the lesion or of its surface.
    const size_t all = scene.body.mesh().rest.size();
    for (std::vector<float>* far :
         {&scene.field.to_placode_m, &scene.field.to_skin_m, &scene.field.depth_m})
        far->resize(all, 1.0F);
}

std::vector<std::string> mesh_notes(const TetMesh& mesh, size_t tethers) {
    double least = 1, sum = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const double q = tet_quality(mesh, static_cast<int>(t));
        least = std::min(least, q);
        sum += q;
    }
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "mesh: %zu vertices, %zu tets, %zu tethers",
                  mesh.rest.size(), mesh.tets.size(), tethers);
    std::vector<std::string> notes{text.data()};
    // In thousandths, because %f would follow the locale.
    std::snprintf(text.data(), text.size(), "quality: least 0.%03d, mean 0.%03d",
                  static_cast<int>(1000 * least),
                  static_cast<int>(1000 * sum / static_cast<double>(mesh.tets.size())));
    notes.emplace_back(text.data());
    return notes;
}

// Walls and floor of a slit. Its columns are those of the triangles that lie in it.
void uncover_slit(const FieldMesh& field, Surface& surface) {
    if (!field.slit.present()) return;
    std::vector<uint8_t> in_slit(field.columns.size(), 0);
    for (size_t t = 0; t < field.open.size(); ++t) {
        if (field.open[t] == 0) continue;
        for (const int32_t c : field.plane.triangles[t]) in_slit[c] = 1;
    }
    for (size_t i = 0; i < surface.rest_triangles().size(); ++i) {
        const auto& face = surface.rest_triangles()[i].vertex;
        bool inside = true, below = false;
        for (const int32_t v : face) {
            inside = inside && in_slit[field.column[v]] != 0 && field.level[v] <= field.slit.layers;
            below = below || field.level[v] > 0;
        }
        if (inside && below) surface.uncover(i);
    }
}

}  // namespace

std::shared_ptr<const Scene> build_operative_field(const OperativeFieldSpec& spec) {
    const FieldShape shape(spec);
    const FieldMesh field = build_field_mesh(spec, shape);
    SoftBodySpec body;
    body.mesh = field.mesh;
    body.materials = spec.materials;
    body.solver = spec.solver;
    lay_on_bed(spec, field, body);
    hang_on_sides(spec, field, body);
    pre_tension(spec, field, body);
    tie_placode(spec, field, body);
    const size_t tethers = body.tethers.size();
    Sac sac = spec.cystic ? make_sac(spec, shape, field) : Sac{};
    for (const int32_t v : sac.vertices) {
        body.springs.push_back({v, field.mesh.rest[v], Vec3::UnitZ(), 0, 0});
    }
    take_pressure(field, body);
    const bool scissors = std::any_of(spec.tools.begin(), spec.tools.end(), [](const ToolSpec& t) {
        return t.kind == ToolKind::kScissors;
    });
    if (scissors || spec.plane) body.spare_vertices = spec.spare_vertices;
    std::optional<Patch> patch = add_patch(spec, field, body);
    std::optional<Irrigation> irrigation = add_irrigation(spec, shape, field, body);

    auto scene = std::make_shared<Scene>(SoftBody(std::move(body)), std::move(patch));
    scene->id = spec.id;
    if (spec.heat) scene->heat.emplace(field.mesh, spec.materials, spec.heat_settings);
    scene->sac = std::move(sac);
    scene->slit = field.slit;
    scene->irrigation = std::move(irrigation);
    uncover_slit(field, scene->surface);
    scene->plane = make_plane(spec, field, scene->surface);
    scene->contact = spec.contact;
    scene->cut_snap = spec.cut_snap;
    scene->tear_radius_m = spec.tear_radius_m;
    scene->tools = spec.tools;
    add_suture(spec, *scene);
    scene->colour_linear = kColourLinear;
    add_landmarks(spec, shape, field, *scene);
    mark_resection(spec, shape, field, *scene);
    scene->notes = mesh_notes(field.mesh, tethers);
    const std::vector<std::string> body_notes = scene->body.notes();
    scene->notes.insert(scene->notes.end(), body_notes.begin(), body_notes.end());
    return scene;
}

}  // namespace placode::sim
