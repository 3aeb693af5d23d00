// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A gently domed block of two layers of vertices, as the view gets it, and holes through it. No
// physics.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "sim/step/snapshot.h"
#include "ui/view/view_field.h"

namespace placode::view {

struct DrawnField {
    static constexpr int kNx = 61, kNy = 47;  // vertices, about 0.65 mm apart
    static constexpr float kThickM = 0.0025F;
    ViewField view;
    sim::Snapshot snapshot;

    DrawnField() {
        add_vertices();
        add_triangles();
        snapshot.x = view.rest;
        snapshot.damage.assign(view.rest.size(), {0, 0, 0, 37});
        snapshot.triangles = view.rest_triangles;
        snapshot.surface_version = 1;
    }

    /// Takes out everything, down to the bottom, below the triangles of the top that `gone` names
    /// by their centroid [mm]. Walls are fresh.
    void cut(const std::function<bool(const sim::Vec2&)>& gone) {
        std::vector<sim::SurfaceTriangle> left;
        std::map<std::pair<int, int>, int> kept, out;  // edges of the top, directed
        for (const sim::SurfaceTriangle& t : snapshot.triangles) {
            const bool go = gone(centroid(t));
            if (!go) left.push_back(t);
            for (size_t e = 0; e < 3 && on_top(t); ++e)
                ++(go ? out : kept)[{t.vertex[e], t.vertex[(e + 1) % 3]}];
        }
        for (const auto& [edge, count] : out) {
            const auto [a, b] = edge;
            if (kept.count({b, a}) == 0) continue;
            left.push_back({{b, a, a + kNx * kNy}, 0, sim::Tissue::kSkin, 1, {}});
            left.push_back({{b, a + kNx * kNy, b + kNx * kNy}, 0, sim::Tissue::kSkin, 1, {}});
        }
        snapshot.triangles = left;
        ++snapshot.surface_version;
    }

    [[nodiscard]] sim::Vec2 rest_mm(int v) const {
        const auto& p = view.rest[static_cast<size_t>(v)];
        return {1000.0 * static_cast<double>(p[0]), 1000.0 * static_cast<double>(p[1])};
    }

 private:
    [[nodiscard]] bool on_top(const sim::SurfaceTriangle& t) const {
        return std::all_of(t.vertex.begin(), t.vertex.end(), [](int v) { return v < kNx * kNy; });
    }
    [[nodiscard]] sim::Vec2 centroid(const sim::SurfaceTriangle& t) const {
        return (rest_mm(t.vertex[0]) + rest_mm(t.vertex[1]) + rest_mm(t.vertex[2])) / 3;
    }
    void add_vertices() {
        for (const float depth : {0.0F, kThickM}) {
            for (int j = 0; j < kNy; ++j) {
                for (int i = 0; i < kNx; ++i) {
                    const float x = 0.040F * (static_cast<float>(i) / (kNx - 1) - 0.5F);
                    const float y = 0.030F * (static_cast<float>(j) / (kNy - 1) - 0.5F);
                    view.rest.push_back({x, y, -y * y / 0.064F - x * x / 0.24F - depth});
                    view.depth_m.push_back(depth);
                }
            }
        }
        for (int i = 0; i < 72; ++i) {
            const double t = 2 * 3.14159265358979 * i / 72;
            view.placode_edge.emplace_back(0.008 * std::cos(t), 0.003 * std::sin(t), 0);
            view.skin_edge.emplace_back(0.012 * std::cos(t), 0.008 * std::sin(t), 0);
        }
    }
    void add(int a, int b, int c, sim::Tissue tissue) {
        view.rest_triangles.push_back({{a, b, c}, 0, tissue, 0, {}});
    }
    void add_side(int a, int b) {  // the block lies to the left of the way from a to b
        constexpr int below = kNx * kNy;
        add(a, a + below, b + below, sim::Tissue::kMuscle);
        add(a, b + below, b, sim::Tissue::kMuscle);
    }
    void add_triangles() {
        constexpr int below = kNx * kNy;
        for (int j = 0; j + 1 < kNy; ++j) {
            for (int i = 0; i + 1 < kNx; ++i) {
                const int a = j * kNx + i, b = a + 1, c = a + kNx, d = c + 1;
                add(a, b, d, sim::Tissue::kSkin);
                add(a, d, c, sim::Tissue::kSkin);
                add(a + below, d + below, b + below, sim::Tissue::kMuscle);
                add(a + below, c + below, d + below, sim::Tissue::kMuscle);
            }
        }
        for (int i = 0; i + 1 < kNx; ++i) {
            add_side(i, i + 1);
            add_side((kNy - 1) * kNx + i + 1, (kNy - 1) * kNx + i);
        }
        for (int j = 0; j + 1 < kNy; ++j) {
            add_side(j * kNx + kNx - 1, (j + 1) * kNx + kNx - 1);
            add_side((j + 1) * kNx, j * kNx);
        }
    }
};

}  // namespace placode::view
