// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tissue_mesh.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;
constexpr float kTopDepthMm = 0.02F;
constexpr float kRimFresh = 0.6F;

// z = a + b x + c y + d x^2 + e y^2 through the edge of the field: how the back goes on beyond it.
struct Quadric {
    Eigen::Matrix<double, 5, 1> k = Eigen::Matrix<double, 5, 1>::Zero();
    [[nodiscard]] double z(double x, double y) const {
        return k[0] + k[1] * x + k[2] * y + k[3] * x * x + k[4] * y * y;
    }
    [[nodiscard]] Vector3f normal(double x, double y) const {
        return Vector3f(static_cast<float>(-k[1] - 2 * k[3] * x),
                        static_cast<float>(-k[2] - 2 * k[4] * y), 1.0F)
            .normalized();
    }
};

Quadric fit(const std::vector<Vector3f>& points) {
    Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), 5);
    Eigen::VectorXd b(static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        const Eigen::Vector3d p = points[static_cast<size_t>(i)].cast<double>();
        a.row(i) << 1, p.x(), p.y(), p.x() * p.x(), p.y() * p.y();
        b[i] = p.z();
    }
    return {a.colPivHouseholderQr().solve(b)};
}

}  // namespace

TissueMesh::TissueMesh(const ViewField& field) : has_depth_(!field.depth_m.empty()) {
    rest_mm_.reserve(field.rest.size());
    for (const auto& p : field.rest) rest_mm_.emplace_back(1000 * p[0], 1000 * p[1], 1000 * p[2]);
    mesh_mm_ = rest_mm_;
    depth_mm_.assign(field.rest.size(), 0.0F);
    for (size_t i = 0; i < field.depth_m.size(); ++i) depth_mm_[i] = 1000 * field.depth_m[i];
    whole_ = field.rest.size();
    slot_of_.assign(2 * field.rest.size(), -1);
    touched_.assign(field.rest.size(), 0);
    if (has_depth_) build_skirt(field);
}

// The sides and the bottom of the simulated block are no anatomy: only its top, and what was cut.
bool TissueMesh::drawn(const SurfaceTriangle& triangle) const {
    if (triangle.fresh != 0 || !has_depth_) return true;
    for (const int32_t v : triangle.vertex) {
        if (depth_mm_[static_cast<size_t>(v)] > kTopDepthMm) return false;
    }
    return true;
}

bool TissueMesh::update(const Snapshot& snapshot) {
    const bool changed = !built_ || snapshot.surface_version != version_ ||
                         snapshot.slides != slides_ || snapshot.triangles.size() != triangle_count_;
    if (changed) rebuild(snapshot);
    place(snapshot);
    shade();
    for (size_t c = 0; c < vertex_of_.size(); ++c) {
        const auto v = static_cast<size_t>(vertex_of_[c]);
        float* out = &vertices_[c * kTissueVertexFloats];
        std::copy_n(position_[c].data(), 3, out);
        std::copy_n(normal_[c].data(), 3, out + 3);
        if (v < snapshot.damage.size()) std::copy_n(snapshot.damage[v].data(), 4, out + 10);
        out[14] = hollow_[c];
    }
    return changed;
}

