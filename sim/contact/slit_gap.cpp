// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/slit_gap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "sim/contact/self_contact.h"
#include "sim/core/tool_shape.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

// Walls that shift along each other this far still find their counterpart.
constexpr int kStationsAround = 3;
constexpr double kBesideWallM = 1e-4, kStationM = 5e-4;
// A wall pressed into the other by up to this much touches it. Contact keeps them 50 um apart, less
// what the pull of threads presses; planning value.
constexpr double kPassedM = 3e-4;

using Wall = Slit::Column Slit::Station::*;

Vec3 rest_of(const Scene& scene, int32_t v) noexcept {
    return scene.body.mesh().rest[static_cast<size_t>(v)];
}

/// From the middle of a station to its right wall at the surface, in the plane at rest [m].
Vec2 half_way_across(const Scene& scene, int station) noexcept {
    const Slit::Station& s = scene.slit.stations[static_cast<size_t>(station)];
    return 0.5 * (rest_of(scene, s.right[0]) - rest_of(scene, s.left[0])).head<2>();
}

bool is_station(const Scene& scene, int station) noexcept {
    return 0 <= station && station < static_cast<int>(scene.slit.stations.size());
}

/// From a point to the nearest place of a wall around a station.
class WayToWall {
 public:
    WayToWall(const Scene& scene, const State& state, Wall wall) noexcept
        : slit_(scene.slit), state_(state), wall_(wall) {}

    Vec3 from(const Vec3& p, int station) noexcept {
        best2_ = std::numeric_limits<double>::max();
        const int last = static_cast<int>(slit_.stations.size()) - 1;
        const int first = std::max(0, station - kStationsAround);
        for (int s = first; s < std::min(last, station + kStationsAround); ++s) {
            for (int level = 0; level < slit_.layers; ++level) {
                const Vec3 a = at(s, level), b = at(s + 1, level), c = at(s + 1, level + 1),
                           d = at(s, level + 1);
                look_at(p, {a, b, c});
                look_at(p, {a, c, d});
            }
        }
        return way_;
    }

 private:
    [[nodiscard]] Vec3 at(int station, int level) const noexcept {
        const Slit::Station& s = slit_.stations[static_cast<size_t>(station)];
        return position(state_.body, (s.*wall_)[static_cast<size_t>(level)]);
    }
    void look_at(const Vec3& p, const Triangle& face) noexcept {
        const Vec3 w = closest_on_triangle(p, face);
        const Vec3 offset = w.x() * face[0] + w.y() * face[1] + w.z() * face[2] - p;
        if (!(offset.squaredNorm() < best2_)) return;  // nor what is no number
        best2_ = offset.squaredNorm();
        way_ = offset;
    }

    const Slit& slit_;
    const State& state_;
    Wall wall_;
    double best2_ = 0;
    Vec3 way_ = Vec3::Zero();
};

}  // namespace

double slit_gap(const Scene& scene, const State& state, int station, int level) noexcept {
    assert(is_station(scene, station) && "the slit has no such station");
    assert(0 <= level && level < scene.slit.layers && "a level is from 0 to below the floor");
    const Slit::Station& s = scene.slit.stations[static_cast<size_t>(station)];
    const auto k = static_cast<size_t>(level);
    const Vec3 across = (rest_of(scene, s.right[k]) - rest_of(scene, s.left[k])).normalized();
    const Vec3 from_left = WayToWall(scene, state, &Slit::Station::right)
                               .from(position(state.body, s.left[k]), station);
    const Vec3 from_right = WayToWall(scene, state, &Slit::Station::left)
                                .from(position(state.body, s.right[k]), station);
    // One that has passed the other wall by a little is not apart from it; further, edges ride over
    // each other and shut nothing. Edges of which one stands higher have not passed each other.
    const double left_past = -from_left.dot(across), right_past = from_right.dot(across);
    if (std::max(left_past, right_past) > kPassedM)
        return (left_past > right_past ? from_left : from_right).norm() - kTissueGapM;
    if (left_past >= 0 || right_past >= 0) return 0;
    return std::max(0.0, std::min(from_left.norm(), from_right.norm()) - kTissueGapM);
}

Vec3 middle_at_rest(const Scene& scene, int station) noexcept {
    assert(is_station(scene, station) && "the slit has no such station");
    const Slit::Station& s = scene.slit.stations[static_cast<size_t>(station)];
    return 0.5 * (rest_of(scene, s.left[0]) + rest_of(scene, s.right[0]));
}

