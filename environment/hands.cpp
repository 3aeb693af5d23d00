// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/hands.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/random.h"

namespace placode::environment {

namespace {

using haptics::Vec3;

// Places of the eight numbers.
enum : size_t { kX, kY, kZ, kRoll, kJaw, kCut, kCoag };
static_assert(kCoag + 1 == kActionEngaged);

Vec3 within_reach(Vec3 tip) {
    for (int k = 0; k < 3; ++k) tip[k] = std::clamp(tip[k], kReachLowM[k], kReachHighM[k]);
    return tip;
}

/// From `now` towards `goal`, at most `most` of the way.
double towards(double now, double goal, double most) {
    return now + std::clamp(goal - now, -most, most);
}

}  // namespace

Hands::Hands(std::span<const sim::ToolSpec> tools) : tools_(tools.begin(), tools.end()) {
    // Homes as for everybody; the action says where the tip goes, in W.
    for (haptics::TrocarSettings settings : haptics::default_trocars(tools, "script")) {
        settings.mapping = haptics::Mapping::kTip;
        settings.R_WD = haptics::Mat3::Identity();
        settings.scale = 1;
        trocars_.emplace_back(tools_[trocars_.size()], settings);
    }
    hands_.resize(tools_.size());
    reset(0, 0);
}

void Hands::reset(uint64_t seed, double spread_m) {
    sim::SplitMix64 random(seed);
    for (size_t i = 0; i < hands_.size(); ++i) {
        haptics::Trocar& trocar = trocars_[i];
        trocar = haptics::Trocar(tools_[i], trocar.settings());
        Vec3 tip = trocar.settings().home_tip_m;
        if (spread_m > 0 && tools_[i].kind != sim::ToolKind::kScope)
            tip += Vec3(random.uniform(-spread_m, spread_m), random.uniform(-spread_m, spread_m),
                        random.uniform(0, spread_m));
        hands_[i] = {};
        hands_[i].tip_m = hands_[i].goal_m = within_reach(tip);
        // An instrument that shares its port with an earlier one waits outside.
        const uint32_t others = haptics::others_in_port(tools_, i);
        hands_[i].engaged = (others & ((1U << i) - 1)) == 0;
    }
    frames_left_ = 1;
}

/// Of instruments that share a port the one that is wanted most is in.
void Hands::choose_engaged(std::span<const double> actions, double above) {
    const auto wish = [&](size_t i) { return actions[i * kActionSize + kActionEngaged]; };
    for (size_t i = 0; i < hands_.size(); ++i) {
        const uint32_t others = haptics::others_in_port(tools_, i);
        bool in = others == 0 || wish(i) > above;
        for (size_t k = 0; k < hands_.size(); ++k)
            if ((others >> k & 1U) != 0 && (wish(k) > wish(i) || (wish(k) == wish(i) && k < i)))
                in = false;
        hands_[i].engaged = in;
    }
}

void Hands::aim(ActionUnits units, double speed_m_s, std::span<const double> actions, int frames,
                double frame_s) {
    assert(actions.size() >= hands_.size() * kActionSize &&
           std::ranges::all_of(actions, [](double number) { return std::isfinite(number); }));
    frame_s_ = frame_s;
    frames_left_ = std::max(1, frames);
    const bool normalised = units == ActionUnits::kNormalised;
    const double whole_s = frames_left_ * frame_s_, above = normalised ? 0 : 0.5;
    for (size_t i = 0; i < hands_.size(); ++i) {
        const auto action = actions.subspan(i * kActionSize, kActionSize);
        Hand& hand = hands_[i];
        Vec3 place(action[kX], action[kY], action[kZ]);
        double roll = action[kRoll], jaw = action[kJaw];
        if (normalised) {
            for (int k = 0; k < 3; ++k) place[k] = std::clamp(place[k], -1.0, 1.0);
            place = hand.tip_m + place / std::max(1.0, place.norm()) * speed_m_s * whole_s;
            roll = hand.roll_rad + std::clamp(roll, -1.0, 1.0) * kNormalisedRollRad_S * whole_s;
            jaw = (std::clamp(jaw, -1.0, 1.0) + 1) / 2 * tools_[i].jaw_open_rad;
        }
        hand.goal_m = within_reach(place);
        hand.roll_goal_rad = roll;
        hand.jaw_goal_rad = std::clamp(jaw, 0.0, tools_[i].jaw_open_rad);
        // Both pedals at once mean nothing, as in haptics/servo.cpp.
        const bool cut = action[kCut] > above, coag = action[kCoag] > above;
        hand.pedals = cut == coag ? 0 : cut ? sim::kPedalCut : sim::kPedalCoag;
    }
    choose_engaged(actions, above);
}

void Hands::next(std::span<sim::ToolInput> inputs) {
    for (size_t i = 0; i < hands_.size(); ++i) {
        Hand& hand = hands_[i];
        const Vec3 offset = (hand.goal_m - hand.tip_m) / frames_left_;
        const double longest = kFastestM_S * frame_s_, length = offset.norm();
        hand.tip_m =
            frames_left_ == 1 && length <= longest
                ? hand.goal_m
                : Vec3(hand.tip_m + offset * std::min(1.0, longest / std::max(length, 1e-12)));
        const double turn = (hand.roll_goal_rad - hand.roll_rad) / frames_left_;
        hand.roll_rad = towards(hand.roll_rad, hand.roll_rad + turn, kFastestRollRad_S * frame_s_);
        hand.jaw_rad = towards(hand.jaw_rad, hand.jaw_goal_rad, kFastestJawRad_S * frame_s_);
        haptics::DeviceState state;
        state.position_m = hand.tip_m - trocars_[i].settings().home_tip_m;
        state.roll_rad = hand.roll_rad;
        sim::ToolInput& input = inputs[i];
        input = {};
        input.set_pose(trocars_[i].tip_pose(state));
        input.jaw_rad = static_cast<float>(hand.jaw_rad);
        input.pedals = hand.engaged ? hand.pedals : 0;
        input.engaged = hand.engaged ? 1 : 0;
    }
    frames_left_ = std::max(1, frames_left_ - 1);
}

}  // namespace placode::environment
