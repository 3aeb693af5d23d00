// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a sheet of triangles covers, seen along the normal of the plane that it lies on: how far it
// reaches from a place, what of a region is left open, how much of it lies in folds. Pure geometry,
// docs/patch.md.

#include <array>
#include <span>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

/// A sheet as it lies. The constructor allocates, place() does not.
class SheetCover {
 public:
    SheetCover() = default;
    explicit SheetCover(size_t faces);

    /// Corners of all faces as they lie [m], (F x 3); the plane is z = 0.
    /// @pre corners.size() == faces(). Never throws.
    void place(std::span<const std::array<Vec3, 3>> corners) noexcept;

    [[nodiscard]] size_t faces() const noexcept { return face_.size(); }
    [[nodiscard]] bool covers(const Vec2& p) const noexcept;
    /// Length [m] from `from` along the unit vector `direction` that is covered without a gap; 0
    /// where `from` itself is open, and at most `most` [m].
    [[nodiscard]] double reach(const Vec2& from, const Vec2& direction, double most) noexcept;
    /// Least reach() into the half plane on the side of `outward`: along it, and along `directions`
    /// to either side of it, evenly spread over a right angle. A straight rim between two of them
    /// is missed by 1 - cos(45 degrees / directions) of the reach at most: 0.034 % for 30. @pre
    /// directions >= 1.
    [[nodiscard]] double margin(const Vec2& from, const Vec2& outward, int directions,
                                double most) noexcept;
    /// Share of one face [0..1] that lies in folds: where m layers lie over each other at its
    /// middle, 1 - 1 / m of each, so that their sum is what the sheet covers less; where nothing
    /// lies over or under it, all of a face that stands or turns more than 60 degrees away from
    /// `most_look`.
    [[nodiscard]] double folded(size_t face, const Vec3& most_look) const noexcept;
    /// Where the sheet looks, by its greater part: mean of the normals by area, or upwards.
    [[nodiscard]] Vec3 most_look() const noexcept;
    /// Middle of a face [m].
    [[nodiscard]] Vec2 middle(size_t face) const noexcept { return face_[face].middle; }
    /// Area of a face as it lies, not of its shadow [m2].
    [[nodiscard]] double area_m2(size_t face) const noexcept { return face_[face].area_m2; }

 private:
    struct Face {
        std::array<Vec2, 3> at{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
        Vec2 middle = Vec2::Zero();
        double radius_m = 0;  // of a circle about its middle that holds it
        Vec3 normal = Vec3::UnitZ();
        double area_m2 = 0;
    };
    static bool holds(const Face& face, const Vec2& p) noexcept;

    std::vector<Face> face_;
    std::vector<std::array<double, 2>> crossed_;  // by a ray; room for every face
};

/// A point of a closed line, and which way is out of it.
struct EdgePoint {
    Vec2 at_m = Vec2::Zero(), outward = Vec2::UnitX();
};

/// `count` points of a closed line (last != first), evenly spread along it from its first point.
/// @pre line.size() >= 3, count >= 1.
[[nodiscard]] std::vector<EdgePoint> points_of_edge(std::span<const Vec3> line, int count);

/// Points of a square lattice within a closed line [m].
[[nodiscard]] std::vector<Vec2> points_within(std::span<const Vec3> line, double spacing_m);

}  // namespace placode::sim
