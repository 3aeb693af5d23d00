// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/fluid_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/tissue_mesh.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;

constexpr float kSeenM = 6e-5F;  // fluid less deep than that is the wetness of the tissue
constexpr int kSpeckRows = 4, kSpeckSides = 8, kJetSides = 14, kJetRows = 10;

}  // namespace

void FluidMesh::clear() noexcept {
    vertices.clear();
    indices.clear();
}

void FluidMesh::corner(const Vector3f& p, const Vector3f& n, float material, float a, float b,
                       float c) {
    const float row[kTissueVertexFloats] = {p.x(), p.y(),    p.z(), n.x(), n.y(),
                                            n.z(), material, a,     b,     c};
    vertices.insert(vertices.end(), std::begin(row), std::end(row));
}

void FluidMesh::build_pool(const FluidSnapshot& fluid) {
    clear();
    const auto cells = static_cast<size_t>(fluid.columns) * static_cast<size_t>(fluid.rows);
    if (fluid.depth_m.size() != cells) return;
    level_.assign(cells, 0);
    number_.assign(cells, -1);
    level_cells(fluid);
    add_pool_corners(fluid);
    add_pool_faces(fluid.columns, fluid.rows);
}

void FluidMesh::level_cells(const FluidSnapshot& fluid) {
    const int columns = fluid.columns, rows = fluid.rows;
    // A dry cell beside fluid has the level of that: the surface runs into the tissue, and the
    // depth buffer draws the shore.
    const auto wet = [&](size_t c) { return fluid.depth_m[c] > kSeenM; };
    const auto at = [&](int i, int j) {
        return static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i);
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            float sum = 0;
            int count = 0;
            const size_t c = at(i, j);
            for (int dj = -1; dj <= 1; ++dj) {
                for (int di = -1; di <= 1; ++di) {
                    if (i + di < 0 || j + dj < 0 || i + di >= columns || j + dj >= rows) continue;
                    const size_t other = at(i + di, j + dj);
                    if (!wet(other)) continue;
                    sum += fluid.ground_m[other] + fluid.depth_m[other];
                    ++count;
                }
            }
            if (count == 0) continue;
            level_[c] = wet(c) ? 0.5F * (fluid.ground_m[c] + fluid.depth_m[c] +
                                         sum / static_cast<float>(count))
                               : sum / static_cast<float>(count);
            number_[c] = 0;
        }
    }
}

void FluidMesh::add_pool_corners(const FluidSnapshot& fluid) {
    const int columns = fluid.columns, rows = fluid.rows;
    const auto at = [&](int i, int j) {
        return static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i);
    };
    int next = 0;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const size_t c = at(i, j);
            if (number_[c] < 0) continue;
            number_[c] = next++;
            const auto level = [&](int ii, int jj) {
                const size_t o = at(std::clamp(ii, 0, columns - 1), std::clamp(jj, 0, rows - 1));
                return number_[o] < 0 ? level_[c] : level_[o];
            };
            const auto cell = static_cast<float>(fluid.cell_m);
            const Vector3f n = Vector3f((level(i - 1, j) - level(i + 1, j)) / (2 * cell),
                                        (level(i, j - 1) - level(i, j + 1)) / (2 * cell), 1)
                                   .normalized();
            const Vector3f p(static_cast<float>(1000 * (fluid.x_m + fluid.cell_m * (i + 0.5))),
                             static_cast<float>(1000 * (fluid.y_m + fluid.cell_m * (j + 0.5))),
                             1000 * level_[c]);
            corner(p, n, static_cast<float>(ToolMaterial::kPool), 1000 * fluid.depth_m[c],
                   1000 * fluid.blood_m[c], 0);
        }
    }
}

void FluidMesh::add_pool_faces(int columns, int rows) {
    const auto at = [&](int i, int j) {
        return static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i);
    };
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < columns; ++i) {
            const std::array<int, 4> q{number_[at(i, j)], number_[at(i + 1, j)],
                                       number_[at(i + 1, j + 1)], number_[at(i, j + 1)]};
            if (std::any_of(q.begin(), q.end(), [](int v) { return v < 0; })) continue;
            for (const int k : {0, 1, 2, 0, 2, 3})
                indices.push_back(static_cast<unsigned>(q[static_cast<size_t>(k)]));
        }
    }
}

