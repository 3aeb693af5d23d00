// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How far heat went beyond the edge of the incision, measured along rays on the surface at rest.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "sim/core/portable_math.h"
#include "sim/ledger/damage.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kCell = 0.0005;       // of the lookup grid [m]
constexpr double kRayStep = 0.00002;   // [m]
constexpr double kKerfWithin = 0.002;  // an incision farther off the plan is none of this ray [m]
constexpr double kBridge = 0.0003;     // slivers of tissue left standing in the kerf [m]
constexpr double kOneSecond = 1;
constexpr double kHottest = 250;  // a dose past every number is one of charred tissue [C]
// What body temperature gives in the second that a burn takes; cold tissue is 0 in the state, which
// has no logarithm.
constexpr double kColdDamage = 1e-4, kColdDoseMin = 1e-5;

/// Point of the surface at rest: triangle and barycentric weights.
struct SurfacePoint {
    int32_t tet = -1;
    std::array<int32_t, 3> vertex{};
    Vec3 weight = Vec3::Zero();
    double z_m = 0;
};

/// Triangles of the surface at rest by the cells of the xy plane that their boxes touch.
class SurfaceLocator {
 public:
    explicit SurfaceLocator(const Scene& scene)
        : rest_(scene.body.mesh().rest), triangles_(scene.surface.rest_triangles()) {
        for (size_t i = 0; i < triangles_.size(); ++i) {
            const auto& v = triangles_[i].vertex;
            const Vec3 &a = rest_[v[0]], &b = rest_[v[1]], &c = rest_[v[2]];
            if (!((b - a).cross(c - a).z() > 0)) continue;  // Looks down or to the side.
            const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
            for (int x = cell(low.x()); x <= cell(high.x()); ++x) {
                for (int y = cell(low.y()); y <= cell(high.y()); ++y)
                    cells_[{x, y}].push_back(static_cast<int32_t>(i));
            }
        }
    }
    /// The uppermost triangle over a place; nothing beside the body.
    [[nodiscard]] std::optional<SurfacePoint> find(const Vec2& p) const {
        const auto it = cells_.find({cell(p.x()), cell(p.y())});
        if (it == cells_.end()) return std::nullopt;
        std::optional<SurfacePoint> found;
        for (const int32_t i : it->second) {
            const SurfaceTriangle& t = triangles_[static_cast<size_t>(i)];
            const Vec3 &a = rest_[t.vertex[0]], &b = rest_[t.vertex[1]], &c = rest_[t.vertex[2]];
            const double area = cross(b - a, c - a);
            const Vec3 at(p.x(), p.y(), 0);
            const double wb = cross(at - a, c - a) / area, wc = cross(b - a, at - a) / area;
            const Vec3 w(1 - wb - wc, wb, wc);
            if (w.minCoeff() < -1e-9) continue;
            const double z = w.x() * a.z() + w.y() * b.z() + w.z() * c.z();
            if (!found || z > found->z_m) found = {t.tet, t.vertex, w, z};
        }
        return found;
    }

 private:
    static int cell(double x) { return static_cast<int>(std::floor(x / kCell)); }
    static double cross(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }
    std::span<const Vec3> rest_;
    std::span<const SurfaceTriangle> triangles_;
    std::map<std::pair<int, int>, std::vector<int32_t>> cells_;
};

/// Natural logarithms of Omega and CEM43 [min].
struct Reading {
    double damage_log = 0, dose_log = 0;
};

/// The ray through one point of the planned contour; sample i lies i steps outwards of it.
class Ray {
 public:
    Ray(const Scene& scene, const State& state, const SurfaceLocator& surface, const Vec2& from,
        const Vec2& out)
        : scene_(scene), state_(state), surface_(surface), from_(from), out_(out) {}
    [[nodiscard]] Vec2 place(double i) const { return from_ + i * kRayStep * out_; }
    /// First and last sample of the kerf next to the contour.
    [[nodiscard]] std::optional<std::pair<int, int>> kerf() const {
        for (int i = 0; i <= steps(kKerfWithin); ++i) {
            for (const int start : {i, -i})
                if (gone(start)) return std::pair(end(start, -1), end(start, 1));
        }
        return std::nullopt;
    }
    /// Distances from the edge at which Omega and CEM43 fall below their limits [m].
    [[nodiscard]] std::pair<double, double> beyond(int edge, int side) const {
        return {beyond(edge, side, &Reading::damage_log, log_portable(kSpreadDamage)),
                beyond(edge, side, &Reading::dose_log, log_portable(kSpreadDoseMin))};
    }

