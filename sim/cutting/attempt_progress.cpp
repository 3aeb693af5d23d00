// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/attempt_progress.h"

#include <algorithm>
#include <array>

#include "sim/cutting/cutting.h"
#include "sim/cutting/pieces.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

void set_place(Event& event, const Vec3& at) noexcept {
    for (int k = 0; k < 3; ++k)
        event.rest_position_m[static_cast<size_t>(k)] = static_cast<float>(at[k]);
}

/// Middle of the marked tissue that still hangs in the sector that has most of it.
Vec3 most_left(const Scene& scene, const State& state) {
    constexpr int kWide = 6;  // sectors of 5 degrees: one hour
    std::array<double, kSectors / kWide> volume{};
    std::array<Vec3, kSectors / kWide> moment;
    moment.fill(Vec3::Zero());
    for (size_t t = 0; t < scene.marked.size(); ++t) {
        if (scene.marked[t] == 0 || state.body.tet_alive[t] == 0) continue;
        const int8_t piece = state.pieces.of[t];
        if (piece >= 0 && state.pieces.list[static_cast<size_t>(piece)].leaving == kDrawnOut)
            continue;
        const Vec3 at = rest_centroid(scene, static_cast<int>(t));
        const double here = static_cast<double>(scene.body.volume_m3()[t]);
        const auto hour = static_cast<size_t>(sector_of(at) / kWide);
        volume[hour] += here;
        moment[hour] += here * at;
    }
    const auto most = std::max_element(volume.begin(), volume.end());
    if (!(*most > 0)) return Vec3::Zero();
    return moment[static_cast<size_t>(most - volume.begin())] / *most;
}

/// Stretches of contour points that are not cut, in order; one that passes the end is one.
void add_gaps(const Scene& scene, const State& state, std::vector<Event>& events) {
    const auto& line = scene.geometry.planned_contour;
    const auto& cut = state.progress.cut;
    const size_t n = cut.size();
    if (n < 3 || line.size() != n) return;
    Event head;
    head.time_s = state.time_s;
    head.kind = EventKind::kRingGap;
    head.value2 = static_cast<float>(ring_share(state));
    const size_t at = events.size();
    events.push_back(head);
    // From a point that is cut, so that no gap is met in its middle; a ring without any is one gap.
    const auto first = static_cast<size_t>(std::find(cut.begin(), cut.end(), 1) - cut.begin()) % n;
    std::vector<size_t> gap;
    const auto close = [&] {
        if (gap.empty()) return;
        Event event = head;
        event.element = static_cast<int32_t>(gap[gap.size() / 2]);
        double length = 0;
        for (const size_t i : gap)
            length +=
                ((line[(i + 1) % n] - line[i]).norm() + (line[i] - line[(i + n - 1) % n]).norm()) /
                2;
        event.value = static_cast<float>(length);
        set_place(event, line[gap[gap.size() / 2]]);
        events.push_back(event);
        gap.clear();
    };
    for (size_t k = 0; k < n; ++k) {
        const size_t i = (first + k) % n;
        if (cut[i] == 0)
            gap.push_back(i);
        else
            close();
    }
    close();
    events[at].value = static_cast<float>(events.size() - at - 1);
}

}  // namespace

double ring_share(const State& state) noexcept {
    const size_t points = state.progress.cut.size();
    return points > 0 ? static_cast<double>(state.progress.cut_count) / static_cast<double>(points)
                      : 0;
}

double taken_out_share(const Scene& scene, const State& state) noexcept {
    if (!(scene.marked_volume_m3 > 0)) return -1;
    // Sums in another order than the whole: a share of 1 stays one.
    return std::min(1.0, state.pieces.marked_out_m3 / scene.marked_volume_m3);
}

double gone_share(const Scene& scene, const State& state) noexcept {
    if (!(scene.marked_volume_m3 > 0)) return -1;
    return std::min(
        1.0, (state.pieces.marked_out_m3 + state.pieces.marked_lost_m3) / scene.marked_volume_m3);
}

Event taken_out_event(const Scene& scene, const State& state) noexcept {
    Event event;
    event.time_s = state.time_s;
    event.kind = EventKind::kTakenOut;
    event.tissue = Tissue::kZone;
    event.value = static_cast<float>(state.pieces.marked_out_m3);
    event.value2 = static_cast<float>(taken_out_share(scene, state));
    return event;
}

std::vector<Event> reached_events(const Scene& scene, const State& state) {
    std::vector<Event> events;
    if (scene.marked_volume_m3 > 0) {
        events.push_back(taken_out_event(scene, state));
        set_place(events.back(), most_left(scene, state));
        Event lost = taken_out_event(scene, state);
        lost.kind = EventKind::kMarkedLost;
        lost.value = static_cast<float>(state.pieces.marked_lost_m3);
        lost.value2 =
            static_cast<float>(std::min(1.0, state.pieces.marked_lost_m3 / scene.marked_volume_m3));
        events.push_back(lost);
    }
    add_gaps(scene, state, events);
    return events;
}

}  // namespace placode::sim
