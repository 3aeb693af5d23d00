// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The parametric operative field: a graded 2-D Delaunay triangulation of the lesion's surroundings,
// extruded into four layers of prisms and split into tetrahedra, conforming and deterministic.
// Flat variant (myeloschisis), or cystic (meningomyelocele): membrane and placode form a dome of
// two layers over the canal, filled with fluid (sim/cutting/sac.h). Shapes and thicknesses:
// docs/anatomy.md.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/world/scene.h"

namespace placode::sim {

/// Clinically reasoned materials of the eight tissues (the defaults that scene files state again).
[[nodiscard]] MaterialTable default_materials();

/// Needle and thread of a scene, and where the needle is at the start. Planning values.
struct FieldSuture {
    SutureSpec suture;    ///< Gravity and floor are the field's.
    bool in_jaws = true;  ///< Of the first needle driver; else it lies at `position_m`.
    /// In jaws: where they hold it, as a share of the arc from the point, and how far its plane is
    /// tipped from square to the shaft, about the wire there [degrees].
    double held_share = 0.67, plane_deg = 0;
    /// Lying flat: its circle's centre, and which way its point lies from there, from +x to +y.
    Vec3 position_m = Vec3(0, 0, 0.005);
    double yaw_deg = 0;
};

/// A wound in the skin beside the lesion, open from the start: an ellipse from tip to tip.
struct FieldSlit {
    Vec2 from_m = Vec2::Zero(), to_m = Vec2::Zero();
    double width_m = 0.001;  ///< In its middle.
    int layers = 2;          ///< From the surface down, that are parted.
    double edge_m = 0.0005;  ///< Of the triangles along it.
    std::optional<WatertightSpec> watertight = std::nullopt;  ///< Slit::watertight.
};

/// The plane in which skin is undermined: subcutis parts from the fascia below it.
struct FieldPlane {
    double strength_pa = 10e3;  ///< Traction at which it parts; a planning value.
};

/// A patch to cover the lesion with, flat and free at the start. All planning values, after
/// dura substitutes of collagen (docs/patch.md); a fetal surgeon must confirm them.
struct FieldPatch {
    double length_m = 0.025, width_m = 0.015;  ///< Along x and y before it is turned.
    double edge_m = 0.001;                     ///< Of its lattice of triangles.
    double thickness_m = 0.0004;
    double bending = 0.1;  ///< Share of a plate's bending stiffness: wet felt is softer than that.
    double friction = 0.3, tool_friction = 0.2;  ///< On wet tissue, on instruments.
    Vec2 centre_m = Vec2::Zero();
    double yaw_deg = 0;
    double height_m = 0;  ///< Above the highest tissue below it.
    /// Young's modulus in its plane, Poisson's ratio, density, damping; the rest is not used.
    Material material{.youngs_modulus_pa = 3e6,
                      .poissons_ratio = 0.3,
                      .density_kg_m3 = 1050,
                      .damping_per_s = 20};
};

/// Fluid, jet, suction and debris over the lesion. All planning values.
struct FieldIrrigation {
    JetSpec jet;
    SuctionSpec suction;
    DebrisLaw law;
    double cell_m = 0.0005;           ///< Of the grid in which fluid stands.
    int crumbs = 8, spots = 6;        ///< Of char, of blood.
    double start_m3 = 1e-7;           ///< Stands in the lesion at the start ...
    double start_blood_share = 0.02;  ///< ... so much of it blood.
};

/// Parameters in SI. Defaults are those of the default preset.
struct OperativeFieldSpec {
    std::string id = "field";
    uint64_t seed = 1;
    double domain_x_m = 0.040, domain_y_m = 0.030;
    double edge_ring_m = 0.00050, edge_placode_m = 0.0008, edge_outer_m = 0.0016;
    double edge_growth = 0.25;                            ///< Mesh size growth [m/m].
    double skin_edge_a_m = 0.012, skin_edge_b_m = 0.008;  ///< Semi-axes of the lesion (skin edge).
    double placode_a_m = 0.008, placode_b_m = 0.003;
    double dome_height_m = 0.002;
    double dome_exponent = 0.75;   ///< Profile H (1 - rho^2)^n: 0.75 is steep at the skin edge.
    bool cystic = false;           ///< A sac: no gel under membrane and placode, but fluid.
    double canal_depth_m = 0.003;  ///< Cystic: floor of the canal below the back.
    SacSettings sac;
    double base_radius_x_m = 0.120, base_radius_y_m = 0.032;
    double wobble = 0.04;           ///< Amplitude of the seeded outline [-].
    double asymmetry_m = 0;         ///< Placode's centre lies this far to the left (+y).
    double band_outside_m = 0.001;  ///< The finest triangles reach this far outside the skin edge.
    double groove_depth_m = 0.00035, groove_width_m = 0.0006;    ///< Midline groove of the placode.
    double rim_height_m = 0.00025, rim_width_m = 0.0007;         ///< Rolled skin edge.
    double relief_skin_m = 0.00006, relief_placode_m = 0.00003;  ///< Amplitude of the fine relief.
    double relief_frequency_per_m = 900;                         ///< Its lowest frequency.
    double thin_skin_width_m = 0.0025;                           ///< Atrophic skin at the edge.
    double thin_skin_factor = 0.5;    ///< Its thickness, as a share of the skin's [-].
    double blend_placode_m = 0.0005;  ///< Layers blend over twice this width at the placode edge.
    double blend_skin_m = 0.00075;    ///< The same at the skin edge.
    std::array<double, 4> placode_layers_m{0.0006, 0.0006, 0.0007, 0.0006};
    std::array<double, 4> ring_layers_m{0.00025, 0.00025, 0.0010, 0.0010};
    std::array<double, 4> skin_layers_m{0.0004, 0.0004, 0.0008, 0.0009};
    double skin_prestretch = 1.08, zone_prestretch = 1.12, placode_prestretch = 1;
    double bed_normal_pa_m = 11e6, bed_tangent_pa_m = 1.3e6,
           side_pa_m = 3e6;            ///< Winkler bed, per area.
    double contour_offset_m = 0.0015;  ///< Planned incision: this far outside the placode edge.
    /// Sector of the zone outside the planned incision that is marked for resection, counted from
    /// +x (cranial) towards +y (left) [degrees]; equal = nothing is marked.
    double resect_from_deg = 0, resect_to_deg = 0;
    double resect_margin_m = 0.0004;  ///< Left standing along the skin edge.
    double cut_snap = 0;              ///< Scene::cut_snap.
    double tear_radius_m = 0;         ///< Scene::tear_radius_m.
    int spare_vertices = 4000;  ///< For cutting; used only where scissors are among the tools.
    bool isotropic = false;     ///< `paper` preset: triangles of `edge_ring_m` everywhere, skin not
                                ///< thinned; with equal layers the tets have about equal edges.
    int tethers = 0;            ///< Breakable strands between placode and canal floor.
    double tether_break_n = 0.020;
    double tether_compliance_m_n = 1e-2;
    MaterialTable materials = default_materials();
    SolverSettings solver;
    ContactSettings contact;
    bool heat = true;
    HeatSettings heat_settings;
    std::optional<FieldSuture> suture;
    std::optional<FieldSlit> slit;
    std::optional<FieldPatch> patch;
    std::optional<FieldIrrigation> irrigation;
    std::vector<ToolSpec> tools;
    std::optional<FieldPlane> plane;
};

/// Builds the scene. Throws MeshError naming what cannot be meshed. Deterministic in `spec`.
[[nodiscard]] std::shared_ptr<const Scene> build_operative_field(const OperativeFieldSpec& spec);

}  // namespace placode::sim
