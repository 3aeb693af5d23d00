// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "sim/core/number_text.h"

namespace placode::sim {
namespace {

/// Squared lengths of the six edges.
std::array<double, 6> squared_edges(const TetMesh& mesh, int t) {
    const auto& k = mesh.tets[static_cast<size_t>(t)];
    std::array<double, 6> out{};
    size_t n = 0;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = i + 1; j < 4; ++j) {
            out[n++] = (mesh.rest[static_cast<size_t>(k[i])] - mesh.rest[static_cast<size_t>(k[j])])
                           .squaredNorm();
        }
    }
    return out;
}

std::array<int32_t, 4> sorted(std::array<int32_t, 4> tet) {
    std::sort(tet.begin(), tet.end());
    return tet;
}

void check_tet(const TetMesh& mesh, int t) {
    const auto vertices = static_cast<int32_t>(mesh.rest.size());
    for (const int32_t v : mesh.tets[static_cast<size_t>(t)]) {
        if (v < 0 || v >= vertices) {
            throw MeshError("tet " + std::to_string(t) + ": vertex index " + std::to_string(v) +
                            " is outside 0 .. " + std::to_string(vertices - 1));
        }
    }
    double mean_edge = 0;
    for (const double l2 : squared_edges(mesh, t)) mean_edge += std::sqrt(l2) / 6;
    const double volume = rest_volume(mesh, t);
    const double least = 1e-9 * mean_edge * mean_edge * mean_edge;
    if (!(volume > least)) {
        throw MeshError("tet " + std::to_string(t) + ": volume " + rounded_text(volume * 1e9, 4) +
                        " mm^3 is inverted or degenerate, must be above 1e-9 of the cubed mean "
                        "edge (" +
                        rounded_text(mean_edge * 1e3, 4) + " mm)");
    }
}

/// Vertex graph through the tets, neighbours ascending.
std::vector<std::vector<int32_t>> vertex_graph(const TetMesh& mesh) {
    std::vector<std::vector<int32_t>> graph(mesh.rest.size());
    for (const auto& tet : mesh.tets) {
        for (const int32_t a : tet) {
            for (const int32_t b : tet) {
                if (a != b) graph[static_cast<size_t>(a)].push_back(b);
            }
        }
    }
    for (auto& list : graph) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return graph;
}

/// Breadth-first order from `start` over unplaced vertices, neighbours by degree, then index.
/// `seen` holds the number of the last search that met the vertex.
std::vector<int32_t> breadth_first(const std::vector<std::vector<int32_t>>& graph, int32_t start,
                                   std::vector<int32_t>& seen, int32_t mark) {
    std::vector<int32_t> order{start};
    seen[static_cast<size_t>(start)] = mark;
    std::vector<int32_t> next;
    for (size_t head = 0; head < order.size(); ++head) {
        next.clear();
        for (const int32_t v : graph[static_cast<size_t>(order[head])]) {
            if (seen[static_cast<size_t>(v)] == mark) continue;
            seen[static_cast<size_t>(v)] = mark;
            next.push_back(v);
        }
        std::stable_sort(next.begin(), next.end(), [&](int32_t a, int32_t b) {
            return graph[static_cast<size_t>(a)].size() < graph[static_cast<size_t>(b)].size();
        });
        order.insert(order.end(), next.begin(), next.end());
    }
    return order;
}

}  // namespace

double rest_volume(const TetMesh& mesh, int t) {
    const auto& k = mesh.tets[static_cast<size_t>(t)];
    const Vec3& x0 = mesh.rest[static_cast<size_t>(k[0])];
    const Vec3 e1 = mesh.rest[static_cast<size_t>(k[1])] - x0;
    const Vec3 e2 = mesh.rest[static_cast<size_t>(k[2])] - x0;
    const Vec3 e3 = mesh.rest[static_cast<size_t>(k[3])] - x0;
    return e1.dot(e2.cross(e3)) / 6;
}

double tet_quality(const TetMesh& mesh, int t) {
    const auto edges = squared_edges(mesh, t);
    const double rms = std::sqrt(std::accumulate(edges.begin(), edges.end(), 0.0) / 6);
    return rms > 0 ? 6 * std::sqrt(2.0) * rest_volume(mesh, t) / (rms * rms * rms) : 0;
}

