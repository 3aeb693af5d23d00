// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/verification_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "curriculum/verification_place.h"

namespace placode::curriculum {
namespace {

namespace fs = std::filesystem;

uint8_t axes_of(const Place& place) {
    uint8_t axes = 0;
    const std::string text = place.text();
    for (const char c : text) {
        const auto bit = static_cast<uint8_t>(c == 'x'   ? sim::kAxisX
                                              : c == 'y' ? sim::kAxisY
                                              : c == 'z' ? sim::kAxisZ
                                                         : 0);
        if (bit == 0 || (axes & bit) != 0) place.expected("letters of \"xyz\", each at most once");
        axes |= bit;
    }
    if (axes == 0) place.expected("at least one letter of \"xyz\"");
    return axes;
}

void read_material(const Place& place, sim::VerificationScene& scene) {
    place.keys({"youngs_modulus_pa", "poissons_ratio", "density_kg_m3"});
    read_elastic(place, scene.material);
}

void read_fixed(const Place& list, sim::VerificationScene& scene) {
    list.each([&](const Place& place) {
        place.keys({"box_m", "axes"});
        sim::HeldRegion& region = scene.held.emplace_back();
        region.pointer = place.pointer();
        region.box = box_of(place.at("box_m"));
        if (place.has("axes")) region.axes = axes_of(place.at("axes"));
    });
}

/// Three numbers for x, y and z, or one for each of the one or two letters of `axes`, in its order.
Vec3 displacement_of(const Place& place, const std::string& axes, sim::VerificationScene& scene) {
    Vec3 out = Vec3::Zero();
    if (place.is_array() && place.size() == axes.size() && axes.size() < 3) {
        for (size_t i = 0; i < axes.size(); ++i) out[axes[i] - 'x'] = place.at(i).number(kAny);
        return out;
    }
    out = place.vector();
    for (int a = 0; a < 3; ++a) {
        if (axes.find("xyz"[a]) != std::string::npos || out[a] == 0) continue;
        scene.warnings.push_back(place.pointer() + ": the displacement along " + "xyz"[a] +
                                 " is left out, \"axes\" does not name it");
        out[a] = 0;
    }
    return out;
}

void read_prescribed(const Place& list, sim::VerificationScene& scene) {
    list.each([&](const Place& place) {
        place.keys({"box_m", "axes", "displacement_m", "ramp_s"});
        sim::HeldRegion& region = scene.held.emplace_back();
        region.pointer = place.pointer();
        region.box = box_of(place.at("box_m"));
        std::string axes = "xyz";
        if (place.has("axes")) {
            region.axes = axes_of(place.at("axes"));
            axes = place.at("axes").text();
        }
        region.displacement_m = displacement_of(place.at("displacement_m"), axes, scene);
        place.take("ramp_s", region.ramp_s, kNotNegative);
    });
}

void read_loads(const Place& list, sim::VerificationScene& scene) {
    list.each([&](const Place& place) {
        place.keys({"box_m", "total_force_n", "ramp_s"});
        sim::LoadRegion& region = scene.loads.emplace_back();
        region.pointer = place.pointer();
        region.box = box_of(place.at("box_m"));
        region.total_force_n = place.at("total_force_n").vector();
        place.take("ramp_s", region.ramp_s, kNotNegative);
    });
}

void read_contacts(const Place& list, sim::VerificationScene& scene) {
    list.each([&](const Place& place) {
        place.keys({"sphere", "velocity_m_s", "friction"});
        const Place sphere = place.at("sphere");
        sphere.keys({"centre_m", "radius_m"});
        sim::SphereObstacle& out = scene.spheres.emplace_back();
        out.centre_m = sphere.at("centre_m").vector(kPlace);
        out.radius_m = sphere.at("radius_m").number({0, kPlace.high, true, false});
        if (place.has("velocity_m_s")) out.velocity_m_s = place.at("velocity_m_s").vector(kPlace);
        place.take("friction", out.friction, {0, 10});
    });
}

void read_start(const Place& place, sim::VerificationScene& scene) {
    place.keys({"kind", "amount", "seed"});
    constexpr std::pair<const char*, sim::StartKind> kKinds[]{
        {"rest", sim::StartKind::kRest},   {"random", sim::StartKind::kRandom},
        {"flat", sim::StartKind::kFlat},   {"mirror", sim::StartKind::kMirror},
        {"point", sim::StartKind::kPoint}, {"stretch", sim::StartKind::kStretch}};
    const Place kind = place.at("kind");
    const std::string name = kind.text();
    const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                     [&](const auto& one) { return name == one.first; });
    if (found == std::end(kKinds))
        kind.expected("one of: rest, random, flat, mirror, point, stretch");
    scene.start.kind = found->second;
    const bool stretch = scene.start.kind == sim::StartKind::kStretch;
    if (stretch) scene.start.amount = 0.5;
    place.take("amount", scene.start.amount, stretch ? Range{-0.99, 100} : Range{0, 1});
    if (place.has("seed")) {
        scene.start.seed = static_cast<uint64_t>(place.at("seed").whole(0, int64_t{1} << 53));
    }
    const std::pair<const char*, bool> idle[]{
        {"amount", scene.start.kind == sim::StartKind::kRest},
        {"seed", scene.start.kind != sim::StartKind::kRandom}};
    for (const auto& [key, is_idle] : idle) {
        if (is_idle && place.has(key))
            scene.warnings.push_back(place.pointer() + "/" + key + ": has no effect with " + name);
    }
}

/// Keys that the method has no use for.
void warn_of_idle_keys(const Place& place, sim::VerificationScene& scene) {
    using sim::SolveMethod;
    const SolveMethod method = scene.solver.method;
    const bool is_double = method == SolveMethod::kExplicit || method == SolveMethod::kNewton;
    const std::pair<const char*, bool> idle[]{{"over_relaxation", method != SolveMethod::kVbd},
                                              {"iterations", is_double},
                                              {"single_precision", is_double}};
    for (const auto& [key, is_idle] : idle) {
        if (is_idle && place.has(key))
            scene.warnings.push_back(place.pointer() + "/" + key + ": has no effect with " +
                                     sim::method_name(method));
    }
}

void read_solver(const Place& place, sim::VerificationScene& scene) {
    place.keys({"method", "frame_s", "substeps", "iterations", "threads", "over_relaxation",
                "allow_invalid", "single_precision"});
    sim::VerificationSolver& s = scene.solver;
    if (place.has("method")) {
        const Place method = place.at("method");
        const std::string name = method.text();
        bool known = false;
        for (const auto m :
             {sim::SolveMethod::kXpbd, sim::SolveMethod::kXpbdPair, sim::SolveMethod::kVbd,
              sim::SolveMethod::kExplicit, sim::SolveMethod::kNewton}) {
            if (name != sim::method_name(m)) continue;
            s.method = m;
            known = true;
        }
        if (!known) method.expected("one of: xpbd, xpbd_pair, vbd, explicit, newton");
    }
    place.take("frame_s", s.frame_s, {0, 10, true, false});
    place.take("substeps", s.substeps, 1, 1000000);
    place.take("iterations", s.iterations, 1, 64);
    place.take("threads", s.threads, 1, 64);
    place.take("over_relaxation", s.over_relaxation, {0, 1.3, true, false});
    place.take("allow_invalid", s.allow_invalid);
    place.take("single_precision", s.single_precision);
    warn_of_idle_keys(place, scene);
}

void read_until(const Place& place, sim::VerificationScene& scene) {
    place.keys({"time_s", "rest"});
    if (place.has("time_s") == place.has("rest")) place.expected("either \"time_s\" or \"rest\"");
    if (place.has("time_s")) {
        scene.end_s = place.at("time_s").number({0, 1e6, true, false});
        return;
    }
    const Place rest = place.at("rest");
    rest.keys({"speed_m_s", "max_s"});
    scene.end_s = 20;
    double speed = 1e-5;
    rest.take("speed_m_s", speed, kPositive);
    rest.take("max_s", scene.end_s, {0, 1e6, true, false});
    scene.rest_speed_m_s = speed;
}

void read_probes(const Place& list, sim::VerificationScene& scene) {
    std::set<std::string> names;
    list.each([&](const Place& place) {
        place.keys({"name", "box_m"});
        const Place name = place.at("name");
        sim::Probe& probe = scene.probes.emplace_back();
        probe.name = name.text();
        probe.pointer = place.pointer();
        const bool plain = std::all_of(probe.name.begin(), probe.name.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '_' || c == '-';
        });
        if (!plain || probe.name.empty())
            name.expected("letters, digits, '_' and '-' (it becomes a column's name)");
        if (!names.insert(probe.name).second) name.expected("a name that no other probe has");
        probe.box = box_of(place.at("box_m"));
    });
}

