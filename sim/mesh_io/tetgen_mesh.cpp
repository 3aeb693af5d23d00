// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// TetGen: points in NAME.node, tetrahedra in NAME.ele; numbers start at 0 or 1, '#' comments.
// Source: TetGen manual, "File formats".

#include "sim/mesh_io/file_cursor.h"

namespace placode::sim {
namespace {

/// A count that is too small would drop what follows.
void expect_end(FileCursor& in, int64_t n, const char* what) {
    if (in.at_end()) return;
    in.fail("found \"" + std::string(in.peek()) + "\" behind the " + std::to_string(n) + " " +
            what + " that the first line counts; expected the end of the file");
}

void read_nodes(FileCursor& in, FileMesh& out, PointNumbers& numbers) {
    in.hash_comments(true);
    const int64_t n = counted(in, "points");
    const int64_t dimension = in.whole("the dimension");
    if (dimension != 3) in.fail("dimension " + std::to_string(dimension) + "; expected 3");
    const int64_t attributes = in.count("the number of attributes");
    const int64_t markers = in.count("the number of boundary markers");
    if (n == 0)
        in.fail("0 points: they are in the .poly or .smesh file; let TetGen write them out");
    for (int64_t i = 0; i < n; ++i) {
        const int64_t id = in.whole("a point number");
        Vec3 x;
        for (int c = 0; c < 3; ++c) x[c] = in.real("a coordinate");
        in.check_point(id, x);
        for (int64_t k = 0; k < attributes + markers; ++k) (void)in.real("an attribute");
        numbers.add(id, static_cast<int32_t>(out.points.size()), in);
        out.points.push_back(x);
        out.point_id.push_back(id);
    }
    expect_end(in, n, "points");
}

void read_elements(FileCursor& in, FileMesh& out, const PointNumbers& numbers) {
    in.hash_comments(true);
    const int64_t n = counted(in, "tetrahedra");
    const int64_t corners = in.whole("points per tetrahedron");
    if (corners != 4 && corners != 10)
        in.fail(std::to_string(corners) + " points per tetrahedron; expected 4 or 10");
    const int64_t attributes = in.count("the number of attributes");
    for (int64_t i = 0; i < n; ++i) {
        FileTet tet;
        tet.id = in.whole("a tetrahedron number");
        tet.line = in.line();
        for (int64_t k = 0; k < corners; ++k) {
            const int64_t point = in.whole("a point number");
            if (k < 4)
                tet.point[static_cast<size_t>(k)] =
                    numbers.index(point, "tetrahedron " + std::to_string(tet.id), in);
        }
        for (int64_t k = 0; k < attributes; ++k) (void)in.real("an attribute");
        out.tets.push_back(tet);
    }
    expect_end(in, n, "tetrahedra");
    if (corners == 10 && n > 0)
        out.warnings.push_back(std::to_string(n) +
                               " tetrahedra of second order: their corners are used");
}

}  // namespace

FileMesh read_tetgen(const std::string& path) {
    const std::string stem = path.substr(0, path.rfind('.'));
    FileMesh out;
    out.file = stem + ".ele";
    out.format = "TetGen";
    PointNumbers numbers;
    FileCursor nodes(stem + ".node");
    read_nodes(nodes, out, numbers);
    FileCursor elements(stem + ".ele");
    read_elements(elements, out, numbers);
    return out;
}

}  // namespace placode::sim
