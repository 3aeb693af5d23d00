// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What shows depth to one eye: where a tip would touch if it went straight down, and a soft shadow
// of the instrument right below it, darker and sharper the nearer it is. The scope's own light
// throws its shadows behind the instruments, where nobody sees them.

#include <array>
#include <span>
#include <vector>

#include "ui/view/tool_renderer.h"

namespace placode::view {

/// The place right below a tip (along -z of W) on the drawn tissue.
struct TipFoot {
    bool found = false;
    sim::Vec3 foot_mm = sim::Vec3::Zero();
    double height_mm = 0;  ///< Of the tip above it; negative below.
};

/// The tissue as it is drawn: vertices of kTissueVertexFloats, three indices a triangle.
struct DrawnTissue {
    std::span<const float> vertices;
    std::span<const unsigned> indices;
};

class DepthCue {
 public:
    DepthCue();

    /// Looks for feet and for the tissue below the instruments. Reads every triangle once.
    void update(const sim::Snapshot& snapshot, const std::vector<sim::ToolSpec>& tools,
                std::span<const DrawnTissue> parts);
    [[nodiscard]] const std::array<TipFoot, sim::kMaxTools>& feet() const { return feet_; }
    /// Triangles in the shadow's reach.
    [[nodiscard]] size_t triangles() const { return below_.size() / 12; }
    [[nodiscard]] GlProgram& program() { return program_; }
    /// Darkens what was drawn; the program is in use and knows light and capsules.
    void draw();

 private:
    /// One instrument: where its tip drops to, and the tissue that its shadow may reach.
    struct Drop {
        Eigen::Vector3f tip;
        Eigen::Vector2f shaft;  // from the tip along the shaft, in the plane [mm]
        float low[2], high[2];  // box around both, with the shadow's border and a triangle
        float strength = 0;     // of its shadow, 0..1
        TipFoot* foot = nullptr;
        [[nodiscard]] bool is_about(const Eigen::Vector3f& p) const;
        /// In the plane: along the shaft from the tip, 0..1, and beside it [mm].
        struct Place {
            float along = 0, aside = 0;
        };
        [[nodiscard]] Place place(const Eigen::Vector3f& p) const;
        /// Of the shadow that is drawn there: it ends softly, wherever the triangles do.
        [[nodiscard]] float share(const Place& at) const;
    };
    static void drop_on(const Drop& drop, const std::array<Eigen::Vector3f, 3>& p);
    void collect(const DrawnTissue& tissue);
    GlProgram program_;
    GlMesh mesh_;
    std::array<TipFoot, sim::kMaxTools> feet_, before_;  // of this picture and the one before
    std::vector<float> below_;  // place and share of the shadow, of each corner
    std::vector<Drop> drops_;
};

}  // namespace placode::view
