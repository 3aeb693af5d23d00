// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/solve_setup.h"

#include <algorithm>
#include <array>

#include "sim/core/as_index.h"
#include "sim/core/bounds.h"
#include "sim/core/number_text.h"
#include "sim/core/random.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

constexpr double kSelectTolerance = 1e-9;  // [m], by contract

std::string text_of(const Vec3& p) {
    return "[" + rounded_text(p.x(), 6) + ", " + rounded_text(p.y(), 6) + ", " +
           rounded_text(p.z(), 6) + "]";
}

bool inside(const BoxSelection& box, const Vec3& p) {
    for (int a = 0; a < 3; ++a) {
        if (!(p[a] >= box.low[a] - kSelectTolerance && p[a] <= box.high[a] + kSelectTolerance))
            return false;
    }
    return true;
}

double ramp(double time_s, double ramp_s) {
    return ramp_s > 0 ? std::clamp(time_s / ramp_s, 0.0, 1.0) : 1.0;
}

/// In one of the tets at rest, or on a face between them.
bool is_inside(const TetMesh& mesh, const Vec3& p) {
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        std::array<Vec3, 4> to;
        for (size_t k = 0; k < 4; ++k) to[k] = mesh.rest[as_index(mesh.tets[t][k])] - p;
        const double least =
            std::min({to[1].dot(to[2].cross(to[3])), to[0].dot(to[3].cross(to[2])),
                      to[0].dot(to[1].cross(to[3])), to[0].dot(to[2].cross(to[1]))});
        if (least >= -1e-9 * 6 * rest_volume(mesh, static_cast<int>(t))) return true;
    }
    return false;
}

}  // namespace

SolveSetup::SolveSetup(const VerificationScene& source, SolveWatch watch)
    : scene(source), watch_(std::move(watch)) {
    warnings = scene.warnings;
    spec.mesh = scene.mesh;
    spec.materials.fill(scene.material);
    for (size_t k = 0; k < scene.sheet_materials.size(); ++k)
        spec.materials[static_cast<size_t>(sheet_tissue(k))] = scene.sheet_materials[k];
    spec.sheet = scene.sheet;
    spec.sheet_bending = scene.sheet_bending;
    spec.solver.gravity_m_s2 = scene.gravity_m_s2;
    body = std::make_unique<ReferenceBody>(spec);
    hold();
    pieces = pieces_of(scene, held);
    make_loads();
    for (const Probe& probe : scene.probes)
        probe_vertices_.push_back(select(probe.box, probe.pointer));
    if (!scene.spheres.empty())
        contacts = std::make_unique<SphereContacts>(spec.mesh, scene.spheres, free_sheet());
    check_spheres();
    make_start();
}

void SolveSetup::check_spheres() {
    for (size_t s = 0; s < scene.spheres.size(); ++s) {
        const SphereObstacle& sphere = scene.spheres[s];
        const std::string pointer = "/sdf_contacts/" + std::to_string(s);
        int within = 0;
        for (size_t v = 0; v < held.size(); ++v) {
            const Vec3 offset = scene.mesh.rest[v] - sphere.centre_m;
            within += held[v] == 7 && offset.norm() < 0.999 * sphere.radius_m ? 1 : 0;
        }
        if (within > 0)
            warnings.push_back(pointer + ": " + std::to_string(within) +
                               " held vertices begin inside it and cannot give way: its force "
                               "has no meaning; expected a sphere that clears them");
        if (is_inside(scene.mesh, sphere.centre_m))
            warnings.push_back(pointer +
                               ": the centre begins inside the tissue, whose faces are touched "
                               "from outside only: those turned away from it let it through; "
                               "expected a centre outside");
    }
}

std::vector<int32_t> SolveSetup::select(const BoxSelection& box, const std::string& pointer) const {
    std::vector<int32_t> out;
    for (size_t v = 0; v < scene.mesh.rest.size(); ++v) {
        if (inside(box, scene.mesh.rest[v])) out.push_back(static_cast<int32_t>(v));
    }
    if (out.empty()) {
        const Eigen::AlignedBox3d mesh = bounds_of(scene.mesh.rest);
        throw VerificationError(pointer + "/box_m",
                                "[" + text_of(box.low) + ", " + text_of(box.high) +
                                    "] selects no vertex; the mesh reaches from " +
                                    text_of(mesh.min()) + " to " + text_of(mesh.max()) +
                                    " m; expected a box with at least one vertex in it");
    }
    return out;
}

