// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The vertices that the kernels leave to others: those that spheres touch, with dry friction, and
// those that only some axes hold. The law of sim/contact, for bodies without instruments. Private
// to sim/verify.

#include <memory>
#include <vector>

#include "sim/contact/contact_law.h"
#include "sim/solver/soft_body.h"
#include "sim/verify/kernel_units.h"
#include "sim/verify/rigid_modes.h"
#include "sim/verify/solve_setup.h"
#include "sim/verify/sphere_contact.h"

namespace placode::sim {

/// Positions and forces in the kernels' units, times in the scene's.
class ConstrainedVertices {
 public:
    ConstrainedVertices(const SolveSetup& setup, const KernelUnits& units, const SoftBody& body,
                        SoftBodyState& state, double h_body);

    /// Start of a frame: forces are summed anew.
    void start_frame();
    /// Start of a substep that ends at `time_s`.
    void set_time(double time_s) { time_ = time_s; }
    /// After the start guess: who is touched. @param modes nullptr = what nothing holds has no
    /// motion of its own.
    void find(const RigidModes* modes);
    /// After a sweep: one pass over all of them, a second one over those that are touched.
    void solve();
    /// What the spheres do to the tissue where it is now, valid until the next call.
    const std::vector<ContactPush>& pushes();
    /// End of a substep: forces on the spheres, and where vertices stick from now on.
    void finish();

    /// Force of the tissue on a sphere, mean over the frame so far.
    [[nodiscard]] Vec3 force(size_t sphere) const;
    [[nodiscard]] size_t spheres() const { return force_.size(); }
    [[nodiscard]] double deepest() const { return deepest_; }
    /// Where a held coordinate is at the substep's end.
    [[nodiscard]] double held_at(int32_t v, int axis) const;

 private:
    struct Anchor {
        int sphere = -1;
        Vec3 from_centre = Vec3::Zero();
    };
    void find_touches();
    void drop_doubles();
    void set_stiffness();
    void add(int32_t v);
    [[nodiscard]] double relaxation_of(size_t i) const;
    void solve_vertex(size_t i);
    void hold_axes(int32_t v, VertexSystem& system) const;
    [[nodiscard]] double gap(const SphereTouch& t) const;
    /// Axes that are held go where their region is.
    void put_on_axes(int32_t v);
    [[nodiscard]] Friction friction_of(int32_t v, const Vec3& load) const;
    [[nodiscard]] double friction_n_m(int32_t v) const;
    void start_where_they_were(const RigidModes* modes);
    void anchor_newcomers();
    void stick();

    const SolveSetup& setup_;
    const KernelUnits& units_;
    const SoftBody& body_;
    SoftBodyState& state_;
    const double h_body_;
    const std::vector<SphereObstacle> spheres_;
    std::unique_ptr<SphereContacts> contacts_;
    double time_ = 0, k_ = 0, deepest_ = 0;
    std::vector<int32_t> special_, slot_;
    std::vector<std::vector<int32_t>> incidence_;  // touch * 4 + corner, of each special vertex
    std::vector<SphereTouch> touches_;
    std::vector<double> touch_n_m_;  // stiffness of each
    std::vector<Mat3> answer_;       // Hessian of each special vertex, its neighbours held
    std::vector<Anchor> anchor_;
    std::vector<ContactPush> pushes_;
    std::vector<Vec3> load_;        // of each special vertex, without friction
    std::vector<int> load_sphere_;  // -1 = none
    std::vector<Vec3> force_;
    int frame_substeps_ = 0;
};

}  // namespace placode::sim
