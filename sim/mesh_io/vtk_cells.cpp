// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh_io/vtk_cells.h"

namespace placode::sim {
namespace {

constexpr int64_t kTriangle = 5, kTetrahedron = 10, kQuadraticTetrahedron = 24;

/// Names of the cell types of vtkCellType.h.
const char* cell_name(int64_t type) {
    switch (type) {
        case 1:
        case 2:
            return "point";
        case 3:
        case 4:
        case 21:
            return "line";
        case 5:
        case 6:
        case 22:
            return "triangle";
        case 7:
        case 8:
        case 9:
        case 23:
            return "quadrangle";
        case 11:
        case 12:
        case 25:
            return "hexahedron";
        case 13:
        case 26:
            return "prism";
        case 14:
        case 27:
            return "pyramid";
        default:
            return "other cell";
    }
}

int32_t line_at(const std::vector<int32_t>& lines, size_t i) {
    return i < lines.size() ? lines[i] : 0;
}

}  // namespace

void add_vtk_cells(const VtkCells& cells, const FileCursor& cursor, FileMesh& out,
                   int64_t first_point, int64_t first_cell) {
    const auto fail = [&](int32_t line, const std::string& message) {
        if (line > 0) cursor.fail_at(line, message);
        throw MeshError(cursor.file() + ": " + message);
    };
    const size_t n = cells.types.size();
    if (cells.offsets.size() != n + 1)
        fail(cells.line, std::to_string(cells.offsets.size() - 1) + " cells, but " +
                             std::to_string(n) + " cell types");
    const auto points = static_cast<int64_t>(out.points.size()) - first_point;
    int quadratic = 0;
    for (size_t c = 0; c < n; ++c) {
        const int64_t from = cells.offsets[c], to = cells.offsets[c + 1];
        const int64_t id = first_cell + static_cast<int64_t>(c);
        const std::string name = "cell " + std::to_string(id);
        if (from < 0 || to < from || to > static_cast<int64_t>(cells.connectivity.size()))
            fail(line_at(cells.offsets_line, c + 1), name + ": offsets " + std::to_string(from) +
                                                         " to " + std::to_string(to) +
                                                         " do not fit the connectivity of " +
                                                         std::to_string(cells.connectivity.size()));
        const int32_t line = line_at(cells.connectivity_line, static_cast<size_t>(from));
        if (cells.types[c] != kTetrahedron && cells.types[c] != kQuadraticTetrahedron) {
            ++out.skipped[cell_name(cells.types[c])];
            if (cells.types[c] != kTriangle) continue;
            // A broken triangle is an error where it is used.
            FileTriangle triangle{{-1, -1, -1}, id, 0};
            for (size_t k = 0; k < 3 && to - from == 3; ++k) {
                const int64_t p = cells.connectivity[static_cast<size_t>(from) + k];
                if (p >= 0 && p < points) triangle.point[k] = static_cast<int32_t>(first_point + p);
            }
            out.triangles.push_back(triangle);
            continue;
        }
        const bool second = cells.types[c] == kQuadraticTetrahedron;
        if (to - from != (second ? 10 : 4))
            fail(line, name + ": " + std::to_string(to - from) + " points; a tetrahedron has " +
                           (second ? "10" : "4"));
        quadratic += second ? 1 : 0;
        FileTet tet;
        tet.id = id;
        tet.line = line;
        for (size_t k = 0; k < 4; ++k) {
            const int64_t p = cells.connectivity[static_cast<size_t>(from) + k];
            if (p < 0 || p >= points)
                fail(line_at(cells.connectivity_line, static_cast<size_t>(from) + k),
                     name + ": no point " + std::to_string(p) + "; the points are numbered 0 to " +
                         std::to_string(points - 1));
            tet.point[k] = static_cast<int32_t>(first_point + p);
        }
        out.tets.push_back(tet);
    }
    if (quadratic > 0)
        out.warnings.push_back(std::to_string(quadratic) +
                               " tetrahedra of second order: their corners are used");
}

}  // namespace placode::sim
