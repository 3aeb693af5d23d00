// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What legacy VTK and VTU files have in common: cells as connectivity, offsets and types.
// Private to sim/mesh_io.

#include "sim/mesh_io/file_cursor.h"

namespace placode::sim {

/// Cell c holds connectivity[offsets[c]] .. [offsets[c + 1] - 1].
struct VtkCells {
    std::vector<int64_t> connectivity, offsets, types;
    // Lines of the file; empty or 0 = unknown, as in binary files.
    std::vector<int32_t> connectivity_line, offsets_line;  ///< Of each entry.
    int32_t line = 0;                                      ///< Of CELLS or <Piece>.
    bool known = false, types_known = false;
};

/// Adds the tetrahedra to `out` and counts the rest. @param first_point index of the piece's first
/// point. @param first_cell number of its first cell in the file. @throws MeshError through
/// `cursor` for sizes that contradict each other and points that do not exist.
void add_vtk_cells(const VtkCells& cells, const FileCursor& cursor, FileMesh& out,
                   int64_t first_point = 0, int64_t first_cell = 0);

}  // namespace placode::sim
