// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The vectorised kernels, dispatched at run time to the widest instruction set. Internal to
// the solver. Results are the same bits at any number of threads; two instruction sets differ in
// rounding (fused multiply-add) only.

#include "sim/solver/kernel_layout.h"

namespace placode::sim {

/// What a kernel reads and writes.
struct KernelArguments {
    const KernelLayout* packed = nullptr;
    Float4* x = nullptr;
    const Float4* x_start = nullptr;
    const Float4* v = nullptr;
    Float4* x_low = nullptr;  ///< nullptr: positions are rounded (SoftBodyState::x_low).
    const Float4* x_start_low = nullptr;
    float* lanes = nullptr;
    const float* springs = nullptr;
    float h = 0;  ///< [s]
    float over_relaxation = 1;
    std::array<float, 3> planned_fall_m{};  ///< h^2 g
    int direction = 1;                      ///< XPBD: -1 = from the last batch to the first.
};

/// What the begin and end of a substep read and write. The fourth number of `fall_m_s` is 0.
struct MotionArguments {
    Float4 *x = nullptr, *v = nullptr, *x_start = nullptr;
    const uint8_t* free_vertex = nullptr;
    const float* damping_per_s = nullptr;
    float h = 0;                      ///< [s]
    std::array<float, 4> fall_m_s{};  ///< h g
    bool gravity_in_guess = false;    ///< For every vertex, not only for free ones.
    bool fused = false;               ///< kernels_fuse(), for what is done by hand.
};

/// Whether the kernels of the chosen instruction set round a product and a sum once.
bool kernels_fuse() noexcept;

/// x_start and start guess of vertices from `first` on. Returns the first vertex that is
/// not done: `last`, fewer than a register of them are left, or one is not finite or differs from
/// its neighbours in being free.
size_t begin_motion(const MotionArguments& arguments, size_t first, size_t last) noexcept;

/// Velocities from positions, likewise.
size_t end_motion(const MotionArguments& arguments, size_t first, size_t last) noexcept;

/// Vertex block descent over batches [first, last) of one colour. Returns StepFlag bits.
uint32_t solve_vertex_batches(const KernelArguments& arguments, int first, int last) noexcept;

/// The same over sheet batches [first, last) of one colour (sheet_strips.h).
uint32_t solve_sheet_batches(const KernelArguments& arguments, int first, int last) noexcept;

/// XPBD's anchor springs at vertex batches [first, last), which may be of any colour: a spring
/// moves its own vertex only.
void solve_spring_batches(const KernelArguments& arguments, int first, int last) noexcept;

/// XPBD over tet batches [first, last) of one job.
void solve_tet_batches(const KernelArguments& arguments, int first, int last) noexcept;

/// The same, with the two constraints of a tet one after the other (xpbd_pair.cpp).
void solve_tet_batches_in_pairs(const KernelArguments& arguments, int first, int last) noexcept;

}  // namespace placode::sim
