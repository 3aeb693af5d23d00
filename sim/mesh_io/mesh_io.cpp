// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh_io/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <optional>

#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/mesh_io/file_cursor.h"
#include "sim/mesh_io/mesh_overlap.h"

namespace placode::sim {
namespace {

/// The first ten of a list of numbers, and how many there are.
class NumberList {
 public:
    void add(const FileTet& tet, const std::string& more = "") {
        if (++count_ <= kShown)
            text_ += (text_.empty() ? "" : ", ") + std::to_string(tet.id) + place_of(tet) + more;
    }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] std::string text() const { return text_ + (count_ > kShown ? ", ..." : ""); }

 private:
    static constexpr int kShown = 10;
    int count_ = 0;
    std::string text_;
};

double signed_volume(const FileMesh& file, const FileTet& tet) {
    const Vec3& a = file.points[as_index(tet.point[0])];
    const Vec3 b = file.points[as_index(tet.point[1])] - a,
               c = file.points[as_index(tet.point[2])] - a,
               d = file.points[as_index(tet.point[3])] - a;
    return b.dot(c.cross(d)) / 6;
}

double mean_edge(const FileMesh& file, const FileTet& tet) {
    double sum = 0;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = 0; j < i; ++j) {
            sum +=
                (file.points[as_index(tet.point[i])] - file.points[as_index(tet.point[j])]).norm();
        }
    }
    return sum / 6;
}

/// Adds one kind of mistake to what is said at the end.
void add_problem(std::string& problems, const std::string& text) {
    problems += (problems.empty() ? "" : "; ") + text;
}

/// Two corners that are one point; such a tet has no volume whatever its points are.
std::optional<std::pair<size_t, size_t>> same_corners(const FileTet& tet) {
    for (size_t i = 1; i < 4; ++i) {
        for (size_t j = 0; j < i; ++j) {
            if (tet.point[i] == tet.point[j]) return std::pair{j, i};
        }
    }
    return std::nullopt;
}

void check_corners(const FileMesh& file, std::string& problems) {
    NumberList twice;
    for (const FileTet& tet : file.tets) {
        if (const auto same = same_corners(tet))
            twice.add(tet, ": corners " + std::to_string(same->first + 1) + " and " +
                               std::to_string(same->second + 1) + " are both point " +
                               std::to_string(file.point_id[as_index(tet.point[same->first])]));
    }
    if (twice.count() > 0)
        add_problem(problems, std::to_string(twice.count()) +
                                  " tetrahedra without four different points: number " +
                                  twice.text());
}

/// Finds degenerate and some inverted tets; true when all are turned the other way.
bool check_volumes(const FileMesh& file, std::string& problems) {
    NumberList flat, inverted;
    for (const FileTet& tet : file.tets) {
        const double edge = mean_edge(file, tet), volume = signed_volume(file, tet);
        // Relative: the unit of the file does not matter. As in check_mesh.
        if (!(std::abs(volume) > 1e-9 * edge * edge * edge)) {
            if (!same_corners(tet)) flat.add(tet);
        } else if (volume < 0) {
            inverted.add(tet);
        }
    }
    if (flat.count() > 0)
        add_problem(problems, std::to_string(flat.count()) + " degenerate tetrahedra: number " +
                                  flat.text() +
                                  " (the volume must be above 1e-9 of the cubed mean edge)");
    if (inverted.count() > 0 && inverted.count() < static_cast<int>(file.tets.size()))
        add_problem(problems, std::to_string(inverted.count()) + " of " +
                                  std::to_string(file.tets.size()) +
                                  " tetrahedra are inverted: number " + inverted.text() +
                                  " (the volume must be above 0 in all; if it is below 0 in all, "
                                  "they are turned round)");
    return inverted.count() > 0;
}

