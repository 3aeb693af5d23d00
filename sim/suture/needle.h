// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A suture needle: a rigid half circle of round wire. Everything about it is said by the arc
// coordinate s, which runs from the point (s = 0) to the swage (s = arc length), and on into the
// thread.
//
// Frame N: origin in the centre of the circle, the point at (R, 0, 0), the arc in the plane z = 0
// through (0, R, 0) to the swage at (-R, 0, 0). The needle is driven with its point ahead, towards
// -y. All of it is closed form; what the step uses is free of the library's sine and arc tangent,
// whose last bit depends on the processor.

#include "sim/core/geometry.h"
#include "sim/suture/suture_error.h"

namespace placode::sim {

/// Planning values, from catalogues of needles for 4/0 to 5/0 sutures [to be confirmed by a fetal
/// surgeon].
struct NeedleSpec {
    double arc_m = 17e-3;           ///< Point to swage along the wire: 5e-3 to 40e-3.
    double wire_radius_m = 0.2e-3;  ///< 0.05e-3 to 0.5e-3, at most a tenth of the circle's radius.
    double density_kg_m3 = 7900;    ///< Steel: 1000 to 25000.
};

/// A place on the arc, in N.
struct ArcPoint {
    Vec3 place_m = Vec3::Zero();
    Vec3 back = Vec3::UnitY();    ///< Unit tangent, towards the swage.
    Vec3 radial = Vec3::UnitX();  ///< Unit, away from the centre; with z it spans the normal plane.
};

/// Where a point lies against the circle that carries the arc. Beyond the ends the circle goes on:
/// s < 0 is ahead of the point, s > arc behind the swage.
struct ArcFoot {
    double s_m = 0;       ///< -arc / 2 to 3 arc / 2.
    double radial_m = 0;  ///< Off the wire's axis, in the normal plane; negative: inwards [m].
    double across_m = 0;  ///< Off the needle's plane, along z [m].
    double ring_m = 0;    ///< Distance from the circle's axis, R + radial_m.
    Vec3 back = Vec3::UnitY();
    Vec3 radial = Vec3::UnitX();
};

/// Constant part.
class Needle {
 public:
    /// @throws SutureError
    explicit Needle(const NeedleSpec& spec);
    [[nodiscard]] const NeedleSpec& spec() const noexcept { return spec_; }
    [[nodiscard]] double arc_m() const noexcept { return spec_.arc_m; }
    /// Of the circle, to the wire's axis [m].
    [[nodiscard]] double radius_m() const noexcept { return radius_m_; }
    [[nodiscard]] double mass_kg() const noexcept { return mass_kg_; }
    /// Centre of mass in N [m]: 2 R / pi from the centre.
    [[nodiscard]] const Vec3& centre_m() const noexcept { return centre_m_; }
    /// About the centre of mass; x, y and z of N are the principal axes [kg m^2].
    [[nodiscard]] const Vec3& inertia_kg_m2() const noexcept { return inertia_; }

    /// @param s_m 0 to arc; beyond them the circle goes on, to half an arc at either side.
    [[nodiscard]] ArcPoint at(double s_m) const noexcept;
    /// Nearest place of the whole circle. On the circle's axis, where all are as near, s is that of
    /// the point.
    [[nodiscard]] ArcFoot foot(const Vec3& p_N) const noexcept;
    /// The same, where a place near by is known: much cheaper. More than a tenth of a radian away
    /// it is foot().
    /// @param radial, s_m of that place.
    [[nodiscard]] ArcFoot foot_near(const Vec3& p_N, const Vec3& radial, double s_m) const noexcept;
    /// Where the point is, and which way it goes.
    [[nodiscard]] Vec3 tip_m() const noexcept { return {radius_m_, 0, 0}; }
    [[nodiscard]] static Vec3 forward() noexcept { return -Vec3::UnitY(); }

 private:
    /// All of a foot but its coordinate.
    [[nodiscard]] ArcFoot across_from(const Vec3& p_N) const noexcept;

    NeedleSpec spec_;
    double radius_m_ = 0, mass_kg_ = 0;
    Vec3 centre_m_, inertia_;
};

}  // namespace placode::sim
