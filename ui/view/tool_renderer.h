// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Instruments as meshes in their own frame (tip at the origin, +z distal), posed every frame.

#include <array>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::view {

enum class ToolMaterial {
    kSteel = 0,
    kInsulation = 1,
    kCeramic = 2,
    kThread = 3,
    kPatch = 4,
    kPool = 5,
    kJet = 6,
    kCrumb = 7,
    kSpot = 8
};

/// Triangles of one instrument in T [mm]; `jaw`: -1 and +1 turn about the hinge, 0 is fixed.
struct ToolModel {
    struct Vertex {
        Eigen::Vector3f p, n;
        float material = 0, along_mm = 0, around = 0;
        int jaw = 0;
    };
    std::vector<Vertex> vertices;
    std::vector<unsigned> indices;
    float hinge_mm = 0;  ///< Distance of the hinge from the tip.
};
[[nodiscard]] ToolModel tool_model(const sim::ToolSpec& spec);

/// Capsules (a, b, radius) [mm] that stand for a tool in shadows.
struct ShadowCapsule {
    sim::Vec3 a = sim::Vec3::Zero(), b = sim::Vec3::Zero();
    double radius = 0;
};
[[nodiscard]] std::vector<ShadowCapsule> shadow_capsules(const sim::ToolSpec& spec,
                                                         const sim::Pose& X_WT);

/// Whether instrument `i` is drawn: no scope, not what waits outside for its turn at the port, and
/// nothing that no hand has moved yet.
[[nodiscard]] bool is_drawn(const std::vector<sim::ToolSpec>& tools, size_t i,
                            const sim::Snapshot& snapshot);

class ToolRenderer {
 public:
    explicit ToolRenderer(const std::vector<sim::ToolSpec>& tools);
    /// Draws all tools except the scope. The program is `tissue_vertex` + `tool`, in use.
    void draw(const sim::Snapshot& snapshot, GlProgram& program);

 private:
    std::vector<sim::ToolSpec> specs_;
    std::vector<ToolModel> shapes_;
    std::array<GlMesh, sim::kMaxTools> meshes_;
    std::vector<float> staging_;
};

}  // namespace placode::view