/// Returns which tets are there a second time (T).
std::vector<uint8_t> check_duplicates(const FileMesh& file, std::string& problems) {
    std::vector<uint8_t> second(file.tets.size(), 0);
    std::vector<std::pair<std::array<int32_t, 4>, int32_t>> keys;
    for (size_t t = 0; t < file.tets.size(); ++t) {
        auto key = file.tets[t].point;
        std::sort(key.begin(), key.end());
        keys.emplace_back(key, static_cast<int32_t>(t));
    }
    std::sort(keys.begin(), keys.end());
    NumberList same;
    for (size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].first != keys[i - 1].first) continue;
        second[as_index(keys[i].second)] = 1;
        const FileTet& first = file.tets[as_index(keys[i - 1].second)];
        same.add(file.tets[as_index(keys[i].second)],
                 " = " + std::to_string(first.id) + place_of(first));
    }
    if (same.count() > 0)
        add_problem(problems, std::to_string(same.count()) +
                                  " duplicate tetrahedra (same four points): number " +
                                  same.text());
    return second;
}

/// A face belongs to one tet at the boundary and to two inside. @param left_out (T) tets that are
/// known to be wrong.
void check_faces(const FileMesh& file, const std::vector<uint8_t>& left_out,
                 std::string& problems) {
    std::vector<std::pair<std::array<int32_t, 3>, int32_t>> faces;
    for (size_t t = 0; t < file.tets.size(); ++t) {
        if (left_out[t] != 0 || same_corners(file.tets[t])) continue;
        for (size_t skip = 0; skip < 4; ++skip) {
            std::array<int32_t, 3> face{};
            for (size_t i = 0, n = 0; i < 4; ++i) {
                if (i != skip) face[n++] = file.tets[t].point[i];
            }
            std::sort(face.begin(), face.end());
            faces.emplace_back(face, static_cast<int32_t>(t));
        }
    }
    std::sort(faces.begin(), faces.end());
    std::vector<int32_t> overlapping;
    for (size_t i = 2; i < faces.size(); ++i) {
        if (faces[i].first != faces[i - 2].first) continue;
        for (size_t k = 0; k < 3; ++k) overlapping.push_back(faces[i - k].second);
    }
    std::sort(overlapping.begin(), overlapping.end());
    overlapping.erase(std::unique(overlapping.begin(), overlapping.end()), overlapping.end());
    NumberList crowded;
    for (const int32_t t : overlapping) crowded.add(file.tets[as_index(t)]);
    if (crowded.count() > 0)
        add_problem(problems,
                    "more than two tetrahedra at one face, so that some of them overlap: number " +
                        crowded.text());
}

/// Size of every component, largest first, with a point of it.
std::vector<std::pair<int, int32_t>> components(const FileMesh& file) {
    std::vector<int32_t> parent(file.points.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int32_t v) {
        while (parent[as_index(v)] != v)
            v = parent[as_index(v)] = parent[as_index(parent[as_index(v)])];
        return v;
    };
    for (const FileTet& tet : file.tets) {
        for (size_t k = 1; k < 4; ++k) parent[as_index(root(tet.point[k]))] = root(tet.point[0]);
    }
    std::map<int32_t, int> size;
    for (const FileTet& tet : file.tets) ++size[root(tet.point[0])];
    std::vector<std::pair<int, int32_t>> out;
    for (const auto& [point, tets] : size) out.emplace_back(tets, point);
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    return out;
}

void check_connected(const FileMesh& file, bool allow, std::vector<std::string>& warnings,
                     std::string& problems) {
    const auto parts = components(file);
    if (parts.size() < 2) return;
    std::string sizes;
    for (size_t i = 0; i < std::min<size_t>(parts.size(), 5); ++i) {
        sizes += (i > 0 ? ", " : "") + std::to_string(parts[i].first) + " tets (around point " +
                 std::to_string(file.point_id[as_index(parts[i].second)]) + ")";
    }
    const std::string text = std::to_string(parts.size()) +
                             " pieces that do not hang together: " + sizes +
                             (parts.size() > 5 ? ", ..." : "");
    if (allow) {
        warnings.push_back(text);
    } else {
        add_problem(problems, text + " (expected 1; \"allow_disconnected\": true accepts more)");
    }
}

