// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rigid spheres near the surface of a body, for verification scenes: every boundary triangle is
// looked at. What touches is left to the instruments' contact for the kernels
// (pressed_vertices.h); the references in double precision push the nearest point of each triangle
// out with f = k max(0, -gap).

#include <array>
#include <functional>
#include <vector>

#include "sim/verify/reference_body.h"

namespace placode::sim {

struct SphereObstacle {
    Vec3 centre_m = Vec3::Zero();  ///< At t = 0.
    double radius_m = 0.001;
    Vec3 velocity_m_s = Vec3::Zero();
    double friction = 0;  ///< Coulomb [-].

    [[nodiscard]] Vec3 centre_at(double time_s) const { return centre_m + time_s * velocity_m_s; }
};

/// One triangle against one sphere.
struct SphereTouch {
    std::array<int32_t, 3> vertex{};
    Vec3 b = Vec3::Zero();   ///< Barycentric weights of the nearest point.
    Vec3 n = Vec3::UnitZ();  ///< From the sphere's centre to that point.
    double gap_m = 0;        ///< Negative when they overlap.
    int sphere = 0;
    bool both_sides = false;  ///< Of a sheet.
    bool looks_away = false;  ///< A face that turns its back on the sphere.
};

class SphereContacts {
 public:
    /// @param sheet triangles that are touched from both sides, beside the faces of the tets.
    SphereContacts(const TetMesh& mesh, std::vector<SphereObstacle> spheres,
                   const std::vector<std::array<int32_t, 3>>& sheet = {});

    using PositionOf = std::function<Vec3(int32_t vertex)>;
    /// Triangles nearer than `margin_m` at time `time_s`, whichever way they face.
    void near(const PositionOf& x, double time_s, double margin_m,
              std::vector<SphereTouch>& out) const;
    /// The same without those that turn their back on the sphere: their other side is touched.
    void find(const PositionOf& x, double time_s, double margin_m,
              std::vector<SphereTouch>& out) const;

    [[nodiscard]] const std::vector<SphereObstacle>& spheres() const { return spheres_; }
    /// Mean edge of the boundary triangles [m].
    [[nodiscard]] double mean_edge_m() const { return mean_edge_m_; }
    /// Vertices of the surface, ascending.
    [[nodiscard]] const std::vector<int32_t>& vertices() const { return vertices_; }

 private:
    std::vector<std::array<int32_t, 3>> triangles_;  // faces of tets first
    size_t faces_ = 0;
    std::vector<int32_t> vertices_;
    std::vector<SphereObstacle> spheres_;
    double mean_edge_m_ = 0, longest_edge_m_ = 0;
};

/// Energy k/2 gap^2 of the overlapping touches at x [J].
[[nodiscard]] double contact_energy(const SphereContacts& contacts, const Coordinates& x,
                                    double time_s, double k);
/// Adds its gradient and (where `stiffness` is given) the positive part of its Hessian. Returns the
/// force on each sphere [N].
std::vector<Vec3> add_contact(const SphereContacts& contacts, const Coordinates& x, double time_s,
                              double k, Coordinates& gradient, Triplets* stiffness);

}  // namespace placode::sim
