// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which way a vertex slides onto the plane of blades: the shortest one at rest that leaves the
// body's shape as it is. What lies on the surface, on a crease of it or between two tissues stays
// there. Private to blade_slides.cpp.

#include <Eigen/LU>

#include "sim/cutting/blade_slides.h"
#include "sim/world/scratch.h"

namespace placode::sim {

class SlideChooser {
 public:
    SlideChooser(const Scene& scene, const State& state, const Scissors& blades,
                 const BladeReach& reach) noexcept
        : scene_(scene), state_(state), blades_(blades), reach_(reach) {}

    [[nodiscard]] Vec3 place(int32_t v) const noexcept { return met_at(blades_, state_.body, v); }
    /// True when the plane crosses an edge of the vertex between the blades.
    [[nodiscard]] bool crossed(int32_t vertex) const noexcept;
    /// shift_m < 0 where there is none.
    [[nodiscard]] SlideChoice choose(int32_t vertex) const noexcept;

 private:
    /// What lies around a vertex, or around an edge of it.
    struct Surroundings {
        uint32_t tissues = 0;
        int faces = 0;         // of the surface
        double least_cos = 1;  // between the first and another of them
        Vec3 normal = Vec3::Zero();

        void add_face(const Vec3& n) noexcept;
        [[nodiscard]] bool crease() const noexcept;
    };
    /// One vertex and the best so far.
    struct Search {
        int32_t vertex = -1;
        Vec3 at = Vec3::Zero();  // in T
        Surroundings here;
        bool strict = true;
        SlideChoice best;
    };
    [[nodiscard]] bool in_reach(const Vec3& p) const noexcept;
    [[nodiscard]] Surroundings look_around(int32_t vertex, int32_t other) const noexcept;
    [[nodiscard]] bool may_follow_edge(const Search& search, int32_t other) const noexcept;
    [[nodiscard]] bool may_enter_face(const Search& search, int32_t tet, int f) const noexcept;
    void try_all(Search& search) const noexcept;
    void try_tet(Search& search, int32_t tet) const noexcept;
    template <int N>
    void try_simplex(Search& search, const std::array<int32_t, 3>& towards) const noexcept;

    const Scene& scene_;
    const State& state_;
    const Scissors& blades_;
    const BladeReach& reach_;
};

}  // namespace placode::sim
