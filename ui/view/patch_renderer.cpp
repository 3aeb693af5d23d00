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
        vertices.insert(vertices.end(), std::begin(row), std::end(row));
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
