// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures of one attempt, the same in window and PDF: the damage ledger on a time line, damage on
// the anatomy at rest, the instruments' ways from three sides, a value beside its band.

#include <QPainter>
#include <optional>
#include <vector>

#include "assessment/ledger.h"
#include "assessment/standard_setting.h"
#include "reports/report.h"
#include "reports/task_scope.h"

namespace placode::reports {

/// A remark at a time, e.g. of an educator.
struct TimeMark {
    double time_s = 0;
    std::string label;  ///< One or two characters inside the flag.
};

/// What stands on the time line.
struct LedgerPicture {
    double duration_s = 1;
    std::vector<assessment::PhaseStart> phases;
    std::vector<assessment::LedgerEntry> entries;
    std::vector<std::pair<double, double>> energy;  ///< From, to [s].
    std::vector<TimeMark> marks;
    int selected = -1;                   ///< Entry with a frame round it.
    double cursor_s = -1;                ///< Where a replay stands; -1 = no line.
    int lanes = assessment::kHarmLanes;  ///< The first ones; the last is energy.
};
/// Phases and the lane of energy only where the task has them.
[[nodiscard]] LedgerPicture ledger_picture(const sim::Recording& recording, const TaskScope& scope);

/// Height that the time line wants at this font size [px].
[[nodiscard]] double ledger_height(const ChartStyle& style);
void draw_ledger(QPainter& painter, const QRectF& where, const LedgerPicture& picture,
                 const ChartStyle& style);
/// Rectangle of each entry, at least 12 px wide, for pointers and fingers.
[[nodiscard]] std::vector<QRectF> ledger_boxes(const QRectF& where, const LedgerPicture& picture,
                                               const ChartStyle& style);
/// Time under a point, clamped to the attempt [s].
[[nodiscard]] double ledger_time_at(const QRectF& where, const LedgerPicture& picture,
                                    const ChartStyle& style, double x_px);

/// What the map of the field shows.
enum class FieldLayer : uint8_t {
    kDamage,  ///< Entries of the ledger by clock sector and region, with a sign at each place.
    kEnergy   ///< Energy delivered into the tissue [J/mm2].
};
/// The anatomy at rest with clock positions.
void draw_field_map(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                    const std::vector<assessment::LedgerEntry>& entries, FieldLayer layer,
                    const ChartStyle& style);

/// Entries of the ledger by clock hour (0 = 12 o'clock, 1 = 1 o'clock ..) and region.
[[nodiscard]] std::array<std::array<int, assessment::kRegions>, 12> damage_by_sector(
    const std::vector<assessment::LedgerEntry>& entries);

/// What the steps of an exercise asked for, and what came of it.
struct AskedPlaces {
    struct Place {
        sim::Vec2 at_m = sim::Vec2::Zero();
        int step = 0;  ///< From 0.
        bool done = false;
    };
    std::vector<Place> places;      ///< To be touched, cut, grasped ..
    std::vector<sim::Vec2> missed;  ///< Tissue was touched beside the place.
    bool line = false;              ///< The planned line was to be followed ..
    std::vector<uint8_t> followed;  ///< .. and was (1): kTraceBins stretches of it.
    [[nodiscard]] bool any() const noexcept { return line || !places.empty(); }
    [[nodiscard]] int done() const noexcept;
};
/// Nothing for a task without such steps, or one that this build cannot read any more.
[[nodiscard]] AskedPlaces asked_places(const sim::Recording& recording);
/// The field from above with these places (numbered; filled = done) and touches beside them.
void draw_asked(QPainter& painter, const QRectF& where, const sim::FieldGeometry& geometry,
                const AskedPlaces& asked, const ChartStyle& style);

enum class Side : uint8_t {
    kAbove,     ///< x up, y to the left.
    kFromSide,  ///< Seen from the patient's left: x to the left, z up.
    kFromFeet   ///< Seen from caudal: y to the left, z up.
};
/// Ways of all instruments but the scope; where energy flowed they are thick.
void draw_trajectory(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                     Side side, const ChartStyle& style);

/// A value on the band of earlier ones: mean and one standard deviation, with the extremes.
struct Band {
    double mean = 0, sd = 0, low = 0, high = 0;
    int n = 0;
};
[[nodiscard]] std::optional<Band> band_of(const std::vector<double>& values);
void draw_band(QPainter& painter, const QRectF& where, const Band& band, double value,
               const ChartStyle& style);

/// Contrasting groups: both groups' scores under their normal curves, the cut between them.
void draw_groups(QPainter& painter, const QRectF& where,
                 const assessment::ContrastingGroups& result, const std::vector<double>& novices,
                 const std::vector<double>& experts, const ChartStyle& style);

}  // namespace placode::reports
