// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the thread asks of one vertex of the tissue.

#include <span>

#include "sim/suture/thread_line.h"

namespace placode::sim {

/// Adds gradient and stiffness of all pieces that run through tets around the vertex.
/// @param entries ~(4 * passage + corner), in the order of the passages.
void add_thread(const ThreadLine& line, const ThreadState& thread, std::span<const int32_t> entries,
                VertexSystem& system) noexcept;
/// The vertex has moved.
void move_thread(ThreadLine& line, const ThreadState& thread, std::span<const int32_t> entries,
                 const Vec3& by) noexcept;

}  // namespace placode::sim
