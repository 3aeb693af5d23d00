// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/tissue_metrics.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "assessment/tissue_metric_parts.h"

namespace placode::assessment {

namespace {

constexpr double kNearPlacodeM = 0.001, kOverheatedSquareM = 0.002;
// Henriques & Moritz 1947, skin: a stand-in, there is no accepted set for the placode.
constexpr double kSkinAPerS = 3.1e98, kSkinEaJMol = 6.28e5;

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
    const EventSum contact = total(recording, sim::EventKind::kPlacodeContact);
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

/// Tips below the surface, from whatever instrument.
void add_buried(const sim::Recording& recording, std::vector<Metric>& out) {
    if (!has_ledger(recording)) return;
    const EventSum buried = total(recording, sim::EventKind::kBuried);
    out.push_back({"buried_s", buried.value});
    out.push_back({"buried_count", static_cast<double>(buried.count)});
}

}  // namespace

void add_tissue_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    add_incision(recording, out);
    if (recording.samples.empty()) return;
    add_burned_skin(recording, out);
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
