// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/stage_way_back.h"

#include <algorithm>
#include <cmath>

#include "haptics/minimum_jerk.h"
#include "sim/world/scene.h"

namespace placode::curriculum {
namespace {

constexpr double kReleaseS = 0.4;  // jaws open
constexpr double kRiseS = 0.4, kRiseM = 0.004;
constexpr double kTravelM_s = 0.02, kLeastTravelS = 0.8;
constexpr double kCalmM_s = 1e-3;  // no vertex is faster
constexpr double kCalmS = 0.2, kLongestCalmS = 3;

float between(float from, float to, double share) {
    return static_cast<float>(static_cast<double>(from) +
                              share * (static_cast<double>(to) - static_cast<double>(from)));
}

/// Straight on, the shorter way round.
void place_between(const sim::ToolInput& from, const sim::ToolInput& to, double share,
                   sim::ToolInput& out) {
    for (size_t k = 0; k < 3; ++k)
        out.position_m[k] = between(from.position_m[k], to.position_m[k], share);
    float along = 0, norm2 = 0;
    for (size_t k = 0; k < 4; ++k) along += from.orientation[k] * to.orientation[k];
    for (size_t k = 0; k < 4; ++k) {
        const float goal = along < 0 ? -to.orientation[k] : to.orientation[k];
        out.orientation[k] = between(from.orientation[k], goal, share);
        norm2 += out.orientation[k] * out.orientation[k];
    }
    const float norm = std::sqrt(norm2);
    if (norm > 1e-3F)
        for (float& q : out.orientation) q /= norm;
}

bool is_calm(const sim::State& state) {
    for (const sim::Float4& v : state.body.v) {
        const double speed2 = static_cast<double>(v.x) * static_cast<double>(v.x) +
                              static_cast<double>(v.y) * static_cast<double>(v.y) +
                              static_cast<double>(v.z) * static_cast<double>(v.z);
        if (speed2 > kCalmM_s * kCalmM_s) return false;
    }
    return true;
}

}  // namespace

StageWayBack::StageWayBack(const sim::Scene& scene, const sim::State& state, const Hands& home,
                           const Hands& now)
    : scene_(scene), home_(home), from_(now) {
    double farthest_m = 0;
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        keeps_[i] = state.suturing.driver == static_cast<int8_t>(i);
        holds_[i] = state.grasps[i].count > 0;
        if (holds_[i]) release_s_ = kReleaseS;
        double way2 = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double d = static_cast<double>(home_[i].position_m[k]) -
                             static_cast<double>(from_[i].position_m[k]);
            way2 += d * d;
        }
        farthest_m = std::max(farthest_m, std::sqrt(way2));
    }
    travel_s_ = std::max(kLeastTravelS, farthest_m / kTravelM_s);
}

void StageWayBack::place(std::span<sim::ToolInput> hands) const {
    const double rise_s = std::clamp(time_s_ - release_s_, 0.0, kRiseS);
    const double travel = std::clamp((time_s_ - release_s_ - kRiseS) / travel_s_, 0.0, 1.0);
    for (size_t i = 0; i < hands.size(); ++i) {
        if (scene_.tools[i].kind == sim::ToolKind::kScope) continue;
        sim::ToolInput from = from_[i];
        const double open = holds_[i] ? std::clamp(time_s_ / kReleaseS, 0.0, 1.0) : 0;
        const auto wide = static_cast<float>(scene_.tools[i].jaw_open_rad);
        from.jaw_rad = between(from.jaw_rad, std::max(from.jaw_rad, wide), open);
        if (!keeps_[i]) from.position_m[2] += static_cast<float>(kRiseM * rise_s / kRiseS);
        hands[i] = from;
        place_between(from, home_[i], haptics::minimum_jerk(travel), hands[i]);
        // A driver's jaws stay shut on its needle.
        if (!keeps_[i]) hands[i].jaw_rad = between(from.jaw_rad, home_[i].jaw_rad, travel);
        hands[i].pedals = 0;
    }
}

bool StageWayBack::next(const sim::State& state, std::span<sim::ToolInput> hands, double dt_s) {
    const double arrived_s = release_s_ + kRiseS + travel_s_;
    if (time_s_ > arrived_s) {
        calm_s_ = is_calm(state) ? calm_s_ + dt_s : 0;
        if (calm_s_ >= kCalmS || time_s_ > arrived_s + kLongestCalmS) return false;
    }
    time_s_ += dt_s;
    place(hands);
    return true;
}

}  // namespace placode::curriculum
