// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tetrahedral meshes from files: Gmsh 1, 2.x and 4.1 (ascii and binary), legacy VTK (ascii and
// binary), VTU (ascii), TetGen (.node with .ele). Linear tetrahedra enter the solver, triangles
// where a scene makes a sheet of them; points, lines and other cells are skipped and counted.
// Broken elements are named with the number that they have in the file, and with its line.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/mesh/mesh.h"

namespace placode::sim {

/// One tetrahedron as the file has it.
struct FileTet {
    std::array<int32_t, 4> point{};  ///< Index into FileMesh::points.
    int64_t id = 0;                  ///< Its number in the file (0-based where it has none).
    int32_t line = 0;                ///< Line of the file, 0 in binary ones.
};

/// One triangle as the file has it.
struct FileTriangle {
    std::array<int32_t, 3> point{};  ///< Index into FileMesh::points, -1 = there is none.
    int64_t id = 0;                  ///< Its number in the file.
    int64_t group = 0;  ///< Physical group (Gmsh 1, 2), surface (Gmsh 4.1), 0 elsewhere.
};

/// What a file holds, nothing repaired.
struct FileMesh {
    std::string file;                     ///< For messages.
    std::string format;                   ///< "Gmsh 2.2 ascii", ...
    std::vector<Vec3> points;             ///< In the order of the file, in its unit.
    std::vector<int64_t> point_id;        ///< Number of each point in the file.
    std::vector<FileTet> tets;            ///< In the order of the file.
    std::vector<FileTriangle> triangles;  ///< Likewise.
    std::map<std::string, int> skipped;   ///< Cells that are no tetrahedra, by kind.
    std::vector<std::string> warnings;    ///< What was read in another way than it stands there.
};

/// Reads a mesh file; the ending decides: .msh, .vtk, .vtu, .node or .ele.
/// @throws MeshError naming file, line, what was found and what is expected.
[[nodiscard]] FileMesh read_mesh_file(const std::string& path);
/// The same for a file of which only the triangles count. @throws MeshError also without any.
[[nodiscard]] FileMesh read_triangle_file(const std::string& path);

/// A file's mesh made ready for the solver.
struct LoadedMesh {
    TetMesh mesh;
    std::vector<int32_t> vertex_of_point;  ///< (points of the file) -1 = used by no tet.
    std::vector<int64_t> tet_id;           ///< (T) number in the file.
    std::vector<std::string> warnings;     ///< What was skipped or repaired.
};

/// Scales to metres and checks. Repaired with a warning: all tets with the opposite orientation
/// (turned round), points that no tet uses (left out; they keep their number in
/// `vertex_of_point`). Said in a warning: tets inside each other, vertices on each other.
/// @param allow_disconnected accepts more than one connected component.
/// @throws MeshError listing by number: some inverted tets, degenerate tets, duplicates, faces with
/// more than two tets, points that are not finite, disconnected components.
[[nodiscard]] LoadedMesh prepare_mesh(const FileMesh& file, double scale, bool allow_disconnected,
                                      Tissue tissue = Tissue::kSubcutis);

// One reader for each format, called by read_mesh_file.
[[nodiscard]] FileMesh read_gmsh(const std::string& path);
[[nodiscard]] FileMesh read_legacy_vtk(const std::string& path);
[[nodiscard]] FileMesh read_vtu(const std::string& path);
[[nodiscard]] FileMesh read_tetgen(const std::string& path);

}  // namespace placode::sim
