// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>

#include "sim/anatomy/field_patch.h"
#include "sim/anatomy/field_shape.h"
#include "sim/core/number_text.h"

namespace placode::sim {

namespace {

class Checker {
 public:
    explicit Checker(const OperativeFieldSpec& spec) : spec_(spec) {}

    void range(const std::string& field, double value, double low, double high) const {
        // Written so that NaN fails as well.
        if (value >= low && value <= high) return;
        throw MeshError("operative field '" + spec_.id + "': " + field + " = " +
                        rounded_text(value, 6) + ", allowed " + rounded_text(low, 6) + " to " +
                        rounded_text(high, 6));
    }

    void layers(const std::string& field, const std::array<double, 4>& value) const {
        for (size_t l = 0; l < value.size(); ++l) {
            range(field + "[" + std::to_string(l) + "]", value[l], 0.00005, 0.01);
        }
    }

    void mesh_and_layers() const {
        range("edge_ring_m", spec_.edge_ring_m, 0.0001, 0.005);
        range("edge_placode_m", spec_.edge_placode_m, 0.0001, 0.005);
        range("edge_outer_m", spec_.edge_outer_m, 0.0001, 0.01);
        range("edge_growth", spec_.edge_growth, 0.01, 1);
        range("band_outside_m", spec_.band_outside_m, 0, 0.02);
        layers("placode_layers_m", spec_.placode_layers_m);
        layers("ring_layers_m", spec_.ring_layers_m);
        layers("skin_layers_m", spec_.skin_layers_m);
        range("thin_skin_factor", spec_.thin_skin_factor, 0.1, 1);
        range("thin_skin_width_m", spec_.thin_skin_width_m, 0.0001, 0.02);
        range("blend_placode_m", spec_.blend_placode_m, 0.00001, 0.005);
        range("blend_skin_m", spec_.blend_skin_m, 0.00001, 0.005);
    }

    void outlines() const {
        range("wobble", spec_.wobble, 0, 0.08);
        // All three harmonics may add up.
        const double swing = 3 * spec_.wobble, edge = spec_.edge_ring_m;
        range("domain_x_m", spec_.domain_x_m, 0.005, 0.2);
        range("domain_y_m", spec_.domain_y_m, 0.005, 0.2);
        range("skin_edge_a_m", spec_.skin_edge_a_m, 0.002,
              (spec_.domain_x_m / 2 - 2 * edge) / (1 + swing));
        range("skin_edge_b_m", spec_.skin_edge_b_m, 0.002,
              (spec_.domain_y_m / 2 - 2 * edge) / (1 + swing));
        range("contour_offset_m", spec_.contour_offset_m, 0.0005, 0.02);
        range("resect_from_deg", spec_.resect_from_deg, -360, 720);
        range("resect_to_deg", spec_.resect_to_deg, -360, 720);
        range("resect_margin_m", spec_.resect_margin_m, 0, 0.003);
        range("cut_snap", spec_.cut_snap, 0, 0.75);
        range("tear_radius_m", spec_.tear_radius_m, 0, 0.001);
        range("spare_vertices", spec_.spare_vertices, 0, 20000);
        // Between the outlines there is room for the contour and one edge behind it.
        const double gap = (spec_.contour_offset_m + edge) / (1 - swing);
        range("placode_a_m", spec_.placode_a_m, 0.0005, spec_.skin_edge_a_m - gap);
        range("placode_b_m", spec_.placode_b_m, 0.0005, spec_.skin_edge_b_m - gap);
        const double aside = spec_.skin_edge_b_m - gap - spec_.placode_b_m;
        range("asymmetry_m", spec_.asymmetry_m, -aside, aside);
    }

