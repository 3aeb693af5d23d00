// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/wound_map.h"

#include <algorithm>
#include <cmath>

namespace placode::view {

using namespace sim;
namespace {

// Three means of a box are nearly a bell: radius 2 texels of 0.11 mm give 0.28 mm, 8 give 0.95 mm.
constexpr int kNarrow = 2, kWide = 8, kPasses = 3;
constexpr int kMargin = kPasses * kWide + 1;
constexpr float kSlopeScale = 1.5F;  // of the share's difference over two texels

uint8_t byte(float v) {
    return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255.0F));
}

// Mean over 2 r + 1 values along a line of `count` values, `stride` apart; beyond its ends are 0.
void box(float* line, int count, int stride, int r, std::vector<float>& scratch) {
    scratch.resize(static_cast<size_t>(count));
    const auto at = [&](int i) { return i >= 0 && i < count ? line[i * stride] : 0.0F; };
    float sum = 0;
    for (int i = -r; i < r; ++i) sum += at(i);
    for (int i = 0; i < count; ++i) {
        sum += at(i + r);
        scratch[static_cast<size_t>(i)] = sum / static_cast<float>(2 * r + 1);
        sum -= at(i - r);
    }
    for (int i = 0; i < count; ++i) line[i * stride] = scratch[static_cast<size_t>(i)];
}

void bell(std::vector<float>& field, int width, int height, int r) {
    std::vector<float> scratch;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (int j = 0; j < height; ++j)
            box(&field[static_cast<size_t>(j * width)], width, 1, r, scratch);
        for (int i = 0; i < width; ++i)
            box(&field[static_cast<size_t>(i)], height, width, r, scratch);
    }
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

WoundMap::WoundMap(const ViewField& field, const Vec2& low_mm, const Vec2& high_mm)
    : low_(low_mm),
      texels_per_mm_(Vec2(kSize, kSize).cwiseQuotient(high_mm - low_mm)),
      mask_(size_t{kSize} * kSize, 0.0F),
      pixels_(size_t{kSize} * kSize * 4, 0),
      whole_(static_cast<int>(field.rest.size())) {
    constexpr float kTopDepthM = 0.00002F;
    constexpr double kFlatMm2 = 1e-3;  // seen from above; a wall has none
    for (size_t i = 0; i < pixels_.size(); i += 4) pixels_[i + 2] = pixels_[i + 3] = 128;
    for (const SurfaceTriangle& t : field.rest_triangles) {
        Top top;
        bool on_top = true;
        for (size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<size_t>(t.vertex[k]);
            on_top = on_top && !field.depth_m.empty() && field.depth_m[v] <= kTopDepthM;
            top.corners[k] = t.vertex[k];
            top.place[k] = 1000 * Vec2(static_cast<double>(field.rest[v][0]),
                                       static_cast<double>(field.rest[v][1]));
        }
        // The floor of a wound that is open from the start: nothing was ever on top of it.
        const bool floor = t.fresh != 0 && std::abs(cross(top.place[1] - top.place[0],
                                                          top.place[2] - top.place[0])) > kFlatMm2;
        if (!(on_top && t.fresh == 0) && !floor) continue;
        std::sort(top.corners.begin(), top.corners.end());
        tops_.push_back(top);
    }
    std::sort(tops_.begin(), tops_.end(),
              [](const Top& a, const Top& b) { return a.corners < b.corners; });
}

int WoundMap::top_of(std::array<int, 3> corners) const {
    std::sort(corners.begin(), corners.end());
    const auto found =
        std::lower_bound(tops_.begin(), tops_.end(), corners,
                         [](const Top& a, const auto& key) { return a.corners < key; });
    if (found == tops_.end() || found->corners != corners) return -1;
    return static_cast<int>(found - tops_.begin());
}

