// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/surroundings.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "ui/view/drawn_mesh.h"
#include "ui/view/tissue_mesh.h"

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;
using Edge = std::pair<int, int>;

Vector3f rest_mm(const ViewField& field, int vertex) {
    const auto& p = field.rest[static_cast<size_t>(vertex)];
    return 1000 * Vector3f(p[0], p[1], p[2]);
}

bool on_top(const ViewField& field, const SurfaceTriangle& triangle) {
    constexpr float kTopDepthM = 0.00002F;
    return std::all_of(triangle.vertex.begin(), triangle.vertex.end(), [&](int32_t v) {
        return field.depth_m.empty() || field.depth_m[static_cast<size_t>(v)] <= kTopDepthM;
    });
}

Vector3f area_of(const ViewField& field, const SurfaceTriangle& t) {
    const Vector3f a = rest_mm(field, t.vertex[0]);
    return (rest_mm(field, t.vertex[1]) - a).cross(rest_mm(field, t.vertex[2]) - a);
}

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

struct Rim {
    std::vector<Edge> edges;        // of one top triangle only, each vertex with its successor
    std::vector<Vector3f> normals;  // by vertex of the field
};

Rim rim_of(const ViewField& field) {
    Rim rim;
    rim.normals.assign(field.rest.size(), Vector3f::Zero());
    std::map<Edge, int> count;
    for (const SurfaceTriangle& t : field.rest_triangles) {
        if (!on_top(field, t)) continue;
        const Vector3f area = area_of(field, t);
        for (size_t e = 0; e < 3; ++e) {
            rim.normals[static_cast<size_t>(t.vertex[e])] += area;
            const int a = t.vertex[e], b = t.vertex[(e + 1) % 3];
            ++count[std::minmax(a, b)];
            rim.edges.emplace_back(a, b);
        }
    }
    std::erase_if(rim.edges,
                  [&](const Edge& e) { return count[std::minmax(e.first, e.second)] != 1; });
    return rim;
}

}  // namespace

DrawnMesh build_skirt(const ViewField& field) {
    DrawnMesh mesh;
    if (field.depth_m.empty()) return mesh;
    const Rim rim = rim_of(field);
    std::vector<Vector3f> points;
    for (const Edge& e : rim.edges) points.push_back(rest_mm(field, e.first));
    if (points.size() < 8) return mesh;
    const Quadric back = fit(points);

    constexpr float kSteps[] = {0.0F,  0.04F, 0.10F, 0.18F, 0.30F, 0.46F,
                                0.70F, 1.0F,  1.45F, 2.1F,  3.0F};
    constexpr unsigned kRings = std::size(kSteps);
    const auto add_column = [&](int v) {
        const Vector3f p = rest_mm(field, v);
        const double miss = p.z() - back.z(p.x(), p.y());
        for (const float s : kSteps) {
            const float x = p.x() * (1 + s), y = p.y() * (1 + s);
            const float away = s * std::hypot(p.x(), p.y());
            const auto z = static_cast<float>(back.z(x, y) + miss * std::exp(-away / 4.0));
            const float blend = std::exp(-away / 2.0F);
            const Vector3f n = (blend * rim.normals[static_cast<size_t>(v)].normalized() +
                                (1 - blend) * back.normal(x, y))
                                   .normalized();
            add_vertex(mesh, {Vector3f(x, y, z), n});
        }
    };
    for (const Edge& e : rim.edges) {
        const auto base = static_cast<unsigned>(mesh.vertices.size() / kTissueVertexFloats);
        add_column(e.first);
        add_column(e.second);
        for (unsigned r = 0; r + 1 < kRings; ++r) add_square(mesh, base + r, base + kRings + r);
    }
    return mesh;
}