    void heights() const {
        // A high dome of four layers has flat tets on its flanks; a sac's wall stands across them.
        // A lesion that has sunk after its release lies below the back; a sac does not.
        range("dome_height_m", spec_.dome_height_m, spec_.cystic ? 0 : -0.0025,
              spec_.cystic ? 0.008 : 0.0035);
        range("dome_exponent", spec_.dome_exponent, spec_.cystic ? 1 : 0.5, 3);
        range("canal_depth_m", spec_.canal_depth_m, 0.001, 0.008);
        range("base_radius_x_m", spec_.base_radius_x_m, spec_.domain_x_m / 2, 1e6);
        range("base_radius_y_m", spec_.base_radius_y_m, spec_.domain_y_m / 2, 1e6);
        range("groove_depth_m", spec_.groove_depth_m, 0, 0.001);
        range("groove_width_m", spec_.groove_width_m, 0.0001, 0.01);
        range("rim_height_m", spec_.rim_height_m, 0, 0.001);
        range("rim_width_m", spec_.rim_width_m, 0.0001, 0.01);
        range("relief_skin_m", spec_.relief_skin_m, 0, 0.0003);
        range("relief_placode_m", spec_.relief_placode_m, 0, 0.0003);
        range("relief_frequency_per_m", spec_.relief_frequency_per_m, 0, 1e5);
    }

    void sac() const {
        range("sac.pressure_pa", spec_.sac.pressure_pa, 0, 2000);
        range("sac.stiffness_pa_m3", spec_.sac.stiffness_pa_m3, 1e6, 1e11);
        range("sac.discharge", spec_.sac.discharge, 0, 1);
        range("sac.fluid_density_kg_m3", spec_.sac.fluid_density_kg_m3, 100, 20000);
        range("sac.floor_n_m", spec_.sac.floor_n_m, 0, 1000);
        range("sac.floor_drag_n_m", spec_.sac.floor_drag_n_m, 0, 1000);
        if (spec_.cystic && spec_.solver.method != Method::kVbd) {
            throw MeshError("operative field '" + spec_.id +
                            "': solver.method: a cystic field needs vbd, the only method that "
                            "knows the load of its fluid");
        }
        if (spec_.cystic && spec_.isotropic) {
            throw MeshError("operative field '" + spec_.id +
                            "': cystic and isotropic exclude each other");
        }
    }

    void suture() const {
        const bool driver =
            std::any_of(spec_.tools.begin(), spec_.tools.end(),
                        [](const ToolSpec& t) { return t.kind == ToolKind::kNeedleDriver; });
        const std::string field = "operative field '" + spec_.id + "': ";
        if (!spec_.suture) {
            if (driver)
                throw MeshError(field +
                                "tools: a needle_driver without a needle; expected a section "
                                "\"suture\"");
            return;
        }
        const FieldSuture& s = *spec_.suture;
        try {
            const Suture suture(s.suture);
        } catch (const SutureError& error) {
            throw MeshError(field + "suture." + error.what());
        }
        range("suture.start.held_share", s.held_share, 0, 1);
        range("suture.start.plane_deg", s.plane_deg, -90, 90);
        range("suture.start.yaw_deg", s.yaw_deg, -360, 360);
        for (int k = 0; k < 3; ++k) range("suture.start.position_m", s.position_m[k], -0.1, 0.1);
        if (s.in_jaws && !driver)
            throw MeshError(field +
                            "suture.start.in_jaws: true, but none of the tools is a "
                            "needle_driver");
    }

    void watertight(const WatertightSpec& w) const {
        range("slit.watertight.most_pa", w.most_pa, WatertightSpec::kGoodPa, 20000);
        range("slit.watertight.burst_m3_s", w.burst_m3_s, 1e-12, 1e-3);
    }

    void slit() const {
        if (!spec_.slit) return;
        const FieldSlit& s = *spec_.slit;
        range("slit.edge_m", s.edge_m, 0.0001, 0.005);
        // Narrower, the triangles of its tips would be flat.
        range("slit.width_m", s.width_m, 1.5 * s.edge_m, 0.01);
        range("slit.layers", s.layers, 1, kFieldLayers - 1);
        range("slit: length", (s.to_m - s.from_m).norm(), 2 * s.width_m, 0.1);
        if (s.watertight) watertight(*s.watertight);
        if (!spec_.contact.self_contact)
            throw MeshError("operative field '" + spec_.id +
                            "': contact.self_contact: false, but the edges of a slit must meet; "
                            "expected true");
    }

