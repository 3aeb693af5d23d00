// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/tissue_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "assessment/motion_metrics.h"
#include "assessment/statistics.h"
#include "haptics/json_scan.h"
#include "sim/cutting/attempt_progress.h"

namespace placode::assessment {

namespace {

constexpr double kNearPlacodeM = 0.001, kOverheatedSquareM = 0.002;
// Henriques & Moritz 1947, skin: a stand-in, there is no accepted set for the placode.
constexpr double kSkinAPerS = 3.1e98, kSkinEaJMol = 6.28e5;

struct Sum {
    int count = 0;
    double value = 0, peak = 0;
};

/// Count, sum of `value`, largest `value2` of one kind of event.
Sum total(const sim::Recording& recording, sim::EventKind kind) {
    Sum sum;
    for (const sim::Event& event : recording.events) {
        if (event.kind != kind) continue;
        ++sum.count;
        sum.value += event.value;
        sum.peak = std::max(sum.peak, static_cast<double>(event.value2));
    }
    return sum;
}

bool is_skin(sim::Tissue tissue) {
    return tissue == sim::Tissue::kSkin || tissue == sim::Tissue::kThinSkin;
}

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

/// How much of the ring is cut, from the number that the picture showed, and its gaps.
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

/// Where the incision runs, from what was removed.
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

/// The ledger names one vertex a second, and heat that adds up at one place passes the limit at one
/// neighbour after the other: squares of the tissue are counted, vertices are not. A square more is
/// never a square less, which groups of near vertices do not promise.
int overheated_places(const sim::Recording& recording) {
    std::set<std::pair<long, long>> squares;
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kPlacodeOverheated) continue;
        squares.emplace(std::lround(event.rest_position_m[0] / kOverheatedSquareM),
                        std::lround(event.rest_position_m[1] / kOverheatedSquareM));
    }
    return static_cast<int>(squares.size());
}

void add_placode(const sim::Recording& recording, std::vector<Metric>& out) {
    const Sum contact = total(recording, sim::EventKind::kPlacodeContact);
    out.push_back({"placode_contacts", static_cast<double>(contact.count)});
    out.push_back({"placode_contact_s", contact.value});
    out.push_back({"placode_peak_force_mn", contact.peak * 1e3});
    out.push_back(
        {"placode_energised_s", total(recording, sim::EventKind::kPlacodeEnergised).value});
    double dose = 0, burned_m3 = 0, cut_m3 = 0;
    std::optional<double> temperature;
    for (const sim::Sample& sample : recording.samples) {
        dose = std::max(dose, static_cast<double>(sample.placode_peak_cem43_min));
        burned_m3 = std::max(burned_m3, static_cast<double>(sample.placode_burned_m3));
        temperature =
            std::max(temperature.value_or(-INFINITY), static_cast<double>(sample.placode_peak_c));
    }
    for (const sim::Event& event : recording.events) {
        const bool removed =
            event.kind == sim::EventKind::kVaporised || event.kind == sim::EventKind::kTorn;
        if (removed && event.tissue == sim::Tissue::kPlacode) cut_m3 += event.value;
    }
    if (temperature) {
        out.push_back({"placode_peak_cem43_min", std::min(dose, kLargestDoseMin)});
        out.push_back({"placode_peak_c", *temperature});
        std::vector<double> time_s, celsius;
        for (const sim::Sample& sample : recording.samples) {
            time_s.push_back(sample.time_s);
            celsius.push_back(sample.placode_peak_c);
        }
        out.push_back(
            {"placode_arrhenius",
             std::min(kLargestDamage, arrhenius_damage(time_s, celsius, kSkinAPerS, kSkinEaJMol))});
    }
    out.push_back({"placode_overheated", static_cast<double>(overheated_places(recording))});
    const double volume_m3 = recording.header.geometry.placode_volume_m3;
    if (volume_m3 > 0) out.push_back({"placode_burned_percent", burned_m3 / volume_m3 * 100});
    out.push_back({"placode_cut_mm3", cut_m3 * 1e9});
}

