// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers of vertices, tets and triangles are int32_t or int64_t; the standard library counts in
// size_t.

#include <cstddef>
#include <cstdint>

namespace placode::sim {

/// A number as an index into a container. @pre i >= 0
[[nodiscard]] constexpr size_t as_index(int64_t i) noexcept { return static_cast<size_t>(i); }

}  // namespace placode::sim
