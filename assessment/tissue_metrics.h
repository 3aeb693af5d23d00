// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the tissue suffered and how well the ring was cut: pure functions of contours, temperature
// and force signals, and of a recording. Lengths here are in m unless the caller's signals differ.

#include <optional>
#include <span>
#include <vector>

#include "assessment/metrics.h"
#include "sim/core/geometry.h"

namespace placode::assessment {

using sim::Vec2;
using sim::Vec3;

/// A closed planned line with arc length, in the x-y plane.
class ClosedContour {
 public:
    /// @pre at least 3 points, the last one not a copy of the first.
    explicit ClosedContour(std::span<const Vec3> points);

    struct Foot {
        double arc = 0;     ///< Arc length of the nearest point of the line.
        double offset = 0;  ///< Signed distance: negative inside, positive outside.
    };
    [[nodiscard]] Foot nearest(const Vec2& point) const noexcept;
    [[nodiscard]] Vec2 at(double arc) const noexcept;
    [[nodiscard]] double length() const noexcept { return arc_.back(); }

 private:
    std::vector<Vec2> points_;
    std::vector<double> arc_;  // one more than points: the last is the perimeter
};

/// Union of arcs on a closed line of the given length.
class ArcCover {
 public:
    explicit ArcCover(double length) : length_(length) {}
    /// Covers from `from` to `to` in the direction of growing arc length (may pass the end).
    void add(double from, double to);
    struct Result {
        double covered = 0;      ///< Share 0..1.
        double largest_gap = 0;  ///< Length of the longest uncovered arc.
        double gap_middle = 0;   ///< Arc length of its middle.
        int gaps = 0;
    };
    [[nodiscard]] Result result() const;

 private:
    double length_;
    std::vector<std::pair<double, double>> arcs_;
};

/// How a cut line follows a planned closed line.
struct ContourComparison {
    double mean_abs = 0, rms = 0, p95 = 0, max = 0;  ///< Cut vertices to planned segments.
    double mean_signed = 0;                          ///< Negative: inside.
    double hausdorff_cut_to_plan = 0;                ///< Directed, between the vertex sets.
    double hausdorff_plan_to_cut = 0, hausdorff = 0;
    double completeness = 0;  ///< 0..1 of the planned length within the tolerance.
    double largest_gap = 0;
    int gaps = 0;
};
/// The cut counts as closed when its ends are no further apart than 2.5 mean segments.
[[nodiscard]] ContourComparison compare_contours(std::span<const Vec3> plan,
                                                 std::span<const Vec3> cut, double tolerance);

/// Thermal dose in equivalent minutes at 43 C, trapezoid over the rate. R = 0.5 above, 0.25 below.
/// Source: Sapareto & Dewey 1984.
[[nodiscard]] double cem43_min(std::span<const double> time_s,
                               std::span<const double> temperature_c);
/// Arrhenius damage integral, trapezoid [-].
[[nodiscard]] double arrhenius_damage(std::span<const double> time_s,
                                      std::span<const double> temperature_c, double a_per_s,
                                      double ea_j_mol);

struct ForceSummary {
    double peak_n = 0, mean_n = 0, rms_n = 0, impulse_n_s = 0;
    double over_s = 0;  ///< Sum of dt with F above the threshold.
    double excess_impulse_n_s = 0;
};
/// Trapezoid rules over the whole signal.
[[nodiscard]] ForceSummary summarise_force(std::span<const double> time_s,
                                           std::span<const double> force_n, double threshold_n);

/// One stretch of the planned contour (about 0.5 mm) and what was removed next to it.
struct KerfBin {
    double arc_m = 0;  ///< Middle.
    Vec2 at_m = Vec2::Zero();
    double volume_m3 = 0;
    double offset_m = 0;  ///< Volume-weighted mean signed distance to the plan: the kerf's centre.
    double width_m = 0;
    double time_s = -1;           ///< First element removed here.
    bool outside_band = false;    ///< Something was removed over 1 mm into healthy skin.
    bool toward_placode = false;  ///< Something was removed less than 0.5 mm from the placode.
};

/// The incision of a recording.
struct Incision {
    std::vector<KerfBin> bins;
    ArcCover::Result cover;  ///< At target depth, within 1 mm of the plan.
    double perimeter_m = 0, bin_m = 0;
    Vec2 gap_at_m = Vec2::Zero();  ///< Middle of the largest gap.
};
/// Nothing when the scene has no planned contour.
[[nodiscard]] std::optional<Incision> analyse_incision(const sim::Recording& recording);

/// At cutting temperatures thermal dose [min] and damage pass every number (and float) within a
/// second; past this they say no more than "destroyed".
inline constexpr double kLargestDoseMin = 1e6, kLargestDamage = 1e6;
inline constexpr double kOffLineM = 0.0005;  ///< Kerf centre further than this is off the line.

/// Share of the planned contour that is cut through, 0..1: what the picture showed in the end.
[[nodiscard]] double ring_cut_share(const sim::Recording& recording) noexcept;

/// True when the ledger has all that sim::kLedgerVersion promises, also where that is nothing.
[[nodiscard]] bool has_ledger(const sim::Recording& recording) noexcept;

/// Over-stretch (T10) and thermal spread (T5), from the sums that the simulation enters.
void add_damage(const sim::Recording& recording, std::vector<Metric>& out);

/// Metrics that a recording of this program would give and this one, made by an older program or
/// interrupted before its end, cannot.
[[nodiscard]] std::vector<std::string_view> not_recorded(const sim::Recording& recording);

/// Appends what the recording allows. Never throws on odd data.
void add_tissue_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
