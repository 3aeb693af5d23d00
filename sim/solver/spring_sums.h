// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Anchor springs as the kernels take them: the springs of a vertex are one, force = -(K (x - rest)
// + f0), summed in double. Internal to the solver.

#include <vector>

#include "sim/solver/kernel_layout.h"

namespace placode::sim {

class SpringSums {
 public:
    /// Lists in `packed` the vertices that springs hold.
    SpringSums(const SoftBody& body, KernelLayout& packed);

    /// True when a spring was given for vertex `v`, even one without stiffness.
    [[nodiscard]] bool holds(int32_t v) const { return of_[static_cast<size_t>(v)] >= 0; }
    /// Appends the springs of a batch, if it has any, and tells it where they stand.
    void add(const SoftBody& body, VertexBatch& b, KernelLayout& packed) const;

 private:
    std::vector<int32_t> of_;  // (V) into k_ and f_, -1 = none
    std::vector<Mat3> k_;
    std::vector<Vec3> f_;
};

}  // namespace placode::sim
