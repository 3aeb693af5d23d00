// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Smoke of the vaporised tissue: puffs that rise from the tip, and a haze that gathers and clears.

#include <cstdint>
#include <vector>

#include "sim/step/snapshot.h"

namespace placode::view {

struct Puff {
    sim::Vec3 position_mm = sim::Vec3::Zero(), velocity_mm_s = sim::Vec3::Zero();
    double radius_mm = 1, age_s = 0, life_s = 2;
    float opacity = 0.1F, seed = 0;
};

/// Deterministic in the snapshots it is shown. Advances in simulated time.
class Smoke {
 public:
    void update(const sim::Snapshot& snapshot);
    [[nodiscard]] const std::vector<Puff>& puffs() const { return puffs_; }
    [[nodiscard]] double haze() const { return haze_; }  ///< 0 clear .. 0.55

 private:
    double random();
    std::vector<Puff> puffs_;
    double haze_ = 0, time_s_ = -1, owed_ = 0;
    uint64_t random_ = 88172645463325252ULL;
};

}  // namespace placode::view
