// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fluid, debris and what jet and suction do: what changes (sim/fluid).

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/fields.h"
#include "sim/core/tissue.h"
#include "sim/core/tool.h"

namespace placode::sim {

struct Scene;

/// Standing fluid. What was given is in the cells, sucked away or run off.
struct Pool {
    std::vector<double> volume_m3, blood_m3;  ///< (cells) Blood is part of the volume.
    double given_m3 = 0, sucked_m3 = 0, run_off_m3 = 0;
    int32_t calm = 0;  ///< Sweeps in a row in which nothing flowed.
};
template <class Visit>
void fields(Of<Pool> auto& s, Visit&& visit) {
    auto& [volume_m3, blood_m3, given_m3, sucked_m3, run_off_m3, calm] = s;
    visit.state(volume_m3, blood_m3, given_m3, sucked_m3, run_off_m3, calm);
}

enum class DebrisFate : int32_t { kStuck, kLoose, kSucked, kRunOff };
struct DebrisNow {
    DebrisFate fate = DebrisFate::kStuck;
    float dose_s = 0;             ///< So long the jet has had more shear than it stands.
    std::array<float, 2> at_m{};  ///< Where it drifts, once it is loose.
};
template <class Visit>
void fields(Of<DebrisNow> auto& s, Visit&& visit) {
    auto& [fate, dose_s, at_m] = s;
    visit.state(fate, dose_s, at_m);
}
template <>
inline constexpr bool kPlainBytes<DebrisNow> = true;

/// What the tip of one instrument does now.
struct TipFlow {
    float jet_m = 0;   ///< Length of the jet up to what it hits; 0 = none.
    float shut = 0;    ///< Share of the suction that tissue takes: 1 = it lies on the mouth.
    float sucked = 0;  ///< Share of the flow that was fluid and not gas.
};
template <class Visit>
void fields(Of<TipFlow> auto& s, Visit&& visit) {
    auto& [jet_m, shut, sucked] = s;
    visit.state(jet_m, shut, sucked);
}

/// A spell that is not over.
struct FluidSpell {
    float seconds = 0, peak = 0, pause_s = 0;
    Tissue tissue = Tissue::kSkin;
    std::array<float, 3> rest_m{};  ///< Where the peak was.
};
template <class Visit>
void fields(Of<FluidSpell> auto& s, Visit&& visit) {
    auto& [seconds, peak, pause_s, tissue, rest_m] = s;
    visit.state(seconds, peak, pause_s, tissue, rest_m);
}

/// Empty in a scene without irrigation. Sized by the constructor, never grows.
struct IrrigationState {
    explicit IrrigationState(const Scene& scene);

    Pool pool;
    std::vector<DebrisNow> debris;
    std::array<TipFlow, kMaxTools> tips{};
    double placode_pa = 0;  ///< Highest pressure of a jet on the placode in this frame.
    double hidden = 0;      ///< Share of the lesion that blood hides.
    double jet_m3 = 0;      ///< Given by jets.
    // Sums of the attempt.
    double peak_pa = 0, over_s = 0, hidden_s = 0, held_s = 0, placode_held_s = 0;
    std::array<float, 3> peak_rest_m{};
    FluidSpell pressed;                        ///< The jet on the placode, above the limit.
    std::array<FluidSpell, kMaxTools> held{};  ///< Suction on tissue.
    /// Vertices of the tissue that jets and suction load, the first `loaded_count`.
    std::vector<int32_t> loaded;
    int32_t loaded_count = 0;
    std::vector<uint8_t> listed;               ///< (V) 1 = among `loaded`.
    std::vector<std::array<float, 3>> load_n;  ///< (V) [N]
    std::vector<std::array<float, 3>> told_n;  ///< (V) The load when the tissue was last woken [N].
};
template <class Visit>
void fields(Of<IrrigationState> auto& s, Visit&& visit) {
    auto& [pool, debris, tips, placode_pa, hidden, jet_m3, peak_pa, over_s, hidden_s, held_s,
           placode_held_s, peak_rest_m, pressed, held, loaded, loaded_count, listed, load_n,
           told_n] = s;
    visit.state(pool, debris, tips, placode_pa, hidden, jet_m3, peak_pa, over_s, hidden_s, held_s,
                placode_held_s, peak_rest_m, pressed, held, loaded_count, listed, load_n, told_n);
    visit.state_of(loaded_count, loaded);
}

/// Where debris of this number lies now, in W [m]; loose, on the fluid.
[[nodiscard]] Vec3 debris_place(const Scene& scene, const struct State& state,
                                size_t number) noexcept;

}  // namespace placode::sim