/// On-time, time in air and near the placode from the samples; joules from the ledger, and from the
/// samples for an activation that was still running at the end.
void add_energy(const sim::Recording& recording, std::vector<Metric>& out) {
    const double dt = recording.header.sample_s;
    std::optional<ClosedContour> placode;
    if (recording.header.geometry.placode_edge.size() >= 3)
        placode.emplace(recording.header.geometry.placode_edge);
    double joules = 0, open_since = -1;
    int activations = 0;
    for (const sim::Event& event : recording.events) {
        if (event.kind == sim::EventKind::kEnergyOn) {
            ++activations;
            open_since = event.time_s;
        } else if (event.kind == sim::EventKind::kEnergyOff) {
            joules += event.value2;
            open_since = -1;
        }
    }
    double on_s = 0, air_s = 0, near_s = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
            const sim::ToolSample& tool = sample.tools[i];
            const sim::ToolKind kind = recording.header.tools[i].kind;
            const bool electric = kind == sim::ToolKind::kNeedle || kind == sim::ToolKind::kHook;
            if (!electric || tool.pedals == 0) continue;
            on_s += dt;
            if (tool.in_contact == 0) air_s += dt;
            if (placode &&
                placode->nearest(Vec2(tool.tip_m[0], tool.tip_m[1])).offset < kNearPlacodeM)
                near_s += dt;
            if (open_since >= 0 && sample.time_s > open_since) joules += tool.power_w * dt;
        }
    }
    out.push_back({"energy_activations", static_cast<double>(activations)});
    out.push_back({"energy_on_s", on_s});
    out.push_back({"energy_in_air_s", air_s});
    out.push_back({"energy_in_air_count",
                   static_cast<double>(total(recording, sim::EventKind::kEnergyInAir).count)});
    out.push_back({"energy_near_placode_s", near_s});
    out.push_back({"energy_j", joules});
    out.push_back({"dwell_s", total(recording, sim::EventKind::kDwell).value});
}

void add_force(const sim::Recording& recording, std::vector<Metric>& out) {
    double peak = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
            const auto& f = sample.tools[i].force_n;
            peak = std::max(peak, static_cast<double>(std::hypot(f[0], f[1], f[2])));
        }
    }
    // The ledger sees every frame, the samples every tenth.
    const Sum over = total(recording, sim::EventKind::kOverForce);
    peak = std::max({peak, over.peak, total(recording, sim::EventKind::kPlacodeContact).peak});
    double torn_m3 = 0, torn_skin_m3 = 0;
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kTorn) continue;
        torn_m3 += event.value;
        if (is_skin(event.tissue)) torn_skin_m3 += event.value;
    }
    out.push_back({"peak_force_mn", peak * 1e3});
    out.push_back({"over_force_count", static_cast<double>(over.count)});
    out.push_back({"over_force_s", over.value});
    out.push_back({"torn_volume_mm3", torn_m3 * 1e9});
    out.push_back({"torn_skin_mm3", torn_skin_m3 * 1e9});
}

/// The force that the scene of the task calls too much [N]; nothing where the recording does not
/// say.
std::optional<double> over_force_n(const std::string& task_json) {
    double found = -1;
    haptics::JsonScan scan(task_json);
    scan.object([&](std::string_view key) {
        if (key != "scene") return;
        scan.object([&](std::string_view part) {
            if (part != "contact") return;
            scan.object([&](std::string_view name) {
                if (name == "over_force_n") found = scan.number(-1);
            });
        });
    });
    return found > 0 ? std::optional(found) : std::nullopt;
}

/// Sums over the samples in which an instrument touches tissue.
void add_contact_force(const sim::Recording& recording, std::vector<Metric>& out) {
    const double dt = recording.header.sample_s;
    const std::optional<double> limit = over_force_n(recording.header.task_json);
    double contact_s = 0, impulse = 0, square = 0, placode = 0, excess = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
            const sim::ToolSample& tool = sample.tools[i];
            if (tool.in_contact == 0) continue;
            const double force = std::hypot(tool.force_n[0], tool.force_n[1], tool.force_n[2]);
            contact_s += dt;
            impulse += force * dt;
            if (limit) excess += std::max(0.0, force - *limit) * dt;
            square += force * force * dt;
            if (tool.touched == sim::Tissue::kPlacode) placode += force * dt;
        }
    }
    if (contact_s > 0) {
        out.push_back({"mean_force_mn", impulse / contact_s * 1e3});
        out.push_back({"rms_force_mn", std::sqrt(square / contact_s) * 1e3});
    }
    out.push_back({"force_impulse_mn_s", impulse * 1e3});
    if (limit) out.push_back({"excess_impulse_mn_s", excess * 1e3});
    out.push_back({"placode_impulse_mn_s", placode * 1e3});
}

/// Planned contour that is cut, over the tip's way with the pedal down and in contact.
void add_cutting_economy(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto& line = recording.header.geometry.planned_contour;
    if (line.size() < 3) return;
    double way = 0;
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
                way += (track.position_m[k] - track.position_m[k - 1]).norm();
        }
    }
    // A way shorter than a millimetre says nothing.
    if (way > 1e-3)
        out.push_back(
            {"cutting_economy", ring_cut_share(recording) * ClosedContour(line).length() / way});
}