void TissueMesh::rebuild(const Snapshot& snapshot) {
    built_ = true;
    version_ = snapshot.surface_version;
    triangle_count_ = snapshot.triangles.size();
    slides_ = snapshot.slides;
    // Copies that cutting made look at rest like the vertex they came from.
    rest_mm_ = mesh_mm_;
    depth_mm_.resize(whole_);
    for (const int32_t o : snapshot.origin) {
        rest_mm_.push_back(mesh_mm_[static_cast<size_t>(o)]);
        depth_mm_.push_back(depth_mm_[static_cast<size_t>(o)]);
    }
    // Where a cut slid a vertex through the tissue, the tissue's pattern stays where it is.
    for (size_t v = 0; v < rest_mm_.size() && v < snapshot.rest.size(); ++v) {
        const auto& p = snapshot.rest[v];
        rest_mm_[v] = 1000 * Vector3f(p[0], p[1], p[2]);
    }
    slot_of_.resize(2 * rest_mm_.size(), -1);
    touched_.resize(rest_mm_.size(), 0);
    for (size_t c = 0; c < vertex_of_.size(); ++c) {
        slot_of_[2 * static_cast<size_t>(vertex_of_[c]) + fresh_[c]] = -1;
        touched_[static_cast<size_t>(vertex_of_[c])] = 0;
    }
    vertex_of_.clear();
    fresh_.clear();
    indices_.clear();
    for (const SurfaceTriangle& t : snapshot.triangles) {
        if (!drawn(t)) continue;
        for (const int32_t v : t.vertex) {
            int& slot = slot_of_[2 * static_cast<size_t>(v) + (t.fresh != 0 ? 1 : 0)];
            if (slot < 0) {
                slot = static_cast<int>(vertex_of_.size());
                vertex_of_.push_back(v);
                fresh_.push_back(t.fresh != 0 ? 1 : 0);
            }
            indices_.push_back(static_cast<unsigned>(slot));
            if (t.fresh != 0) touched_[static_cast<size_t>(v)] = 1;
        }
    }
    const size_t n = vertex_of_.size();
    near_start_.assign(n + 1, 0);
    for (const unsigned i : indices_) near_start_[i + 1] += 2;
    for (size_t i = 0; i < n; ++i) near_start_[i + 1] += near_start_[i];
    near_.resize(2 * indices_.size());
    std::vector<int> fill(near_start_.begin(), near_start_.end() - 1);
    for (size_t k = 0; k < indices_.size(); k += 3) {
        for (size_t e = 0; e < 3; ++e) {
            int& at = fill[indices_[k + e]];
            near_[static_cast<size_t>(at++)] = static_cast<int>(indices_[k + (e + 1) % 3]);
            near_[static_cast<size_t>(at++)] = static_cast<int>(indices_[k + (e + 2) % 3]);
        }
    }
    position_.resize(n);
    normal_.resize(n);
    scratch_.resize(n);
    hollow_.resize(n);
    scratch_hollow_.resize(n);
    vertices_.assign(n * kTissueVertexFloats, 0.0F);
    for (size_t c = 0; c < n; ++c) {
        const auto v = static_cast<size_t>(vertex_of_[c]);
        float* out = &vertices_[c * kTissueVertexFloats];
        std::copy_n(rest_mm_[v].data(), 3, out + 6);
        out[9] = depth_mm_[v];
        out[13] = 37;
        // The rim belongs to both sides: what was seared and bled there runs over its edge.
        const bool rim = fresh_[c] == 0 && slot_of_[2 * v + 1] >= 0;
        out[15] = rim ? kRimFresh : static_cast<float>(fresh_[c]);
    }
}

bool TissueMesh::on_rim(size_t c) const {
    const auto v = static_cast<size_t>(vertex_of_[c]);
    return slot_of_[2 * v] >= 0 && slot_of_[2 * v + 1] >= 0;
}

// Positions; around the cut they are smoothed for the eye only. Both halves of a rim vertex must
// move alike, or the crease would open.
void TissueMesh::place(const Snapshot& snapshot) {
    const size_t n = vertex_of_.size();
    for (size_t c = 0; c < n; ++c) {
        const auto& x = snapshot.x[static_cast<size_t>(vertex_of_[c])];
        position_[c] = 1000 * Vector3f(x[0], x[1], x[2]);
    }
    // Shrinking and swelling by turns: the zigzag of the elements goes, the depth of the cut stays.
    // Source: Taubin 1995, "Curve and surface smoothing without shrinkage".
    constexpr float kShrink = 0.55F, kSwell = -0.58F;
    // First all of the cut, then its rim as a line: blades leave single elements standing.
    constexpr int kAllPasses = 2, kRimPasses = 8;
    for (int pass = 0; pass < kRimPasses + 8; ++pass) {
        scratch_ = position_;
        for (size_t c = 0; c < n; ++c) {
            const auto v = static_cast<size_t>(vertex_of_[c]);
            if (touched_[v] == 0) continue;
            const int twin = slot_of_[2 * v + (fresh_[c] != 0 ? 0 : 1)];
            if (twin >= 0 && fresh_[c] != 0) continue;  // set together with its other half
            const bool along = pass >= kAllPasses && pass < kRimPasses;
            if (twin < 0 && along) continue;
            Vector3f sum = Vector3f::Zero();
            int count = 0;
            for (const int half : {static_cast<int>(c), twin}) {
                if (half < 0) continue;
                const auto h = static_cast<size_t>(half);
                for (int k = near_start_[h]; k < near_start_[h + 1]; ++k) {
                    const auto other = static_cast<size_t>(near_[static_cast<size_t>(k)]);
                    if (along && !on_rim(other)) continue;
                    sum += scratch_[other];
                    ++count;
                }
            }
            if (count == 0) continue;
            const bool shrinks = pass < kRimPasses || (pass - kRimPasses) % 2 == 0;
            const Vector3f moved =
                scratch_[c] +
                (shrinks ? kShrink : kSwell) * (sum / static_cast<float>(count) - scratch_[c]);
            position_[c] = moved;
            if (twin >= 0) position_[static_cast<size_t>(twin)] = moved;
        }
    }
}

