// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/jaw_spread.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/contact/contact_core.h"
#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr float kJawRadS = 4;      // no hand spreads faster
constexpr float kGiveWay = 0.25F;  // of that speed: backwards, where tissue is stronger

}  // namespace

void spread_jaws(const Scene& scene, State& state) noexcept {
    if (state.undermining.jaws.empty()) return;
    const auto step_rad = kJawRadS * static_cast<float>(scene.body.spec().solver.frame_s);
    for (size_t t = 0; t < scene.tools.size(); ++t) {
        const ToolSpec& spec = scene.tools[t];
        if (!spec.jaws_spread) continue;
        ToolState& tool = state.tools[t];
        SpreadJaws& jaws = state.undermining.jaws[t];
        const auto most = static_cast<float>(spec.jaw_open_rad);
        const float asked =
            std::isfinite(tool.jaw_rad) ? std::clamp(tool.jaw_rad, 0.0F, most) : jaws.rad;
        if (jaws.rad < 0) jaws.rad = std::max(0.0F, asked);
        const bool stronger = static_cast<double>(jaws.push_n) > spec.jaw_force_n;
        const float up = stronger ? -kGiveWay * step_rad : step_rad;
        jaws.rad = std::clamp(jaws.rad + std::clamp(asked - jaws.rad, -step_rad, up), 0.0F, most);
        jaws.push_n = 0;
        tool.jaw_rad = jaws.rad;
        state.scratch->contacts.shapes[t].spread_jaws(
            tool.engaged != 0 ? static_cast<double>(jaws.rad) : 0.0);
    }
}

void weigh_jaws(State& state) noexcept {
    if (state.undermining.jaws.empty()) return;
    const ContactSet& set = state.scratch->contacts;
    std::array<Vec3, kMaxTools> across;
    std::array<std::array<double, 2>, kMaxTools> push_n{};
    for (size_t t = 0; t < state.undermining.jaws.size(); ++t)
        across[t] = state.tools[t].proxy.q * Vec3::UnitY();
    for (int i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[as_index(i)];
        if (c.side == kTissueSide) continue;
        const double gap = gap_of(c, state.body);
        if (gap >= 0) continue;
        const auto t = as_index(c.side);
        const double out = c.n.dot(across[t]);
        push_n[t][out > 0 ? 0 : 1] += -c.stiffness_n_m * gap * std::abs(out);
    }
    for (size_t t = 0; t < state.undermining.jaws.size(); ++t) {
        // Pushed aside as a whole is not spread: what both jaws bear is.
        const double both = std::min(push_n[t][0], push_n[t][1]);
        state.undermining.jaws[t].push_n += static_cast<float>(both / state.substeps);
    }
}

}  // namespace placode::sim
