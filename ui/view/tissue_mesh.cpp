// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tissue_mesh.h"

#include <algorithm>
#include <cmath>

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;
using Eigen::Vector4f;
constexpr float kTopDepthMm = 0.02F;
constexpr float kRimFresh = 0.6F;

}  // namespace

TissueMesh::TissueMesh(const ViewField& field)
    : has_depth_(!field.depth_m.empty()), has_sac_(!field.floor.height_m.empty()) {
    rest_mm_.reserve(field.rest.size());
    for (const auto& p : field.rest) rest_mm_.emplace_back(1000 * p[0], 1000 * p[1], 1000 * p[2]);
    mesh_mm_ = rest_mm_;
    for (const Vector3f& p : mesh_mm_) {
        low_ = low_.cwiseMin(p.head<2>());
        high_ = high_.cwiseMax(p.head<2>());
    }
    depth_mm_.assign(field.rest.size(), 0.0F);
    for (size_t i = 0; i < field.depth_m.size(); ++i) depth_mm_[i] = 1000 * field.depth_m[i];
    whole_ = field.rest.size();
    slot_of_.assign(2 * field.rest.size(), -1);
}

// The sides and the bottom of the simulated block are no anatomy: only its top, what was cut, and
// the steep inner wall of a sac, which its opening shows.
bool TissueMesh::drawn(const SurfaceTriangle& triangle) const {
    if (triangle.fresh != 0 || !has_depth_) return true;
    const auto& t = triangle.vertex;
    const bool top = std::all_of(t.begin(), t.end(), [&](int32_t v) {
        return depth_mm_[static_cast<size_t>(v)] <= kTopDepthMm;
    });
    if (top || !has_sac_) return top;
    const auto at = [&](size_t i) { return rest_mm_[static_cast<size_t>(t[i])]; };
    constexpr float kSteep = 0.6F;
    const bool steep = std::abs((at(1) - at(0)).cross(at(2) - at(0)).normalized().z()) < kSteep;
    constexpr float kAtSideMm = 1e-3F;
    return steep && std::none_of(t.begin(), t.end(), [&](int32_t v) {
               const Eigen::Vector2f p = rest_mm_[static_cast<size_t>(v)].head<2>();
               return (p - low_).minCoeff() < kAtSideMm || (high_ - p).minCoeff() < kAtSideMm;
           });
}

void TissueMesh::set_fine(bool fine) {
    if (fine != fine_) built_ = false;
    fine_ = fine;
}

bool TissueMesh::update(const Snapshot& snapshot) {
    const bool changed = !built_ || snapshot.surface_version != version_ ||
                         snapshot.slides != slides_ || snapshot.triangles.size() != triangle_count_;
    if (changed) rebuild(snapshot);
    place(snapshot);
    shade();
    write();
    if (fine_) write_middles();
    return changed;
}

void TissueMesh::rebuild(const Snapshot& snapshot) {
    built_ = true;
    version_ = snapshot.surface_version;
    triangle_count_ = snapshot.triangles.size();
    slides_ = snapshot.slides;
    rest_places(snapshot);
    number_vertices(snapshot);
    link_neighbours();
    smoothing_.build(marks_, indices_);
    const size_t n = vertex_of_.size();
    position_.resize(n);
    normal_.resize(n);
    scratch_.resize(n);
    hollow_.resize(n);
    scratch_hollow_.resize(n);
    rest_.resize(n);
    damage_.resize(n);
    for (size_t c = 0; c < n; ++c) {
        const auto v = static_cast<size_t>(vertex_of_[c]);
        rest_[c] << rest_mm_[v], depth_mm_[v];
    }
    smoothing_.shape(rest_);
    size_t rows = n;
    if (fine_) {
        refinement_.build(marks_, indices_, refined_);
        rows += refinement_.count();
    }
    vertices_.assign(rows * kTissueVertexFloats, 0.0F);
}

void TissueMesh::rest_places(const Snapshot& snapshot) {
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
}

void TissueMesh::number_vertices(const Snapshot& snapshot) {
    slot_of_.assign(2 * rest_mm_.size(), -1);
    vertex_of_.clear();
    marks_.clear();
    indices_.clear();
    std::vector<uint8_t> touched(rest_mm_.size(), 0);
    for (const SurfaceTriangle& t : snapshot.triangles) {
        if (!drawn(t)) continue;
        for (const int32_t v : t.vertex) {
            int& slot = slot_of_[2 * static_cast<size_t>(v) + (t.fresh != 0 ? 1 : 0)];
            if (slot < 0) {
                slot = static_cast<int>(vertex_of_.size());
                vertex_of_.push_back(v);
                marks_.push_back({-1, t.fresh != 0, false});
            }
            indices_.push_back(static_cast<unsigned>(slot));
            if (t.fresh != 0) touched[static_cast<size_t>(v)] = 1;
        }
    }
    for (size_t c = 0; c < marks_.size(); ++c) {
        const auto v = static_cast<size_t>(vertex_of_[c]);
        marks_[c].moves = touched[v] != 0;
        marks_[c].twin = slot_of_[2 * v + (marks_[c].fresh ? 0 : 1)];
    }
}

void TissueMesh::link_neighbours() {
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
}

