// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The deformable tissue: one Neo-Hookean energy, solved by XPBD (coupled 2x2 block of the
// deviatoric and hydrostatic constraint) or by vertex block descent (exact 3x3 Hessian).
// `SoftBody` never changes during an attempt, `SoftBodyState` does. Hot data is flat arrays.
//
// Sources: Macklin & Mueller 2021 (energy, XPBD), Macklin et al. 2019 "Small Steps" (substeps),
// Chen et al. 2024 "Vertex Block Descent". What was measured: docs/solver.md and docs/measurements.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/aligned_vector.h"
#include "sim/core/fields.h"
#include "sim/core/float4.h"
#include "sim/core/workers.h"
#include "sim/mesh/mesh.h"
#include "sim/solver/sheet.h"

namespace placode::sim {

enum class Method : uint8_t { kXpbd, kXpbdPair, kVbd };

/// How time is stepped. One frame = `substeps` substeps of `iterations` sweeps each.
struct SolverSettings {
    Method method = Method::kVbd;
    double frame_s = 1e-3;         ///< Frame [s].
    int substeps = 4;              ///< 1 to 64.
    int iterations = 1;            ///< Sweeps a substep, 1 to 64.
    double over_relaxation = 1.2;  ///< VBD only; 1.3 is the edge of stability.
    Vec3 gravity_m_s2 = Vec3(0, 0, -9.81);
    /// Let tissue sleep that is at rest and away from instruments (sleep.h).
    bool sleep = true;
    /// Verification and benchmarks only: build even where the method is not valid (notes() says
    /// so).
    bool allow_invalid = false;
};

/// XPBD is refused above these Courant numbers, see `SoftBody::SoftBody`.
inline constexpr double kXpbdMaxCourant = 1.1, kXpbdPairMaxCourant = 0.7;
/// VBD is refused above this Poisson's ratio: one sweep a substep trembles (0.495 is quiet, 0.499
/// is not, at Courant numbers of 1 to 7).
inline constexpr double kVbdMaxPoissonsRatio = 0.495;
/// Above this XPBD is announced as inexact.
inline constexpr double kXpbdGoodCourant = 0.7;
/// Up to this Courant number XPBD sweeps there and back in turns. A tet meets its neighbours where
/// those that came before it have left them; with the order turned round the other ones come
/// before, so that the two errors cancel (homogeneous states at Co 0.14: 0.2 % -> 0.01 %). The
/// price is a tremble from sweep to sweep, which grows with Co^4: from about 0.5 on the beam of
/// nu 0.45 is less exact with it, and at 1.1 it is 6.7 % off instead of 1.9.
inline constexpr double kXpbdTurnCourant = 0.45;

/// Linear spring from a vertex to its anchor, with its own stiffness along and across `normal`.
/// Without any stiffness it holds nothing and only makes room for a load
/// (`SoftBodyState::springs`).
struct AnchorSpring {
    int32_t vertex = 0;
    Vec3 anchor = Vec3::Zero();  ///< [m]
    Vec3 normal = Vec3::UnitZ();
    double normal_n_m = 0;   ///< [N/m]
    double tangent_n_m = 0;  ///< [N/m]
};

/// Breakable one-sided distance constraint (tether): pulls when longer than `rest_m`.
struct Tether {
    std::array<int32_t, 2> vertex{};
    double rest_m = 0;
    double compliance_m_n = 1e-2;  ///< [m/N]
    double break_n = 0.020;        ///< Lagrange multiplier force at which it breaks [N].
};

/// Everything `SoftBody` is built from.
struct SoftBodySpec {
    TetMesh mesh;  ///< Stress-free shape unless `rest_scale` says otherwise.
    MaterialTable materials;
    SolverSettings solver;
    std::vector<int32_t> fixed;  ///< Vertices held in place.
    std::vector<AnchorSpring> springs;
    std::vector<Tether> tethers;
    std::vector<std::array<float, 2>>
        rest_scale;  ///< (T) in-plane (world x and y), normal (world z) scale of the rest shape;
                     ///< below 1 = the tissue is drawn tight; empty = 1. Mass is not scaled.
    std::vector<Vec3f> rest_normal;  ///< (T) Unit normal for `rest_scale` instead of world z; or
                                     ///< empty.
    std::vector<uint8_t> stiffness_percent;  ///< (T) of the material's modulus; empty = 100.
    int spare_vertices = 0;  ///< Room for the copies that cutting makes; 0 = cannot be cut.
    std::vector<SheetTriangle> sheet;  ///< VBD only. May have vertices that no tet has.
    double sheet_bending = 1;          ///< Share of a plate's bending stiffness; 0 = a membrane.
    /// Of the whole sheet, instead of that of its triangles' tissue: for what is no tissue.
    std::optional<Material> sheet_material = std::nullopt;
};

/// What a triangle of the sheet is made of.
[[nodiscard]] inline const Material& material_of(const SoftBodySpec& spec,
                                                 const SheetTriangle& t) noexcept {
    return spec.sheet_material ? *spec.sheet_material
                               : spec.materials[static_cast<size_t>(t.tissue)];
}

/// Maps edges of the mesh to edges of the tet's stress-free shape (rest_scale).
[[nodiscard]] Mat3 rest_stretch(const SoftBodySpec& spec, int tet) noexcept;

struct KernelLayout;  // batches and colours of the kernels, in solver order
struct Topology;      // connectivity that cutting changes: sim/solver/topology.h
class SoftBody;

/// Owns a Topology, or none; copies deeply.
class TopologyPointer {
 public:
    TopologyPointer();
    ~TopologyPointer();
    TopologyPointer(const TopologyPointer& other);
    TopologyPointer& operator=(const TopologyPointer& other);
    TopologyPointer(TopologyPointer&&) noexcept;
    TopologyPointer& operator=(TopologyPointer&&) noexcept;
    void create(const SoftBody& body);
    explicit operator bool() const noexcept { return value_ != nullptr; }
    Topology& operator*() const noexcept { return *value_; }
    Topology* operator->() const noexcept { return value_.get(); }

