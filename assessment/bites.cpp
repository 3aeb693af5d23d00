// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/bites.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/loci.h"

namespace placode::assessment {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Vec3;

/// What the point has done since it last opened a surface; of a slit this may be a wall, which is
/// no entry of a bite.
struct Prick {
    double angle_rad = 0, depth_m = 0;
    uint64_t channel = 0;

    void note(const Event& e) {
        if (e.kind == EventKind::kNeedleEntered)
            *this = {std::asin(std::clamp(static_cast<double>(e.value2), 0.0, 1.0)), 0, e.hash};
        else if (e.kind == EventKind::kNeedleLeft)
            depth_m = std::max(depth_m, static_cast<double>(e.value2));
    }
};

/// What an event says of the bite that is being done.
void note(const Event& e, const Prick& prick, Bite& bite) {
    switch (e.kind) {
        case EventKind::kBiteEntry:  // told after the needle's own events
            if (!bite.left) {
                bite.angle_rad = prick.angle_rad;
                bite.depth_m = prick.depth_m;
                bite.first_channel = prick.channel;
            }
            bite.entered = true;
            bite.entered_s = e.time_s;
            bite.entry_m = rest_place(e);
            bite.entry_offset_m = static_cast<double>(e.value2);
            break;
        case EventKind::kBiteExit:
            bite.left = true;
            bite.left_s = e.time_s;
            bite.exit_m = rest_place(e);
            bite.exit_offset_m = static_cast<double>(e.value2);
            break;
        case EventKind::kNeedleLeft:
            if (bite.left) break;
            bite.depth_m = std::max(bite.depth_m, static_cast<double>(e.value2));
            bite.channel = e.hash;
            break;
        case EventKind::kNeedleThrough:
            bite.done =
                !bite.lost && (bite.done || (bite.entered && bite.left && e.hash == bite.channel));
            break;
        case EventKind::kNeedleLeftIn:
            bite.done = false;
            break;
        default:
            break;
    }
}

/// A channel without thread holds nothing, however long ago and well it was sewn.
void note_lost(const Event& e, Bite& bite) {
    if (e.kind != EventKind::kThreadToreOut && e.kind != EventKind::kThreadOut) return;
    if (!bite.left || (e.hash != bite.first_channel && e.hash != bite.channel)) return;
    bite.lost = true;
    bite.done = false;
}

double across_m(const Bite& bite, const Vec3& place) {
    const Vec3 offset = bite.mark_in_m - bite.mark_out_m;
    if (offset.squaredNorm() < 1e-12) return 0;  // marks at one place have no line between them
    return (place - bite.planned_middle_m()).dot(offset.normalized());
}

std::vector<double> pitches_m(const std::vector<Bite>& bites) {
    std::vector<double> found;
    for (size_t i = 1; i < bites.size(); ++i)
        if (const auto pitch = pitch_m(bites[i - 1], bites[i])) found.push_back(*pitch);
    return found;
}

double spread(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most - *least;
}

/// A metric speaks of what was done of a bite, finished or not: else whoever leaves a bad one would
/// do better than whoever ends it.
bool speaks_of(std::string_view metric, const Bite& bite) {
    if (metric == "bite_entry_worst_mm" || metric == "bite_angle_least_deg") return bite.entered;
    if (metric == "bite_exit_worst_mm" || metric == "bite_asymmetry_mm" ||
        metric.substr(0, 11) == "bite_depth_")
        return bite.entered && bite.left;
    return bite.done;
}

/// What is largest at the bite that a metric speaks of.
double badness(std::string_view metric, const Bite& bite) {
    if (metric == "bite_entry_worst_mm") return bite.entry_offset_m;
    if (metric == "bite_exit_worst_mm") return bite.exit_offset_m;
    if (metric == "bite_depth_least_mm") return -bite.depth_m;
    if (metric == "bite_depth_most_mm" || metric == "bite_depth_spread_mm") return bite.depth_m;
    if (metric == "bite_asymmetry_mm") return bite.asymmetry_m();
    if (metric == "bite_angle_least_deg") return -bite.angle_rad;
    return bite.number;  // of the row as a whole: its last
}

}  // namespace

