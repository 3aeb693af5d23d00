// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an instrument is, what the hand asks of it, and what it answers.

#include <array>
#include <cstdint>
#include <string>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Stored as a number in recordings: append only. kNeedle is that of diathermy; a suture needle is
/// held by a kNeedleDriver. Of a kIrrigator the yellow pedal opens the jet, the blue one the
/// suction.
enum class ToolKind : uint8_t {
    kScope,
    kNeedle,
    kHook,
    kGrasper,
    kScissors,
    kProbe,
    kNeedleDriver,
    kIrrigator
};
inline constexpr int kToolKinds = 8;
enum class Hand : uint8_t { kRight, kLeft, kCamera };

/// Its pedals do something; other instruments have jaws, or nothing.
[[nodiscard]] constexpr bool uses_pedals(ToolKind kind) noexcept {
    return kind == ToolKind::kNeedle || kind == ToolKind::kHook || kind == ToolKind::kIrrigator;
}

inline constexpr int kMaxTools = 4;       ///< Two for the right hand, one for the left, the scope.
inline constexpr uint8_t kPedalCut = 1;   ///< Yellow pedal.
inline constexpr uint8_t kPedalCoag = 2;  ///< Blue pedal.

/// One instrument of a scene. All lengths in m.
struct ToolSpec {
    ToolKind kind = ToolKind::kNeedle;
    Hand hand = Hand::kRight;
    /// Each jaw of a grasper touches tissue where it is, so that jaws that open push to both sides,
    /// no harder than jaw_force_n each. Else they touch as if they were shut, as in recordings of
    /// before.
    bool jaws_spread = false;
    Vec3 pivot_m = Vec3(-0.020, -0.055, 0.060);  ///< Trocar point in W.
    double shaft_radius_m = 0.0015;
    double length_m = 0.200;
    double tip_radius_m = 0.00025;  ///< Radius of the working tip.
    double tip_length_m = 0.0025;   ///< Exposed needle, jaw or blade length.
    double scope_angle_deg = 0;     ///< View angle of a scope.
    double field_of_view_deg = 70;  ///< Diagonal, scope only.
    // What a scope shows at first; haptics/trocar.h says from where.
    Vec3 look_at_m = Vec3::Zero();  ///< The middle of its picture, in W: the lesion's centre.
    double look_from_m = 0.030;     ///< Way of its tip to there, at least [m].
    double cut_power_w = 12;        ///< Generator setting, yellow pedal.
    double coag_power_w = 12;       ///< Generator setting, blue pedal.
    double efficiency = 0.5;        ///< Share of the power that reaches tissue.
    double hand_n_m = 600;  ///< Stiffness of the hand's hold on the tip, for the proxy [N/m].
    // Grasper and scissors; tip_length_m is the length of jaws or blades.
    double jaw_open_rad = 0.96;   ///< Widest angle between the jaws [rad].
    double jaw_width_m = 0.002;   ///< Width of a jaw [m].
    double jaw_touch_m = 0.0012;  ///< Jaws nearer than this at the tip touch what is between [m].
    double jaw_force_n = 1.0;     ///< Jaw force when squeezed fully [N].
    double jaw_friction = 0.8;    ///< Serrated jaw on tissue, effective [-].
};

/// What the hand asks: one per tool and frame. Stored bit for bit in the recording, hence float.
struct ToolInput {
    std::array<float, 3> position_m{};             ///< p_WT.
    std::array<float, 4> orientation{1, 0, 0, 0};  ///< w x y z of R_WT.
    float jaw_rad = 0;                             ///< 0 = closed.
    uint8_t pedals = 0;                            ///< kPedalCut | kPedalCoag
    uint8_t engaged = 0;                           ///< 0: no hand (lost device): exerts no force.
    uint8_t reserved[2]{};

    [[nodiscard]] Pose pose() const {
        return {Vec3(position_m[0], position_m[1], position_m[2]),
                Quat(orientation[0], orientation[1], orientation[2], orientation[3])};
    }
    void set_pose(const Pose& X_WT) {
        for (int i = 0; i < 3; ++i) position_m[i] = static_cast<float>(X_WT.p[i]);
        orientation = {static_cast<float>(X_WT.q.w()), static_cast<float>(X_WT.q.x()),
                       static_cast<float>(X_WT.q.y()), static_cast<float>(X_WT.q.z())};
    }
};

/// What the tissue answers: last published value goes to the servo thread.
struct ToolFeedback {
    Pose proxy;  ///< X_WP where the instrument really is.
    Vec3 force_n =
        Vec3::Zero();  ///< f_P_W, force of tissue on the tool, mean over the frame's substeps [N].
    double stiffness_n_m = 0;  ///< Contact stiffness felt at the tip [N/m].
    double time_s = 0;         ///< Simulated time.
    /// Centre of a suture needle in these jaws, in P [m]: what turning it through tissue should
    /// turn about. Zero where they hold none.
    Vec3 turn_centre_m = Vec3::Zero();
};

}  // namespace placode::sim
