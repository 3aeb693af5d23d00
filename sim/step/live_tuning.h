// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue and generator changed while somebody operates (the clinician's tuning panel). A scene does
// not change during an attempt; this is the one exception, made between two frames by the thread
// that owns the state, and written down as an event, so that a replay does the same.

#include <string_view>

#include "sim/core/event.h"
#include "sim/step/step.h"
#include "sim/world/scene.h"

namespace placode::sim {

enum class TuneParameter : int32_t {
    kStiffness,    ///< Young's modulus [Pa].
    kDamping,      ///< Velocity damping [1/s].
    kFriction,     ///< Coulomb, dynamic [-].
    kFailStretch,  ///< Principal stretch at which it tears [-].
    kCutPower,     ///< Of all needles and hooks [W]; tissue does not matter.
    kCoagPower,    ///< [W]
    kPreset        ///< The attempt began with a saved preset: nothing to do.
};
inline constexpr int kTuneParameters = 6;  ///< That a panel offers.
inline constexpr bool tunes_tissue(TuneParameter p) { return p < TuneParameter::kCutPower; }

/// What a panel offers: name as in the scene's JSON, allowed range, factor or step of one click.
struct TuneRange {
    std::string_view name;
    double low = 0, high = 1;
    double step = 0.1;       ///< Added, or
    bool geometric = false;  ///< multiplied by (1 + step).
};
[[nodiscard]] const TuneRange& tune_range(TuneParameter parameter) noexcept;

/// The value as the scene has it now.
[[nodiscard]] double tuned_value(const Scene& scene, TuneParameter parameter,
                                 Tissue tissue) noexcept;

/// Does what the event says, with its value brought into the allowed range. XPBD bodies keep their
/// stiffness: the method is valid at small Courant numbers only. Takes some ten milliseconds for a
/// change of stiffness. Never throws. @return false when nothing changed.
bool tune_live(Scene& scene, State& state, const Event& event) noexcept;

}  // namespace placode::sim
