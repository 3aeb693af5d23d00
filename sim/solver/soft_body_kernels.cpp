// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for every instruction set: Highway includes this file again and again.
#include "sim/solver/soft_body_kernels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "sim/core/event.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/soft_body_kernels.cpp"
#include <hwy/foreach_target.h>
// Below foreach_target on purpose.
#include <hwy/highway.h>

#include "sim/solver/motion_kernel-inl.h"
#include "sim/solver/tet_kernel-inl.h"
#include "sim/solver/vertex_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

uint32_t VertexBatches(const KernelArguments& arguments, int first, int last) {
    uint32_t flags = 0;
    for (int b = first; b < last; ++b) {
        flags |= arguments.x_low != nullptr ? SolveVertexBatch<true, false>(arguments, b)
                                            : SolveVertexBatch<false, false>(arguments, b);
    }
    return flags;
}

uint32_t SheetBatches(const KernelArguments& arguments, int first, int last) {
    uint32_t flags = 0;
    for (int i = first; i < last; ++i) {
        const SheetBatch& b = arguments.packed->sheet_strips.batches[static_cast<size_t>(i)];
        flags |= arguments.x_low != nullptr ? SolveVertexBatch<true, true>(arguments, b.batch, &b)
                                            : SolveVertexBatch<false, true>(arguments, b.batch, &b);
    }
    return flags;
}

void SpringBatches(const KernelArguments& arguments, int first, int last) {
    for (int b = first; b < last; ++b) SolveSpringBatch(arguments, b);
}

void TetBatches(const KernelArguments& arguments, int first, int last) {
    SolveTetJob<BlockProjection>(arguments, first, last);
}

size_t BeginVertices(const MotionArguments& arguments, size_t first, size_t last) {
    return BeginMotion(arguments, first, last);
}

size_t EndVertices(const MotionArguments& arguments, size_t first, size_t last) {
    return EndMotion(arguments, first, last);
}

bool Fuses() { return HWY_NATIVE_FMA != 0; }

const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace placode::sim {

HWY_EXPORT(VertexBatches);
HWY_EXPORT(SheetBatches);
HWY_EXPORT(SpringBatches);
HWY_EXPORT(TetBatches);
HWY_EXPORT(BeginVertices);
HWY_EXPORT(EndVertices);
HWY_EXPORT(Fuses);
HWY_EXPORT(Name);

uint32_t solve_vertex_batches(const KernelArguments& arguments, int first, int last) noexcept {
    return HWY_DYNAMIC_DISPATCH(VertexBatches)(arguments, first, last);
}

uint32_t solve_sheet_batches(const KernelArguments& arguments, int first, int last) noexcept {
    return HWY_DYNAMIC_DISPATCH(SheetBatches)(arguments, first, last);
}

void solve_spring_batches(const KernelArguments& arguments, int first, int last) noexcept {
    HWY_DYNAMIC_DISPATCH(SpringBatches)(arguments, first, last);
}

void solve_tet_batches(const KernelArguments& arguments, int first, int last) noexcept {
    HWY_DYNAMIC_DISPATCH(TetBatches)(arguments, first, last);
}

size_t begin_motion(const MotionArguments& arguments, size_t first, size_t last) noexcept {
    return HWY_DYNAMIC_DISPATCH(BeginVertices)(arguments, first, last);
}

size_t end_motion(const MotionArguments& arguments, size_t first, size_t last) noexcept {
    return HWY_DYNAMIC_DISPATCH(EndVertices)(arguments, first, last);
}

bool kernels_fuse() noexcept { return HWY_DYNAMIC_DISPATCH(Fuses)(); }

const char* kernel_target() noexcept { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace placode::sim
#endif  // HWY_ONCE
