// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The front lens of the scope: steam fogs it, bursts of boiling tissue spatter droplets on it,
// tissue smears it; fog dries slowly, droplets hardly; wiping clears both. A jet that lands near
// splashes water on it, one that meets it rinses it.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/camera.h"

namespace placode::view {

struct LensDrop {
    sim::Vec2 at = sim::Vec2::Zero();  ///< In the round picture, radius 1.
    double radius = 0.05;
    double strength = 1;  ///< Fades as it dries.
};
inline constexpr int kMostDrops = 10;

/// Deterministic in the snapshots it is shown. Advances in simulated time.
class Lens {
 public:
    /// `scope_tip_m`: where the lens is, in W; `scope_touches`: it lies on tissue.
    void update(const sim::Snapshot& snapshot, const sim::Vec3& scope_tip_m, bool scope_touches);
    /// Begins to wipe: the cloth passes over the lens within kWipeS.
    void wipe();
    [[nodiscard]] double fog() const { return fog_; }  ///< 0 clear .. 0.8
    [[nodiscard]] const std::vector<LensDrop>& drops() const { return drops_; }
    /// Little is seen: somebody should wipe.
    [[nodiscard]] bool dirty() const { return wipe_s_ < 0 && (fog_ > 0.28 || drops_.size() >= 4); }
    /// Edge of the cloth from -1.3 to 1.3 across the picture; 2 = no wiping.
    [[nodiscard]] double cloth() const { return wipe_s_ < 0 ? 2.0 : -1.3 + 2.6 * wipe_s_ / kWipeS; }

    static constexpr double kWipeS = 0.9;

 private:
    double random();
    void add_drop(double radius);
    void get_wet(const sim::Snapshot& snapshot, const sim::Vec3& scope_tip_m, double dt_s);
    double fog_ = 0, time_s_ = -1, wipe_s_ = -1, owed_ = 0, splashes_owed_ = 0;
    bool touching_ = false;
    std::vector<LensDrop> drops_;
    uint64_t random_ = 0x9E3779B97F4A7C15ULL;
};

}  // namespace placode::view