void FluidMesh::build_specks(const FluidSnapshot& fluid) {
    clear();
    for (size_t s = 0; s < fluid.specks.size(); ++s) {
        const FluidSnapshot::Speck& speck = fluid.specks[s];
        const auto first = static_cast<unsigned>(vertices.size() / kTissueVertexFloats);
        const Vector3f middle(1000 * speck.at_m[0], 1000 * speck.at_m[1], 1000 * speck.at_m[2]);
        const float radius = 1000 * speck.radius_m, flat = speck.blood != 0 ? 0.22F : 0.6F;
        const auto seed = static_cast<float>(s);
        const auto material =
            static_cast<float>(speck.blood != 0 ? ToolMaterial::kSpot : ToolMaterial::kCrumb);
        for (int r = 0; r <= kSpeckRows; ++r) {
            const float up = static_cast<float>(r) / kSpeckRows * std::numbers::pi_v<float> / 2;
            for (int k = 0; k < kSpeckSides; ++k) {
                const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kSpeckSides;
                // No two are of one shape.
                const float lump = 1 +
                                   (speck.blood != 0 ? 0.18F : 0.30F) *
                                       std::sin(2 * a + 2.1F * seed) * std::cos(up) +
                                   0.14F * std::sin(3 * a + 4.7F * seed + 2 * up);
                const Vector3f out(std::cos(a) * std::cos(up), std::sin(a) * std::cos(up),
                                   flat * std::sin(up));
                const Vector3f n =
                    Vector3f(out.x() * flat, out.y() * flat, out.z() / flat + 0.05F).normalized();
                corner(middle + radius * lump * out, n, material, seed, a, up);
            }
        }
        for (unsigned r = 0; r < kSpeckRows; ++r) {
            for (unsigned k = 0; k < kSpeckSides; ++k) {
                const unsigned l = (k + 1) % kSpeckSides, b = first + r * kSpeckSides;
                for (const unsigned v : {b + k, b + l, b + kSpeckSides + l, b + k,
                                         b + kSpeckSides + l, b + kSpeckSides + k})
                    indices.push_back(v);
            }
        }
    }
}

void FluidMesh::build_jets(const Snapshot& snapshot) {
    clear();
    const FluidSnapshot& fluid = snapshot.fluid;
    for (size_t t = 0; t < static_cast<size_t>(snapshot.tool_count); ++t) {
        if (fluid.jet_m[t] <= 0) continue;
        const auto first = static_cast<unsigned>(vertices.size() / kTissueVertexFloats);
        const Pose& tip = snapshot.tools[t].pose;
        for (int r = 0; r <= kJetRows; ++r) {
            const float share = static_cast<float>(r) / kJetRows;
            // It spreads out where it lands.
            const float foot = r == kJetRows ? 1.9F : 1.0F;
            const float radius =
                1000 * foot * std::lerp(fluid.jet_radius_m[t], fluid.jet_end_radius_m[t], share);
            for (int k = 0; k < kJetSides; ++k) {
                const double a = 2 * std::numbers::pi * k / kJetSides;
                const Vec3 side(std::cos(a), std::sin(a), 0);
                const Vec3 p =
                    1000 * (tip * Vec3(0, 0, static_cast<double>(share * fluid.jet_m[t]))) +
                    static_cast<double>(radius) * (tip.q * side);
                corner(p.cast<float>(), (tip.q * side).cast<float>(),
                       static_cast<float>(ToolMaterial::kJet), 1000 * share * fluid.jet_m[t],
                       static_cast<float>(a), share);
            }
        }
        for (unsigned r = 0; r < kJetRows; ++r) {
            for (unsigned k = 0; k < kJetSides; ++k) {
                const unsigned l = (k + 1) % kJetSides, b = first + r * kJetSides;
                for (const unsigned v :
                     {b + k, b + l, b + kJetSides + l, b + k, b + kJetSides + l, b + kJetSides + k})
                    indices.push_back(v);
            }
        }
    }
}

FluidRenderer::FluidRenderer() { gl_.create({3, 3, 4, 4, 2}); }

void FluidRenderer::draw_mesh() {
    if (mesh_.indices.empty()) return;
    gl_.vertices(mesh_.vertices.data(), mesh_.vertices.size(), true);
    gl_.indices(mesh_.indices);
    gl_.draw(GL_TRIANGLES);
}

void FluidRenderer::draw(const Snapshot& snapshot, GlProgram& program) {
    program.set("energised", 0.0F);
    // Alpha of the picture tells the edges of instruments: it stays what it is.
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    mesh_.build_specks(snapshot.fluid);
    draw_mesh();
    glDepthMask(GL_FALSE);
    mesh_.build_pool(snapshot.fluid);
    draw_mesh();
    mesh_.build_jets(snapshot);
    draw_mesh();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace placode::view
