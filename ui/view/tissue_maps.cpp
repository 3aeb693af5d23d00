// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tissue_maps.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "ui/view/tile_noise.h"
#include "ui/view/vessel_tree.h"

namespace placode::view {

using namespace sim;
namespace {

constexpr int kBorderSize = 256, kVesselSize = 1024, kSkinSize = 768, kNoiseSize = 256;

uint8_t byte(double v) { return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); }

// Signed distance to a closed polyline in the plane, negative inside [mm].
double signed_distance(const std::vector<Vec2>& line, const Vec2& p) {
    double best = 1e9;
    bool inside = false;
    for (size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
        const Vec2 a = line[j], b = line[i], ab = b - a;
        const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
        best = std::min(best, (p - a - t * ab).norm());
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            inside = !inside;
        }
    }
    return inside ? -best : best;
}

std::vector<Vec2> flat_mm(const std::vector<Vec3>& line) {
    std::vector<Vec2> out;
    for (const Vec3& p : line) out.emplace_back(p.x() * 1000, p.y() * 1000);
    return out;
}

void bake_borders(const ViewField& field, BakedMaps& maps) {
    const std::vector<Vec2> placode = flat_mm(field.placode_edge), skin = flat_mm(field.skin_edge);
    maps.border_size = kBorderSize;
    maps.borders.resize(size_t{kBorderSize} * kBorderSize * 2);
    for (int j = 0; j < kBorderSize; ++j) {
        for (int i = 0; i < kBorderSize; ++i) {
            const Vec2 t((i + 0.5) / kBorderSize, (j + 0.5) / kBorderSize);
            const Vec2 p = maps.low_mm + t.cwiseProduct(maps.high_mm - maps.low_mm);
            float* out =
                &maps.borders[2 * (static_cast<size_t>(j) * kBorderSize + static_cast<size_t>(i))];
            // A scene without a lesion is all skin.
            out[0] = placode.size() < 3 ? 30.0F : static_cast<float>(signed_distance(placode, p));
            out[1] = skin.size() < 3 ? 30.0F : static_cast<float>(signed_distance(skin, p));
        }
    }
}

Vec2 border_at(const BakedMaps& maps, const Vec2& p) {
    const Vec2 t = (p - maps.low_mm).cwiseQuotient(maps.high_mm - maps.low_mm) * kBorderSize;
    const int i = std::clamp(static_cast<int>(t.x()), 0, kBorderSize - 1);
    const int j = std::clamp(static_cast<int>(t.y()), 0, kBorderSize - 1);
    const float* d =
        &maps.borders[2 * (static_cast<size_t>(j) * kBorderSize + static_cast<size_t>(i))];
    return {d[0], d[1]};
}

// Draws tapered strokes into one channel, keeping the maximum.
void draw_strokes(BakedMaps& maps, const std::vector<VesselSegment>& strokes, int channel,
                  double softness, double strength) {
    const Vec2 scale = Vec2(kVesselSize, kVesselSize).cwiseQuotient(maps.high_mm - maps.low_mm);
    for (const VesselSegment& s : strokes) {
        const double margin = std::max(s.radius_a, s.radius_b) * (1 + softness) + 0.08;
        const Vec2 low =
            (s.a.cwiseMin(s.b) - Vec2(margin, margin) - maps.low_mm).cwiseProduct(scale);
        const Vec2 high =
            (s.a.cwiseMax(s.b) + Vec2(margin, margin) - maps.low_mm).cwiseProduct(scale);
        const int i0 = std::max(0, static_cast<int>(low.x())),
                  j0 = std::max(0, static_cast<int>(low.y()));
        const int i1 = std::min(kVesselSize - 1, static_cast<int>(high.x()));
        const int j1 = std::min(kVesselSize - 1, static_cast<int>(high.y()));
        const Vec2 ab = s.b - s.a;
        for (int j = j0; j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                const Vec2 p = maps.low_mm + Vec2(i + 0.5, j + 0.5).cwiseQuotient(scale);
                const double t =
                    std::clamp((p - s.a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
                const double r = s.radius_a + t * (s.radius_b - s.radius_a);
                const double d = (p - s.a - t * ab).norm();
                // Strokes thinner than a texel keep their contrast share instead of vanishing.
                const double width = std::max(r, 0.035);
                const double edge =
                    std::clamp((width * (1 + softness) - d) / (width * softness + 0.04), 0.0, 1.0);
                const double value = strength * edge * std::min(1.0, 0.35 + r / 0.05);
                uint8_t& out = maps.vessels[4 * (static_cast<size_t>(j) * kVesselSize +
                                                 static_cast<size_t>(i)) +
                                            static_cast<size_t>(channel)];
                out = std::max(out, byte(value));
            }
        }
    }
}

std::vector<Vec2> ring_of_roots(const BakedMaps& maps, double offset_mm, int count,
                                std::mt19937_64& random) {
    std::vector<Vec2> roots;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * 3.14159265358979 * (k + 0.7 * unit(random)) / count;
        const Vec2 ray(std::cos(angle), std::sin(angle));
        double r = 0.5;
        while (r < 30 && border_at(maps, r * ray).y() < offset_mm) r += 0.1;
        roots.push_back(r * ray);
    }
    return roots;
}

