// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/solve_setup.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "sim/number_text.h"
#include "sim/surface.h"

namespace placode::sim {
namespace {

constexpr double kSelectTolerance = 1e-9;  // [m], by contract
constexpr int kQuietFrames = 10;

size_t at(int64_t i) { return static_cast<size_t>(i); }

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

/// Uniform in [0, 1), the same everywhere (splitmix64).
class Random {
 public:
    explicit Random(uint64_t seed) : state_(seed) {}
    double next() {
        uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
    }

 private:
    uint64_t state_;
};

}  // namespace

const char* method_name(SolveMethod method) noexcept {
    switch (method) {
        case SolveMethod::kXpbd:
            return "xpbd";
        case SolveMethod::kXpbdPair:
            return "xpbd_pair";
        case SolveMethod::kVbd:
            return "vbd";
        case SolveMethod::kExplicit:
            return "explicit";
        case SolveMethod::kNewton:
            return "newton";
    }
    return "?";
}

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
    make_loads();
    for (const Probe& probe : scene.probes)
        probe_vertices_.push_back(select(probe.box, probe.pointer));
    if (!scene.spheres.empty())
        contacts = std::make_unique<SphereContacts>(spec.mesh, scene.spheres, free_sheet());
    make_start();
}

std::vector<int32_t> SolveSetup::select(const BoxSelection& box, const std::string& pointer) const {
    std::vector<int32_t> out;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (size_t v = 0; v < scene.mesh.rest.size(); ++v) {
        const Vec3& p = scene.mesh.rest[v];
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        if (inside(box, p)) out.push_back(static_cast<int32_t>(v));
    }
    if (out.empty())
        throw VerificationError(pointer + "/box_m",
                                "[" + text_of(box.low) + ", " + text_of(box.high) +
                                    "] selects no vertex; the mesh reaches from " + text_of(low) +
                                    " to " + text_of(high) +
                                    " m; expected a box with at least one vertex in it");
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
                int32_t& by = held_by_[at(v)][at(a)];
                if (by >= 0) {
                    const HeldRegion& other = scene.held[at(by)];
                    if (other.displacement_m[a] != region.displacement_m[a]) ++taken;
                }
                by = static_cast<int32_t>(r);
                held[at(v)] |= static_cast<uint8_t>(1 << a);
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
        for (const int32_t v : chosen) is_chosen[at(v)] = 1;
        double area = 0;
        for (const auto& k : triangles) {
            if (!is_chosen[at(k[0])] || !is_chosen[at(k[1])] || !is_chosen[at(k[2])]) continue;
            const Vec3& x0 = scene.mesh.rest[at(k[0])];
            const double third =
                (scene.mesh.rest[at(k[1])] - x0).cross(scene.mesh.rest[at(k[2])] - x0).norm() / 6;
            area += 3 * third;
            for (const int32_t v : k) weight[at(v)] += third;
        }
        Load load{region.total_force_n, region.ramp_s, {}};
        for (const int32_t v : chosen) {
            const double share =
                area > 0 ? weight[at(v)] / area : 1.0 / static_cast<double>(chosen.size());
            if (share > 0) load.share.emplace_back(v, share);
        }
        loads_.push_back(std::move(load));
    }
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
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& p : scene.mesh.rest) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec3 middle = (low + high) / 2;
    Random random(s.seed);
    for (size_t v = 0; v < scene.mesh.rest.size(); ++v) {
        const Vec3& p = scene.mesh.rest[v];
        Vec3 x = p;
        if (s.kind == StartKind::kRandom) {
            for (int a = 0; a < 3; ++a)
                x[a] += s.amount * (low[a] + random.next() * (high[a] - low[a]) - p[a]);
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
    return scene.mesh.rest[at(vertex)][axis] + held_way(vertex, axis, time_s);
}

double SolveSetup::held_way(int vertex, int axis, double time_s) const {
    const HeldRegion& region = scene.held[at(held_by_[at(vertex)][at(axis)])];
    return ramp(time_s, region.ramp_s) * region.displacement_m[axis];
}

void SolveSetup::add_loads(double time_s, Coordinates& out) const {
    for (const Load& load : loads_) {
        const Vec3 total = ramp(time_s, load.ramp_s) * load.total;
        for (const auto& [v, share] : load.share) out.segment<3>(3 * v) += share * total;
    }
}

double SolveSetup::usual_stress() const {
    return scene.material.density_kg_m3 * usual_acceleration() * longest_way();
}

double SolveSetup::longest_way() const {
    double longest = 0;
    for (const Vec3& p : scene.mesh.rest)
        longest = std::max(longest, (p - scene.mesh.rest.front()).norm());
    return longest;
}

double SolveSetup::usual_acceleration() const {
    if (scene.held.empty()) return 0;
    const double extent = longest_way();
    double strain = scene.start.kind == StartKind::kRest ? 0 : 0.1;
    for (const HeldRegion& region : scene.held)
        strain = std::max(strain, region.displacement_m.norm() / extent);
    for (const SphereObstacle& s : scene.spheres)
        strain = std::max(strain, std::min(0.1, s.velocity_m_s.norm() * scene.end_s / extent));
    Vec3 load = Vec3::Zero();
    for (const LoadRegion& region : scene.loads) load += region.total_force_n;
    double mass = 0;
    for (const float m : body->mass_kg()) mass += m;
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

void SolveSetup::sample(double time_s, const Coordinates& x, SolveResult& out) const {
    out.sample_time_s.push_back(time_s);
    auto& row = out.probe_m.emplace_back();
    for (const auto& vertices : probe_vertices_) {
        Vec3 mean = Vec3::Zero();
        for (const int32_t v : vertices) mean += x.segment<3>(3 * v);
        row.push_back(mean / static_cast<double>(vertices.size()));
    }
}

void SolveSetup::finish(const Coordinates& x, const Coordinates& v, double time_s,
                        SolveResult& out) const {
    out.simulated_s = time_s;
    out.max_courant = max_courant;
    out.warnings.insert(out.warnings.begin(), warnings.begin(), warnings.end());
    out.final_m = scene.output_points;
    for (size_t p = 0; p < scene.output_points.size(); ++p) {
        const int32_t vertex = scene.vertex_of_output[p];
        if (vertex >= 0) out.final_m[p] = x.segment<3>(3 * vertex);
    }
    for (int i = 0; i < body->vertex_count(); ++i) {
        out.not_finite +=
            x.segment<3>(3 * i).allFinite() && v.segment<3>(3 * i).allFinite() ? 0 : 1;
        out.kinetic_energy_j += 0.5 * body->mass_kg()[at(i)] * v.segment<3>(3 * i).squaredNorm();
    }
    double mass = 0;
    Vec3 centre = Vec3::Zero();
    for (int i = 0; i < body->vertex_count(); ++i) {
        mass += body->mass_kg()[at(i)];
        centre += body->mass_kg()[at(i)] * x.segment<3>(3 * i);
    }
    centre /= mass;
    for (int i = 0; i < body->vertex_count(); ++i) {
        const Vec3 p = body->mass_kg()[at(i)] * v.segment<3>(3 * i);
        const Vec3 arm = Vec3(x.segment<3>(3 * i)) - centre;
        out.momentum_kg_m_s += p;
        out.momentum_scale_kg_m_s += p.norm();
        out.angular_momentum_kg_m2_s += arm.cross(p);
        out.angular_momentum_scale_kg_m2_s += arm.norm() * p.norm();
    }
    out.elastic_energy_j = body->energy(x);
    out.inverted_tets = body->inverted_tets(x);
    if (out.inverted_tets > 0)
        out.warnings.push_back(std::to_string(out.inverted_tets) +
                               " tets are inverted at the end: no tissue can be in that state");

    // A support gives what elastic forces, gravity and loads leave over in its coordinates.
    Coordinates support = Coordinates::Zero(x.size());
    body->add_gradient(x, support);
    Coordinates outer = Coordinates::Zero(x.size());
    add_loads(time_s, outer);
    for (int i = 0; i < body->vertex_count(); ++i)
        outer.segment<3>(3 * i) += body->mass_kg()[at(i)] * scene.gravity_m_s2;
    support -= outer;
    bool any_fixed = false;
    for (const HeldRegion& region : scene.held) {
        out.reactions.push_back({region.pointer, Vec3::Zero()});
        any_fixed = any_fixed || region.pointer.rfind("/fixed", 0) == 0;
    }
    for (size_t i = 0; i < held.size(); ++i) {
        for (size_t a = 0; a < 3; ++a) {
            const int32_t by = held_by_[i][a];
            if (by < 0) continue;
            const double f = support[static_cast<Eigen::Index>(3 * i + a)];
            out.reactions[at(by)].force_n[static_cast<Eigen::Index>(a)] += f;
            const bool fixed = scene.held[at(by)].pointer.rfind("/fixed", 0) == 0;
            if (fixed || !any_fixed) out.reaction_n[static_cast<Eigen::Index>(a)] += f;
        }
    }
    for (const RegionForce& f : out.contact_forces) out.contact_force_n += f.force_n;
}

bool RestWatch::frame(double time_s, const Coordinates& x) {
    const auto& limit = setup_.scene.rest_speed_m_s;
    if (!limit || time_s < setup_.longest_ramp_s()) return false;
    double farthest = before_.size() > 0 ? 0 : std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < before_.size(); i += 3)
        farthest = std::max(farthest, (x.segment<3>(i) - before_.segment<3>(i)).norm());
    before_ = x;
    for (const SphereObstacle& s : setup_.scene.spheres) {
        if (s.velocity_m_s.norm() > 0) return false;
    }
    quiet_ = farthest < *limit * setup_.scene.solver.frame_s ? quiet_ + 1 : 0;
    return quiet_ >= kQuietFrames;
}

SolveResult solve(const VerificationScene& scene, const SolveWatch& watch) {
    const SolveMethod method = scene.solver.method;
    if (!scene.sheet.empty() && (method == SolveMethod::kXpbd || method == SolveMethod::kXpbdPair))
        throw VerificationError("/solver/method",
                                std::string("found ") + method_name(method) +
                                    ", which knows tetrahedra only, and " +
                                    std::to_string(scene.sheet.size()) +
                                    " triangles of sheets; expected vbd, explicit or newton");
    if (method == SolveMethod::kVbd && scene.material.poissons_ratio > kVbdMaxPoissonsRatio &&
        !scene.mesh.tets.empty())
        throw VerificationError("/material/poissons_ratio",
                                "found " + shortest_text(scene.material.poissons_ratio) +
                                    "; expected at most " + shortest_text(kVbdMaxPoissonsRatio) +
                                    " for vbd, which would tremble, or method explicit or newton");
    SolveSetup setup(scene, watch);
    SoftBodySpec spec = setup.spec;
    spec.solver.frame_s = scene.solver.frame_s / scene.solver.substeps;
    spec.solver.substeps = 1;
    const SoftBody body(std::move(spec));
    const auto courant = body.courant_numbers();
    setup.max_courant = *std::max_element(courant.begin(), courant.end());
    SolveResult out;
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    switch (scene.solver.method) {
        case SolveMethod::kExplicit:
            run_explicit(setup, out);
            break;
        case SolveMethod::kNewton:
            run_newton(setup, out);
            break;
        default:
            run_fast(setup, out);
    }
    out.cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    out.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

}  // namespace placode::sim