FileMesh read_any(const std::string& path) {
    const size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending == ".msh") return read_gmsh(path);
    if (ending == ".vtk") return read_legacy_vtk(path);
    if (ending == ".vtu") return read_vtu(path);
    if (ending == ".node" || ending == ".ele") return read_tetgen(path);
    throw MeshError(path + ": ending \"" + ending +
                    "\"; expected .msh (Gmsh), .vtk, .vtu, or .node (TetGen, with .ele)");
}

/// "; found 12 triangle, 3 line".
std::string found_in(const FileMesh& mesh) {
    std::string found;
    if (!mesh.tets.empty()) found = "; found " + std::to_string(mesh.tets.size()) + " tetrahedron";
    for (const auto& [kind, n] : mesh.skipped)
        found += (found.empty() ? "; found " : ", ") + std::to_string(n) + " " + kind;
    return found;
}

}  // namespace

FileMesh read_mesh_file(const std::string& path) {
    FileMesh out = read_any(path);
    if (out.tets.empty())
        throw MeshError(out.file + ": no tetrahedra" + found_in(out) + "; expected at least 1");
    return out;
}

FileMesh read_triangle_file(const std::string& path) {
    FileMesh out = read_any(path);
    if (out.triangles.empty())
        throw MeshError(out.file + ": no triangles" + found_in(out) + "; expected at least 1");
    return out;
}

LoadedMesh prepare_mesh(const FileMesh& file, double scale, bool allow_disconnected,
                        Tissue tissue) {
    LoadedMesh out;
    out.warnings = file.warnings;
    for (const auto& [kind, n] : file.skipped)
        out.warnings.push_back("skipped " + std::to_string(n) + " cells: " + kind);
    std::string problems;
    check_corners(file, problems);
    const bool turn = check_volumes(file, problems);
    const std::vector<uint8_t> second = check_duplicates(file, problems);
    check_faces(file, second, problems);
    check_connected(file, allow_disconnected, out.warnings, problems);
    if (!problems.empty()) throw MeshError(file.file + ": " + problems + "; repair the mesh");
    if (turn)
        out.warnings.emplace_back(
            "all tetrahedra have the opposite orientation: they were turned round");
    for (std::string& warning : overlap_warnings(file)) out.warnings.push_back(std::move(warning));

    out.vertex_of_point.assign(file.points.size(), -1);
    for (const FileTet& tet : file.tets) {
        for (const int32_t p : tet.point) out.vertex_of_point[as_index(p)] = 0;
    }
    int unused = 0;
    std::string some;
    for (size_t p = 0; p < file.points.size(); ++p) {
        if (out.vertex_of_point[p] < 0) {
            if (++unused <= 10)
                some += (some.empty() ? "" : ", ") + std::to_string(file.point_id[p]);
            continue;
        }
        out.vertex_of_point[p] = static_cast<int32_t>(out.mesh.rest.size());
        const Vec3 x = scale * file.points[p];
        for (int a = 0; a < 3; ++a) {
            if (!std::isfinite(x[a]))
                throw MeshError(file.file + ": point " + std::to_string(file.point_id[p]) + ": " +
                                "xyz"[a] + " = " + shortest_text(file.points[p][a]) +
                                " times scale " + shortest_text(scale) + " is not finite");
        }
        out.mesh.rest.push_back(x);
    }
    if (unused > 0)
        out.warnings.push_back(
            std::to_string(unused) + " points are used by no tetrahedron: " + "number " + some +
            (unused > 10 ? ", ..." : "") + "; they take no part and keep their place");
    for (const FileTet& tet : file.tets) {
        std::array<int32_t, 4> t{};
        for (size_t k = 0; k < 4; ++k) t[k] = out.vertex_of_point[as_index(tet.point[k])];
        if (turn) std::swap(t[0], t[1]);
        out.mesh.tets.push_back(t);
        out.tet_id.push_back(tet.id);
    }
    out.mesh.tissue.assign(out.mesh.tets.size(), tissue);
    check_mesh(out.mesh);
    return out;
}

}  // namespace placode::sim
