// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scene JSON: one list of fields for reading and writing, so that neither can forget one. Keys are
// the C++ field names.

#include <string_view>

#include "curriculum/json_reader.h"
#include "sim/core/tool_kind_name.h"

namespace placode::curriculum {

namespace {

using sim::ContactSettings;
using sim::Hand;
using sim::HeatSettings;
using sim::Material;
using sim::Method;
using sim::OperativeFieldSpec;
using sim::SolverSettings;
using sim::ToolKind;
using sim::ToolSpec;
using sim::Vec2;
using sim::Vec3;

template <class E>
struct EnumName {
    E value;
    const char* name;
};
constexpr EnumName<Method> kMethods[]{
    {Method::kXpbd, "xpbd"}, {Method::kXpbdPair, "xpbd_pair"}, {Method::kVbd, "vbd"}};
constexpr EnumName<ToolKind> named(ToolKind kind) { return {kind, sim::tool_kind_name(kind)}; }
constexpr EnumName<ToolKind> kToolKinds[]{
    named(ToolKind::kScope),        named(ToolKind::kNeedle),   named(ToolKind::kHook),
    named(ToolKind::kGrasper),      named(ToolKind::kScissors), named(ToolKind::kProbe),
    named(ToolKind::kNeedleDriver), named(ToolKind::kIrrigator)};
constexpr EnumName<Hand> kHands[]{
    {Hand::kRight, "right"}, {Hand::kLeft, "left"}, {Hand::kCamera, "camera"}};

/// Takes what the JSON has and leaves the rest at its default.
struct Reader {
    const Json& json;

    template <class T>
    void operator()(const char* key, T& value) const {
        if (json.contains(key)) value = json[key].get<T>();
    }
    void operator()(const char* key, Vec3& value) const {
        if (!json.contains(key)) return;
        for (size_t i = 0; i < 3; ++i) value[static_cast<int>(i)] = json[key][i].get<double>();
    }
    void operator()(const char* key, Vec2& value) const {
        if (!json.contains(key)) return;
        for (size_t i = 0; i < 2; ++i) value[static_cast<int>(i)] = json[key][i].get<double>();
    }
    template <class E, size_t N>
    void choice(const char* key, E& value, const EnumName<E> (&names)[N]) const {
        if (!json.contains(key)) return;
        for (const auto& entry : names) {
            if (json[key] == entry.name) value = entry.value;
        }
    }
};

struct Writer {
    Json& json;