void bake_vessels(const ViewField& field, BakedMaps& maps) {
    maps.vessel_size = kVesselSize;
    maps.vessels.assign(size_t{kVesselSize} * kVesselSize * 4, 0);
    if (field.placode_edge.size() < 3 || field.skin_edge.size() < 3) return;
    std::mt19937_64 random(field.seed * 7919 + 17);
    const auto at = [&](const Vec2& p) { return border_at(maps, p); };
    VesselSpec arterioles;
    arterioles.roots = ring_of_roots(maps, 6.5, 15, random);
    arterioles.inside = [&](const Vec2& p) { return at(p).x() > 0.15 && at(p).y() < 7; };
    arterioles.low = maps.low_mm;
    arterioles.high = maps.high_mm;
    arterioles.attractors = 2300;
    arterioles.kill_mm = 0.42;
    arterioles.step_mm = 0.2;
    arterioles.seed = random();
    draw_strokes(maps, grow_vessels(arterioles), 1, 0.6, 0.95);

    VesselSpec venules = arterioles;
    venules.roots = ring_of_roots(maps, 7.0, 9, random);
    venules.attractors = 420;
    venules.kill_mm = 0.9;
    venules.step_mm = 0.28;
    venules.thinnest_mm = 0.035;
    venules.seed = random();
    draw_strokes(maps, grow_vessels(venules), 2, 1.8, 0.8);

    // On the placode: two cords beside the groove, branches to the edge.
    VesselSpec cord;
    const Vec2 axis_low(-30, -0.35), axis_high(30, 0.35);
    double x = -20;
    while (x < 0 && at({x, 0}).x() > -0.5) x += 0.1;
    for (double u = x; u < 30 && at({u, 0}).x() < -0.5; u += 0.35) {
        cord.roots.emplace_back(u, axis_low.y() + 0.16 * std::sin(1.3 * u));
        cord.roots.emplace_back(u, axis_high.y() + 0.16 * std::sin(1.1 * u + 2));
    }
    std::vector<VesselSegment> strokes;
    for (size_t i = 2; i < cord.roots.size(); ++i) {
        const double r = 0.055 + 0.03 * std::sin(0.9 * static_cast<double>(i));
        strokes.push_back({cord.roots[i - 2], cord.roots[i], r, r});
    }
    cord.inside = [&](const Vec2& p) { return at(p).x() < -0.25; };
    cord.low = Vec2(-10, -5);
    cord.high = Vec2(10, 5);
    cord.attractors = 900;
    cord.kill_mm = 0.3;
    cord.step_mm = 0.16;
    cord.seed = random();
    const std::vector<VesselSegment> branches = grow_vessels(cord);
    strokes.insert(strokes.end(), branches.begin(), branches.end());
    draw_strokes(maps, strokes, 0, 0.5, 1.0);
}