void SolveSetup::hold() {
    const size_t n = scene.mesh.rest.size();
    held.assign(n, 0);
    held_by_.assign(n, {-1, -1, -1});
    for (size_t r = 0; r < scene.held.size(); ++r) {
        const HeldRegion& region = scene.held[r];
        int taken = 0;
        for (const int32_t v : select(region.box, region.pointer)) {
            for (int a = 0; a < 3; ++a) {
                if ((region.axes >> a & 1) == 0) continue;
                int32_t& by = held_by_[as_index(v)][as_index(a)];
                if (by >= 0) {
                    const HeldRegion& other = scene.held[as_index(by)];
                    if (other.displacement_m[a] != region.displacement_m[a]) ++taken;
                }
                by = static_cast<int32_t>(r);
                held[as_index(v)] |= static_cast<uint8_t>(1 << a);
            }
        }
        if (taken > 0)
            warnings.push_back(region.pointer + ": takes " + std::to_string(taken) +
                               " coordinates over that an earlier region holds elsewhere");
    }
    size_t whole = 0;
    for (size_t v = 0; v < n; ++v) {
        whole += held[v] == 7 ? 1 : 0;
        if (held[v] != 0 && held[v] != 7) partly_.push_back(static_cast<int32_t>(v));
    }
    if (whole == n)
        throw VerificationError("/fixed", "holds all " + std::to_string(n) +
                                              " vertices; expected at least one that can move");
}

void SolveSetup::make_loads() {
    if (scene.loads.empty()) return;
    std::vector<std::array<int32_t, 3>> triangles = free_sheet();
    const Surface surface(spec.mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) triangles.push_back(t.vertex);
    for (const LoadRegion& region : scene.loads) {
        const std::vector<int32_t> chosen = select(region.box, region.pointer);
        std::vector<double> weight(scene.mesh.rest.size(), 0.0);
        std::vector<uint8_t> is_chosen(weight.size(), 0);
        for (const int32_t v : chosen) is_chosen[as_index(v)] = 1;
        double area = 0;
        for (const auto& k : triangles) {
            if (!is_chosen[as_index(k[0])] || !is_chosen[as_index(k[1])] ||
                !is_chosen[as_index(k[2])])
                continue;
            const Vec3& x0 = scene.mesh.rest[as_index(k[0])];
            const double third = (scene.mesh.rest[as_index(k[1])] - x0)
                                     .cross(scene.mesh.rest[as_index(k[2])] - x0)
                                     .norm() /
                                 6;
            area += 3 * third;
            for (const int32_t v : k) weight[as_index(v)] += third;
        }
        Load load{region.total_force_n, region.ramp_s, {}};
        for (const int32_t v : chosen) {
            const double share =
                area > 0 ? weight[as_index(v)] / area : 1.0 / static_cast<double>(chosen.size());
            if (share > 0) load.share.emplace_back(v, share);
        }
        check_effect(region, load);
        loads_.push_back(std::move(load));
    }
}

/// A load that meets nothing but held coordinates moves nothing.
void SolveSetup::check_effect(const LoadRegion& region, const Load& load) {
    bool acts = false, moves = false;
    for (int a = 0; a < 3; ++a) {
        if (load.total[a] == 0) continue;
        acts = true;
        for (const auto& [v, share] : load.share)
            moves = moves || (held[as_index(v)] >> a & 1) == 0;
    }
    if (acts && !moves)
        warnings.push_back(
            region.pointer +
            ": acts on held coordinates only: it moves nothing, the supports take it");
}

std::vector<std::array<int32_t, 3>> SolveSetup::free_sheet() const {
    const auto key = [](std::array<int32_t, 3> v) {
        std::sort(v.begin(), v.end());
        return v;
    };
    std::vector<std::array<int32_t, 3>> faces, out;
    if (spec.sheet.empty()) return out;
    const Surface surface(spec.mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) faces.push_back(key(t.vertex));
    std::sort(faces.begin(), faces.end());
    for (const SheetTriangle& t : spec.sheet) {
        if (!std::binary_search(faces.begin(), faces.end(), key(t.vertex))) out.push_back(t.vertex);
    }
    return out;
}

