// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The kernels choose the widest instruction set of the processor at start; a test tries them all.

#include <hwy/highway.h>

#include <cstdint>

namespace placode::test {

/// Calls `what` with the kernels of each instruction set that this processor has; the widest one
/// is chosen again at the end. Returns how many there were.
template <class What>
int with_every_instruction_set(What&& what) {
    int tried = 0;
    for (const int64_t target : {HWY_SCALAR, HWY_SSSE3, HWY_SSE4, HWY_AVX2, HWY_AVX3}) {
        hwy::SetSupportedTargetsForTest(0);
        if ((hwy::SupportedTargets() & target) == 0) continue;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        what();
        ++tried;
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return tried;
}

}  // namespace placode::test