MapPart WoundMap::update(const Snapshot& snapshot) {
    if (tops_.empty() ||
        (snapshot.surface_version == version_ && snapshot.triangles.size() == triangle_count_))
        return {};
    version_ = snapshot.surface_version;
    triangle_count_ = snapshot.triangles.size();
    for (Top& top : tops_) top.here = false;
    const auto original = [&](int32_t v) {
        return v < whole_ ? v : snapshot.origin[static_cast<size_t>(v - whole_)];
    };
    for (const SurfaceTriangle& t : snapshot.triangles) {
        if (t.fresh != 0) continue;
        const int top =
            top_of({original(t.vertex[0]), original(t.vertex[1]), original(t.vertex[2])});
        if (top >= 0) tops_[static_cast<size_t>(top)].here = true;
    }
    Vec2 low(kSize, kSize), high(0, 0);
    bool restart = false, more = false;
    for (Top& top : tops_) {
        if (top.gone == !top.here) continue;
        restart = restart || top.gone;  // it is there again: another attempt, or a replay went back
        more = true;
        top.gone = !top.here;
        for (const Vec2& p : top.place) {
            const Vec2 at = (p - low_).cwiseProduct(texels_per_mm_);
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
        if (top.gone) fill(top);
    }
    if (!more) return {};
    if (restart) {
        std::fill(mask_.begin(), mask_.end(), 0.0F);
        for (const Top& top : tops_)
            if (top.gone) fill(top);
        low = Vec2(0, 0);
        high = Vec2(kSize, kSize);
    }
    MapPart part;
    part.x = std::max(0, static_cast<int>(low.x()) - kMargin);
    part.y = std::max(0, static_cast<int>(low.y()) - kMargin);
    part.width = std::min(kSize, static_cast<int>(high.x()) + kMargin + 1) - part.x;
    part.height = std::min(kSize, static_cast<int>(high.y()) + kMargin + 1) - part.y;
    if (part.width <= 0 || part.height <= 0) return {};
    blur(part);
    return part;
}

void WoundMap::fill(const Top& top) {
    std::array<Vec2, 3> p;
    for (size_t k = 0; k < 3; ++k) p[k] = (top.place[k] - low_).cwiseProduct(texels_per_mm_);
    if (cross(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
    const Vec2 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    for (int j = std::max(0, static_cast<int>(low.y())); j < kSize && j <= high.y(); ++j) {
        for (int i = std::max(0, static_cast<int>(low.x())); i < kSize && i <= high.x(); ++i) {
            const Vec2 q(i + 0.5, j + 0.5);
            if (cross(p[1] - p[0], q - p[0]) >= 0 && cross(p[2] - p[1], q - p[1]) >= 0 &&
                cross(p[0] - p[2], q - p[2]) >= 0)
                mask_[static_cast<size_t>(j * kSize + i)] = 1;
        }
    }
}

// Around the part the mask is read as far as the bells reach, so that no seam shows.
void WoundMap::blur(const MapPart& part) {
    const int x0 = std::max(0, part.x - kMargin), y0 = std::max(0, part.y - kMargin);
    const int width = std::min(kSize, part.x + part.width + kMargin) - x0;
    const int height = std::min(kSize, part.y + part.height + kMargin) - y0;
    std::vector<float> narrow(static_cast<size_t>(width * height));
    for (int j = 0; j < height; ++j)
        std::copy_n(&mask_[static_cast<size_t>((y0 + j) * kSize + x0)], width,
                    &narrow[static_cast<size_t>(j * width)]);
    std::vector<float> wide = narrow;
    bell(narrow, width, height, kNarrow);
    bell(wide, width, height, kWide);
    const auto at = [&](int x, int y) {
        x = std::clamp(x - x0, 0, width - 1);
        y = std::clamp(y - y0, 0, height - 1);
        return static_cast<size_t>(y * width + x);
    };
    for (int y = part.y; y < part.y + part.height; ++y) {
        for (int x = part.x; x < part.x + part.width; ++x) {
            uint8_t* out = &pixels_[4 * static_cast<size_t>(y * kSize + x)];
            out[0] = byte(narrow[at(x, y)]);
            out[1] = byte(wide[at(x, y)]);
            out[2] = byte(0.5F + kSlopeScale * (narrow[at(x + 1, y)] - narrow[at(x - 1, y)]));
            out[3] = byte(0.5F + kSlopeScale * (narrow[at(x, y + 1)] - narrow[at(x, y - 1)]));
        }
    }
}

double WoundMap::gone_at(const Vec2& mm) const {
    const Vec2 at = (mm - low_).cwiseProduct(texels_per_mm_) - Vec2(0.5, 0.5);
    const auto share = [&](int x, int y) {
        x = std::clamp(x, 0, kSize - 1);
        y = std::clamp(y, 0, kSize - 1);
        return pixels_[4 * static_cast<size_t>(y * kSize + x)] / 255.0;
    };
    const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
    const double fx = at.x() - x, fy = at.y() - y;
    return std::lerp(std::lerp(share(x, y), share(x + 1, y), fx),
                     std::lerp(share(x, y + 1), share(x + 1, y + 1), fx), fy);
}

}  // namespace placode::view
