// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shape of the flat operative field as functions of the plane: outlines of placode and skin
// edge, height of the surface, thickness and tissue of the layers. No mesh here.

#include <array>
#include <vector>

#include "sim/anatomy/operative_field.h"

namespace placode::sim {

/// Layers from the surface to the bed.
inline constexpr int kFieldLayers = 4;

/// Throws MeshError naming field, value and allowed range.
void check_field_spec(const OperativeFieldSpec& spec);

[[nodiscard]] double squared_distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);

/// Signed distance to a closed outline that is star-shaped around `centre` (negative inside).
class Outline {
 public:
    /// Ellipse with semi-axes a, b, stretched by s(theta) = 1 + sum a_k cos(k theta + phi_k),
    /// k = 2..4, theta = atan2(y / b, x / a) around the centre.
    Outline(const Vec2& centre, double a_m, double b_m, const std::array<double, 3>& amplitude,
            const std::array<double, 3>& phase);
    /// Closed polyline, counter-clockwise, fine enough that its error is below 1 um.
    [[nodiscard]] const std::vector<Vec2>& points() const noexcept { return points_; }
    /// Elliptic radius over the wobble: 1 on the outline, less inside [-].
    [[nodiscard]] double rho(const Vec2& p) const;
    /// Euclidean distance [m], negative inside.
    [[nodiscard]] double signed_distance(const Vec2& p) const;
    /// Closed polyline `offset_m` outside of the outline.
    [[nodiscard]] std::vector<Vec2> offset(double offset_m) const;

 private:
    [[nodiscard]] double stretch(double theta) const;
    Vec2 centre_;
    double a_m_, b_m_;
    std::array<double, 3> amplitude_, phase_;
    std::vector<Vec2> points_;
};

/// What a column of the field is made of, below one point of the plane.
struct FieldColumn {
    double to_placode_m = 0;                         ///< d_p
    double to_skin_m = 0;                            ///< d_s
    double top_m = 0;                                ///< Height z of the surface.
    std::array<double, kFieldLayers> thickness_m{};  ///< From the surface down.
    std::array<Vec3, kFieldLayers + 1> level_m{};    ///< Where the layers meet, surface first.
};

/// The field of one spec and seed.
class FieldShape {
 public:
    /// @throws MeshError as check_field_spec.
    explicit FieldShape(const OperativeFieldSpec& spec);
    [[nodiscard]] const Outline& placode() const noexcept { return placode_; }
    [[nodiscard]] const Outline& skin() const noexcept { return skin_; }
    /// Planned incision in the plane, closed.
    [[nodiscard]] const std::vector<Vec2>& contour() const noexcept { return contour_; }
    [[nodiscard]] FieldColumn column(const Vec2& p) const;
    /// Label of a piece of layer `layer` with these distances at its centroid.
    [[nodiscard]] Tissue tissue(int layer, double to_placode_m, double to_skin_m) const;
    /// True where the layer is fluid instead of tissue.
    [[nodiscard]] bool fluid(int layer, double to_skin_m) const {
        return spec_.cystic && layer == 2 && to_skin_m < 0;
    }
    /// Wanted edge length in the plane [m]; from a table of the distances, hence fast.
    [[nodiscard]] double edge_length(const Vec2& p) const;

 private:
    struct Wobble {
        std::array<double, 3> amplitude{}, phase{};
    };
    FieldShape(const OperativeFieldSpec& spec, const Wobble& wobble);
    static Wobble wobble_of(const OperativeFieldSpec& spec);
    [[nodiscard]] double relief(const Vec2& p) const;
    [[nodiscard]] double base(const Vec2& p) const;
    [[nodiscard]] double dome(const Vec2& p) const;
    void stack_levels(const Vec2& p, FieldColumn& column) const;
    void stack_sac(const Vec2& p, FieldColumn& column) const;
    [[nodiscard]] double exact_edge_length(const Vec2& p) const;
    void tabulate_edge_length();

    OperativeFieldSpec spec_;
    Vec2 placode_centre_;
    Outline placode_, skin_;
    std::vector<Vec2> contour_;
    int table_nx_ = 0, table_ny_ = 0;
    std::vector<double> table_m_;  // edge length on a lattice of kTableStep
};

}  // namespace placode::sim
