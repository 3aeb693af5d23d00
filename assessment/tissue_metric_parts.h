// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of add_tissue_metrics() by subject. Private to assessment.

#include <algorithm>
#include <optional>
#include <vector>

#include "assessment/tissue_metrics.h"
#include "sim/core/healthy_skin.h"

namespace placode::assessment {

using sim::is_skin;
using sim::kOutsideSkinM;

/// Events of one kind in the ledger.
struct EventSum {
    int count = 0;
    double value = 0;  ///< Sum of Event::value.
    double peak = 0;   ///< Largest Event::value2.
};
[[nodiscard]] inline EventSum total(const sim::Recording& recording, sim::EventKind kind) {
    EventSum sum;
    for (const sim::Event& event : recording.events) {
        if (event.kind != kind) continue;
        ++sum.count;
        sum.value += event.value;
        sum.peak = std::max(sum.peak, static_cast<double>(event.value2));
    }
    return sum;
}

/// A time in which one instrument did too much [s].
struct Spell {
    int tool = -1;
    double from_s = 0, to_s = 0;
};
inline constexpr double kAgainS = 2;  ///< A spell counts once more for each time like this.

/// Spells as a number of times: one for the first of an instrument, once more for each kAgainS of
/// each, and one for the next where it begins kPauseS or later, before that in proportion. A pause
/// weighs less than the same time in the spell, so that nothing is gained by pressing on through a
/// pause, nor by pauses in a spell; and time that spells share counts once.
[[nodiscard]] double times_of(std::vector<Spell> spells);
/// Spells of a kind whose event was raised at the end of one, with its length.
[[nodiscard]] std::vector<Spell> spells_of(const sim::Recording& recording, sim::EventKind kind);

/// Which of what heat removed, or warmed, was healthy skin. A kerf may reach 1 mm beyond the edge
/// of the lesion, wherever the plan runs; farther out nothing is part of the operation, however far
/// it is. Where a scene has no lesion, or an event no place, nothing excuses the loss.
class HealthySkin {
 public:
    explicit HealthySkin(const sim::FieldGeometry& geometry) {
        if (geometry.skin_edge.size() >= 3) edge_.emplace(geometry.skin_edge);
    }
    [[nodiscard]] bool holds(sim::Tissue tissue, const Vec2& at_m) const noexcept {
        return is_skin(tissue) &&
               (!edge_ || !at_m.allFinite() || edge_->nearest(at_m).offset > kOutsideSkinM);
    }
    [[nodiscard]] bool burned(const sim::Event& event) const noexcept {
        return event.kind == sim::EventKind::kVaporised &&
               holds(event.tissue, {event.rest_position_m[0], event.rest_position_m[1]});
    }
    /// Current flows into it. A tip stands where tissue is now, which near the edge may have been
    /// drawn along by less than a kerf may reach.
    [[nodiscard]] bool heated(const sim::ToolSample& tool) const noexcept {
        return tool.power_w > 0 && holds(tool.touched, {tool.tip_m[0], tool.tip_m[1]});
    }

 private:
    std::optional<ClosedContour> edge_;
};

/// Skin that heat removed outside of the lesion, and energy that reached skin there.
void add_burned_skin(const sim::Recording& recording, std::vector<Metric>& out);
/// Where the incision runs, from what was removed.
void add_incision(const sim::Recording& recording, std::vector<Metric>& out);
/// How much of the ring is cut, from the number that the picture showed, and its gaps.
void add_ring(const sim::Recording& recording, std::vector<Metric>& out);
/// Planned contour that is cut, over the tip's path with the pedal down and in contact.
void add_cutting_economy(const sim::Recording& recording, std::vector<Metric>& out);

/// Peak and excessive force, and what was torn.
void add_force(const sim::Recording& recording, std::vector<Metric>& out);
/// Sums over the samples in which an instrument touches tissue.
void add_contact_force(const sim::Recording& recording, std::vector<Metric>& out);

/// Grasper and scissors. Nothing where the scene has neither.
void add_dissection(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