 private:
    static int steps(double metres) { return static_cast<int>(std::lround(metres / kRayStep)); }
    [[nodiscard]] bool gone(int i) const {
        const std::optional<SurfacePoint> point = surface_.find(place(i));
        return point && state_.gone_by_heat[static_cast<size_t>(point->tet)] != 0;
    }
    /// Last vaporised sample in one direction; slivers left standing do not end it.
    [[nodiscard]] int end(int from, int side) const {
        int last = from;
        for (int i = from; std::abs(i - last) <= steps(kBridge); i += side)
            if (gone(i)) last = i;
        return last;
    }
    /// The kerf ends half a step beyond its last sample.
    [[nodiscard]] double beyond(int edge, int side, double Reading::*quantity, double limit) const {
        double before = 0;
        for (int n = 1; n <= steps(kSpreadFarthestM); ++n) {
            const std::optional<Reading> here = read(edge + n * side);
            if (!here) return (n - 1) * kRayStep;  // The body ends.
            const double value = (*here).*quantity;
            if (value < limit)
                return n == 1 ? 0 : (n - 1.5 + (before - limit) / (before - value)) * kRayStep;
            before = value;
        }
        return kSpreadFarthestM;
    }
    [[nodiscard]] std::optional<Reading> read(int i) const {
        const std::optional<SurfacePoint> point = surface_.find(place(i));
        if (!point) return std::nullopt;
        Reading reading;
        const HeatState& heat = state_.heat[0];
        for (int k = 0; k < 3; ++k) {
            // Heat knows nothing of scissors: it hangs on the vertices of the rest shape.
            const auto v = static_cast<size_t>(point->vertex[static_cast<size_t>(k)]);
            const auto dose = static_cast<double>(heat.cem43_min[v]);
            const double damage =
                continued_damage(scene_, static_cast<double>(heat.arrhenius[v]), dose);
            reading.damage_log += point->weight[k] * log_portable(std::max(damage, kColdDamage));
            reading.dose_log +=
                point->weight[k] * log_portable(std::clamp(dose, kColdDoseMin, 1e30));
        }
        return reading;
    }
    const Scene& scene_;
    const State& state_;
    const SurfaceLocator& surface_;
    Vec2 from_, out_;
};

}  // namespace

double continued_damage(const Scene& scene, double arrhenius, double cem43_min) noexcept {
    if (arrhenius < 10 || !scene.heat) return arrhenius;
    const HeatSettings& heat = scene.heat->settings();
    const double celsius =
        std::min(kHottest, 43 + log2_portable(std::clamp(cem43_min * 60 / kOneSecond, 1.0, 1e300)));
    return std::max(arrhenius, kOneSecond * arrhenius_rate(heat.arrhenius_a_per_s,
                                                           heat.arrhenius_ea_j_mol, celsius));
}

std::vector<SpreadRay> thermal_spread(const Scene& scene, const State& state) {
    std::vector<SpreadRay> rays;
    const auto& contour = scene.geometry.planned_contour;
    const size_t n = contour.size();
    if (state.heat.empty() || n < 3) return rays;
    // Without a kerf there are no rays; environments ask twice a second.
    if (std::ranges::all_of(state.gone_by_heat, [](auto gone) { return gone == 0; })) return rays;
    const SurfaceLocator surface(scene);
    double area = 0;
    for (size_t i = 0; i < n; ++i) {
        const Vec3 &a = contour[i], &b = contour[(i + 1) % n];
        area += a.x() * b.y() - a.y() * b.x();
    }
    for (size_t i = 0; i < n; ++i) {
        const Vec2 from = contour[i].head<2>();
        const Vec2 along = (contour[(i + 1) % n] - contour[(i + n - 1) % n]).head<2>();
        if (!(along.norm() > 0)) continue;
        const Vec2 out = (area < 0 ? -1 : 1) * Vec2(along.y(), -along.x()).normalized();
        const Ray ray(scene, state, surface, from, out);
        const auto kerf = ray.kerf();
        if (!kerf) continue;
        for (const int side : {-1, 1}) {
            const int edge = side < 0 ? kerf->first : kerf->second;
            const Vec2 at = ray.place(edge + side * 0.5);
            const std::optional<SurfacePoint> last = surface.find(ray.place(edge));
            SpreadRay one;
            one.point = static_cast<int>(i);
            one.outward = side > 0;
            one.edge_m = Vec3(at.x(), at.y(), last ? last->z_m : 0);
            std::tie(one.damage_m, one.dose_m) = ray.beyond(edge, side);
            rays.push_back(one);
        }
    }
    return rays;
}

}  // namespace placode::sim
