// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The bites of a running suture, one by one and as a row: what they have in common is what a
// running suture is judged by. From the events of a recording; a single bite has no row.

#include <optional>
#include <vector>

#include "assessment/metrics.h"
#include "sim/core/geometry.h"

namespace placode::assessment {

/// One bite of a row. Places on the rest shape [m].
struct Bite {
    int number = 0;                           ///< From 0, in the order of the task.
    sim::Vec3 mark_in_m = sim::Vec3::Zero();  ///< Where the needle was to go in, and out.
    sim::Vec3 mark_out_m = sim::Vec3::Zero();
    sim::Vec3 entry_m = sim::Vec3::Zero(), exit_m = sim::Vec3::Zero();  ///< The last of each.
    double entry_offset_m = 0, exit_offset_m = 0;                       ///< From their marks.
    /// Deepest place of its channels below the surface at rest: through both walls of a slit it has
    /// two.
    double depth_m = 0;
    double angle_rad = 0;  ///< Of the needle to the surface at rest where it went in.
    uint64_t first_channel = 0, channel = 0;  ///< That of the entry, that of the exit.
    double entered_s = 0, left_s = 0;
    bool entered = false, left = false;
    bool lost = false;  ///< Thread tore, or was drawn, out of one of these channels.
    /// Came out, all of the needle was drawn through, and the thread is in it; the last one not
    /// while the needle is in tissue, where it may stand in for a bite.
    bool done = false;

    /// Distances of entry and exit from the line, which is square to the way between the marks and
    /// passes in the middle between them.
    [[nodiscard]] double entry_from_line_m() const;
    [[nodiscard]] double exit_from_line_m() const;
    [[nodiscard]] double asymmetry_m() const;
    [[nodiscard]] sim::Vec3 middle_m() const { return 0.5 * (entry_m + exit_m); }
    [[nodiscard]] sim::Vec3 planned_middle_m() const { return 0.5 * (mark_in_m + mark_out_m); }
};

/// Every bite that was begun, in order; empty where the task has no row of bites.
[[nodiscard]] std::vector<Bite> bites_of(const sim::Recording& recording);

/// The bite that was begun last, of a row or by itself: not every prick is one. Nothing where none
/// was begun. It has no number and no marks.
[[nodiscard]] std::optional<Bite> last_bite(const sim::Recording& recording);

/// Distance of a bite from the one before, along the line between their planned middles [m]; below
/// zero where they lie in the wrong order. Nothing unless both are done and neighbours.
[[nodiscard]] std::optional<double> pitch_m(const Bite& before, const Bite& after);

/// Which bite a metric of the row speaks of: the worst, or the last of those between which a spread
/// is largest, among those that were done as far as the metric asks (in, out, or all of the needle
/// drawn through). nullptr = of none.
[[nodiscard]] const Bite* bite_shown(std::string_view metric, const std::vector<Bite>& bites);

/// Metrics of the row: of each bite what was done of it, of the pitch the bites that are done.
/// Nothing where the task has no row.
void add_bite_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
