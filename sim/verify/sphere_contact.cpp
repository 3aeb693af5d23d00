// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/sphere_contact.h"

#include <algorithm>

#include "sim/contact/contact_core.h"
#include "sim/core/as_index.h"
#include "sim/core/tool_shape.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

SphereContacts::PositionOf position_in(const Coordinates& x) {
    return [&x](int32_t v) { return Vec3(x.segment<3>(3 * v)); };
}

/// In-plane gradients of the barycentric coordinates that are at work in a touch: of the triangle,
/// of the edge, none at a corner [1/m].
std::array<Vec3, 3> gradients(const SphereTouch& t, const Coordinates& x) {
    std::array<Vec3, 3> g{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    std::array<Vec3, 3> p;
    int count = 0, first = -1, last = -1;
    for (int i = 0; i < 3; ++i) {
        p[as_index(i)] = x.segment<3>(3 * t.vertex[as_index(i)]);
        if (!(t.b[i] > 1e-12)) continue;
        if (count++ == 0) first = i;
        last = i;
    }
    if (count == 3) {
        const Vec3 face = (p[1] - p[0]).cross(p[2] - p[0]);
        for (size_t i = 0; i < 3; ++i)
            g[i] = face.cross(p[(i + 2) % 3] - p[(i + 1) % 3]) / face.squaredNorm();
    } else if (count == 2) {
        const Vec3 offset = p[as_index(last)] - p[as_index(first)];
        g[as_index(last)] = offset / offset.squaredNorm();
        g[as_index(first)] = -g[as_index(last)];
    }
    return g;
}

}  // namespace

SphereContacts::SphereContacts(const TetMesh& mesh, std::vector<SphereObstacle> spheres,
                               const std::vector<std::array<int32_t, 3>>& sheet)
    : spheres_(std::move(spheres)) {
    if (spheres_.empty()) return;
    const Surface surface(mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) triangles_.push_back(t.vertex);
    faces_ = triangles_.size();
    triangles_.insert(triangles_.end(), sheet.begin(), sheet.end());
    for (const auto& t : triangles_) {
        for (size_t k = 0; k < 3; ++k) {
            const double edge =
                (mesh.rest[as_index(t[k])] - mesh.rest[as_index(t[(k + 1) % 3])]).norm();
            mean_edge_m_ += edge;
            longest_edge_m_ = std::max(longest_edge_m_, edge);
            vertices_.push_back(t[k]);
        }
    }
    mean_edge_m_ /= 3.0 * static_cast<double>(triangles_.size());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

void SphereContacts::find(const PositionOf& x, double time_s, double margin_m,
                          std::vector<SphereTouch>& out) const {
    near(x, time_s, margin_m, out);
    std::erase_if(out, [](const SphereTouch& t) { return t.looks_away; });
}

void SphereContacts::near(const PositionOf& x, double time_s, double margin_m,
                          std::vector<SphereTouch>& out) const {
    out.clear();
    for (size_t s = 0; s < spheres_.size(); ++s) {
        const Vec3 centre = spheres_[s].centre_at(time_s);
        const double reach = spheres_[s].radius_m + margin_m;
        // A stretched triangle is longer than at rest; 3 is beyond what tissue bears.
        const double far = reach + 3 * longest_edge_m_;
        for (size_t i = 0; i < triangles_.size(); ++i) {
            const auto& triangle = triangles_[i];
            const Vec3 first = x(triangle[0]);
            if ((first - centre).squaredNorm() > far * far) continue;
            const Triangle corners{first, x(triangle[1]), x(triangle[2])};
            const Vec3 b = closest_on_triangle(centre, corners);
            const Vec3 offset = b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2] - centre;
            const double distance = offset.norm();
            if (!(distance < reach) || !(distance > 0)) continue;
            const Vec3 n = offset / distance;
            const Vec3 face = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
            const bool sheet = i >= faces_;
            out.push_back({triangle, b, n, distance - spheres_[s].radius_m, static_cast<int>(s),
                           sheet, !sheet && n.dot(face) > kContactFacing});
        }
    }
}

double contact_energy(const SphereContacts& contacts, const Coordinates& x, double time_s,
                      double k) {
    std::vector<SphereTouch> touches;
    contacts.find(position_in(x), time_s, 0, touches);
    double sum = 0;
    for (const SphereTouch& t : touches) sum += 0.5 * k * t.gap_m * t.gap_m;
    return sum;
}

std::vector<Vec3> add_contact(const SphereContacts& contacts, const Coordinates& x, double time_s,
                              double k, Coordinates& gradient, Triplets* stiffness) {
    std::vector<Vec3> force(contacts.spheres().size(), Vec3::Zero());
    std::vector<SphereTouch> touches;
    contacts.find(position_in(x), time_s, 0, touches);
    for (const SphereTouch& t : touches) {
        force[as_index(t.sphere)] += k * t.gap_m * t.n;
        // The nearest point slides when the triangle tilts: the distance has a second derivative of
        // -distance g_i . g_j n n^T, as stiff as the tissue where triangles are small.
        const double slide =
            -k * t.gap_m * (t.gap_m + contacts.spheres()[as_index(t.sphere)].radius_m);
        const auto g = gradients(t, x);
        for (int i = 0; i < 3; ++i) {
            gradient.segment<3>(3 * t.vertex[as_index(i)]) += k * t.gap_m * t.b[i] * t.n;
            if (stiffness == nullptr) continue;
            for (int j = 0; j < 3; ++j) {
                const double along =
                    k * t.b[i] * t.b[j] + slide * g[as_index(i)].dot(g[as_index(j)]);
                const Mat3 block = along * t.n * t.n.transpose();
                for (int r = 0; r < 9; ++r) {
                    stiffness->emplace_back(3 * t.vertex[as_index(i)] + r / 3,
                                            3 * t.vertex[as_index(j)] + r % 3, block(r / 3, r % 3));
                }
            }
        }
    }
    return force;
}

}  // namespace placode::sim
