// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/smoke.h"

#include <algorithm>
#include <cmath>

namespace placode::view {

using namespace sim;
namespace {

// Chosen by trial on a 12 W cut (about 2 mm^3/s): 60 puffs a second, and half the contrast is gone
// after some 30 s without a pause. The reference asks for 40 to 120 puffs and tau 20 to 40 s.
constexpr double kPuffsPerMm3 = 28, kHazePerMm3 = 0.010, kClearingS = 22, kHazeMax = 0.55;
constexpr size_t kMaxPuffs = 160;

}  // namespace

double Smoke::random() {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 7;
    random_ ^= random_ << 17;
    return static_cast<double>(random_ >> 11) * 0x1.0p-53;
}

void Smoke::update(const Snapshot& snapshot) {
    if (time_s_ < 0 || snapshot.time_s < time_s_) time_s_ = snapshot.time_s;
    const double dt = std::min(snapshot.time_s - time_s_, 0.25);
    time_s_ = snapshot.time_s;
    if (dt <= 0) return;
    for (Puff& p : puffs_) {
        p.age_s += dt;
        p.position_mm += dt * p.velocity_mm_s;
        p.velocity_mm_s *= std::exp(-0.9 * dt);
        p.velocity_mm_s.z() += dt * 9.0;  // hot gas keeps rising
        p.radius_mm += dt * 2.6;
    }
    std::erase_if(puffs_, [](const Puff& p) { return p.age_s >= p.life_s; });
    const double mm3 = std::max(0.0F, snapshot.vapour_rate_m3_s) * 1e9 * dt;
    haze_ = std::min(kHazeMax, haze_ * std::exp(-dt / kClearingS) + kHazePerMm3 * mm3);
    const ToolSnapshot* source = nullptr;
    for (int i = 0; i < snapshot.tool_count; ++i) {
        const ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        if (tool.kind != ToolKind::kScope && (tool.energised != 0 || source == nullptr))
            source = &tool;
        if (tool.energised != 0) break;
    }
    if (source == nullptr) return;
    owed_ += kPuffsPerMm3 * mm3;
    for (; owed_ >= 1; owed_ -= 1) {
        if (puffs_.size() >= kMaxPuffs) continue;
        Puff p;
        p.position_mm =
            1000 * source->pose.p + Vec3(random() - 0.5, random() - 0.5, random()) * 0.8;
        p.velocity_mm_s = Vec3(8 * (random() - 0.5), 8 * (random() - 0.5), 10 + 14 * random());
        p.radius_mm = 0.5 + 0.6 * random();
        p.life_s = 1.0 + 1.6 * random();
        p.opacity = static_cast<float>(0.03 + 0.07 * random());
        p.seed = static_cast<float>(random());
        puffs_.push_back(p);
    }
}

}  // namespace placode::view
