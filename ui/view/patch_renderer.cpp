// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/patch_renderer.h"

#include <algorithm>

#include "ui/view/tissue_mesh.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

using namespace sim;
namespace {

Vec3 at_mm(const std::array<float, 3>& p) {
    return 1000 *
           Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

}  // namespace

void PatchMesh::find_rim(const Snapshot& snapshot, int32_t first, size_t count) {
    if (rim_triangles_ == snapshot.patch.size() && rim_.size() == count) return;
    std::vector<std::array<int32_t, 2>> edges;
    for (const auto& t : snapshot.patch)
        for (size_t k = 0; k < 3; ++k)
            edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    std::sort(edges.begin(), edges.end());
    rim_.assign(count, 0);
    for (size_t i = 0; i < edges.size(); ++i) {
        const bool shared = (i > 0 && edges[i - 1] == edges[i]) ||
                            (i + 1 < edges.size() && edges[i + 1] == edges[i]);
        if (shared) continue;
        for (const int32_t v : edges[i]) rim_[static_cast<size_t>(v - first)] = 1;
    }
    // So small that nothing lies inside, it has no edge to be seen.
    if (std::all_of(rim_.begin(), rim_.end(), [](float r) { return r > 0; })) rim_.assign(count, 0);
    rim_triangles_ = snapshot.patch.size();
    find_corners(snapshot, first);
}

void PatchMesh::build(const Snapshot& snapshot, const std::vector<std::array<float, 3>>& rest) {
    vertices.clear();
    indices.clear();
    if (snapshot.patch.empty()) return;
    // Vertices of a patch follow each other behind those of the tissue.
    int32_t first = snapshot.patch[0][0], last = first;
    for (const auto& t : snapshot.patch) {
        first = std::min(first, *std::min_element(t.begin(), t.end()));
        last = std::max(last, *std::max_element(t.begin(), t.end()));
    }
    std::vector<Vec3> normal(static_cast<size_t>(last - first) + 1, Vec3::Zero());
    for (const auto& t : snapshot.patch) {
        std::array<Vec3, 3> x;
        for (size_t k = 0; k < 3; ++k) x[k] = at_mm(snapshot.x[static_cast<size_t>(t[k])]);
        const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]);  // larger triangles count more
        for (const int32_t v : t) {
            normal[static_cast<size_t>(v - first)] += n;
            indices.push_back(static_cast<unsigned>(v - first));
        }
    }
    find_rim(snapshot, first, normal.size());
    for (size_t i = 0; i < normal.size(); ++i) {
        const size_t v = static_cast<size_t>(first) + i;
        const Vec3 p = at_mm(snapshot.x[v]), at_rest = at_mm(rest[v]);
        const Vec3 n = normal[i].squaredNorm() > 0 ? normal[i].normalized() : Vec3::UnitZ();
        float row[kTissueVertexFloats] = {};
        for (int k = 0; k < 3; ++k) {
            row[k] = static_cast<float>(p[k]);
            row[3 + k] = static_cast<float>(n[k]);
        }
        row[6] = static_cast<float>(ToolMaterial::kPatch);
        row[7] = static_cast<float>(at_rest.x());
        row[8] = static_cast<float>(at_rest.y());
        row[9] = rim_[i];
        vertices.insert(vertices.end(), std::begin(row), std::end(row));
    }
    split_corners();
}

// A triangle at a corner has its three vertices at the edge and yet is not all edge: it and its
// neighbour get a vertex in the middle of the side between them.
void PatchMesh::find_corners(const Snapshot& snapshot, int32_t first) {
    corners_.clear();
    const auto& triangles = snapshot.patch;
    const auto local = [first](int32_t v) { return static_cast<unsigned>(v - first); };
    const auto all_edge = [&](const std::array<int32_t, 3>& t) {
        return std::all_of(t.begin(), t.end(), [&](int32_t v) { return rim_[local(v)] > 0; });
    };
    const auto has = [](const std::array<int32_t, 3>& t, int32_t v) {
        return std::find(t.begin(), t.end(), v) != t.end();
    };
    for (size_t i = 0; i < triangles.size(); ++i) {
        if (!all_edge(triangles[i])) continue;
        for (size_t j = 0; j < triangles.size(); ++j) {
            if (all_edge(triangles[j])) continue;
            for (size_t k = 0; k < 3; ++k) {
                const int32_t a = triangles[i][k], b = triangles[i][(k + 1) % 3];
                if (has(triangles[j], a) && has(triangles[j], b))
                    corners_.push_back({{i, j}, local(a), local(b)});
            }
        }
    }
}

void PatchMesh::split_corners() {
    for (const Corner& corner : corners_) {
        const auto middle = static_cast<unsigned>(vertices.size() / kTissueVertexFloats);
        for (size_t k = 0; k < kTissueVertexFloats; ++k)
            vertices.push_back(0.5F * (vertices[kTissueVertexFloats * corner.a + k] +
                                       vertices[kTissueVertexFloats * corner.b + k]));
        vertices[kTissueVertexFloats * middle + 9] = 0.5F;  // half of the way to the inside
        for (const size_t triangle : corner.triangles) {
            unsigned* t = indices.data() + 3 * triangle;
            std::array<unsigned, 3> other{t[0], t[1], t[2]};
            std::replace(t, t + 3, corner.a, middle);
            std::replace(other.begin(), other.end(), corner.b, middle);
            indices.insert(indices.end(), other.begin(), other.end());
        }
    }
}

PatchRenderer::PatchRenderer(const std::vector<std::array<float, 3>>& rest) : rest_(rest) {
    gl_.create({3, 3, 4, 4, 2});
}

void PatchRenderer::draw(const Snapshot& snapshot, GlProgram& program) {
    mesh_.build(snapshot, rest_);
    if (mesh_.indices.empty()) return;
    gl_.vertices(mesh_.vertices.data(), mesh_.vertices.size(), true);
    gl_.indices(mesh_.indices);
    program.set("energised", 0.0F);
    // Alpha of the picture tells the edges of instruments: it stays what it is.
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl_.draw(GL_TRIANGLES);
    glDisable(GL_BLEND);
}

}  // namespace placode::view