/// Work that would never end is refused rather than begun.
void check_work(const Place& root, const sim::VerificationScene& scene) {
    if (scene.solver.method == sim::SolveMethod::kNewton) return;
    const double steps = scene.end_s / scene.solver.frame_s * scene.solver.substeps;
    const std::string text =
        sim::shortest_text(scene.end_s) + " s are " + sim::shortest_text(steps) + " substeps";
    const Place until = root.has("until") ? root.at("until") : root;
    if (steps > 1e9)
        until.fail(text +
                   "; expected at most 1e9: a shorter time, longer frames or fewer substeps");
    if (steps < 1e-6) until.fail(text + "; expected at least one: a longer time");
    if (scene.end_s / scene.sample_s > 1e7 && !scene.probes.empty())
        root.at("sample_s")
            .expected("at most 1e7 samples in " + sim::shortest_text(scene.end_s) + " s");
}

/// A time that is no whole number of substeps is cut into equal ones, a little shorter.
void end_on_a_substep(sim::VerificationScene& scene) {
    sim::VerificationSolver& s = scene.solver;
    if (scene.rest_speed_m_s || s.method == sim::SolveMethod::kNewton) return;
    const double count = scene.end_s / s.frame_s * s.substeps;
    const double whole = std::max(1.0, std::ceil(count - 1e-6));
    if (std::abs(count - whole) > 1e-6 * whole) s.frame_s = scene.end_s / whole * s.substeps;
}

}  // namespace

