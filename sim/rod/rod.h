// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Suture thread: a Cosserat rod with four moduli. Nodes have places, the segments between them have
// frames (quaternions; d3 runs along the thread). Strains of a segment of rest length l, and
// between neighbouring segments:
//   Gamma = R^T (x_j+1 - x_j) / l - e3,            energy l/2 Gamma . diag(GA, GA, EA) Gamma
//   omega = 4 v / (1 + w), (w, v) = q_j* q_j+1,    energy 1/(2 l) (omega - omega_0) . diag(EI, EI,
//   GJ)
// 4 v / (1 + w) = 4 tan(phi / 4) along the axis: within phi^3 / 48 of the angle phi, and smooth
// beyond half a turn, where the 2 v of the paper folds back. Source: Kugelstadt & Schoemer 2016,
// "Position and orientation based Cosserat rods" (strains, staggered places and frames).

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/fields.h"
#include "sim/core/geometry.h"

namespace placode::sim {

inline constexpr int kMaxRodSegments = 300;

/// Of a round section.
struct RodStiffness {
    double stretch_n = 0;   ///< EA [N]
    double shear_n = 0;     ///< GA, times the section's shear factor [N]
    double bend_n_m2 = 0;   ///< EI [N m^2]
    double twist_n_m2 = 0;  ///< GJ [N m^2]
};
/// A full round section: shear factor 6 (1 + nu) / (7 + 6 nu). Source: Cowper 1966.
[[nodiscard]] RodStiffness round_rod(double radius_m, double youngs_modulus_pa,
                                     double poissons_ratio) noexcept;

/// What scene files say about a thread. The default is a monofilament 4/0 of 150 mm.
struct RodSpec {
    int segments = 300;
    double length_m = 0.150;
    double radius_m = 0.09e-3;
    double density_kg_m3 = 1100;
    RodStiffness stiffness = round_rod(0.09e-3, 1e9, 0.4);
    double drag_per_s = 0;        ///< Velocity lost to the surroundings [1/s].
    double retardation_s = 1e-4;  ///< Kelvin-Voigt: stress gains this times its strain's rate [s].
    /// (segments) Rest lengths, empty = all alike; they add up to length_m.
    std::vector<double> segment_m;
    /// (segments - 1) Angle from a segment to the next at rest, as a vector in its frame [rad];
    /// empty = straight.
    std::vector<Vec3> rest_bend_rad;
};

/// A thread that cannot be: which field of the spec, what was found, what is allowed.
class RodError : public std::runtime_error {
 public:
    RodError(std::string field, const std::string& message)
        : std::runtime_error(message), field_(std::move(field)) {}
    [[nodiscard]] const std::string& field() const noexcept { return field_; }

 private:
    std::string field_;
};

/// Constant part.
class Rod {
 public:
    /// @throws RodError
    explicit Rod(RodSpec spec);
    [[nodiscard]] const RodSpec& spec() const noexcept { return spec_; }
    [[nodiscard]] int segments() const noexcept { return spec_.segments; }
    [[nodiscard]] int nodes() const noexcept { return spec_.segments + 1; }
    [[nodiscard]] const std::vector<double>& length_m() const noexcept { return length_m_; }
    [[nodiscard]] const std::vector<double>& mass_kg() const noexcept { return mass_kg_; }
    /// About d1 and d2; about d3 it is twice that [kg m^2].
    [[nodiscard]] const std::vector<double>& inertia_kg_m2() const noexcept { return inertia_; }
    /// (segments + 1) Between the middles of segments j - 1 and j; half a segment at the ends [m].
    [[nodiscard]] const std::vector<double>& bend_length_m() const noexcept { return bend_m_; }
    /// (segments + 1) At node j, zero at the ends.
    [[nodiscard]] const std::vector<Vec3>& rest_omega() const noexcept { return rest_omega_; }

 private:
    RodSpec spec_;
    std::vector<double> length_m_, mass_kg_, inertia_, bend_m_;
    std::vector<Vec3> rest_omega_;
};

/// Changing part.
struct RodState {
    RodState() = default;
    /// At rest along `places` (nodes), with frames that turn as little as they can from segment to
    /// segment.
    RodState(const Rod& rod, const std::vector<Vec3>& places);

    std::vector<Vec3> x;              ///< (N) [m]
    std::vector<Vec3> v;              ///< (N) [m/s]
    std::vector<Quat> q;              ///< (S) Frame to world.
    std::vector<Vec3> w;              ///< (S) In world [rad/s].
    std::vector<uint8_t> node_held;   ///< (N) 1 = goes to `node_target` in the next substep.
    std::vector<Vec3> node_target;    ///< (N)
    std::vector<uint8_t> frame_held;  ///< (S) The same for frames, as jaws hold them.
    std::vector<Quat> frame_target;   ///< (S)
    /// Clamps at the first and last node: a frame there, half a segment from the next one.
    std::array<uint8_t, 2> end_held{};
    std::array<Quat, 2> end_frame{Quat::Identity(), Quat::Identity()};
};
template <class Visit>
void fields(Of<RodState> auto& s, Visit&& visit) {
    auto& [x, v, q, w, node_held, node_target, frame_held, frame_target, end_held, end_frame] = s;
    visit.state(x, v, q, w, node_held, node_target, frame_held, frame_target, end_held, end_frame);
}

/// Hash over everything that decides the future.
[[nodiscard]] uint64_t state_hash(const RodState& state) noexcept;

/// Holds a node where it is.
void hold_node(RodState& state, int node) noexcept;
/// Clamps an end (0 or 1) in the direction that its segment has.
void clamp_end(RodState& state, int end) noexcept;

/// Elastic energy, clamps included [J].
[[nodiscard]] double rod_energy(const Rod& rod, const RodState& state) noexcept;
/// Its derivative by places [N] and by small turns of the frames in world [N m].
/// @pre `force` has N entries, `torque` S.
void rod_gradient(const Rod& rod, const RodState& state, std::vector<Vec3>& force,
                  std::vector<Vec3>& torque) noexcept;
/// What segment j pulls its first node with towards its second [N], in world: tension and shear.
[[nodiscard]] Vec3 segment_force(const Rod& rod, const RodState& state, int segment) noexcept;
/// Bending and twisting moment at node j, in the frame of the segment before it [N m].
[[nodiscard]] Vec3 node_moment(const Rod& rod, const RodState& state, int node) noexcept;

struct RodMotion {
    double kinetic_j = 0;
    Vec3 momentum_kg_m_s = Vec3::Zero();
    Vec3 angular_kg_m2_s = Vec3::Zero();  ///< About the origin, spin of the segments included.
};
[[nodiscard]] RodMotion rod_motion(const Rod& rod, const RodState& state) noexcept;

}  // namespace placode::sim