    void plane() const {
        for (const ToolSpec& t : spec_.tools) {
            if (t.jaws_spread && t.kind != ToolKind::kGrasper)
                throw MeshError("operative field '" + spec_.id +
                                "': tools: jaws_spread: true, but only a grasper's jaws spread");
        }
        if (!spec_.plane) return;
        const std::string field = "operative field '" + spec_.id + "': plane: ";
        range("plane.strength_pa", spec_.plane->strength_pa, 100, 1e6);
        range("spare_vertices", spec_.spare_vertices, 1, 20000);
        if (!spec_.slit || spec_.slit->layers != kFieldLayers - 1)
            throw MeshError(field + "no way leads there; expected a slit with layers 3");
        if (spec_.heat)
            throw MeshError(field + "it does not know heat; expected heat.enabled: false");
        if (spec_.cystic) throw MeshError(field + "not in a cystic field; expected a flat one");
    }

    /// What a patch cannot be together with, yet.
    void beside_patch() const {
        const std::string field = "operative field '" + spec_.id + "': patch: ";
        if (spec_.solver.method != Method::kVbd)
            throw MeshError(field + "it needs solver.method vbd, the only one that knows sheets");
        if (spec_.cystic) throw MeshError(field + "not in a cystic field; expected a flat one");
        if (spec_.heat)
            throw MeshError(field + "it does not know heat; expected heat.enabled: false");
        if (spec_.slit && spec_.slit->watertight)
            throw MeshError(field + "not beside slit.watertight; leave one of them out");
        for (const ToolSpec& t : spec_.tools) {
            if (t.kind == ToolKind::kScissors)
                throw MeshError(field +
                                "it cannot be trimmed, and scissors are among the tools; leave "
                                "one of them out");
        }
    }

    void patch() const {
        if (!spec_.patch) return;
        const FieldPatch& p = *spec_.patch;
        range("patch.thickness_m", p.thickness_m, 0.0001, 0.001);
        range("patch.length_m", p.length_m, 0.003, 0.06);
        range("patch.width_m", p.width_m, 0.003, 0.06);
        // Shorter than it is thick, a triangle is no sheet; longer, the patch would not bend.
        const double shorter = std::min(p.length_m, p.width_m);
        range("patch.edge_m", p.edge_m, std::max(0.0003, p.thickness_m), shorter / 3);
        const double most = 2 * p.length_m * p.width_m / kMostPatchTriangles;
        if (p.edge_m * p.edge_m < most)
            throw MeshError("operative field '" + spec_.id +
                            "': patch.edge_m = " + rounded_text(p.edge_m, 6) + " makes more than " +
                            std::to_string(kMostPatchTriangles) + " triangles; allowed from " +
                            rounded_text(std::sqrt(most), 6));
        range("patch.bending", p.bending, 0, 1);
        range("patch.friction", p.friction, 0, 2);
        range("patch.tool_friction", p.tool_friction, 0, 2);
        range("patch.yaw_deg", p.yaw_deg, -360, 360);
        range("patch.height_m", p.height_m, 0, 0.02);
        for (int k = 0; k < 2; ++k) range("patch.centre_m", p.centre_m[k], -0.1, 0.1);
        range("patch.youngs_modulus_pa", p.material.youngs_modulus_pa, 1e4, 2e7);
        range("patch.poissons_ratio", p.material.poissons_ratio, 0, 0.49);
        range("patch.density_kg_m3", p.material.density_kg_m3, 100, 3000);
        range("patch.damping_per_s", p.material.damping_per_s, 0, 1000);
        beside_patch();
    }

    /// What irrigation cannot be together with, yet: its loads are springs of the surface, which
    /// must stay what it is.
    void beside_irrigation() const {
        const std::string field = "operative field '" + spec_.id + "': irrigation: ";
        if (spec_.solver.method != Method::kVbd)
            throw MeshError(field + "it needs solver.method vbd, the only one that knows loads");
        if (spec_.cystic) throw MeshError(field + "not in a cystic field; expected a flat one");
        if (spec_.heat)
            throw MeshError(field + "it does not know heat; expected heat.enabled: false");
        if (spec_.patch) throw MeshError(field + "not beside a patch; leave one of them out");
        if (spec_.slit) throw MeshError(field + "not beside a slit; leave one of them out");
        for (const ToolSpec& t : spec_.tools) {
            if (t.kind == ToolKind::kScissors)
                throw MeshError(field + "not with scissors among the tools; leave one of them out");
        }
    }