 private:
    std::unique_ptr<Topology> value_;
};

/// Constant part. Vertex numbers are those of `mesh()`.
class SoftBody {
 public:
    /// Packs the body. The mesh should be in RCM order (`renumbered`).
    /// @throws MeshError for a broken spec, and where the method is not valid: one XPBD sweep a
    /// substep has the fixed point k / (1 + Co^2). Measured errors on a cantilever: Co 0.5 1.5 %,
    /// 1.1 about 7 % (pair 20 %), 2 scatter, 3 inversion. Hence the block is refused above
    /// kXpbdMaxCourant, the pair above kXpbdPairMaxCourant. VBD is valid at any Courant number.
    explicit SoftBody(SoftBodySpec spec);
    ~SoftBody();
    SoftBody(SoftBody&&) noexcept;
    SoftBody& operator=(SoftBody&&) noexcept;

    [[nodiscard]] const SoftBodySpec& spec() const noexcept { return spec_; }
    [[nodiscard]] const TetMesh& mesh() const noexcept { return spec_.mesh; }
    [[nodiscard]] int vertex_count() const noexcept {
        return static_cast<int>(spec_.mesh.rest.size());
    }
    /// With the spare vertices: the size of every array of the state that counts vertices.
    [[nodiscard]] int vertex_capacity() const noexcept {
        return vertex_count() + spec_.spare_vertices;
    }
    [[nodiscard]] int tet_count() const noexcept {
        return static_cast<int>(spec_.mesh.tets.size());
    }
    [[nodiscard]] std::span<const float> mass_kg() const noexcept { return mass_kg_; }      ///< (V)
    [[nodiscard]] std::span<const float> volume_m3() const noexcept { return volume_m3_; }  ///< (T)
    [[nodiscard]] std::span<const float> shortest_edge_m() const noexcept {
        return shortest_edge_m_;
    }  ///< (V)
    /// Tets around vertex v: `tets_of(v)`.
    [[nodiscard]] std::span<const int32_t> tets_of(int vertex) const noexcept {
        return {vertex_tets_.data() + vertex_tets_start_[vertex],
                static_cast<size_t>(vertex_tets_start_[vertex + 1] - vertex_tets_start_[vertex])};
    }
    [[nodiscard]] const KernelLayout& packed() const noexcept { return *packed_; }
    /// Largest Courant number c_p h / L of each tissue, with the solver's h [-]; 0 where absent.
    /// L of a tet is the lesser of its shortest edge and sqrt(2) x its smallest height (equal to
    /// the edge on a cubic Kuhn lattice), so that flat tets count.
    [[nodiscard]] std::array<double, kTissueCount> courant_numbers() const;
    /// True where XPBD sweeps there and back, see kXpbdTurnCourant.
    [[nodiscard]] bool turns() const noexcept { return turns_; }
    /// What the loader has to say: method, Courant numbers, predicted error class.
    [[nodiscard]] std::vector<std::string> notes() const;

 private:
    void check_method() const;

    SoftBodySpec spec_;
    std::vector<float> mass_kg_, volume_m3_, shortest_edge_m_;
    std::vector<int32_t> vertex_tets_, vertex_tets_start_;
    std::unique_ptr<KernelLayout> packed_;
    bool turns_ = false;
};

/// What a substep goes over: everything, or what sleep.h has left awake.
struct AwakeRuns {
    using Run = std::array<int32_t, 2>;  ///< [first, last)

