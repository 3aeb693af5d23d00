// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the ledger begins with, and over-stretch as volume x time. Tets beside instruments are
// checked every frame, the others every 64 frames: two checks in a row beyond the limit are 64 ms,
// so nothing shorter than kOverStretchS can hide between them. The tail of a spell after its last
// check is left out.
#include "sim/world/ledger_state.h"

#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

OverStretch::OverStretch(int tets, double frame_s)
    : since_(static_cast<size_t>(tets), -1),
      last_(static_cast<size_t>(tets), -1),
      frame_s_(frame_s) {}

bool OverStretch::extend(int tet, int64_t frame, double volume_m3, Tissue tissue) noexcept {
    const auto i = static_cast<size_t>(tet);
    const double before = static_cast<double>(last_[i] - since_[i]) * frame_s_;
    const double now = static_cast<double>(frame - since_[i]) * frame_s_;
    last_[i] = static_cast<int32_t>(frame);
    // Half a frame: whether 50 frames of 1 ms are more than 50 ms is no matter of rounding.
    const double limit = kOverStretchS + frame_s_ / 2;
    if (now < limit) return false;
    sum_[static_cast<size_t>(tissue)].volume_time_m3_s +=
        volume_m3 * (before < limit ? now : now - before);
    return true;
}

void OverStretch::beyond(int tet, int64_t frame, double stretch, double volume_m3,
                         Tissue tissue) noexcept {
    const auto i = static_cast<size_t>(tet);
    if (since_[i] < 0) since_[i] = last_[i] = static_cast<int32_t>(frame);
    const bool counts = extend(tet, frame, volume_m3, tissue);
    Sum& sum = sum_[static_cast<size_t>(tissue)];
    if (!counts || !(stretch > sum.stretch)) return;
    sum.stretch = stretch;
    sum.tet = tet;
}

void OverStretch::catch_up(const Scene& scene, const State& state) noexcept {
    for (size_t i = 0; i < since_.size(); ++i) {
        if (since_[i] < 0) continue;
        const auto tet = static_cast<int>(i);
        if (!state.body.tet_alive[i])
            below(tet);
        else if (state.sleep.sleeps(corners(scene.body, state.body, tet)))
            (void)extend(tet, state.frame, static_cast<double>(scene.body.volume_m3()[i]),
                         scene.body.mesh().tissue[i]);
    }
}

std::array<OverStretch::Sum, kTissueCount> OverStretch::take() noexcept {
    const std::array<Sum, kTissueCount> taken = sum_;
    sum_ = {};
    return taken;
}

LedgerState::LedgerState(const Scene& scene)
    : over_stretch(scene.body.tet_count(), scene.body.spec().solver.frame_s),
      tether_known(scene.body.spec().tethers.size(), 1),
      stretch_reported(scene.body.tet_count(), 0),
      dose_reported(scene.body.vertex_count(), 0),
      last_substeps(scene.body.spec().solver.substeps) {
    if (scene.heat)
        placode_peak_c = placode_now_c =
            static_cast<float>(scene.heat->settings().body_temperature_c);
}

}  // namespace placode::sim
