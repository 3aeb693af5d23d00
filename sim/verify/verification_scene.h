// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A verification scene: one soft body, what holds it, what loads it, one method, and what came out.
// `placodectl solve` reads it from JSON (curriculum/verification_json.h) and writes the result.

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/solver/soft_body.h"
#include "sim/verify/sphere_contact.h"

namespace placode::sim {

/// A scene that cannot be solved. `pointer` is the JSON pointer of the setting.
class VerificationError : public std::runtime_error {
 public:
    VerificationError(std::string pointer, const std::string& message)
        : std::runtime_error(message), pointer_(std::move(pointer)) {}
    [[nodiscard]] const std::string& pointer() const noexcept { return pointer_; }

 private:
    std::string pointer_;
};

/// Closed box; vertices inside it at rest are selected, with a tolerance of 1e-9 m.
struct BoxSelection {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< [m]
};

/// Bits of `axes`.
inline constexpr uint8_t kAxisX = 1, kAxisY = 2, kAxisZ = 4;

struct HeldRegion {
    BoxSelection box;
    uint8_t axes = kAxisX | kAxisY | kAxisZ;
    Vec3 displacement_m = Vec3::Zero();  ///< Reached after ramp_s; 0 = fixed.
    double ramp_s = 0;                   ///< Linear; 0 = at once.
    std::string pointer;                 ///< "/fixed/0" or "/prescribed/0".
};

/// Spread by area over the boundary triangles that lie in the box; by vertex where there are none.
struct LoadRegion {
    BoxSelection box;
    Vec3 total_force_n = Vec3::Zero();
    double ramp_s = 0;
    std::string pointer;
};

enum class StartKind : uint8_t { kRest, kRandom, kFlat, kMirror, kPoint, kStretch };

/// Where the vertices begin, that are not held. `amount` 1 goes all the way: every vertex at a
/// random place in the bounding box, flat in z, all in its centre, mirrored in x. Stretch is the
/// strain along x.
struct StartShape {
    StartKind kind = StartKind::kRest;
    double amount = 1;
    uint64_t seed = 1;
};

enum class SolveMethod : uint8_t { kXpbd, kXpbdPair, kVbd, kExplicit, kNewton };
[[nodiscard]] const char* method_name(SolveMethod method) noexcept;

struct VerificationSolver {
    SolveMethod method = SolveMethod::kVbd;
    double frame_s = 1e-3;
    int substeps = 8;
    int iterations = 1;
    int threads = 2;
    double over_relaxation = 0;  ///< vbd only; 0 = 1.2, or 1 above a Poisson's ratio of 0.46.
    bool allow_invalid = false;  ///< Run a method where it is not valid, with a warning.
    /// xpbd, xpbd_pair and vbd: positions are rounded to floats, as they are in the simulator; for
    /// measuring that. Without it they have 48 bits.
    bool single_precision = false;
};

struct Probe {
    std::string name;
    BoxSelection box;
    std::string pointer;
};

struct VerificationScene {
    TetMesh mesh;                           ///< [m], one tissue label.
    std::vector<Vec3> output_points;        ///< Rest place of every vertex of the output [m].
    std::vector<int32_t> vertex_of_output;  ///< Vertex of the mesh, -1 = takes no part.
    Material material;
    std::vector<SheetTriangle> sheet;  ///< Of all sheets, see use_sheet.
    std::vector<Material> sheet_materials;
    double sheet_bending = 1;  ///< As SoftBodySpec.
    Vec3 gravity_m_s2 = Vec3(0, 0, -9.81);
    std::vector<HeldRegion> held;  ///< fixed first, then prescribed.
    std::vector<LoadRegion> loads;
    std::vector<SphereObstacle> spheres;
    StartShape start;
    VerificationSolver solver;
    double end_s = 1;                      ///< Time, or longest time until rest.
    std::optional<double> rest_speed_m_s;  ///< Ends at rest: RestWatch.
    std::vector<Probe> probes;
    double sample_s = 1e-3;
    std::vector<std::string> warnings;  ///< From the loader.
};

struct RegionForce {
    std::string pointer;
    Vec3 force_n = Vec3::Zero();
};

struct SolveResult {
    std::vector<Vec3> final_m;  ///< Like output_points.
    std::vector<double> sample_time_s;
    std::vector<std::vector<Vec3>> probe_m;  ///< (samples x probes) mean positions.
    double simulated_s = 0, wall_s = 0;
    double cpu_s = 0;    ///< Of all threads together, without the check of the scene.
    double check_s = 0;  ///< Spent on whether it rests in equilibrium, in neither of them [s].
    int64_t substeps_total = 0;
    double kinetic_energy_j = 0, elastic_energy_j = 0;
    Vec3 momentum_kg_m_s = Vec3::Zero();           ///< Sum of m v.
    Vec3 angular_momentum_kg_m2_s = Vec3::Zero();  ///< About the centre of mass.
    double momentum_scale_kg_m_s = 0;              ///< Sum of m |v|.
    double angular_momentum_scale_kg_m2_s = 0;     ///< Sum of m |r| |v|.
    int inverted_tets = 0, not_finite = 0;
    double max_courant = 0;
    Vec3 reaction_n = Vec3::Zero();           ///< Of all `fixed` on the body (of all
                                              ///< `prescribed` where nothing is fixed).
    std::vector<RegionForce> reactions;       ///< Of every region on the body.
    Vec3 contact_force_n = Vec3::Zero();      ///< Of the body on all spheres.
    std::vector<RegionForce> contact_forces;  ///< Of the body on each sphere.
    double penetration_m = 0;                 ///< Deepest at the end.
    uint64_t state_hash = 0;
    bool diverged = false;  ///< explicit or newton gave up.
    bool at_rest = false;   ///< `until` rest was reached.
    /// At rest, to first order: largest way of a vertex to equilibrium; nothing = not known.
    std::optional<double> equilibrium_error_m;
    int newton_iterations = 0;
    double newton_residual_n = 0;
    std::string kernels;  ///< Instruction set of the fast solver.
    std::vector<std::string> warnings;
};

/// Puts a mesh into the scene, in RCM order (thick ones along their axis); `vertex_of_output` says
/// which of its vertices each output point is, -1 = none.
void use_mesh(VerificationScene& scene, const TetMesh& mesh, std::vector<Vec3> output_points,
              const std::vector<int32_t>& vertex_of_output);
/// The same with a box of Kuhn tets, one corner at the origin.
void use_box(VerificationScene& scene, const Vec3& size_m, const std::array<int, 3>& cells);

/// A sheet to be added to a scene.
struct SheetInput {
    std::vector<Vec3> points;  ///< [m]
    std::vector<std::array<int32_t, 3>> triangles;
    /// (points) Index into output_points; empty = the points are welded to vertices of the mesh
    /// that lie where they do (a millionth of the longest edge apart at most), the others are new.
    std::vector<int32_t> output;
    Material material;
    double thickness_m = 1e-4;
    bool allow_disconnected = false;  ///< Take a sheet that meets nothing.
};
inline constexpr size_t kMostSheets = kTissueCount - 1;

/// Welds a sheet to the scene's mesh, which comes first (or is empty). @throws MeshError naming the
/// triangle for what check_sheet refuses, and for a sheet that touches nothing.
void use_sheet(VerificationScene& scene, const SheetInput& sheet);
/// All boundary triangles with their corners in the box, as a sheet on the mesh.
[[nodiscard]] SheetInput boundary_in(const VerificationScene& scene, const BoxSelection& box);

/// Is told about twice a second how far a run is.
using SolveWatch = std::function<void(const std::string& words)>;

/// Runs the scene. @throws VerificationError for settings that cannot be (empty selections, a
/// method that is not valid at its step, ...), MeshError for a body that cannot be built.
[[nodiscard]] SolveResult solve(const VerificationScene& scene, const SolveWatch& watch = {});

}  // namespace placode::sim