    template <class T>
    void operator()(const char* key, const T& value) const {
        json[key] = value;
    }
    void operator()(const char* key, const Vec3& value) const {
        json[key] = {value[0], value[1], value[2]};
    }
    void operator()(const char* key, const Vec2& value) const { json[key] = {value[0], value[1]}; }
    template <class E, size_t N>
    void choice(const char* key, const E& value, const EnumName<E> (&names)[N]) const {
        for (const auto& entry : names) {
            if (entry.value == value) json[key] = entry.name;
        }
    }
};

template <class V, class M>
void visit_material(const V& v, M& m) {
    v("youngs_modulus_pa", m.youngs_modulus_pa);
    v("poissons_ratio", m.poissons_ratio);
    v("density_kg_m3", m.density_kg_m3);
    v("damping_per_s", m.damping_per_s);
    v("fail_stretch", m.fail_stretch);
    v("injury_stretch", m.injury_stretch);
    v("friction", m.friction);
    v("friction_static_ratio", m.friction_static_ratio);
    v("crush_pa", m.crush_pa);
    v("traction_limit_n", m.traction_limit_n);
    v("heat_conductivity_w_mk", m.heat_conductivity_w_mk);
    v("heat_capacity_j_kgk", m.heat_capacity_j_kgk);
    v("water_fraction", m.water_fraction);
}

template <class V, class S>
void visit_solver(const V& v, S& s) {
    v.choice("method", s.method, kMethods);
    v("frame_s", s.frame_s);
    v("substeps", s.substeps);
    v("iterations", s.iterations);
    v("over_relaxation", s.over_relaxation);
    v("gravity_m_s2", s.gravity_m_s2);
    v("sleep", s.sleep);
}

template <class V, class C>
void visit_contact(const V& v, C& c) {
    v("stiffness_n_m", c.stiffness_n_m);
    v("margin_m", c.margin_m);
    v("self_contact", c.self_contact);
    v("placode_warn_force_n", c.placode_warn_force_n);
    v("over_force_n", c.over_force_n);
    v("warn_dose_cem43_min", c.warn_dose_cem43_min);
    v("injury_dose_cem43_min", c.injury_dose_cem43_min);
    v("injury_temperature_c", c.injury_temperature_c);
}

template <class V, class S>
void visit_sac(const V& v, S& s) {
    v("pressure_pa", s.pressure_pa);
    v("stiffness_pa_m3", s.stiffness_pa_m3);
    v("discharge", s.discharge);
    v("fluid_density_kg_m3", s.fluid_density_kg_m3);
    v("floor_n_m", s.floor_n_m);
    v("floor_drag_n_m", s.floor_drag_n_m);
}

template <class V, class S>
void visit_slit(const V& v, S& s) {
    v("from_m", s.from_m);
    v("to_m", s.to_m);
    v("width_m", s.width_m);
    v("layers", s.layers);
    v("edge_m", s.edge_m);
}

template <class V, class W>
void visit_watertight(const V& v, W& w) {
    v("most_pa", w.most_pa);
    v("burst_m3_s", w.burst_m3_s);
}

template <class V, class P>
void visit_plane(const V& v, P& p) {
    v("strength_pa", p.strength_pa);
}

template <class V, class P>
void visit_patch(const V& v, P& p) {
    v("length_m", p.length_m);
    v("width_m", p.width_m);
    v("edge_m", p.edge_m);
    v("thickness_m", p.thickness_m);
    v("youngs_modulus_pa", p.material.youngs_modulus_pa);
    v("poissons_ratio", p.material.poissons_ratio);
    v("density_kg_m3", p.material.density_kg_m3);
    v("damping_per_s", p.material.damping_per_s);
    v("bending", p.bending);
    v("friction", p.friction);
    v("tool_friction", p.tool_friction);
    v("centre_m", p.centre_m);
    v("yaw_deg", p.yaw_deg);
    v("height_m", p.height_m);
}

template <class V, class I>
void visit_irrigation(const V& v, I& i) {
    v("jet_speed_m_s", i.jet.speed_m_s);
    v("jet_bore_m", i.jet.bore_m);
    v("density_kg_m3", i.jet.density_kg_m3);
    v("viscosity_pa_s", i.jet.viscosity_pa_s);
    v("core_diameters", i.jet.core_diameters);
    v("suction_pa", i.suction.pressure_pa);
    v("suction_bore_m", i.suction.bore_m);
    v("suction_flow_m3_s", i.suction.flow_m3_s);
    v("cell_m", i.cell_m);
    v("crumbs", i.crumbs);
    v("spots", i.spots);
    v("crumb_pa", i.law.adhesion_pa[0]);
    v("spot_pa", i.law.adhesion_pa[1]);
    v("crumb_s", i.law.hold_s[0]);
    v("spot_s", i.law.hold_s[1]);
    v("spot_blood_m3", i.law.blood_m3);
    v("start_m3", i.start_m3);
    v("start_blood_share", i.start_blood_share);
}

template <class V, class N>
void visit_needle(const V& v, N& n) {
    v("arc_m", n.arc_m);
    v("wire_radius_m", n.wire_radius_m);
    v("density_kg_m3", n.density_kg_m3);
}

template <class V, class J>
void visit_jaws(const V& v, J& j) {
    v("force_n", j.force_n);
    v("friction", j.friction);
    v("width_m", j.width_m);
    v("pull_n_m", j.pull_n_m);
    v("turn_n_m_rad", j.turn_n_m_rad);
}

template <class V, class T>
void visit_thread(const V& v, T& t) {
    v("length_m", t.length_m);
    v("stretch_n", t.stretch_n);
    v("friction", t.friction.friction);
    v("drag_n_m", t.friction.drag_n_m);
    v("barb_n_m", t.friction.barb_n_m);
    v("stopper", t.stopper);
}

template <class V, class S>
void visit_strength(const V& v, S& s) {
    v("puncture_n", s.puncture_n);
    v("cutting_share", s.cutting_share);
    v("wall_friction_n_m", s.wall_friction_n_m);
    v("tear_n_m", s.tear_n_m);
}

template <class V, class S>
void visit_needle_start(const V& v, S& s) {
    v("in_jaws", s.in_jaws);
    v("held_share", s.held_share);
    v("plane_deg", s.plane_deg);
    v("position_m", s.position_m);
    v("yaw_deg", s.yaw_deg);
}

/// `section(key)` gives the visitor of a section, or nothing where the JSON has none.
template <class Section, class V, class F>
void visit_suture(const Section& section, const V& v, F& f) {
    v("point_friction", f.suture.point_friction);
    v("drag_per_s", f.suture.drag_per_s);
    section("needle", [&](const V& in) { visit_needle(in, f.suture.needle); });
    section("jaws", [&](const V& in) { visit_jaws(in, f.suture.jaws); });
    section("thread", [&](const V& in) { visit_thread(in, f.suture.thread); });
    section("start", [&](const V& in) { visit_needle_start(in, f); });
}

template <class V, class H>
void visit_heat(const V& v, H& h) {
    v("body_temperature_c", h.body_temperature_c);
    v("gas_temperature_c", h.gas_temperature_c);
    v("surface_cooling_w_m2k", h.surface_cooling_w_m2k);
    v("latent_heat_j_kg", h.latent_heat_j_kg);
    v("char_start_c", h.char_start_c);
    v("char_full_c", h.char_full_c);
    v("arrhenius_a_per_s", h.arrhenius_a_per_s);
    v("arrhenius_ea_j_mol", h.arrhenius_ea_j_mol);
    v("arrhenius_gate_c", h.arrhenius_gate_c);
    v("dwell_radius_m", h.dwell_radius_m);
    v("vaporise_dried", h.vaporise_dried);
}

template <class V, class T>
void visit_tool(const V& v, T& t) {
    v.choice("kind", t.kind, kToolKinds);
    v.choice("hand", t.hand, kHands);
    v("pivot_m", t.pivot_m);
    v("shaft_radius_m", t.shaft_radius_m);
    v("length_m", t.length_m);
    v("tip_radius_m", t.tip_radius_m);
    v("tip_length_m", t.tip_length_m);
    v("scope_angle_deg", t.scope_angle_deg);
    v("field_of_view_deg", t.field_of_view_deg);
    v("cut_power_w", t.cut_power_w);
    v("coag_power_w", t.coag_power_w);
    v("efficiency", t.efficiency);
    v("grip_n_m", t.hand_n_m);
    v("jaw_open_rad", t.jaw_open_rad);
    v("jaw_width_m", t.jaw_width_m);
    v("jaw_grip_m", t.jaw_touch_m);
    v("jaw_force_n", t.jaw_force_n);
    v("jaw_friction", t.jaw_friction);
}

template <class V, class S>
void visit_field(const V& v, S& s) {
    v("id", s.id);
    v("seed", s.seed);
    v("domain_x_m", s.domain_x_m);
    v("domain_y_m", s.domain_y_m);
    v("edge_ring_m", s.edge_ring_m);
    v("edge_placode_m", s.edge_placode_m);
    v("edge_outer_m", s.edge_outer_m);
    v("edge_growth", s.edge_growth);
    v("skin_edge_a_m", s.skin_edge_a_m);
    v("skin_edge_b_m", s.skin_edge_b_m);
    v("placode_a_m", s.placode_a_m);
    v("placode_b_m", s.placode_b_m);
    v("dome_height_m", s.dome_height_m);
    v("dome_exponent", s.dome_exponent);
    v("cystic", s.cystic);
    v("canal_depth_m", s.canal_depth_m);
    v("base_radius_x_m", s.base_radius_x_m);
    v("base_radius_y_m", s.base_radius_y_m);
    v("wobble", s.wobble);
    v("asymmetry_m", s.asymmetry_m);
    v("band_outside_m", s.band_outside_m);
    v("groove_depth_m", s.groove_depth_m);
    v("groove_width_m", s.groove_width_m);
    v("rim_height_m", s.rim_height_m);
    v("rim_width_m", s.rim_width_m);
    v("relief_skin_m", s.relief_skin_m);
    v("relief_placode_m", s.relief_placode_m);
    v("relief_frequency_per_m", s.relief_frequency_per_m);
    v("thin_skin_width_m", s.thin_skin_width_m);
    v("thin_skin_factor", s.thin_skin_factor);
    v("blend_placode_m", s.blend_placode_m);
    v("blend_skin_m", s.blend_skin_m);
    v("placode_layers_m", s.placode_layers_m);
    v("ring_layers_m", s.ring_layers_m);
    v("skin_layers_m", s.skin_layers_m);
    v("skin_prestretch", s.skin_prestretch);
    v("zone_prestretch", s.zone_prestretch);
    v("placode_prestretch", s.placode_prestretch);
    v("bed_normal_pa_m", s.bed_normal_pa_m);
    v("bed_tangent_pa_m", s.bed_tangent_pa_m);
    v("side_pa_m", s.side_pa_m);
    v("contour_offset_m", s.contour_offset_m);
    v("resect_from_deg", s.resect_from_deg);
    v("resect_to_deg", s.resect_to_deg);
    v("resect_margin_m", s.resect_margin_m);
    v("spare_vertices", s.spare_vertices);
    v("cut_snap", s.cut_snap);
    v("tear_radius_m", s.tear_radius_m);
    v("isotropic", s.isotropic);
    v("tethers", s.tethers);
    v("tether_break_n", s.tether_break_n);
    v("tether_compliance_m_n", s.tether_compliance_m_n);
}

sim::FieldSuture suture_from_json(const Json& json) {
    sim::FieldSuture out;
    const auto section = [&](const char* key, auto&& visit) {
        if (json.contains(key)) visit(Reader{json[key]});
    };
    visit_suture(section, Reader{json}, out);
    for (int i = 0; i < sim::kTissueCount && json.contains("strength"); ++i) {
        const std::string name(sim::tissue_name(static_cast<sim::Tissue>(i)));
        if (json["strength"].contains(name))
            visit_strength(Reader{json["strength"][name]},
                           out.suture.strength[static_cast<size_t>(i)]);
    }
    return out;
}

Json suture_to_json(const sim::FieldSuture& suture) {
    Json json;
    const auto section = [&](const char* key, auto&& visit) {
        json[key] = Json::object();
        visit(Writer{json[key]});
    };
    visit_suture(section, Writer{json}, suture);
    for (int i = 0; i < sim::kTissueCount; ++i) {
        const std::string name(sim::tissue_name(static_cast<sim::Tissue>(i)));
        visit_strength(Writer{json["strength"][name]},
                       suture.suture.strength[static_cast<size_t>(i)]);
    }
    return json;
}

sim::FieldSlit slit_from_json(const Json& json) {
    sim::FieldSlit out;
    visit_slit(Reader{json}, out);
    if (json.contains("watertight"))
        visit_watertight(Reader{json["watertight"]}, out.watertight.emplace());
    return out;
}

Json slit_to_json(const sim::FieldSlit& slit) {
    Json json;
    visit_slit(Writer{json}, slit);
    if (slit.watertight) {
        json["watertight"] = Json::object();
        visit_watertight(Writer{json["watertight"]}, *slit.watertight);
    }
    return json;
}

}  // namespace

OperativeFieldSpec scene_from_json(const Json& scene, const std::string& origin,
                                   const std::string& prefix) {
    OperativeFieldSpec spec;
    try {
        visit_field(Reader{scene}, spec);
        spec.materials = sim::default_materials();
        if (scene.contains("materials")) {
            for (int i = 0; i < sim::kTissueCount; ++i) {
                const std::string name(sim::tissue_name(static_cast<sim::Tissue>(i)));
                if (scene["materials"].contains(name))
                    visit_material(Reader{scene["materials"][name]},
                                   spec.materials[static_cast<size_t>(i)]);
            }
        }
        if (scene.contains("solver")) visit_solver(Reader{scene["solver"]}, spec.solver);
        if (scene.contains("sac")) visit_sac(Reader{scene["sac"]}, spec.sac);
        if (scene.contains("suture")) spec.suture = suture_from_json(scene["suture"]);
        if (scene.contains("slit")) spec.slit = slit_from_json(scene["slit"]);
        if (scene.contains("patch")) visit_patch(Reader{scene["patch"]}, spec.patch.emplace());
        if (scene.contains("irrigation"))
            visit_irrigation(Reader{scene["irrigation"]}, spec.irrigation.emplace());
        if (scene.contains("contact")) visit_contact(Reader{scene["contact"]}, spec.contact);
        spec.heat = scene.contains("heat") && scene["heat"].value("enabled", true);
        if (spec.heat) visit_heat(Reader{scene["heat"]}, spec.heat_settings);
        if (scene.contains("plane")) visit_plane(Reader{scene["plane"]}, spec.plane.emplace());
        for (const Json& tool : scene.value("tools", Json::array())) {
            visit_tool(Reader{tool}, spec.tools.emplace_back());
            ToolSpec& read = spec.tools.back();
            read.jaws_spread = tool.value("jaws_spread", false);
            read.look_from_m = tool.value("look_from_m", read.look_from_m);
        }
    } catch (const Json::exception& error) {
        // Only reachable when schema and code disagree.
        throw DefinitionError(origin, prefix, error.what());
    }
    return spec;
}

Json scene_to_json(const OperativeFieldSpec& spec) {
    Json scene;
    visit_field(Writer{scene}, spec);
    for (int i = 0; i < sim::kTissueCount; ++i) {
        const std::string name(sim::tissue_name(static_cast<sim::Tissue>(i)));
        visit_material(Writer{scene["materials"][name]}, spec.materials[static_cast<size_t>(i)]);
    }
    visit_solver(Writer{scene["solver"]}, spec.solver);
    visit_sac(Writer{scene["sac"]}, spec.sac);
    visit_contact(Writer{scene["contact"]}, spec.contact);
    if (spec.suture) scene["suture"] = suture_to_json(*spec.suture);
    if (spec.slit) scene["slit"] = slit_to_json(*spec.slit);
    if (spec.patch) {
        scene["patch"] = Json::object();
        visit_patch(Writer{scene["patch"]}, *spec.patch);
    }
    if (spec.irrigation) {
        scene["irrigation"] = Json::object();
        visit_irrigation(Writer{scene["irrigation"]}, *spec.irrigation);
    }
    if (spec.plane) {
        scene["plane"] = Json::object();
        visit_plane(Writer{scene["plane"]}, *spec.plane);
    }
    scene["heat"]["enabled"] = spec.heat;
    visit_heat(Writer{scene["heat"]}, spec.heat_settings);
    scene["tools"] = Json::array();
    for (const ToolSpec& tool : spec.tools) {
        Json& entry = scene["tools"].emplace_back(Json::object());
        visit_tool(Writer{entry}, tool);
        if (tool.jaws_spread) entry["jaws_spread"] = true;
        if (tool.look_from_m != ToolSpec{}.look_from_m) entry["look_from_m"] = tool.look_from_m;
    }
    return scene;
}

}  // namespace placode::curriculum