/// Seconds during which held tissue was lifted, from the height of the tip since its grasp.
double lifted_s(const sim::Recording& recording) {
    constexpr float kLiftedM = 0.0007F;
    double sum = 0;
    std::array<float, sim::kMaxTools> from{};
    std::array<bool, sim::kMaxTools> holding{};
    size_t next = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (; next < recording.events.size() && recording.events[next].time_s <= sample.time_s;
             ++next) {
            const sim::Event& e = recording.events[next];
            if (e.tool < 0 || e.tool >= sim::kMaxTools) continue;
            const auto t = static_cast<size_t>(e.tool);
            if (e.kind == sim::EventKind::kGrasped) {
                holding[t] = true;
                from[t] = sample.tools[t].tip_m[2];
            } else if (e.kind == sim::EventKind::kReleased) {
                holding[t] = false;
            }
        }
        for (size_t t = 0; t < sim::kMaxTools; ++t) {
            if (holding[t] && sample.tools[t].tip_m[2] - from[t] > kLiftedM) {
                sum += recording.header.sample_s;
            }
        }
    }
    return sum;
}

/// The share of the marked tissue that the ledger's last such entry tells.
std::optional<double> marked_share(const sim::Recording& recording, sim::EventKind kind) {
    std::optional<double> share;
    for (const sim::Event& e : recording.events)
        if (e.kind == kind) share = std::max(share.value_or(0), static_cast<double>(e.value2));
    return share;
}

/// What became of the marked tissue: taken out, destroyed; the rest was left behind.
void add_marked(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto taken = marked_share(recording, sim::EventKind::kTakenOut);
    const auto lost = marked_share(recording, sim::EventKind::kMarkedLost);
    if (taken) out.push_back({"resected_percent", *taken * 100});
    if (lost) out.push_back({"marked_lost_percent", *lost * 100});
    if (taken && lost) out.push_back({"marked_gone_percent", 100 * std::min(1.0, *taken + *lost)});
}

/// Tips below the surface, from whatever instrument.
void add_buried(const sim::Recording& recording, std::vector<Metric>& out) {
    if (!has_ledger(recording)) return;
    const Sum buried = total(recording, sim::EventKind::kBuried);
    out.push_back({"buried_s", buried.value});
    out.push_back({"buried_count", static_cast<double>(buried.count)});
}

/// Grasper and scissors. Nothing where the scene has neither.
void add_dissection(const sim::Recording& recording, std::vector<Metric>& out) {
    using sim::EventKind;
    bool jaws = false, blades = false;
    for (const sim::ToolSpec& tool : recording.header.tools) {
        jaws = jaws || tool.kind == sim::ToolKind::kGrasper;
        blades = blades || tool.kind == sim::ToolKind::kScissors;
    }
    if (!recording.header.geometry.planned_contour.empty()) {
        out.push_back({"released_deg", 5.0 * total(recording, EventKind::kSectorFree).count});
    }
    if (blades) {
        double skin_m2 = 0;
        for (const sim::Event& e : recording.events)
            if (e.kind == EventKind::kSnipped && is_skin(e.tissue)) skin_m2 += e.value;
        const Sum snips = total(recording, EventKind::kSnipped);
        const Sum pieces = total(recording, EventKind::kPieceOut);
        out.push_back({"placode_snip_mm2", total(recording, EventKind::kPlacodeCut).value * 1e6});
        out.push_back({"skin_snip_mm2", skin_m2 * 1e6});
        out.push_back({"snips", static_cast<double>(snips.count)});
        out.push_back({"pieces_out", static_cast<double>(pieces.count)});
        out.push_back({"resected_mm3", pieces.value * 1e9});
        add_marked(recording, out);
    }
    if (jaws) {
        const Sum released = total(recording, EventKind::kReleased);
        const Sum pulls = total(recording, EventKind::kOverTraction);
        out.push_back({"grasps", static_cast<double>(total(recording, EventKind::kGrasped).count)});
        out.push_back({"lift_hold_s", lifted_s(recording)});
        out.push_back(
            {"slip_count", static_cast<double>(total(recording, EventKind::kSlipped).count)});
        out.push_back(
            {"crush_count", static_cast<double>(total(recording, EventKind::kCrushed).count)});
        out.push_back({"over_traction_count", static_cast<double>(pulls.count)});
        out.push_back({"peak_traction_mn", std::max(released.peak, pulls.peak) * 1e3});
    }
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

void add_tissue_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    add_incision(recording, out);
    if (recording.samples.empty()) return;
    add_ring(recording, out);
    add_buried(recording, out);
    add_placode(recording, out);
    add_energy(recording, out);
    add_force(recording, out);
    add_contact_force(recording, out);
    add_damage(recording, out);
    add_cutting_economy(recording, out);
    add_dissection(recording, out);
}

}  // namespace placode::assessment