void bake_noise(const ViewField& field, BakedMaps& maps) {
    std::mt19937_64 random(field.seed * 104729 + 3);
    const int n = kNoiseSize;
    maps.noise_size = n;
    maps.noise.resize(size_t{kNoiseSize} * kNoiseSize * 4);
    const std::vector<double> a = fbm_field(n, 4, 5, 0.55, random);
    const std::vector<double> b = fbm_field(n, 8, 4, 0.6, random);
    const auto wrap = [&](int i, int j) {
        return static_cast<size_t>(((j + n) % n) * n + (i + n) % n);
    };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            uint8_t* out = &maps.noise[4 * wrap(i, j)];
            out[0] = byte(0.5 + 0.62 * a[wrap(i, j)]);
            out[1] = byte(0.5 + 0.62 * b[wrap(i, j)]);
            out[2] = byte(0.5 + 2.2 * (b[wrap(i + 1, j)] - b[wrap(i - 1, j)]));
            out[3] = byte(0.5 + 2.2 * (b[wrap(i, j + 1)] - b[wrap(i, j - 1)]));
        }
    }
}

void bake_skin(const ViewField& field, BakedMaps& maps) {
    std::mt19937_64 random(field.seed * 15485863 + 5);
    const int n = kSkinSize;
    const double texels_per_mm = n / kSkinTileMm;
    maps.skin_size = n;
    maps.skin.assign(size_t{kSkinSize} * kSkinSize * 4, 0);
    const auto texel = [&](int i, int j) {
        return &maps.skin[4 * static_cast<size_t>(((j % n) + n) % n * n + ((i % n) + n) % n)];
    };
    const std::vector<double> clump = fbm_field(n, 4, 4, 0.5, random);
    const std::vector<double> grain = fbm_field(n, 24, 3, 0.6, random);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto k = static_cast<size_t>(j * n + i);
            uint8_t* out = texel(i, j);
            // Vernix lies in few smeared patches, broken up by a finer grain.
            out[0] = byte(5.0 * (clump[k] + 0.45 * grain[k] - 0.52));
            out[2] = byte(0.5 + 0.8 * clump[k]);
            out[3] = byte(0.5 + 0.9 * grain[k]);
        }
    }
    // Lanugo: short fine hairs that lie one way, with swirl.
    for (int h = 0; h < 900; ++h) {
        double x = unit(random) * n, y = unit(random) * n;
        double angle =
            0.5 +
            1.1 * clump[static_cast<size_t>(static_cast<int>(y) * n + static_cast<int>(x))] * 3 +
            0.5 * (unit(random) - 0.5);
        const double bend = 0.05 * (unit(random) - 0.5);
        const double length = (0.7 + 1.1 * unit(random)) * texels_per_mm;
        for (double s = 0; s < length; s += 0.5) {
            x += 0.5 * std::cos(angle);
            y += 0.5 * std::sin(angle);
            angle += bend;
            uint8_t* out =
                texel(static_cast<int>(std::floor(x + n)), static_cast<int>(std::floor(y + n)));
            out[1] = std::max(out[1], byte(0.9 * (1 - 0.8 * s / length)));
        }
    }
}

}  // namespace

BakedMaps bake_maps(const ViewField& field) {
    BakedMaps maps;
    if (!field.skin_edge.empty()) {
        Vec2 low(1e9, 1e9), high(-1e9, -1e9);
        for (const Vec2& p : flat_mm(field.skin_edge)) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        maps.low_mm = low - Vec2(12, 12);
        maps.high_mm = high + Vec2(12, 12);
    }
    bake_borders(field, maps);
    bake_vessels(field, maps);
    bake_noise(field, maps);
    bake_skin(field, maps);
    return maps;
}

TissueMaps::TissueMaps(const BakedMaps& baked) : low_mm(baked.low_mm), high_mm(baked.high_mm) {
    borders.load(baked.border_size, baked.border_size, {GL_RG32F, GL_RG, GL_FLOAT},
                 baked.borders.data());
    vessels.load(baked.vessel_size, baked.vessel_size,
                 {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, true, false}, baked.vessels.data());
    skin.load(baked.skin_size, baked.skin_size, {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, true, true},
              baked.skin.data());
    noise.load(baked.noise_size, baked.noise_size,
               {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, true, true}, baked.noise.data());
}

void TissueMaps::bind() const {
    borders.bind(0);
    vessels.bind(1);
    skin.bind(2);
    noise.bind(3);
}

}  // namespace placode::view