void TissueMesh::shade() {
    const size_t n = vertex_of_.size();
    std::fill(normal_.begin(), normal_.end(), Vector3f::Zero());
    for (size_t k = 0; k < indices_.size(); k += 3) {
        const Vector3f &a = position_[indices_[k]], &b = position_[indices_[k + 1]],
                       &c = position_[indices_[k + 2]];
        const Vector3f area = (b - a).cross(c - a);
        for (size_t e = 0; e < 3; ++e) normal_[indices_[k + e]] += area;
    }
    for (Vector3f& m : normal_) m = m.squaredNorm() > 1e-20F ? m.normalized() : Vector3f(0, 0, 1);
    // One round of averaging on the skin, six in the cut where the facets are coarse.
    for (int pass = 0; pass < 6; ++pass) {
        scratch_ = normal_;
        for (size_t c = 0; c < n; ++c) {
            if (pass > 0 && fresh_[c] == 0) continue;
            Vector3f sum = 2 * scratch_[c];
            for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
                sum += 0.5F * scratch_[static_cast<size_t>(near_[static_cast<size_t>(k)])];
            }
            if (sum.squaredNorm() > 1e-12F) normal_[c] = sum.normalized();
        }
    }
    // How far the surroundings stand above a vertex, as a share of their distance: cheap occlusion.
    for (size_t c = 0; c < n; ++c) {
        float rise = 0;
        const int count = near_start_[c + 1] - near_start_[c];
        for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
            const Vector3f d =
                position_[static_cast<size_t>(near_[static_cast<size_t>(k)])] - position_[c];
            rise += normal_[c].dot(d) / std::max(d.norm(), 0.05F);
        }
        hollow_[c] =
            count > 0 ? std::clamp(2.2F * rise / static_cast<float>(count), 0.0F, 1.0F) : 0.0F;
        if (fresh_[c] != 0) {
            const float depth = depth_mm_[static_cast<size_t>(vertex_of_[c])];
            hollow_[c] = std::max(hollow_[c], std::min(0.75F, 0.55F * depth));
        }
    }
    scratch_hollow_ = hollow_;
    for (size_t c = 0; c < n; ++c) {
        float sum = 2 * scratch_hollow_[c], weight = 2;
        for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
            sum += 0.5F * scratch_hollow_[static_cast<size_t>(near_[static_cast<size_t>(k)])];
            weight += 0.5F;
        }
        hollow_[c] = sum / weight;
    }
}

void TissueMesh::build_skirt(const ViewField& field) {
    // Edges that belong to one top triangle only, each vertex with its successor.
    std::map<std::pair<int, int>, int> count;
    std::vector<Vector3f> normals(rest_mm_.size(), Vector3f::Zero());
    std::vector<std::pair<int, int>> edges;
    for (const SurfaceTriangle& t : field.rest_triangles) {
        if (!drawn(t)) continue;
        const auto at = [&](size_t e) { return rest_mm_[static_cast<size_t>(t.vertex[e])]; };
        const Vector3f area = (at(1) - at(0)).cross(at(2) - at(0));
        for (size_t e = 0; e < 3; ++e) {
            normals[static_cast<size_t>(t.vertex[e])] += area;
            const int a = t.vertex[e], b = t.vertex[(e + 1) % 3];
            ++count[{std::min(a, b), std::max(a, b)}];
            edges.emplace_back(a, b);
        }
    }
    std::erase_if(edges, [&](const auto& e) {
        return count[{std::min(e.first, e.second), std::max(e.first, e.second)}] != 1;
    });
    std::vector<Vector3f> rim;
    for (const auto& [a, b] : edges) rim.push_back(rest_mm_[static_cast<size_t>(a)]);
    if (rim.size() < 8) return;
    const Quadric back = fit(rim);

    constexpr float kSteps[] = {0.0F,  0.04F, 0.10F, 0.18F, 0.30F, 0.46F,
                                0.70F, 1.0F,  1.45F, 2.1F,  3.0F};
    constexpr unsigned kRings = std::size(kSteps);
    const auto add_column = [&](int v) {
        const Vector3f p = rest_mm_[static_cast<size_t>(v)];
        const double miss = p.z() - back.z(p.x(), p.y());
        for (const float s : kSteps) {
            const float x = p.x() * (1 + s), y = p.y() * (1 + s);
            const float away = s * std::hypot(p.x(), p.y());
            const auto z = static_cast<float>(back.z(x, y) + miss * std::exp(-away / 4.0));
            const float blend = std::exp(-away / 2.0F);
            const Vector3f n = (blend * normals[static_cast<size_t>(v)].normalized() +
                                (1 - blend) * back.normal(x, y))
                                   .normalized();
            const float row[kTissueVertexFloats] = {x, y, z, n.x(), n.y(), n.z(), x, y,
                                                    z, 0, 0, 0,     0,     37,    0, 0};
            skirt_vertices_.insert(skirt_vertices_.end(), std::begin(row), std::end(row));
        }
    };
    for (const auto& [a, b] : edges) {
        const auto base = static_cast<unsigned>(skirt_vertices_.size() / kTissueVertexFloats);
        add_column(a);
        add_column(b);
        for (unsigned r = 0; r + 1 < kRings; ++r) {
            const unsigned p = base + r, q = base + kRings + r;
            for (const unsigned i : {p, p + 1, q, q, p + 1, q + 1}) skirt_indices_.push_back(i);
        }
    }
}

}  // namespace placode::view