void check_mesh(const TetMesh& mesh, const std::vector<uint8_t>& elsewhere) {
    if (mesh.tets.empty() && elsewhere.empty()) throw MeshError("the mesh has no tetrahedra");
    if (mesh.tissue.size() != mesh.tets.size()) {
        throw MeshError("tissue labels: " + std::to_string(mesh.tissue.size()) + ", must be one " +
                        "for each of the " + std::to_string(mesh.tets.size()) + " tets");
    }
    for (size_t v = 0; v < mesh.rest.size(); ++v) {
        if (!mesh.rest[v].allFinite()) {
            throw MeshError("vertex " + std::to_string(v) + ": position is not finite");
        }
    }
    std::vector<uint8_t> used(mesh.rest.size(), 0);
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
        check_tet(mesh, t);
        const auto label = static_cast<int>(mesh.tissue[static_cast<size_t>(t)]);
        if (label >= kTissueCount) {
            throw MeshError("tet " + std::to_string(t) + ": tissue label " + std::to_string(label) +
                            " is outside 0 .. " + std::to_string(kTissueCount - 1));
        }
        for (const int32_t v : mesh.tets[static_cast<size_t>(t)]) used[static_cast<size_t>(v)] = 1;
    }
    for (size_t v = 0; v < used.size(); ++v) {
        if (used[v] == 0 && (elsewhere.empty() || elsewhere[v] == 0)) {
            throw MeshError("vertex " + std::to_string(v) + " is used by no tet");
        }
    }
    std::vector<std::array<int32_t, 5>> keys;
    keys.reserve(mesh.tets.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto s = sorted(mesh.tets[t]);
        keys.push_back({s[0], s[1], s[2], s[3], static_cast<int32_t>(t)});
    }
    std::sort(keys.begin(), keys.end());
    for (size_t i = 1; i < keys.size(); ++i) {
        if (std::equal(keys[i].begin(), keys[i].begin() + 4, keys[i - 1].begin())) {
            throw MeshError("tets " + std::to_string(keys[i - 1][4]) + " and " +
                            std::to_string(keys[i][4]) + " are duplicates: same four vertices");
        }
    }
}

TetMesh box_mesh(const Vec3& size_m, const std::array<int, 3>& cells, Tissue tissue) {
    if (!(size_m.minCoeff() > 0) || *std::min_element(cells.begin(), cells.end()) < 1) {
        throw MeshError("box: sizes must be positive and every axis needs at least one cell");
    }
    TetMesh mesh;
    const std::array<int, 3> points{cells[0] + 1, cells[1] + 1, cells[2] + 1};
    const auto index = [&](int i, int j, int k) { return i + points[0] * (j + points[1] * k); };
    for (int k = 0; k < points[2]; ++k) {
        for (int j = 0; j < points[1]; ++j) {
            for (int i = 0; i < points[0]; ++i) {
                mesh.rest.emplace_back(size_m.x() * i / cells[0], size_m.y() * j / cells[1],
                                       size_m.z() * k / cells[2]);
            }
        }
    }
    // Kuhn split: one tet for each order in which the three axes are walked from corner 000 to 111.
    // All cells use the same diagonal, so neighbours conform. Odd orders are turned round.
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int k = 0; k < cells[2]; ++k) {
        for (int j = 0; j < cells[1]; ++j) {
            for (int i = 0; i < cells[0]; ++i) {
                for (size_t o = 0; o < kOrders.size(); ++o) {
                    std::array<int, 3> at{i, j, k};
                    std::array<int32_t, 4> tet{index(i, j, k), 0, 0, 0};
                    for (size_t s = 0; s < 3; ++s) {
                        ++at[static_cast<size_t>(kOrders[o][s])];
                        tet[s + 1] = index(at[0], at[1], at[2]);
                    }
                    if (o >= 3) std::swap(tet[1], tet[2]);
                    mesh.tets.push_back(tet);
                }
            }
        }
    }
    mesh.tissue.assign(mesh.tets.size(), tissue);
    return mesh;
}

std::vector<int32_t> rcm_order(const TetMesh& mesh) {
    const auto graph = vertex_graph(mesh);
    const size_t n = graph.size();
    std::vector<int32_t> order;
    order.reserve(n);
    std::vector<uint8_t> placed(n, 0);
    std::vector<int32_t> seen(n, 0);
    int32_t mark = 0;
    for (size_t first = 0; first < n; ++first) {
        if (placed[first] != 0) continue;
        // Pseudo-peripheral start (George and Liu): walk to the far end a few times.
        auto start = static_cast<int32_t>(first);
        for (int pass = 0; pass < 4; ++pass)
            start = breadth_first(graph, start, seen, ++mark).back();
        for (const int32_t v : breadth_first(graph, start, seen, ++mark)) {
            placed[static_cast<size_t>(v)] = 1;
            order.push_back(v);
        }
    }
    std::reverse(order.begin(), order.end());
    return order;
}

TetMesh renumbered(const TetMesh& mesh, const std::vector<int32_t>& order) {
    if (order.size() != mesh.rest.size()) {
        throw MeshError("renumbering: " + std::to_string(order.size()) + " numbers for " +
                        std::to_string(mesh.rest.size()) + " vertices");
    }
    TetMesh out;
    std::vector<int32_t> new_of_old(order.size(), -1);
    for (size_t i = 0; i < order.size(); ++i) {
        const auto old = static_cast<size_t>(order[i]);
        if (old >= order.size() || new_of_old[old] != -1) {
            throw MeshError("renumbering: entry " + std::to_string(i) + " is not a permutation");
        }
        new_of_old[old] = static_cast<int32_t>(i);
        out.rest.push_back(mesh.rest[old]);
    }
    std::vector<std::array<int32_t, 4>> tets = mesh.tets;
    for (auto& tet : tets) {
        for (auto& v : tet) v = new_of_old[static_cast<size_t>(v)];
    }
    std::vector<size_t> rank(tets.size());
    std::iota(rank.begin(), rank.end(), size_t{0});
    std::stable_sort(rank.begin(), rank.end(),
                     [&](size_t a, size_t b) { return sorted(tets[a]) < sorted(tets[b]); });
    for (const size_t t : rank) {
        out.tets.push_back(tets[t]);
        out.tissue.push_back(mesh.tissue[t]);
    }
    return out;
}

}  // namespace placode::sim
