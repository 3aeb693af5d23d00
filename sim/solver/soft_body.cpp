// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/soft_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "sim/core/number_text.h"
#include "sim/solver/courant.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

void require(bool ok, const std::string& message) {
    if (!ok) throw MeshError(message);
}

void check_solver(const SolverSettings& s) {
    require(s.frame_s > 0 && std::isfinite(s.frame_s),
            "solver: frame " + rounded_text(s.frame_s, 4) + " s, must be above 0");
    require(s.substeps >= 1 && s.substeps <= 64,
            "solver: " + std::to_string(s.substeps) + " substeps, allowed 1 to 64");
    require(s.iterations >= 1 && s.iterations <= 64,
            "solver: " + std::to_string(s.iterations) + " iterations, allowed 1 to 64");
    require(s.over_relaxation > 0 && s.over_relaxation <= 1.3,
            "solver: over-relaxation " + rounded_text(s.over_relaxation, 4) +
                ", allowed above 0 to 1.3 (1.6 explodes)");
    require(s.gravity_m_s2.allFinite(), "solver: gravity is not finite");
}

void check_material(const Material& m, const std::string& name) {
    require(m.youngs_modulus_pa > 0, name + ": Young's modulus " +
                                         rounded_text(m.youngs_modulus_pa, 4) +
                                         " Pa, must be above 0");
    require(
        m.poissons_ratio > -1 && m.poissons_ratio < 0.5,
        name + ": Poisson's ratio " + rounded_text(m.poissons_ratio, 4) + ", allowed -1 to 0.5");
    require(m.density_kg_m3 > 0,
            name + ": density " + rounded_text(m.density_kg_m3, 4) + " kg/m^3, must be above 0");
    require(m.damping_per_s >= 0,
            name + ": damping " + rounded_text(m.damping_per_s, 4) + " 1/s, must not be negative");
}

void check_attachments(const SoftBodySpec& spec) {
    const auto vertices = static_cast<int32_t>(spec.mesh.rest.size());
    const auto check = [&](int32_t v, const char* what) {
        require(v >= 0 && v < vertices, std::string(what) + ": vertex " + std::to_string(v) +
                                            " is outside 0 .. " + std::to_string(vertices - 1));
    };
    for (const int32_t v : spec.fixed) check(v, "fixed");
    for (const AnchorSpring& s : spec.springs) {
        check(s.vertex, "spring");
        require(
            s.normal_n_m >= 0 && s.tangent_n_m >= 0 && s.normal.norm() > 0 && s.anchor.allFinite(),
            "spring at vertex " + std::to_string(s.vertex) +
                ": stiffness must not be negative, normal must not be zero");
    }
    for (const Tether& t : spec.tethers) {
        for (const int32_t v : t.vertex) check(v, "tether");
        require(t.vertex[0] != t.vertex[1], "tether: both ends at one vertex");
        require(t.compliance_m_n > 0 && t.rest_m >= 0 && t.break_n > 0,
                "tether: compliance and breaking force must be above 0, rest length not negative");
    }
    const size_t tets = spec.mesh.tets.size();
    require(spec.rest_scale.empty() || spec.rest_scale.size() == tets,
            "rest_scale: one entry for each tet, or none");
    require(spec.stiffness_percent.empty() || spec.stiffness_percent.size() == tets,
            "stiffness_percent: one entry for each tet, or none");
    require(spec.rest_normal.empty() || spec.rest_normal.size() == spec.rest_scale.size(),
            "rest_normal: one entry for each of rest_scale, or none");
    for (const Vec3f& n : spec.rest_normal) {
        require(std::abs(n.norm() - 1) < 1e-5F, "rest_normal: must be unit vectors");
    }
    for (const auto& s : spec.rest_scale) {
        require(s[0] > 0.1F && s[0] < 10.0F && s[1] > 0.1F && s[1] < 10.0F,
                "rest_scale: allowed 0.1 to 10");
    }
    for (const uint8_t p : spec.stiffness_percent) {
        require(p > 0, "stiffness_percent: must be above 0");
    }
}

const char* method_name(Method m) {
    return m == Method::kVbd ? "vbd" : m == Method::kXpbd ? "xpbd" : "xpbd pair";
}