double Bite::entry_from_line_m() const { return across_m(*this, entry_m); }
double Bite::exit_from_line_m() const { return -across_m(*this, exit_m); }
double Bite::asymmetry_m() const { return std::abs(entry_from_line_m() - exit_from_line_m()); }

std::vector<Bite> bites_of(const sim::Recording& recording) {
    std::vector<Bite> bites;
    Prick prick;
    for (const Event& e : recording.events) {
        prick.note(e);
        for (Bite& bite : bites) note_lost(e, bite);
        if (e.kind == EventKind::kBiteMark) {
            if (bites.empty() || bites.back().number != e.element) {
                bites.emplace_back();
                bites.back().number = e.element;
            }
            (e.value2 > 0 ? bites.back().mark_out_m : bites.back().mark_in_m) = rest_place(e);
        } else if (!bites.empty()) {
            note(e, prick, bites.back());
        }
    }
    return bites;
}

std::optional<Bite> last_bite(const sim::Recording& recording) {
    std::optional<Bite> bite;
    Prick prick;
    for (const Event& e : recording.events) {
        prick.note(e);
        if (e.kind == EventKind::kBiteEntry && (!bite || bite->left)) bite.emplace();
        if (!bite) continue;
        note(e, prick, *bite);
        note_lost(e, *bite);
    }
    return bite;
}

std::optional<double> pitch_m(const Bite& before, const Bite& after) {
    if (!before.done || !after.done || after.number != before.number + 1) return std::nullopt;
    const Vec3 along = after.planned_middle_m() - before.planned_middle_m();
    if (along.squaredNorm() < 1e-12) return std::nullopt;
    return (after.middle_m() - before.middle_m()).dot(along.normalized());
}

const Bite* bite_shown(std::string_view metric, const std::vector<Bite>& bites) {
    const Bite* worst = nullptr;
    for (const Bite& bite : bites)
        if (speaks_of(metric, bite) &&
            (worst == nullptr || badness(metric, bite) > badness(metric, *worst)))
            worst = &bite;
    return worst;
}

void add_bite_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    const std::vector<Bite> bites = bites_of(recording);
    if (bites.empty()) return;
    const auto add = [&](const char* id, double value) { out.push_back({id, value}); };
    // At the bite that is worst, if there is one.
    const auto worst = [&](const char* id, double unit, auto value_of) {
        if (const Bite* bite = bite_shown(id, bites)) add(id, unit * value_of(*bite));
    };
    add("bites_done", static_cast<double>(std::count_if(
                          bites.begin(), bites.end(), [](const Bite& bite) { return bite.done; })));
    worst("bite_entry_worst_mm", 1e3, [](const Bite& bite) { return bite.entry_offset_m; });
    worst("bite_exit_worst_mm", 1e3, [](const Bite& bite) { return bite.exit_offset_m; });
    worst("bite_depth_least_mm", 1e3, [](const Bite& bite) { return bite.depth_m; });
    worst("bite_depth_most_mm", 1e3, [](const Bite& bite) { return bite.depth_m; });
    worst("bite_asymmetry_mm", 1e3, [](const Bite& bite) { return bite.asymmetry_m(); });
    worst("bite_angle_least_deg", 180 / std::numbers::pi,
          [](const Bite& bite) { return bite.angle_rad; });
    std::vector<double> depths;
    for (const Bite& bite : bites)
        if (speaks_of("bite_depth_spread_mm", bite)) depths.push_back(bite.depth_m);
    if (!depths.empty()) add("bite_depth_spread_mm", 1e3 * spread(depths));  // of a single bite 0
    const std::vector<double> pitches = pitches_m(bites);
    if (pitches.empty()) return;
    double mean = 0;
    for (const double pitch : pitches) mean += pitch / static_cast<double>(pitches.size());
    add("bite_pitch_mm", 1e3 * mean);
    // Of a single distance nobody can say whether it is even.
    if (pitches.size() > 1) add("bite_pitch_spread_mm", 1e3 * spread(pitches));
}

}  // namespace placode::assessment