double depth_at_rest(const Scene& scene, int station, int level) noexcept {
    assert(is_station(scene, station) && "the slit has no such station");
    assert(0 <= level && level <= scene.slit.layers && "a level is from 0 to the floor");
    const Slit::Station& s = scene.slit.stations[static_cast<size_t>(station)];
    return (rest_of(scene, s.left[0]) - rest_of(scene, s.left[static_cast<size_t>(level)])).norm();
}

bool is_whole(const Scene& scene, const State& state, int32_t v) noexcept {
    const auto around = scene.body.tets_of(v);
    return position(state.body, v).allFinite() &&
           std::all_of(around.begin(), around.end(), [&](int32_t t) {
               return state.body.tet_alive[static_cast<size_t>(t)] != 0;
           });
}

double open_gap(const Scene& scene, const State& state, int station, int level) noexcept {
    assert(is_station(scene, station) && "the slit has no such station");
    assert(0 <= level && level <= scene.slit.layers && "a level is from 0 to the floor");
    const Slit::Station& s = scene.slit.stations[static_cast<size_t>(station)];
    const int32_t left = s.left[static_cast<size_t>(level)],
                  right = s.right[static_cast<size_t>(level)];
    const auto apart = [](const Vec3& a, const Vec3& b) {
        return std::max(0.0, (b - a).norm() - kTissueGapM);
    };
    const bool whole = is_whole(scene, state, left) && is_whole(scene, state, right);
    if (level == scene.slit.layers) {
        // The walls' end: rags of it shut nothing that the walls leave open.
        const double now = apart(position(state.body, left), position(state.body, right));
        return whole ? now : std::max(now, open_gap(scene, state, station, level - 1));
    }
    return whole ? slit_gap(scene, state, station, level)
                 : apart(rest_of(scene, left), rest_of(scene, right));
}

double narrowest_gap(const Scene& scene, const State& state, int station) noexcept {
    assert(is_station(scene, station) && "the slit has no such station");
    double least = std::numeric_limits<double>::max();
    for (int level = 0; level < scene.slit.layers; ++level)
        least = std::min(least, open_gap(scene, state, station, level));
    return least;
}

int nearest_station(const Scene& scene, const Vec2& place) noexcept {
    int nearest = -1;
    double least2 = std::numeric_limits<double>::max();
    for (size_t i = 0; i < scene.slit.stations.size(); ++i) {
        const Vec3 middle = middle_at_rest(scene, static_cast<int>(i));
        const double away2 = (middle.head<2>() - place).squaredNorm();
        if (away2 >= least2) continue;
        least2 = away2;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

bool in_slit(const Scene& scene, const Vec2& place) noexcept {
    const int nearest = nearest_station(scene, place);
    if (nearest < 0) return false;
    const Vec2 way = half_way_across(scene, nearest), across = way.normalized();
    const Vec2 from_middle = place - middle_at_rest(scene, nearest).head<2>();
    const double along = Vec2(-across.y(), across.x()).dot(from_middle);
    double half = way.norm();
    const int next = nearest + (along > 0 ? 1 : -1);
    // Walls run straight from one station to the next.
    if (is_station(scene, next)) {
        const double apart =
            (middle_at_rest(scene, next) - middle_at_rest(scene, nearest)).head<2>().norm();
        half +=
            std::min(1.0, std::abs(along) / apart) * (half_way_across(scene, next).norm() - half);
    }
    const double most = half + kBesideWallM;
    return std::abs(across.dot(from_middle)) <= most && std::abs(along) <= most + kStationM;
}

bool below_skin(const Scene& scene, const Vec3& place) noexcept {
    const int nearest = scene.plane.present() ? nearest_station(scene, place.head<2>()) : -1;
    if (nearest < 0) return false;
    const double depth = middle_at_rest(scene, nearest).z() - place.z();
    return depth > 0.5 * depth_at_rest(scene, nearest, scene.slit.layers);
}

std::vector<Event> slit_events(const Scene& scene, const State& state) {
    std::vector<Event> events;
    const auto stations = static_cast<int>(scene.slit.stations.size());
    if (stations == 0) return events;
    Event head;
    head.kind = EventKind::kSlitGap;
    head.value = static_cast<float>(stations);
    head.value2 = static_cast<float>(depth_at_rest(scene, stations / 2, scene.slit.layers));
    events.push_back(head);
    for (int i = 0; i < stations; ++i) {
        Event event;
        event.kind = EventKind::kSlitGap;
        event.element = i;
        double least = open_gap(scene, state, i, 0);
        event.value2 = static_cast<float>(least);
        for (int level = 1; level < scene.slit.layers; ++level)
            least = std::min(least, open_gap(scene, state, i, level));
        event.value = static_cast<float>(least);
        set_rest_position(event, middle_at_rest(scene, i));
        events.push_back(event);
    }
    return events;
}

}  // namespace placode::sim
