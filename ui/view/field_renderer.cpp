// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/field_renderer.h"

#include "ui/view/scope_light.h"

namespace placode::view {
namespace {

const std::vector<int> kFieldLayout{3, 3, 4, 4, 2};

void load_field(GlMesh& mesh, const DrawnMesh& drawn) {
    mesh.create(kFieldLayout);
    if (drawn.indices.empty()) return;
    mesh.vertices(drawn.vertices.data(), drawn.vertices.size(), false);
    mesh.indices(drawn.indices);
}

}  // namespace

FieldRenderer::FieldRenderer(const ViewField& field)
    : mesh_(field),
      skirt_(build_skirt(field)),
      bed_(field),
      maps_(bake_maps(field)),
      wound_(field, maps_.low_mm, maps_.high_mm) {
    tissue_gl_.create(kFieldLayout);
    load_field(skirt_gl_, skirt_);
    load_field(floor_gl_, build_floor(field.floor));
    load_field(bed_gl_, bed_.mesh());
    load_field(wall_gl_, build_wall());
    wound_texture_.load(WoundMap::kSize, WoundMap::kSize, {}, wound_.pixels().data());
}

void FieldRenderer::follow(const sim::Snapshot& snapshot, bool fine) {
    mesh_.set_fine(fine);
    const bool changed = mesh_.update(snapshot);
    if (changed) tissue_gl_.indices(mesh_.indices());
    tissue_gl_.vertices(mesh_.vertices().data(), mesh_.vertices().size(), true);
    if (mesh_.cut()) {
        if (changed) {
            bed_.choose(snapshot);
            bed_gl_.indices(bed_.mesh().indices);
        }
        bed_.follow(snapshot);
        bed_gl_.vertices(bed_.mesh().vertices.data(), bed_.mesh().vertices.size(), true);
    }
    const MapPart part = wound_.update(snapshot);
    if (part.width > 0)
        wound_texture_.replace({part.x, part.y, part.width, part.height}, WoundMap::kSize,
                               wound_.pixels().data());
}

void FieldRenderer::draw_parts() const {
    tissue_gl_.draw(GL_TRIANGLES);
    skirt_gl_.draw(GL_TRIANGLES);
    floor_gl_.draw(GL_TRIANGLES);
    if (mesh_.cut()) bed_gl_.draw(GL_TRIANGLES);
}

void FieldRenderer::draw_shadows(const Camera& camera) {
    constexpr double kWider = 0.06;  // the light stands beside the lens
    if (!shadow_) shadow_ = std::make_unique<ShadowMap>();
    Camera lamp = camera;
    lamp.position_mm = light_place(camera);
    lamp.half_angle_rad += kWider;
    shadow_->begin(lamp);
    draw_parts();
    shadow_->end();
}

GlProgram& FieldRenderer::tissue_program(const Quality& quality) {
    const std::string options = quality.plain ? "PLAIN" : quality.shadows ? "SHADOWED" : "";
    return tissue_.try_emplace(options, "tissue_vertex", "tissue", options).first->second;
}

void FieldRenderer::draw_tissue(GlProgram& program, const Quality& quality) {
    program.set("map_low", static_cast<float>(maps_.low_mm.x()),
                static_cast<float>(maps_.low_mm.y()));
    program.set("map_high", static_cast<float>(maps_.high_mm.x()),
                static_cast<float>(maps_.high_mm.y()));
    program.set("skin_tile", static_cast<float>(kSkinTileMm));
    program.set("wound_map", 4);
    wound_texture_.bind(4);
    if (quality.shadows) {
        program.set("light_map", 5);
        program.set("light_projection", shadow_->projection());
        shadow_->bind(5);
    }
    draw_parts();
}

std::array<DrawnTissue, 2> FieldRenderer::around_the_tips() const {
    return {{{mesh_.vertices(), mesh_.indices()}, {skirt_.vertices, skirt_.indices}}};
}

}  // namespace placode::view