    bool all = true;
    std::vector<Run> batches;            ///< Of vertex batches; VBD: job by job.
    std::vector<int32_t> job_start;      ///< VBD: (jobs + 1) into `batches`.
    std::vector<Run> vertices;           ///< Bounds are multiples of 16, or the end.
    std::vector<Run> tets;               ///< XPBD: of tet batches, job by job.
    std::vector<int32_t> tet_job_start;  ///< XPBD: (tet jobs + 1) into `tets`.
    /// XPBD: vertices that sleep but are moved by a kernel together with others, and what they
    /// weigh; see hold_sleepers().
    std::vector<int32_t> held;
    std::vector<float> held_w;
    bool holding = false;
};
template <class Visit>
void fields(Of<AwakeRuns> auto& s, Visit&& visit) {
    auto& [all, batches, job_start, vertices, tets, tet_job_start, held, held_w, holding] = s;
    visit.state(all, batches, job_start, vertices, tets, tet_job_start, held, held_w, holding);
}

/// Changing part. All arrays are allocated by the constructor and never grow.
struct SoftBodyState {
    explicit SoftBodyState(const SoftBody& body);

    std::vector<Float4> x;           ///< Position [m], w = inverse mass [1/kg], 0 when held (V).
    std::vector<Float4> v;           ///< Velocity [m/s] (V).
    std::vector<Float4> x_start;     ///< Position at the start of the substep [m] (V).
    std::vector<uint8_t> tet_alive;  ///< 1 while the tet carries stress (T).
    std::vector<uint8_t>
        contact_vertex;  ///< 1 = left out of the sweep, solved in the contact colour (V).
    std::vector<uint8_t> free_vertex;  ///< 1 = belongs to a component that nothing holds: gravity
                                       ///< enters the start guess (V).
    std::vector<uint8_t> tether_alive;
    std::vector<float> tether_lambda_n;  ///< Force of the last substep [N].
    std::vector<Float4> force_n;         ///< External force on each vertex [N] (V); empty = none.
                                         ///< Set it (size V) before the substep it acts in.
    std::vector<Float4> pushed;          ///< Private: v + h force / m (V), empty without forces.
    /// What a float has no room for: x + x_low is the position (V); empty = it is rounded. See
    /// double_float.h.
    std::vector<Float4> x_low, x_start_low;
    AlignedVector<float> lanes;     ///< Private to the kernels (per-lane element switches).
    AlignedVector<float> springs;   ///< Anchor springs and loads; see set_load().
    std::vector<int32_t> scratch;   ///< Private to restore_collapsed (V).
    std::vector<uint8_t> seen_tet;  ///< Private to update_free_vertices (T).
    TopologyPointer topology;       ///< Only in bodies with spare vertices.
    AwakeRuns awake;
    std::vector<int32_t> roused;  ///< Vertices that must not sleep in the next frame; see rouse().
    int32_t roused_count = 0;     ///< Past the end of `roused`: all.
    uint32_t flags = 0;  ///< Bits of StepReport raised by the kernels; the caller clears them.
    /// The next sweep goes back, where the body turns(). Frames begin with a sweep there, so that a
    /// tremble with the period of two sweeps is not seen from frame to frame.
    bool backward = false;
};
template <class Visit>
void fields(Of<SoftBodyState> auto& s, Visit&& visit) {
    auto& [x, v, x_start, tet_alive, contact_vertex, free_vertex, tether_alive, tether_lambda_n,
           force_n, pushed, x_low, x_start_low, lanes, springs, scratch, seen_tet, topology, awake,
           roused, roused_count, flags, backward] = s;
    visit.state(x, v, x_start, tet_alive, contact_vertex, free_vertex, tether_alive,
                tether_lambda_n, force_n, x_low, x_start_low, springs, topology, roused,
                roused_count, flags, backward);
    visit.kept(lanes, awake);
    visit.constant(pushed, scratch, seen_tet);
}

/// Where a vertex is now [m].
[[nodiscard]] inline Vec3 position(const SoftBodyState& state, int vertex) noexcept {
    return to_vec(state.x[static_cast<size_t>(vertex)]);
}

// Connectivity as it is now. Vertices from vertex_count() on are copies that cutting made; their
// data at rest are those of origin_of.

/// Tets around a vertex, dead ones too.
[[nodiscard]] std::span<const int32_t> tets_around(const SoftBody& body, const SoftBodyState& state,
                                                   int vertex) noexcept;
/// Corners of a tet.
[[nodiscard]] const std::array<int32_t, 4>& corners(const SoftBody& body,
                                                    const SoftBodyState& state, int tet) noexcept;
/// Corners of all tets; empty in a body without spare vertices.
[[nodiscard]] std::span<const std::array<int32_t, 4>> current_tets(
    const SoftBodyState& state) noexcept;
/// Vertex of the mesh that a vertex came from: itself, unless it is a copy.
[[nodiscard]] int32_t origin_of(const SoftBodyState& state, int vertex) noexcept;
/// Where a vertex is at rest [m]: the mesh's place, unless a cut has slid it (slide_vertex.h).
[[nodiscard]] const Vec3& rest_place(const SoftBody& body, const SoftBodyState& state,
                                     int vertex) noexcept;
/// Volume of a tet at rest [m^3], likewise.
[[nodiscard]] float rest_volume_of(const SoftBody& body, const SoftBodyState& state,
                                   int tet) noexcept;
/// Lumped mass [kg].
[[nodiscard]] float mass_of(const SoftBody& body, const SoftBodyState& state, int vertex) noexcept;
/// The kernels' view of the body.
[[nodiscard]] const KernelLayout& packed_of(const SoftBody& body,
                                            const SoftBodyState& state) noexcept;

/// Gradient and Hessian of the implicit-Euler objective in one vertex:
/// m/(2h^2)|x - target|^2 + sum Psi V + springs + stretched tethers + sheet. Works with every
/// method.
struct VertexSystem {
    Vec3 gradient = Vec3::Zero();  ///< [N]
    Mat3 hessian = Mat3::Zero();   ///< [N/m], symmetric positive definite
};
[[nodiscard]] VertexSystem vertex_system(const SoftBody& body, const SoftBodyState& state,
                                         int vertex, double h) noexcept;

/// Elastic force of tets and sheet on a vertex, -dE/dx without inertia, springs and tethers [N].
[[nodiscard]] Vec3 elastic_force(const SoftBody& body, const SoftBodyState& state,
                                 int vertex) noexcept;

/// Start of a substep: x_start, start guess. h [s]. Held vertices (w = 0) stay where the
/// caller put them; a vertex that is not finite returns to its last good place.
void begin_substep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept;
/// One sweep over all elements (or vertices), leaving out `contact_vertex`. Call it
/// `iterations` times a substep.
void sweep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept;
/// End of a substep: velocities from positions, damping, tethers that break.
void end_substep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept;

/// A frame of `substeps` whole substeps of the solver's own h and iterations, without contact; the
/// three calls above in one go, bit for bit.
void run_substeps(const SoftBody& body, SoftBodyState& state, int substeps,
                  Workers& workers) noexcept;

/// Takes their inverse masses from the vertices that sleep beside what is awake, so that nothing
/// moves them, until release_sleepers(). Around the substeps of a frame.
void hold_sleepers(SoftBodyState& state) noexcept;
void release_sleepers(SoftBodyState& state) noexcept;

/// Sets `free_vertex` anew: 1 for every vertex of a component (through living tets and
/// tethers) that no held vertex (w = 0) and no spring holds. Call after removing tets, grasping or
/// letting go; a breaking tether calls it by itself. Never allocates.
void update_free_vertices(const SoftBody& body, SoftBodyState& state) noexcept;

/// Sets what a stiffless anchor spring does from now on: force = load_n - diag(k_n_m) (x -
/// anchor_m). VBD only. @pre the spec has an anchor spring without stiffness at `vertex`.
void set_load(const SoftBody& body, SoftBodyState& state, int vertex, const Vec3f& load_n,
              const Vec3f& k_n_m, const Vec3f& anchor_m) noexcept;

/// Ties a vertex with a stiffless anchor spring to a place from now on: force = -K (x - anchor_m),
/// K symmetric as xx xy xz yy yz zz. VBD only. @pre as set_load().
void set_spring(const SoftBody& body, SoftBodyState& state, int vertex,
                const std::array<float, 6>& k_n_m, const Vec3f& anchor_m) noexcept;

/// Says that something has changed at a vertex, so that sleeping tissue there wakes (sleep.h).
void rouse(SoftBodyState& state, int32_t vertex) noexcept;
/// The same for all of it.
void rouse_all(SoftBodyState& state) noexcept;

/// Takes a tet out of the body (vaporised, torn). Its mass stays with its vertices.
void remove_tet(const SoftBody& body, SoftBodyState& state, int tet) noexcept;

/// 64-bit FNV-1a hash over positions, velocities and alive flags, in vertex order.
[[nodiscard]] uint64_t state_hash(const SoftBodyState& state) noexcept;

/// Name of the instruction set that the kernels run on here ("AVX3", "AVX2", "SSE4", "EMU128").
[[nodiscard]] const char* kernel_target() noexcept;

}  // namespace placode::sim
