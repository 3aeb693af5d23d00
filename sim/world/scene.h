// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scene: everything about an attempt that never changes while it runs.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/tool.h"
#include "sim/heat/heat.h"
#include "sim/mesh/surface.h"
#include "sim/solver/soft_body.h"
#include "sim/suture/suture.h"
#include "sim/world/dissection_plane.h"
#include "sim/world/irrigation.h"
#include "sim/world/patch.h"
#include "sim/world/sac_state.h"
#include "sim/world/slit.h"

namespace placode::sim {

/// Landmarks of the operative field at rest, in W [m]. Stored in every recording, so that an
/// attempt can be assessed without rebuilding the scene.
struct FieldGeometry {
    std::vector<Vec3>
        planned_contour;  ///< Closed polyline of the incision on the surface (last != first).
    std::vector<Vec3> placode_edge;  ///< Closed polyline.
    std::vector<Vec3> skin_edge;     ///< Closed polyline.
    double target_depth_m = 0.0005;  ///< Depth at which the ring counts as cut through.
    double placode_volume_m3 = 0;
};

/// Per-vertex knowledge that only the operative field has.
struct FieldVertexData {
    std::vector<float>
        to_placode_m;  ///< d_p: signed distance to the placode edge (V), negative inside.
    std::vector<float>
        to_skin_m;  ///< d_s: signed distance to the skin edge (V), negative inside the lesion.
    std::vector<float> depth_m;  ///< Below the rest surface (V), 0 on top.
};

/// A planned-contour point tied to a surface triangle, so that it moves with the tissue.
struct ContourAnchor {
    std::array<int32_t, 3> vertex{};
    std::array<float, 3> weight{};  ///< Barycentric.
};

/// Tissue that the operator shall take out: outlined on the surface, closed.
struct Resection {
    std::vector<Vec3> line;              ///< At rest [m], last != first.
    std::vector<ContourAnchor> anchors;  ///< One per point.
    /// Tets of the top layer just inside and just outside of each point: parted there when no path
    /// leads from one to the other any more.
    std::vector<std::array<int32_t, 2>> across;
    Vec3 grasp_m = Vec3::Zero();  ///< A good place to take hold, at rest.
    ContourAnchor grasp_anchor;
};

struct ContactSettings {
    double stiffness_n_m = 3000;          ///< k of the contact colour [N/m].
    double margin_m = 0.0002;             ///< Contact starts this far out, for time continuity.
    bool self_contact = false;            ///< Tissue meets tissue: sim/contact/self_contact.h.
    double placode_warn_force_n = 0.005;  ///< Contact of the placode counts above.
    double over_force_n = 0.4;            ///< Force on any tissue that counts as too much.
    double warn_dose_cem43_min = 5, injury_dose_cem43_min = 20, injury_temperature_c = 60;
};

/// Where an attempt finds its needle.
struct NeedleStart {
    /// In the jaws of the first needle driver, from the frame in which a hand first has it; else it
    /// lies at `X_WN` until somebody takes it.
    bool in_jaws = true;
    double held_arc_m = 0;  ///< Where the jaws hold it, from the point.
    Pose X_TN;              ///< In the driver.
    Pose X_WN;
};

/// Built once (sim/anatomy), then shared as `shared_ptr<const Scene>`.
struct Scene {
    /// @param sheet is what the body's sheet must be, if it has one.
    /// @throws MeshError for a sheet that is no patch: instruments, heat and cutting do not know
    /// it.
    explicit Scene(SoftBody tissue, std::optional<Patch> sheet = std::nullopt);

    std::string id;  ///< Scene file and preset, for messages.
    SoftBody body;
    Surface surface;
    std::optional<HeatModel> heat;  ///< Absent = costs nothing.
    std::optional<Suture> suture;   ///< Needle and thread; absent = costs nothing.
    NeedleStart needle_start;
    Sac sac;                     ///< Of the cystic variant; absent otherwise.
    Slit slit;                   ///< To be sewn up; absent in most scenes.
    std::optional<Patch> patch;  ///< To cover the lesion with; absent = costs nothing.
    ContactSettings contact;
    /// How far a vertex may slide to where blades pass, as a share of the way to its neighbours; 0
    /// = cuts follow the faces of the mesh, as in recordings of before.
    double cut_snap = 0;
    /// Tissue tears by its mean stretch over this distance at rest [m]; 0 = tet by tet, as in
    /// recordings of before.
    double tear_radius_m = 0;
    std::vector<uint8_t> marked;  ///< (T) 1 = to be resected; empty = nothing is marked.
    double marked_volume_m3 = 0;
    Resection resection;
    std::vector<ToolSpec> tools;  ///< At most kMaxTools.
    FieldGeometry geometry;
    FieldVertexData field;
    std::vector<ContourAnchor> contour_anchors;  ///< One per planned_contour point.
    std::array<std::array<float, 3>, kTissueCount>
        colour_linear{};  ///< Base albedo by tissue, linear RGB.
    std::vector<std::string>
        notes;  ///< What the loader found: Courant numbers, qualities, choices.
    std::optional<Irrigation> irrigation;  ///< Fluid and debris; absent = costs nothing.
    DissectionPlane plane;                 ///< To be undermined; absent in most scenes.
};

}  // namespace placode::sim
