// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/lens.h"

#include <algorithm>
#include <cmath>

namespace placode::view {

using namespace sim;
namespace {

// By trial on a 12 W ring (20 mm3 boil away in 35 s) seen from 30 mm: the first droplets after some
// 10 s, a picture that wants wiping when the ring is closed. Nearer by half, four times as fast.
constexpr double kReferenceMm = 25;
constexpr double kDropsPerMm3 = 0.30, kFogPerMm3 = 0.017;
constexpr double kFogDriesS = 35, kDropDriesS = 120, kFogMost = 0.8;
constexpr double kSmearFog = 0.35;  // the lens on wet tissue
// Water: a jet that lands 10 mm away splashes a drop a second, at 20 mm an eighth of that (the rate
// at which spray that leaves in all directions at one speed meets the lens, times that it slows
// down). The jet itself carries away what it meets. By eye.
constexpr double kSplashNearMm = 10, kSplashReachMm = 25, kSplashesPerS = 1;
constexpr double kLensM = 1.2e-3, kRinseS = 0.25;
constexpr double kMostStepS = 2;  // snapshots are further apart while pictures are saved

}  // namespace

double Lens::random() {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 7;
    random_ ^= random_ << 17;
    return static_cast<double>(random_ >> 11) * 0x1.0p-53;
}

void Lens::add_drop(double radius) {
    if (drops_.size() >= kMostDrops) return;
    const double angle = 2 * 3.14159265358979 * random(), r = 0.95 * std::sqrt(random());
    drops_.push_back({Vec2(r * std::cos(angle), r * std::sin(angle)), radius, 1.0});
}

void Lens::get_wet(const Snapshot& snapshot, const Vec3& scope_tip_m, double dt_s) {
    for (size_t t = 0; t < static_cast<size_t>(snapshot.tool_count); ++t) {
        const double length = static_cast<double>(snapshot.fluid.jet_m[t]);
        if (length <= 0) continue;
        const Pose& tip = snapshot.tools[t].pose;
        const Vec3 axis = tip.q * Vec3::UnitZ();
        const double along = std::clamp((scope_tip_m - tip.p).dot(axis), 0.0, length);
        const double wide =
            std::lerp(static_cast<double>(snapshot.fluid.jet_radius_m[t]),
                      static_cast<double>(snapshot.fluid.jet_end_radius_m[t]), along / length);
        if ((tip.p + along * axis - scope_tip_m).norm() < wide + kLensM) {
            fog_ *= std::exp(-dt_s / kRinseS);
            for (LensDrop& drop : drops_) drop.strength *= std::exp(-dt_s / kRinseS);
            continue;
        }
        const double away_mm = 1000 * (tip.p + length * axis - scope_tip_m).norm();
        if (away_mm > kSplashReachMm) continue;
        const double nearness = kSplashNearMm / std::max(away_mm, 0.5 * kSplashNearMm);
        splashes_owed_ += kSplashesPerS * nearness * nearness * nearness * dt_s;
    }
    for (; splashes_owed_ >= 1; splashes_owed_ -= 1) add_drop(0.03 + 0.05 * random());
}

void Lens::wipe() {
    if (wipe_s_ < 0) wipe_s_ = 0;
}

void Lens::update(const Snapshot& snapshot, const Vec3& scope_tip_m, bool scope_touches) {
    if (time_s_ < 0 || snapshot.time_s < time_s_) time_s_ = snapshot.time_s;
    const double dt = std::min(snapshot.time_s - time_s_, kMostStepS);
    time_s_ = snapshot.time_s;
    if (dt <= 0) return;
    // Spatter and steam come from where it boils.
    double nearest_mm = kReferenceMm;
    for (int i = 0; i < snapshot.tool_count; ++i) {
        const ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        if (tool.energised == 0) continue;
        nearest_mm = std::max(5.0, 1000 * (tool.pose.p - scope_tip_m).norm());
    }
    const double reach = std::min(9.0, std::pow(kReferenceMm / nearest_mm, 2));
    const double mm3 = std::max(0.0F, snapshot.vapour_rate_m3_s) * 1e9 * dt * reach;
    fog_ = std::min(kFogMost, fog_ * std::exp(-dt / kFogDriesS) + kFogPerMm3 * mm3);
    if (scope_touches && !touching_) fog_ = std::min(kFogMost, fog_ + kSmearFog);
    touching_ = scope_touches;
    for (LensDrop& drop : drops_) drop.strength *= std::exp(-dt / kDropDriesS);
    get_wet(snapshot, scope_tip_m, dt);
    std::erase_if(drops_, [](const LensDrop& d) { return d.strength < 0.15; });
    for (owed_ += kDropsPerMm3 * mm3; owed_ >= 1; owed_ -= 1)
        add_drop(0.02 + 0.06 * random() * random());
    if (wipe_s_ < 0) return;
    wipe_s_ += dt;
    const double edge = cloth();
    std::erase_if(drops_, [&](const LensDrop& d) { return d.at.x() < edge; });
    if (wipe_s_ >= kWipeS) {
        wipe_s_ = -1;
        fog_ = 0;
        drops_.clear();
    }
}

}  // namespace placode::view