// Around the cut everything is smoothed for the eye only.
void TissueMesh::place(const Snapshot& snapshot) {
    constexpr int kHeatPasses = 3;
    for (size_t c = 0; c < vertex_of_.size(); ++c) {
        const auto v = static_cast<size_t>(vertex_of_[c]);
        const auto& x = snapshot.x[v];
        position_[c] = 1000 * Vector3f(x[0], x[1], x[2]);
        damage_[c] = v < snapshot.damage.size() ? Vector4f(snapshot.damage[v].data())
                                                : Vector4f(0, 0, 0, kBodyC);
    }
    smoothing_.shape(position_);
    smoothing_.spread(damage_, kHeatPasses);
}

void TissueMesh::shade() {
    std::fill(normal_.begin(), normal_.end(), Vector3f::Zero());
    for (size_t k = 0; k < indices_.size(); k += 3) {
        const Vector3f &a = position_[indices_[k]], &b = position_[indices_[k + 1]],
                       &c = position_[indices_[k + 2]];
        const Vector3f area = (b - a).cross(c - a);
        for (size_t e = 0; e < 3; ++e) normal_[indices_[k + e]] += area;
    }
    for (Vector3f& m : normal_) m = m.squaredNorm() > 1e-20F ? m.normalized() : Vector3f(0, 0, 1);
    smooth_normals();
    find_hollows();
}

// One round of averaging on the skin, six in the cut where the facets are coarse. The rim is round:
// a crease would show the zigzag of the elements.
void TissueMesh::smooth_normals() {
    constexpr int kPasses = 6;
    for (int pass = 0; pass < kPasses; ++pass) {
        scratch_ = normal_;
        for (size_t c = 0; c < normal_.size(); ++c) {
            if (pass > 0 && !marks_[c].fresh) continue;
            Vector3f sum = 2 * scratch_[c];
            for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
                sum += 0.5F * scratch_[static_cast<size_t>(near_[static_cast<size_t>(k)])];
            }
            if (sum.squaredNorm() > 1e-12F) normal_[c] = sum.normalized();
        }
    }
    for (const int c : smoothing_.moving()) {
        const int twin = marks_[static_cast<size_t>(c)].twin;
        if (twin < 0) continue;
        Vector3f &skin = normal_[static_cast<size_t>(c)],
                 &wall = normal_[static_cast<size_t>(twin)];
        const Vector3f sum = skin + wall;
        if (sum.squaredNorm() > 0.04F) skin = wall = sum.normalized();
    }
}

// How far the surroundings stand above a vertex, as a share of their distance: cheap occlusion.
void TissueMesh::find_hollows() {
    constexpr float kSteep = 2.2F, kPerMm = 0.55F, kMost = 0.75F;
    for (size_t c = 0; c < hollow_.size(); ++c) {
        float rise = 0;
        const int count = near_start_[c + 1] - near_start_[c];
        for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
            const Vector3f d =
                position_[static_cast<size_t>(near_[static_cast<size_t>(k)])] - position_[c];
            rise += normal_[c].dot(d) / std::max(d.norm(), 0.05F);
        }
        hollow_[c] =
            count > 0 ? std::clamp(kSteep * rise / static_cast<float>(count), 0.0F, 1.0F) : 0.0F;
        if (marks_[c].fresh)
            hollow_[c] = std::max(hollow_[c], std::min(kMost, kPerMm * rest_[c].w()));
    }
    constexpr int kPasses = 3;  // one on the skin
    for (int pass = 0; pass < kPasses; ++pass) {
        scratch_hollow_ = hollow_;
        for (size_t c = 0; c < hollow_.size(); ++c) {
            if (pass > 0 && !marks_[c].fresh) continue;
            float sum = 2 * scratch_hollow_[c], weight = 2;
            for (int k = near_start_[c]; k < near_start_[c + 1]; ++k) {
                sum += 0.5F * scratch_hollow_[static_cast<size_t>(near_[static_cast<size_t>(k)])];
                weight += 0.5F;
            }
            hollow_[c] = sum / weight;
        }
    }
}

void TissueMesh::write() {
    for (size_t c = 0; c < vertex_of_.size(); ++c) {
        float* out = &vertices_[c * kTissueVertexFloats];
        std::copy_n(position_[c].data(), 3, out);
        std::copy_n(normal_[c].data(), 3, out + 3);
        std::copy_n(rest_[c].data(), 4, out + 6);
        std::copy_n(damage_[c].data(), 4, out + 10);
        out[14] = hollow_[c];
        // The rim belongs to both sides: what was seared and bled there runs over its edge.
        const bool rim = !marks_[c].fresh && marks_[c].twin >= 0;
        out[15] = rim ? kRimFresh : static_cast<float>(marks_[c].fresh);
    }
}

void TissueMesh::write_middles() {
    const size_t base = vertex_of_.size();
    for (size_t i = 0; i < refinement_.count(); ++i) {
        const WoundRefinement::Edge& e = refinement_.edge(i);
        const float* a = &vertices_[static_cast<size_t>(e.a) * kTissueVertexFloats];
        const float* b = &vertices_[static_cast<size_t>(e.b) * kTissueVertexFloats];
        float* out = &vertices_[(base + i) * kTissueVertexFloats];
        for (int k = 0; k < kTissueVertexFloats; ++k) out[k] = 0.5F * (a[k] + b[k]);
        const Vector3f at = refinement_.place(i, position_, normal_);
        std::copy_n(at.data(), 3, out);
        if (Eigen::Map<const Vector3f>(out + 3).squaredNorm() < 1e-4F)
            std::copy_n(a + 3, 3, out + 3);
    }
}

}  // namespace placode::view
