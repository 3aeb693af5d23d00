// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The vertices that spheres touch, solved by the contact of the instruments
// (sim/contact/contact_core.h). What a sphere adds to it: its exact distance instead of a chain of
// cones, every boundary triangle instead of candidates of a frame, and, of bodies that nothing
// holds, their motion as a whole. Private to sim/verify.

#include <memory>
#include <vector>

#include "sim/solver/soft_body.h"
#include "sim/verify/kernel_units.h"
#include "sim/verify/rigid_modes.h"
#include "sim/verify/solve_setup.h"
#include "sim/verify/sphere_contact.h"
#include "sim/world/contact_lists.h"

namespace placode::sim {

/// Positions and forces in the kernels' units, times in the scene's.
class PressedVertices {
 public:
    PressedVertices(const SolveSetup& setup, const KernelUnits& units, const SoftBody& body,
                    SoftBodyState& state, double h_body);

    /// Start of a frame: forces are summed anew.
    void start_frame();
    /// Start of a substep that ends at `time_s`.
    void set_time(double time_s) { time_ = time_s; }
    /// After the start guess: who is touched. @param modes nullptr = what nothing holds has no
    /// motion of its own.
    void find(const RigidModes* modes);
    /// One pass, there or back.
    void solve(bool backward);
    /// What the spheres do to the tissue where it is now, valid until the next call.
    const std::vector<ContactPush>& pushes();
    /// End of a substep: forces on the spheres, and where vertices stick from now on.
    void finish();

    /// True from find() on for a vertex that is touched or nearly is.
    [[nodiscard]] bool touches(int32_t v) const;
    /// Force of the tissue on a sphere, mean over the frame so far.
    [[nodiscard]] Vec3 force(size_t sphere) const;
    [[nodiscard]] size_t spheres() const { return force_.size(); }
    [[nodiscard]] double deepest() const { return deepest_; }

 private:
    struct Anchor {
        int32_t sphere = kTissueSide;  // = none
        uint8_t slipping = 0;
        Vec3 from_centre = Vec3::Zero();
    };
    void touch_near_triangles();
    void recall_anchors();
    void anchor_newcomers();
    void go_with(const RigidModes& modes);
    [[nodiscard]] Vec3 centre(int32_t sphere, double time_s) const;

    const SolveSetup& setup_;
    const KernelUnits& units_;
    const SoftBody& body_;
    SoftBodyState& state_;
    const double h_, h_body_;  // of a substep, in the scene's units and in the kernels'
    const std::vector<SphereObstacle> spheres_;
    std::unique_ptr<SphereContacts> contacts_;  // nullptr = no spheres
    ContactLists lists_;
    double time_ = 0, most_n_m_ = 0, deepest_ = 0;
    int64_t frame_ = 0;
    int frame_substeps_ = 0;
    std::vector<SphereTouch> near_;
    std::vector<int32_t> colour_;  // of this substep
    std::vector<Anchor> anchor_;   // (V)
    std::vector<ContactPush> pushes_;
    std::vector<Vec3> force_;
};

}  // namespace placode::sim