double limit_of(Method m) {
    return m == Method::kVbd    ? std::numeric_limits<double>::infinity()
           : m == Method::kXpbd ? kXpbdMaxCourant
                                : kXpbdPairMaxCourant;
}

void check_spec(const SoftBodySpec& spec) {
    check_sheet(spec.mesh.rest, spec.sheet);
    check_mesh(spec.mesh, sheet_vertices(spec));
    check_solver(spec.solver);
    for (const Tissue tissue : spec.mesh.tissue) {
        check_material(spec.materials[static_cast<size_t>(tissue)],
                       std::string(tissue_name(tissue)));
    }
    for (const SheetTriangle& t : spec.sheet) {
        check_material(material_of(spec, t), spec.sheet_material
                                                 ? std::string("sheet")
                                                 : std::string(tissue_name(t.tissue)));
    }
    require(spec.sheet_bending >= 0 && spec.sheet_bending <= 1,
            "sheet: bending " + rounded_text(spec.sheet_bending, 4) + ", allowed 0 to 1");
    check_attachments(spec);
}

/// Of every vertex: its share of the mass around it [kg], and the shortest edge that it has [m].
struct Lumped {
    std::vector<double> mass, shortest;

    explicit Lumped(size_t vertices)
        : mass(vertices, 0.0), shortest(vertices, std::numeric_limits<double>::infinity()) {}

    void add_tet(const SoftBodySpec& spec, size_t t, double volume) {
        const TetMesh& mesh = spec.mesh;
        const double density = spec.materials[static_cast<size_t>(mesh.tissue[t])].density_kg_m3;
        for (const int32_t v : mesh.tets[t]) {
            const auto i = static_cast<size_t>(v);
            mass[i] += volume * density / 4;
            for (const int32_t other : mesh.tets[t]) {
                if (other == v) continue;
                const double edge = (mesh.rest[i] - mesh.rest[static_cast<size_t>(other)]).norm();
                shortest[i] = std::min(shortest[i], edge);
            }
        }
    }

    void add_triangle(const SoftBodySpec& spec, const SheetTriangle& t) {
        const double area = area_of(spec.mesh.rest, t);
        const double density = material_of(spec, t).density_kg_m3;
        for (size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<size_t>(t.vertex[k]);
            const auto b = static_cast<size_t>(t.vertex[(k + 1) % 3]);
            const double edge = (spec.mesh.rest[a] - spec.mesh.rest[b]).norm();
            mass[a] += area * t.thickness_m * density / 3;
            shortest[a] = std::min(shortest[a], edge);
            shortest[b] = std::min(shortest[b], edge);
        }
    }
};

/// The tets of every vertex, those of vertex v from start[v] to start[v + 1].
void index_tets(const TetMesh& mesh, std::vector<int32_t>& start, std::vector<int32_t>& tets_of) {
    const size_t vertices = mesh.rest.size(), tets = mesh.tets.size();
    start.assign(vertices + 1, 0);
    for (const auto& tet : mesh.tets) {
        for (const int32_t v : tet) ++start[static_cast<size_t>(v) + 1];
    }
    for (size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
    tets_of.resize(4 * tets);
    std::vector<int32_t> fill(start.begin(), start.end() - 1);
    for (size_t t = 0; t < tets; ++t) {
        for (const int32_t v : mesh.tets[t]) {
            tets_of[static_cast<size_t>(fill[static_cast<size_t>(v)]++)] = static_cast<int32_t>(t);
        }
    }
}

}  // namespace

