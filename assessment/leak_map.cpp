// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/leak_map.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/bites.h"
#include "assessment/closure.h"
#include "assessment/loci.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Vec2;

/// What the events of one station say; each list of stations has it once.
struct Told {
    LeakStation station;
    size_t leaks = 0, gaps = 0;  ///< Stages told.
    bool gap = false, opened = false;
};

void note(const Event& e, Told& told) {
    const auto value = static_cast<double>(e.value);
    LeakStation& station = told.station;
    switch (e.kind) {
        case EventKind::kSlitGap:
            station.gap_m = value;
            told.gap = true;
            break;
        case EventKind::kWatertight:
            if (told.leaks == kLeakStages) break;
            station.leak_m3_s[told.leaks++] = value;
            station.at_m = rest_place(e).head<2>();
            break;
        case EventKind::kSlitPressed:
            if (told.gaps < kLeakStages) station.pressed_gap_m[told.gaps++] = value;
            break;
        case EventKind::kSlitOpened:
            station.opened_pa = e.value2 > 0 ? value : -1;
            told.opened = true;
            break;
        default:
            break;
    }
}

/// From its first end to its last, in the plane at rest.
struct Axis {
    Vec2 from = Vec2::Zero(), along = Vec2::Zero();
    double lead_m = 0;  ///< Of the first station from the end.

    /// Along the slit from its first end, and aside.
    [[nodiscard]] Vec2 seen(const Vec2& p) const {
        const Vec2 up(-along.y(), along.x());  // with +x up and +y left
        return {(p - from).dot(along) + lead_m, (p - from).dot(up)};
    }
};

double apart_m(const LeakStation& a, const LeakStation& b) { return (b.at_m - a.at_m).norm(); }

/// Puts the stations into order, gives them their places and the map its ends. False where they
/// lie at one place.
bool lay_out(LeakMap& map, Axis& axis) {
    std::vector<LeakStation>& all = map.stations;
    const Vec2 way = all.back().at_m - all.front().at_m;
    if (!(way.norm() > 1e-6)) return false;
    map.upright = std::abs(way.x()) > std::abs(way.y());
    // Up is +x and left +y.
    if ((map.upright ? way.x() : way.y()) > 0) std::reverse(all.begin(), all.end());
    axis.from = all.front().at_m;
    axis.along = (all.back().at_m - all.front().at_m).normalized();
    axis.lead_m = apart_m(all[0], all[1]);
    for (size_t i = 0; i < all.size(); ++i) {
        all[i].along_m = axis.seen(all[i].at_m).x();
        all[i].length_m = 0;
        if (i > 0) all[i].length_m += 0.5 * apart_m(all[i - 1], all[i]);
        if (i + 1 < all.size()) all[i].length_m += 0.5 * apart_m(all[i], all[i + 1]);
    }
    map.length_m = all.back().along_m + apart_m(all[all.size() - 2], all.back());
    return std::isfinite(map.length_m);
}

void add_bites(const sim::Recording& recording, const Axis& axis, LeakMap& map) {
    for (const Bite& bite : bites_of(recording)) {
        if (!bite.entered && !bite.left) continue;
        map.bites.push_back({bite.number + 1, axis.seen(bite.entry_m.head<2>()),
                             axis.seen(bite.exit_m.head<2>()), bite.entered, bite.left, bite.done});
    }
}

}  // namespace

std::optional<LeakMap> leak_map(const sim::Recording& recording) {
    const std::optional<Watertight> test = watertight_of(recording);
    if (!test) return std::nullopt;
    std::map<int32_t, Told> stations;
    LeakMap map;
    map.all_m3_s = {test->pass_m3_s, test->good_m3_s, 0};
    map.held_pa = test->held_pa;
    bool head = false;
    double last_m3_s = 0;
    for (const Event& e : recording.events) {
        if (e.element >= 0 &&
            (e.kind == EventKind::kSlitGap || e.kind == EventKind::kWatertight ||
             e.kind == EventKind::kSlitPressed || e.kind == EventKind::kSlitOpened))
            note(e, stations[e.element]);
        if (e.kind == EventKind::kWatertight && e.element == -2)
            last_m3_s = static_cast<double>(e.value);
        if (e.kind == EventKind::kSlitOpened && e.element < 0) {
            head = true;
            map.burst = e.value2 > 0;
        }
    }
    if (stations.size() < 2) return std::nullopt;
    map.whole = head;
    for (const auto& [number, told] : stations) {
        if (!told.gap || told.leaks < 2) return std::nullopt;
        map.whole =
            map.whole && told.leaks == kLeakStages && told.gaps == kLeakStages && told.opened;
        map.stations.push_back(told.station);
        map.stations.back().number = number;
    }
    if (map.whole) map.all_m3_s[2] = last_m3_s;
    map.burst = map.burst && map.whole;
    Axis axis;
    if (!lay_out(map, axis)) return std::nullopt;
    add_bites(recording, axis, map);
    return map;
}

std::optional<LeakPlace> worst_leak(const LeakMap& map, LeakStage stage) {
    if (stage == LeakStage::kLast && !map.whole) return std::nullopt;
    const auto at = static_cast<size_t>(stage);
    std::vector<const LeakBite*> bites;
    for (const LeakBite& bite : map.bites)
        if (bite.done) bites.push_back(&bite);
    std::sort(bites.begin(), bites.end(),
              [](const LeakBite* a, const LeakBite* b) { return a->along_m() < b->along_m(); });
    std::vector<double> leaks(bites.size() + 1, 0);
    std::vector<const LeakStation*> worst(bites.size() + 1, nullptr);
    double all = 0;
    for (const LeakStation& station : map.stations) {
        const auto stretch = static_cast<size_t>(std::count_if(
            bites.begin(), bites.end(),
            [&](const LeakBite* bite) { return bite->along_m() <= station.along_m; }));
        const double leak = station.leak_m3_s[at];
        leaks[stretch] += leak;
        all += leak;
        const LeakStation*& shown = worst[stretch];
        if (shown == nullptr || leak > shown->leak_m3_s[at]) shown = &station;
    }
    const auto most =
        static_cast<size_t>(std::max_element(leaks.begin(), leaks.end()) - leaks.begin());
    if (!(leaks[most] > 0) || worst[most] == nullptr) return std::nullopt;
    LeakPlace place;
    place.between.before = most == 0 ? 0 : bites[most - 1]->number;
    place.between.after = most == bites.size() ? 0 : bites[most]->number;
    place.between.upright = map.upright;
    place.stretch = static_cast<int>(most);
    place.along_m = worst[most]->along_m;
    place.at_m = worst[most]->at_m;
    place.leak_m3_s = leaks[most];
    place.rest_m3_s = std::max(0.0, all - leaks[most]);
    return place;
}

}  // namespace placode::assessment
