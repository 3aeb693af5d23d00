// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From actions to what hands ask of their instruments, frame by frame, through the ports as for a
// person (haptics/trocar.h). A value: a copy goes on alike.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/trocar.h"
#include "sim/core/tool.h"

namespace placode::environment {

/// What the eight numbers of a tool mean; interface/placode.h says it for users.
enum class ActionUnits : uint8_t { kNormalised, kAbsolute };
inline constexpr int kActionSize = 8;
inline constexpr size_t kActionEngaged = 7;  ///< Place among the eight: is the hand there?

inline constexpr double kFastestM_S = 0.3;       ///< No tip moves faster.
inline constexpr double kFastestRollRad_S = 10;  ///< No handle turns faster.
inline constexpr double kFastestJawRad_S = 12;   ///< No fingers open and close faster.
inline constexpr double kNormalisedRollRad_S = 4;

/// Where tips may be asked to go, in W [m]: from below the tissue to beyond the ports.
inline constexpr double kReachLowM[3] = {-0.06, -0.06, -0.01};
inline constexpr double kReachHighM[3] = {0.06, 0.06, 0.08};

class Hands {
 public:
    explicit Hands(std::span<const sim::ToolSpec> tools);

    /// Tips at home, up to `spread_m` from it in every direction (never lower), by `seed`.
    void reset(uint64_t seed, double spread_m);
    /// The wish for the next `frames` frames. @pre finite numbers, kActionSize for each tool.
    void aim(ActionUnits units, double speed_m_s, std::span<const double> actions, int frames,
             double frame_s);
    /// What the hands ask in the next frame.
    void next(std::span<sim::ToolInput> inputs);

    [[nodiscard]] double roll_rad(size_t tool) const { return hands_[tool].roll_rad; }
    [[nodiscard]] bool engaged(size_t tool) const { return hands_[tool].engaged; }
    [[nodiscard]] size_t count() const { return hands_.size(); }

 private:
    struct Hand {
        haptics::Vec3 tip_m = haptics::Vec3::Zero(), goal_m = haptics::Vec3::Zero();
        double roll_rad = 0, roll_goal_rad = 0, jaw_rad = 0, jaw_goal_rad = 0;
        uint8_t pedals = 0;
        bool engaged = true;
    };
    void choose_engaged(std::span<const double> actions, double above);

    std::vector<sim::ToolSpec> tools_;
    std::vector<haptics::Trocar> trocars_;
    std::vector<Hand> hands_;
    double frame_s_ = 1e-3;
    int frames_left_ = 1;
};

}  // namespace placode::environment