SoftBody::SoftBody(SoftBodySpec spec) : spec_(std::move(spec)) {
    check_spec(spec_);
    Lumped lumped(spec_.mesh.rest.size());
    const size_t tets = spec_.mesh.tets.size();
    volume_m3_.reserve(tets);
    for (size_t t = 0; t < tets; ++t) {
        const double volume = rest_volume(spec_.mesh, static_cast<int>(t));
        volume_m3_.push_back(static_cast<float>(volume));
        lumped.add_tet(spec_, t, volume);
    }
    for (const SheetTriangle& t : spec_.sheet) lumped.add_triangle(spec_, t);
    mass_kg_.assign(lumped.mass.begin(), lumped.mass.end());
    shortest_edge_m_.assign(lumped.shortest.begin(), lumped.shortest.end());
    index_tets(spec_.mesh, vertex_tets_start_, vertex_tets_);
    check_method();
    if (spec_.solver.method != Method::kVbd) {
        const auto courant = courant_numbers();
        turns_ = *std::max_element(courant.begin(), courant.end()) <= kXpbdTurnCourant;
    }
    spec_.mesh.rest.shrink_to_fit();
    spec_.mesh.tets.shrink_to_fit();
    spec_.mesh.tissue.shrink_to_fit();
    packed_ = std::make_unique<KernelLayout>(pack(*this));
    static_cast<void>(kernel_target());  // chooses the instruction set before any worker runs
}

SoftBody::~SoftBody() = default;
SoftBody::SoftBody(SoftBody&&) noexcept = default;
SoftBody& SoftBody::operator=(SoftBody&&) noexcept = default;

void SoftBody::check_method() const {
    const SolverSettings& s = spec_.solver;
    if (s.method != Method::kVbd && !spec_.sheet.empty()) {
        throw MeshError("sheet: " + std::to_string(spec_.sheet.size()) + " triangles, but method " +
                        method_name(s.method) + " knows tetrahedra only; use vbd");
    }
    if (s.method == Method::kVbd && !s.allow_invalid) {
        for (const Tissue tissue : spec_.mesh.tissue) {  // a sheet is free to thin: any nu
            const double nu = spec_.materials[static_cast<size_t>(tissue)].poissons_ratio;
            if (nu <= kVbdMaxPoissonsRatio) continue;
            throw MeshError(std::string(tissue_name(tissue)) + ": poissons_ratio " +
                            rounded_text(nu, 4) + " is above " +
                            rounded_text(kVbdMaxPoissonsRatio, 4) +
                            ", the limit of vbd (it would tremble); lower it");
        }
    }
    const double limit = limit_of(s.method);
    const auto courant = courant_numbers();
    const auto worst = std::max_element(courant.begin(), courant.end());
    if (*worst <= limit || s.allow_invalid) return;
    const auto tissue = static_cast<Tissue>(worst - courant.begin());
    const double needed = std::ceil(s.substeps * *worst / limit);
    throw MeshError(std::string(tissue_name(tissue)) + ": Courant number " +
                    rounded_text(*worst, 4) + " is above " + rounded_text(limit, 4) +
                    ", the limit of " + method_name(s.method) + "; use vbd" +
                    (needed <= 64 ? ", or at least " + rounded_text(needed, 4) + " substeps a frame"
                                  : "; no allowed number of substeps (64) would do"));
}

std::array<double, kTissueCount> SoftBody::courant_numbers() const {
    return sim::courant_numbers(spec_);
}

std::vector<std::string> SoftBody::notes() const {
    std::vector<std::string> out;
    const SolverSettings& s = spec_.solver;
    const auto courant = courant_numbers();
    for (size_t i = 0; i < courant.size(); ++i) {
        if (courant[i] <= 0) continue;
        std::string verdict = "valid";
        if (courant[i] > limit_of(s.method)) {
            verdict = "NOT VALID (limit " + rounded_text(limit_of(s.method), 4) + ")";
        } else if (s.method != Method::kVbd && courant[i] > kXpbdGoodCourant) {
            verdict = "inexact, up to about 5 % too soft (good up to " +
                      rounded_text(kXpbdGoodCourant, 4) + ")";
        }
        out.push_back(std::string(tissue_name(static_cast<Tissue>(i))) + ": Courant number " +
                      rounded_text(courant[i], 4) + ", " + method_name(s.method) + ": " + verdict);
    }
    out.push_back("kernels: " + std::string(kernel_target()) + ", " +
                  std::to_string(packed_->job_start.size() - 1) + " vertex jobs in " +
                  std::to_string(packed_->phase_start.size() - 1) + " phases" +
                  (packed_->tet_phase_start.empty()
                       ? ""
                       : ", " + std::to_string(packed_->tet_job_start.size() - 1) +
                             " tet jobs in " + std::to_string(packed_->tet_phase_start.size() - 1) +
                             " phases"));
    return out;
}

}  // namespace placode::sim