void SolveSetup::make_start() {
    start = body->rest();
    const StartShape& s = scene.start;
    if (s.kind == StartKind::kRest) return;
    const Eigen::AlignedBox3d box = bounds_of(scene.mesh.rest);
    const Vec3 low = box.min(), high = box.max(), middle = (low + high) / 2;
    SplitMix64 random(s.seed);
    for (size_t v = 0; v < scene.mesh.rest.size(); ++v) {
        const Vec3& p = scene.mesh.rest[v];
        Vec3 x = p;
        if (s.kind == StartKind::kRandom) {
            for (int a = 0; a < 3; ++a)
                x[a] += s.amount * (low[a] + random.uniform() * (high[a] - low[a]) - p[a]);
        } else if (s.kind == StartKind::kFlat) {
            x.z() += s.amount * (middle.z() - p.z());
        } else if (s.kind == StartKind::kMirror) {
            x.x() += s.amount * 2 * (middle.x() - p.x());
        } else if (s.kind == StartKind::kPoint) {
            x += s.amount * (middle - p);
        } else {
            x.x() += s.amount * (p.x() - low.x());
        }
        for (int a = 0; a < 3; ++a) {
            if ((held[v] >> a & 1) == 0) start[3 * static_cast<int>(v) + a] = x[a];
        }
    }
}

void SolveSetup::report_time(double time_s) const {
    report([&] {
        return "t = " + rounded_text(time_s, 4) + " s of " +
               (scene.rest_speed_m_s ? "at most " : "") + rounded_text(scene.end_s, 4) + " s";
    });
}

double SolveSetup::held_at(int vertex, int axis, double time_s) const {
    return scene.mesh.rest[as_index(vertex)][axis] + held_displacement(vertex, axis, time_s);
}

double SolveSetup::held_displacement(int vertex, int axis, double time_s) const {
    const HeldRegion& region = scene.held[as_index(held_by_[as_index(vertex)][as_index(axis)])];
    return ramp(time_s, region.ramp_s) * region.displacement_m[axis];
}

void SolveSetup::add_loads(double time_s, Coordinates& out) const {
    for (const Load& load : loads_) {
        const Vec3 total = ramp(time_s, load.ramp_s) * load.total;
        for (const auto& [v, share] : load.share) out.segment<3>(3 * v) += share * total;
    }
}

double SolveSetup::usual_stress() const {
    return scene.material.density_kg_m3 * usual_acceleration() * extent_m();
}

double SolveSetup::extent_m() const {
    double longest = 0;
    for (const Vec3& p : scene.mesh.rest)
        longest = std::max(longest, (p - scene.mesh.rest.front()).norm());
    return longest;
}

double SolveSetup::usual_acceleration() const {
    if (scene.held.empty()) return 0;
    const double extent = extent_m();
    double strain = scene.start.kind == StartKind::kRest ? 0 : 0.1;
    for (const HeldRegion& region : scene.held)
        strain = std::max(strain, region.displacement_m.norm() / extent);
    for (const SphereObstacle& s : scene.spheres)
        strain = std::max(strain, std::min(0.1, s.velocity_m_s.norm() * scene.end_s / extent));
    Vec3 load = Vec3::Zero();
    for (const LoadRegion& region : scene.loads) load += region.total_force_n;
    double mass = 0;
    for (const double m : body->mass_kg()) mass += m;
    const Material& m = scene.material;
    return std::max({scene.gravity_m_s2.norm(), load.norm() / mass,
                     strain * m.youngs_modulus_pa / (m.density_kg_m3 * extent)});
}

double SolveSetup::longest_ramp_s() const {
    double longest = 0;
    for (const HeldRegion& r : scene.held) longest = std::max(longest, r.ramp_s);
    for (const LoadRegion& r : scene.loads) longest = std::max(longest, r.ramp_s);
    return longest;
}

}  // namespace placode::sim