    void irrigation() const {
        const bool tool =
            std::any_of(spec_.tools.begin(), spec_.tools.end(),
                        [](const ToolSpec& t) { return t.kind == ToolKind::kIrrigator; });
        if (!spec_.irrigation) {
            if (tool)
                throw MeshError("operative field '" + spec_.id +
                                "': tools: an irrigator without fluid; expected a section "
                                "\"irrigation\"");
            return;
        }
        const FieldIrrigation& f = *spec_.irrigation;
        range("irrigation.jet_speed_m_s", f.jet.speed_m_s, 0.01, 10);
        range("irrigation.jet_bore_m", f.jet.bore_m, 0.0002, 0.003);
        range("irrigation.density_kg_m3", f.jet.density_kg_m3, 500, 2000);
        range("irrigation.viscosity_pa_s", f.jet.viscosity_pa_s, 1e-4, 0.1);
        range("irrigation.core_diameters", f.jet.core_diameters, 1, 100);
        range("irrigation.suction_pa", f.suction.pressure_pa, 0, 60000);
        range("irrigation.suction_bore_m", f.suction.bore_m, 0.0005, 0.004);
        range("irrigation.suction_flow_m3_s", f.suction.flow_m3_s, 0, 1e-4);
        range("irrigation.cell_m", f.cell_m, 0.0003, 0.002);
        range("irrigation.crumbs", f.crumbs, 0, 64);
        range("irrigation.spots", f.spots, 0, 64);
        range("irrigation.crumb_pa", f.law.adhesion_pa[0], 0.1, 1000);
        range("irrigation.spot_pa", f.law.adhesion_pa[1], 0.1, 1000);
        range("irrigation.crumb_s", f.law.hold_s[0], 0, 60);
        range("irrigation.spot_s", f.law.hold_s[1], 0, 60);
        range("irrigation.spot_blood_m3", f.law.blood_m3, 0, 1e-7);
        range("irrigation.start_m3", f.start_m3, 0, 5e-6);
        range("irrigation.start_blood_share", f.start_blood_share, 0, 1);
        beside_irrigation();
    }

    void mechanics() const {
        range("skin_prestretch", spec_.skin_prestretch, 1, 1.5);
        range("zone_prestretch", spec_.zone_prestretch, 1, 1.5);
        range("placode_prestretch", spec_.placode_prestretch, 1, 1.5);
        sac();
        suture();
        slit();
        plane();
        patch();
        irrigation();
        range("bed_normal_pa_m", spec_.bed_normal_pa_m, 0, 1e12);
        range("bed_tangent_pa_m", spec_.bed_tangent_pa_m, 0, 1e12);
        range("side_pa_m", spec_.side_pa_m, 0, 1e12);
        range("tethers", spec_.tethers, 0, 200);
        range("tether_break_n", spec_.tether_break_n, 1e-6, 10);
        range("tether_compliance_m_n", spec_.tether_compliance_m_n, 0, 10);
        range("tools", static_cast<double>(spec_.tools.size()), 0, kMaxTools);
        for (int i = 0; i < kTissueCount; ++i) {
            const Material& m = spec_.materials[i];
            const std::string name =
                "materials." + std::string(tissue_name(static_cast<Tissue>(i))) + ".";
            range(name + "youngs_modulus_pa", m.youngs_modulus_pa, 1, 1e9);
            range(name + "poissons_ratio", m.poissons_ratio, 0, 0.4999);
            range(name + "density_kg_m3", m.density_kg_m3, 100, 20000);
        }
    }

 private:
    const OperativeFieldSpec& spec_;
};

}  // namespace

void check_field_spec(const OperativeFieldSpec& spec) {
    const Checker check(spec);
    check.mesh_and_layers();
    check.outlines();
    check.heights();
    check.mechanics();
}

}  // namespace placode::sim
