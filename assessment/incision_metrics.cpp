// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The incision as a line: how it follows the plan, how much of the ring is cut, on what way.

#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/motion_metrics.h"
#include "assessment/statistics.h"
#include "assessment/tissue_metric_parts.h"

namespace placode::assessment {

namespace {

/// Largest distance either way between plan and incision, so that a gap shows, too.
double hausdorff(const Incision& incision) {
    const auto& bins = incision.bins;
    const size_t n = bins.size();
    double area = 0;
    for (size_t i = 0; i < n; ++i) {
        const Vec2 &a = bins[i].at_m, &b = bins[(i + 1) % n].at_m;
        area += a.x() * b.y() - a.y() * b.x();
    }
    std::vector<Vec3> cut, plan;
    for (size_t i = 0; i < n; ++i) {
        plan.emplace_back(bins[i].at_m.x(), bins[i].at_m.y(), 0);
        if (!(bins[i].volume_m3 > 0)) continue;
        const Vec2 along = bins[(i + 1) % n].at_m - bins[(i + n - 1) % n].at_m;
        Vec2 out = Vec2(along.y(), -along.x()).normalized();
        if (area < 0) out = -out;
        const Vec2 at = bins[i].at_m + bins[i].offset_m * out;
        cut.emplace_back(at.x(), at.y(), 0);
    }
    return cut.empty() ? -1 : compare_contours(plan, cut, 0.001).hausdorff;
}

}  // namespace

double ring_cut_share(const sim::Recording& recording) noexcept {
    double share = 0;
    // Frames after the last sample count as well.
    for (const sim::Event& event : recording.events)
        if (event.kind == sim::EventKind::kRingGap && event.element < 0 &&
            std::isfinite(event.value2))
            share = std::max(share, static_cast<double>(event.value2));
    for (const sim::Sample& sample : recording.samples)
        if (std::isfinite(sample.cut_fraction))
            share = std::max(share, static_cast<double>(sample.cut_fraction));
    return std::min(1.0, share);
}

void add_ring(const sim::Recording& recording, std::vector<Metric>& out) {
    if (recording.header.geometry.planned_contour.empty()) return;
    out.push_back({"ring_completeness_percent", ring_cut_share(recording) * 100});
    bool told = false;
    double longest = 0;
    int gaps = 0;
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kRingGap) continue;
        told = true;
        if (event.element < 0) continue;
        ++gaps;
        longest = std::max(longest, static_cast<double>(event.value));
    }
    if (!told) return;
    out.push_back({"largest_gap_mm", longest * 1e3});
    out.push_back({"gap_count", static_cast<double>(gaps)});
}

void add_incision(const sim::Recording& recording, std::vector<Metric>& out) {
    const std::optional<Incision> incision = analyse_incision(recording);
    if (!incision) return;
    std::vector<double> distance;
    double mean_signed = 0, width = 0;
    double outside_m = 0, toward_m = 0, off_m = 0;
    for (const KerfBin& bin : incision->bins) {
        if (!(bin.volume_m3 > 0)) continue;
        distance.push_back(std::abs(bin.offset_m));
        mean_signed += bin.offset_m;
        width += bin.width_m;
        if (bin.outside_band) outside_m += incision->bin_m;
        if (bin.toward_placode) toward_m += incision->bin_m;
        // Two faults on both sides have a mean between them: that is no line either.
        if (distance.back() > kOffLineM || bin.outside_band || bin.toward_placode)
            off_m += incision->bin_m;
    }
    if (!distance.empty()) {
        const double n = static_cast<double>(distance.size());
        double mean = 0, square = 0;
        for (const double d : distance) {
            mean += d / n;
            square += d * d / n;
        }
        std::sort(distance.begin(), distance.end());
        out.push_back({"contour_deviation_mm", mean * 1e3});
        out.push_back({"contour_deviation_p95_mm", quantile(distance, 0.95) * 1e3});
        out.push_back({"contour_deviation_max_mm", distance.back() * 1e3});
        out.push_back({"contour_deviation_rms_mm", std::sqrt(square) * 1e3});
        out.push_back({"contour_signed_mm", mean_signed / n * 1e3});
        if (const double worst = hausdorff(*incision); worst >= 0)
            out.push_back({"contour_hausdorff_mm", worst * 1e3});
        out.push_back({"kerf_width_mm", width / n * 1e3});
    }
    out.push_back({"off_line_mm", off_m * 1e3});
    out.push_back({"outside_band_mm", outside_m * 1e3});
    out.push_back({"toward_placode_mm", toward_m * 1e3});
}

void add_burned_skin(const sim::Recording& recording, std::vector<Metric>& out) {
    const HealthySkin skin(recording.header.geometry);
    double burned_m3 = 0;
    for (const sim::Event& event : recording.events)
        if (event.value > 0 && skin.burned(event)) burned_m3 += event.value;
    out.push_back({"skin_burned_mm3", burned_m3 * 1e9});
    // What is heated and stays shows nowhere else: a recording holds no tissue.
    double joules = 0;
    for (const sim::Sample& sample : recording.samples)
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i)
            if (skin.heated(sample.tools[i]))
                joules += sample.tools[i].power_w * recording.header.sample_s;
    out.push_back({"skin_heat_j", joules});
}

void add_cutting_economy(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto& line = recording.header.geometry.planned_contour;
    if (line.size() < 3) return;
    double path = 0;
    for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
        const sim::ToolKind kind = recording.header.tools[i].kind;
        if (kind != sim::ToolKind::kNeedle && kind != sim::ToolKind::kHook) continue;
        const Track track = tool_track(recording, i);  // Filtered: raw samples lengthen the way.
        size_t sample = 0;
        for (size_t k = 1; k < track.position_m.size(); ++k) {
            while (sample + 1 < recording.samples.size() &&
                   recording.samples[sample].time_s < track.time_s(k))
                ++sample;
            const sim::ToolSample& tool = recording.samples[sample].tools[i];
            if (tool.pedals != 0 && tool.in_contact != 0)
                path += (track.position_m[k] - track.position_m[k - 1]).norm();
        }
    }
    // A way shorter than a millimetre says nothing.
    if (path > 1e-3)
        out.push_back(
            {"cutting_economy", ring_cut_share(recording) * ClosedContour(line).length() / path});
}

}  // namespace placode::assessment
