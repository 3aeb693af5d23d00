// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How hard the instruments pressed, how often and how long too hard, and what tore.

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "assessment/tissue_metric_parts.h"
#include "haptics/json_scan.h"

namespace placode::assessment {

namespace {

/// A spell this long after the last one is a new one [s]. Longer than kAgainS: see times_of().
constexpr double kPauseS = 3;
static_assert(kPauseS > kAgainS);

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

}  // namespace

std::vector<Spell> spells_of(const sim::Recording& recording, sim::EventKind kind) {
    std::vector<Spell> spells;
    for (const sim::Event& event : recording.events)
        if (event.kind == kind)
            spells.push_back({event.tool, event.time_s - event.value, event.time_s});
    return spells;
}

double times_of(std::vector<Spell> spells) {
    std::erase_if(spells, [](const Spell& spell) {
        return !std::isfinite(spell.from_s) || !std::isfinite(spell.to_s);
    });
    std::ranges::sort(spells, {}, [](const Spell& each) {
        return std::tuple(each.tool, each.from_s, each.to_s);
    });
    double times = 0, until_s = 0;
    const Spell* last = nullptr;
    for (const Spell& spell : spells) {
        const bool first = last == nullptr || last->tool != spell.tool;
        last = &spell;
        if (first) {
            until_s = spell.from_s;
            ++times;
        } else if (spell.from_s > until_s) {
            times += std::min(1.0, (spell.from_s - until_s) / kPauseS);
            until_s = spell.from_s;
        }
        if (spell.to_s <= until_s) continue;
        times += (spell.to_s - until_s) / kAgainS;
        until_s = spell.to_s;
    }
    return times;
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
    const EventSum over = total(recording, sim::EventKind::kOverForce);
    peak = std::max({peak, over.peak, total(recording, sim::EventKind::kPlacodeContact).peak});
    double torn_m3 = 0, torn_skin_m3 = 0;
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kTorn) continue;
        torn_m3 += event.value;
        if (is_skin(event.tissue)) torn_skin_m3 += event.value;
    }
    out.push_back({"peak_force_mn", peak * 1e3});
    out.push_back({"over_force_count", times_of(spells_of(recording, sim::EventKind::kOverForce))});
    out.push_back({"over_force_s", over.value});
    out.push_back({"torn_volume_mm3", torn_m3 * 1e9});
    out.push_back({"torn_skin_mm3", torn_skin_m3 * 1e9});
}

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

}  // namespace placode::assessment