sim::BoxSelection box_of(const Place& place) {
    if (!place.is_array() || place.size() != 2)
        place.expected("two corners [[x0, y0, z0], [x1, y1, z1]]");
    sim::BoxSelection box{place.at(size_t{0}).vector(), place.at(size_t{1}).vector()};
    if ((box.low.array() > box.high.array()).any())
        place.expected("the corner with the smaller coordinates first");
    return box;
}

void read_elastic(const Place& place, sim::Material& material) {
    place.take("youngs_modulus_pa", material.youngs_modulus_pa, kAnyUnit);
    place.take("poissons_ratio", material.poissons_ratio, {-1, 0.5, true, true});
    place.take("density_kg_m3", material.density_kg_m3, kAnyUnit);
}

sim::VerificationScene verification_scene_from_json(const std::string& text,
                                                    const std::string& origin,
                                                    const std::string& folder) {
    const Json json = parse_json(text, origin);
    const Place root(json, "", origin);
    root.keys({"mesh", "material", "gravity_m_s2", "damping_per_s", "fixed", "prescribed", "loads",
               "sdf_contacts", "start", "solver", "until", "probes", "sample_s", "sheets",
               "sheet_bending"});
    sim::VerificationScene scene;
    scene.material.damping_per_s = 0;
    if (root.has("material")) read_material(root.at("material"), scene);
    if (root.has("gravity_m_s2")) scene.gravity_m_s2 = root.at("gravity_m_s2").vector(kPlace);
    root.take("damping_per_s", scene.material.damping_per_s, {0, 1e6});
    if (root.has("fixed")) read_fixed(root.at("fixed"), scene);
    if (root.has("prescribed")) read_prescribed(root.at("prescribed"), scene);
    if (root.has("loads")) read_loads(root.at("loads"), scene);
    if (root.has("sdf_contacts")) read_contacts(root.at("sdf_contacts"), scene);
    if (root.has("start")) read_start(root.at("start"), scene);
    if (root.has("solver")) read_solver(root.at("solver"), scene);
    if (root.has("until")) read_until(root.at("until"), scene);
    if (root.has("probes")) read_probes(root.at("probes"), scene);
    root.take("sample_s", scene.sample_s, kPositive);
    check_work(root, scene);
    end_on_a_substep(scene);
    read_mesh_and_sheets(root, folder, scene);  // last: everything else is checked without it
    return scene;
}

sim::VerificationScene load_verification_scene(const std::string& file) {
    return verification_scene_from_json(read_definition(file), file,
                                        fs::path(file).parent_path().string());
}

sim::SolveResult solve_verification_scene(const sim::VerificationScene& scene,
                                          const std::string& origin, const sim::SolveWatch& watch) {
    try {
        return sim::solve(scene, watch);
    } catch (const sim::VerificationError& error) {
        throw DefinitionError(origin, error.pointer(), error.what());
    } catch (const sim::MeshError& error) {
        throw DefinitionError(origin, "/mesh", error.what());
    }
}

}  // namespace placode::curriculum
