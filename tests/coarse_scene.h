// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace placode::test {

/// Changes of a scene to about 1,500 tets and two substeps: a field that a test can afford.
inline constexpr const char* kCoarseScene =
    R"({"edge_ring_m": 0.0014, "edge_placode_m": 0.0018, "edge_outer_m": 0.0032,
        "solver": {"substeps": 2}})";

}  // namespace placode::test
