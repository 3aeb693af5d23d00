// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/field_plane.h"

#include <algorithm>
#include <map>

namespace placode::sim {
namespace {

constexpr int kSubcutisLayer = 2;
constexpr double kRayStepM = 5e-5;

using Columns = std::array<int32_t, 3>;

/// Columns of a tet of the field: three, for it lies in one prism.
Columns columns_of(const FieldMesh& field, const std::array<int32_t, 4>& tet) {
    std::array<int32_t, 4> all{};
    for (size_t k = 0; k < 4; ++k) all[k] = field.column[static_cast<size_t>(tet[k])];
    std::sort(all.begin(), all.end());
    const auto last = std::unique(all.begin(), all.end());
    Columns three{-1, -1, -1};
    std::copy(all.begin(), std::min(last, all.begin() + 3), three.begin());
    return three;
}

bool inside(const std::array<Vec2, 3>& t, const Vec2& p) {
    const auto left = [&](const Vec2& a, const Vec2& b) {
        return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) >= 0;
    };
    const bool a = left(t[0], t[1]), b = left(t[1], t[2]), c = left(t[2], t[0]);
    return a == b && b == c;
}

class PlaneMaker {
 public:
    PlaneMaker(const OperativeFieldSpec& spec, const FieldMesh& field, const Surface& surface)
        : spec_(spec), field_(field), surface_(surface) {}

    DissectionPlane make() {
        plane_.strength_pa = spec_.plane->strength_pa;
        collect_faces();
        for (size_t s = 0; s < field_.slit.stations.size(); ++s) {
            const Slit::Station& station = field_.slit.stations[s];
            add_ray(static_cast<int32_t>(s), 1, station.left[0], station.right[0]);
            add_ray(static_cast<int32_t>(s), -1, station.right[0], station.left[0]);
        }
        mark_faces();
        return std::move(plane_);
    }

 private:
    void collect_faces() {
        const TetMesh& mesh = field_.mesh;
        std::map<Columns, std::array<int32_t, 3>> prisms;  // in the order of columns: always one
        std::map<Columns, int> found;
        for (size_t t = 0; t < mesh.tets.size(); ++t) {
            if (mesh.tissue[t] != Tissue::kSubcutis || layer_of(mesh.tets[t]) != kSubcutisLayer)
                continue;
            const Columns key = columns_of(field_, mesh.tets[t]);
            const int n = found[key]++;
            if (n < 3) prisms[key][static_cast<size_t>(n)] = static_cast<int32_t>(t);
        }
        for (auto& [columns, tets] : prisms) add_face(columns, tets);
    }
    [[nodiscard]] int layer_of(const std::array<int32_t, 4>& tet) const {
        int least = kFieldLayers;
        for (const int32_t v : tet) least = std::min(least, field_.level[static_cast<size_t>(v)]);
        return least;
    }
    void add_face(const Columns& columns, std::array<int32_t, 3> tets) {
        const TetMesh& mesh = field_.mesh;
        DissectionPlane::Face face;
        for (size_t i = 0; i < 3; ++i) {
            const auto& tet = mesh.tets[static_cast<size_t>(tets[i])];
            int low = 0, top = 0;
            for (int k = 0; k < 4; ++k) {
                const bool below =
                    field_.level[static_cast<size_t>(tet[static_cast<size_t>(k)])] > kSubcutisLayer;
                low += below ? 1 : 0;
                if (!below) top = k;
            }
            if (low != 3) continue;
            std::swap(tets[0], tets[i]);
            face.face = static_cast<int8_t>(top);
            break;
        }
        face.above = tets;
        if (surface_.neighbours()[static_cast<size_t>(tets[0])][static_cast<size_t>(face.face)] < 0)
            return;
        std::array<Vec2, 3> corner;
        for (size_t k = 0; k < 3; ++k) {
            corner[k] = field_.plane.points[static_cast<size_t>(columns[k])];
            const int32_t v = field_.vertices[static_cast<size_t>(columns[k])][kSubcutisLayer + 1];
            face.middle_m += mesh.rest[static_cast<size_t>(v)] / 3;
        }
        const Vec2 a = corner[1] - corner[0], b = corner[2] - corner[0];
        face.area_m2 = static_cast<float>(std::abs(a.x() * b.y() - a.y() * b.x()) / 2);
        const Vec2 along = spec_.slit->to_m - spec_.slit->from_m;
        const Vec2 to = face.middle_m.head<2>() - spec_.slit->from_m;
        face.side = along.x() * to.y() - along.y() * to.x() > 0 ? 1 : -1;
        plane_.faces.push_back(face);
        corners_.push_back(corner);
    }
    [[nodiscard]] int32_t face_at(const Vec2& p, int32_t guess) const {
        if (guess >= 0 && inside(corners_[static_cast<size_t>(guess)], p)) return guess;
        for (size_t i = 0; i < corners_.size(); ++i)
            if (inside(corners_[i], p)) return static_cast<int32_t>(i);
        return -1;
    }
    void add_ray(int32_t station, int8_t side, int32_t from, int32_t other) {
        DissectionPlane::Ray ray;
        ray.station = station;
        ray.side = side;
        ray.edge_m = field_.mesh.rest[static_cast<size_t>(from)];
        ray.out = ray.edge_m - field_.mesh.rest[static_cast<size_t>(other)];
        ray.out.z() = 0;
        ray.out.normalize();
        int32_t face = -1;
        for (double path = kRayStepM / 2; path < DissectionPlane::kMostReachM; path += kRayStepM) {
            const Vec2 p = ray.edge_m.head<2>() + path * ray.out.head<2>();
            face = face_at(p, face);
            if (face < 0) break;
            if (ray.stretches.empty() || ray.stretches.back().face != face)
                ray.stretches.push_back({face, 0});
            ray.stretches.back().until_m = static_cast<float>(path + kRayStepM / 2);
        }
        plane_.rays.push_back(std::move(ray));
    }

    /// What is to be freed lies straight beside the wound, not beyond its tips.
    void mark_faces() {
        std::vector<double> away(plane_.faces.size(), 1);
        for (size_t i = 0; i < plane_.faces.size(); ++i)
            for (const DissectionPlane::Ray& ray : plane_.rays)
                away[i] =
                    std::min(away[i], (plane_.faces[i].middle_m - ray.edge_m).head<2>().norm());
        for (const DissectionPlane::Ray& ray : plane_.rays)
            for (const DissectionPlane::Stretch& s : ray.stretches) {
                const auto i = static_cast<size_t>(s.face);
                plane_.faces[i].wanted = away[i] <= DissectionPlane::kWantedM;
            }
        for (size_t i = 0; i < plane_.faces.size(); ++i)
            plane_.faces[i].beyond = away[i] > DissectionPlane::kMostM;
    }

    const OperativeFieldSpec& spec_;
    const FieldMesh& field_;
    const Surface& surface_;
    DissectionPlane plane_;
    std::vector<std::array<Vec2, 3>> corners_;  // (faces)
};

}  // namespace

DissectionPlane make_plane(const OperativeFieldSpec& spec, const FieldMesh& field,
                           const Surface& surface) {
    if (!spec.plane) return {};
    return PlaneMaker(spec, field, surface).make();
}

}  // namespace placode::sim