DrawnMesh build_wall() {
    DrawnMesh mesh;
    const Vec3 centre(0, 0, 25), half(100, 72, 66);
    constexpr int kAround = 48, kUp = 24;
    for (int j = 0; j <= kUp; ++j) {
        for (int i = 0; i <= kAround; ++i) {
            const double a = 2 * std::numbers::pi * i / kAround,
                         b = std::numbers::pi * (j / double{kUp} - 0.5);
            const Vec3 unit(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
            add_vertex(mesh, {(centre + half.cwiseProduct(unit)).cast<float>(),
                              (-unit.cwiseQuotient(half)).normalized().cast<float>()});
        }
    }
    for (unsigned j = 0; j < kUp; ++j) {
        for (unsigned i = 0; i < kAround; ++i) {
            const unsigned p = j * (kAround + 1) + i;
            add_square(mesh, p, p + kAround + 1);
        }
    }
    return mesh;
}

Bed::Bed(const ViewField& field) : rest_(field.rest) {
    if (field.depth_m.empty() || field.rest.empty()) return;
    constexpr float kOutMm = 0.12F, kUpright = 0.3F, kHollow = 0.45F;
    Vector3f low = rest_mm(field, 0), high = low;
    for (size_t v = 0; v < field.rest.size(); ++v) {
        low = low.cwiseMin(rest_mm(field, static_cast<int>(v)));
        high = high.cwiseMax(rest_mm(field, static_cast<int>(v)));
    }
    const auto beside = [&](int v) {
        const Vector3f p = rest_mm(field, v);
        return (p - low).head<2>().minCoeff() < 1e-3F || (high - p).head<2>().minCoeff() < 1e-3F;
    };
    std::map<int, Vector3f> normals;
    std::vector<const SurfaceTriangle*> parts;
    for (const SurfaceTriangle& t : field.rest_triangles) {
        if (on_top(field, t)) continue;
        const Vector3f area = area_of(field, t);
        const float up = area.normalized().z();
        const bool deep = t.tissue == Tissue::kDura || t.tissue == Tissue::kMuscle;
        const bool side = std::abs(up) < kUpright && beside(t.vertex[0]) && beside(t.vertex[1]) &&
                          beside(t.vertex[2]);
        if (!side && !(up < -kUpright && deep)) continue;
        parts.push_back(&t);
        for (const int32_t v : t.vertex)
            normals.try_emplace(v, Vector3f::Zero()).first->second += area.normalized();
    }
    std::map<int, unsigned> number;
    for (const auto& [v, sum] : normals) {
        const Vector3f out = sum.normalized();
        number[v] = static_cast<unsigned>(vertex_of_.size());
        vertex_of_.push_back(v);
        const float depth = 1000 * field.depth_m[static_cast<size_t>(v)];
        // The upper edge of a side stays at the edge of the skirt.
        const Vector3f place = rest_mm(field, v) + (depth > 0.02F ? kOutMm : 0.0F) * out;
        field_z_.push_back(rest_mm(field, v).z());
        add_vertex(mesh_, {place, -out, depth, kHollow, 1});
    }
    for (const SurfaceTriangle* t : parts)
        for (const int32_t v : t->vertex) mesh_.indices.push_back(number[v]);
    all_ = mesh_.indices;
    low_ = 0.001F * std::min(low.x(), low.y());
    cell_m_ = (0.001F * std::max(high.x(), high.y()) - low_) / (kCells - 1);
}

int Bed::cell_of(const std::array<float, 3>& rest_m) const {
    const auto at = [&](float x) {
        return std::clamp(static_cast<int>((x - low_) / cell_m_), 0, kCells - 1);
    };
    return at(rest_m[1]) * kCells + at(rest_m[0]);
}

void Bed::choose(const Snapshot& snapshot) {
    constexpr float kSeenM = 0.0035F;  // from a cut, through its depth at a slant
    const int reach = static_cast<int>(std::ceil(kSeenM / cell_m_));
    near_cut_.assign(size_t{kCells} * kCells, 0);
    std::vector<uint8_t> done(near_cut_.size(), 0);
    for (const SurfaceTriangle& t : snapshot.triangles) {
        if (t.fresh == 0) continue;
        const auto v = static_cast<size_t>(t.vertex[0]);
        const size_t o =
            v < rest_.size() ? v : static_cast<size_t>(snapshot.origin[v - rest_.size()]);
        const int cell = cell_of(rest_[o]);
        if (std::exchange(done[static_cast<size_t>(cell)], 1) != 0) continue;
        const int x = cell % kCells, y = cell / kCells;
        for (int j = std::max(0, y - reach); j <= std::min(kCells - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(kCells - 1, x + reach); ++i)
                near_cut_[static_cast<size_t>(j * kCells + i)] = 1;
    }
    mesh_.indices.clear();
    for (size_t k = 0; k + 2 < all_.size(); k += 3) {
        const auto v = static_cast<size_t>(vertex_of_[all_[k]]);
        if (near_cut_[static_cast<size_t>(cell_of(rest_[v]))] == 0) continue;
        mesh_.indices.insert(mesh_.indices.end(), {all_[k], all_[k + 1], all_[k + 2]});
    }
}

void Bed::follow(const Snapshot& snapshot) {
    constexpr float kDeepestMm = 4;
    for (size_t i = 0; i < vertex_of_.size(); ++i) {
        const auto v = static_cast<size_t>(vertex_of_[i]);
        float* row = &mesh_.vertices[i * kTissueVertexFloats];
        const float rest = row[8];  // of the bed itself, see add_vertex()
        if (v >= snapshot.x.size()) continue;
        const float now = 1000 * snapshot.x[v][2];
        const float sunk = std::clamp(field_z_[i] - now, 0.0F, kDeepestMm);
        row[2] = rest - sunk;
    }
}

}  // namespace placode::view
