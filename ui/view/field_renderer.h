// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything that is not brought in: the tissue with its wounds, what lies around and below it, the
// wall of the uterus, and the shadows that they throw on each other.

#include <array>
#include <map>
#include <memory>
#include <string>

#include "ui/view/camera.h"
#include "ui/view/depth_cue.h"
#include "ui/view/picture_quality.h"
#include "ui/view/shadow_map.h"
#include "ui/view/surroundings.h"
#include "ui/view/tissue_maps.h"
#include "ui/view/tissue_mesh.h"
#include "ui/view/wound_map.h"

namespace placode::view {

class FieldRenderer {
 public:
    explicit FieldRenderer(const ViewField& field);

    /// Everything that moved since the last picture, to where it is drawn from.
    /// @param fine triangles around a cut are drawn in four.
    void follow(const sim::Snapshot& snapshot, bool fine);
    /// What the light beside the lens of `camera` does not reach.
    void draw_shadows(const Camera& camera);
    /// Textures of the anatomy, to units 0..3.
    void bind_maps() const { maps_.bind(); }

    /// Made when first needed.
    [[nodiscard]] GlProgram& tissue_program(const Quality& quality);
    /// With `program`, which is in use and knows the light. After draw_shadows() where `quality`
    /// has shadows.
    void draw_tissue(GlProgram& program, const Quality& quality);
    [[nodiscard]] GlProgram& wall_program() { return wall_; }
    void draw_wall() const { wall_gl_.draw(GL_TRIANGLES); }

    /// Field and back beyond it, as they are drawn.
    [[nodiscard]] std::array<DrawnTissue, 2> around_the_tips() const;

 private:
    void draw_parts() const;

    TissueMesh mesh_;
    DrawnMesh skirt_;
    Bed bed_;
    TissueMaps maps_;
    WoundMap wound_;
    GlTexture wound_texture_;
    std::unique_ptr<ShadowMap> shadow_;        // where they are drawn
    std::map<std::string, GlProgram> tissue_;  // by options; made when first needed
    GlProgram wall_{"tissue_vertex", "wall"};
    GlMesh tissue_gl_, skirt_gl_, floor_gl_, bed_gl_, wall_gl_;
};

}  // namespace placode::view
