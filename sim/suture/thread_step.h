// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The thread's part of a substep, around those of needle and vertices (suture_step.h).

#include "sim/suture/thread_channel.h"

namespace placode::sim {

/// Slides, books, pulls. A free end that has come to a channel's mouth goes in and, in the end,
/// out.
void finish_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   ThreadLine& line, SutureReport& report) noexcept;

/// Stored in its pieces at the end of the last substep [J].
[[nodiscard]] double thread_energy(const ThreadState& thread) noexcept;

}  // namespace placode::sim
