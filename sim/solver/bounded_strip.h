// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// link_strip without memory from the heap, for links that change while the simulation runs.

#include <array>
#include <cstdint>
#include <span>

#include "sim/solver/link_strip.h"

namespace placode::sim {

/// A strip over at most 96 triangles. Greedy from the first triangle with each vertex last; the
/// shortest of the three wins. LinkTriangle::tet must number the triangles 0, 1, 2, ...
class BoundedStrip {
 public:
    static constexpr int kMostTriangles = 96;

    void build(std::span<const LinkTriangle> triangles) noexcept;
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] const StripStep& operator[](int32_t step) const noexcept {
        return steps_[static_cast<size_t>(step)];
    }
    /// Step at which triangle `tet` is met.
    [[nodiscard]] int step_of(size_t tet) const noexcept { return met_[tet]; }

 private:
    void find_neighbours() noexcept;
    void run(size_t first, int last_corner) noexcept;
    [[nodiscard]] int32_t corner(size_t f, int k) const noexcept {
        return triangles_[f].vertex[static_cast<size_t>(k % 3)];
    }
    [[nodiscard]] int local(size_t f, int32_t vertex) const noexcept;
    [[nodiscard]] int open_sides(size_t f) const noexcept;
    void load(int32_t vertex, bool keep) noexcept;
    [[nodiscard]] int enter(size_t f) noexcept;
    void choose_older(bool keep) noexcept;
    [[nodiscard]] int follow(int current) noexcept;
    [[nodiscard]] int restart() noexcept;

    std::span<const LinkTriangle> triangles_;
    std::array<std::array<int8_t, 3>, kMostTriangles> neighbours_{};
    std::array<StripStep, size_t{3} * kMostTriangles> steps_{}, best_{};
    std::array<int16_t, kMostTriangles> met_{}, best_met_{};
    std::array<uint8_t, kMostTriangles> visited_{};
    std::array<int32_t, 2> pair_{-1, -1}, before_{-1, -1};
    int size_ = 0, left_ = 0;
};

}  // namespace placode::sim
