// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rigid modes of pieces that nothing holds, solved exactly after the sweeps of a substep. A
// sweep carries what acts on one end of a body, or where a sphere touches it, only some vertices
// far: the body as a whole answers too little, and momentum is lost. To move and turn a piece
// costs no elastic energy, so that six unknowns settle it: momentum changes by what outside forces
// give and nothing else, angular momentum likewise (the implicit step by itself loses a share of
// w h in each). Private to sim/verify.

#include <vector>

#include "sim/solver/soft_body.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {

/// What a sphere does to the tissue at one place.
struct ContactPush {
    int sphere = 0;
    int32_t vertex = 0;  ///< One of those it acts on.
    Vec3 at = Vec3::Zero(), force_n = Vec3::Zero();
    Mat3 stiffness_n_m = Mat3::Zero();
};

/// Positions and forces in the kernels' units.
class RigidModes {
 public:
    RigidModes(const SolveSetup& setup, const SoftBody& body, SoftBodyState& state, double h_body);

    [[nodiscard]] bool any() const { return !pieces_.empty(); }
    /// Before the start guess: how every piece moves.
    void begin();
    /// What that is for a vertex in this substep [m]; zero where its piece is held.
    [[nodiscard]] Vec3 displacement(int32_t vertex) const;
    /// After the sweeps: moves the pieces. `pushes` () gives the contacts at the present positions.
    template <class Pushes>
    void solve(Pushes&& pushes) {
        for (int pass = 0; pass < kPasses; ++pass) {
            const std::vector<ContactPush>& found = pushes();
            if (!solve_once(found)) break;
        }
    }

 private:
    static constexpr int kPasses = 3;  // Newton's: contacts that open or close, finite rotation

    struct Piece {
        std::vector<int32_t> vertices;
        uint8_t held = 0;  ///< Axes that something of it holds: no translation, and no rotation.
        double mass = 0;
        Vec3 centre = Vec3::Zero(), speed = Vec3::Zero(), spin = Vec3::Zero();
    };
    /// What the vertices of a piece have done in this substep, against what they should have.
    struct Sums {
        Vec3 centre = Vec3::Zero();        ///< Of mass, now.
        Vec3 missing = Vec3::Zero();       ///< sum m (plan - way)
        Vec3 missing_turn = Vec3::Zero();  ///< sum m r x plan at the start - sum m r x way now
        Mat3 inertia = Mat3::Zero();
    };
    [[nodiscard]] Sums sum(const Piece& piece) const;
    [[nodiscard]] Vec3 plan(int32_t vertex) const;
    bool solve_once(const std::vector<ContactPush>& pushes);
    double move(int32_t number, const std::vector<ContactPush>& pushes);

    const SoftBody& body_;
    SoftBodyState& state_;
    const double h_;
    const Vec3 gravity_;
    std::vector<Piece> pieces_;
    std::vector<int32_t> piece_of_;  // (V), -1 = held along every axis
};

}  // namespace placode::sim
