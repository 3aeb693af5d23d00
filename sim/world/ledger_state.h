// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the ledger carries from frame to frame: spells that are not yet over, what it has entered
// already, and pauses between two entries for one thing.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"
#include "sim/core/geometry.h"
#include "sim/core/tissue.h"
#include "sim/core/tool.h"

namespace placode::sim {

struct Scene;
struct State;

/// A spell beyond the injury stretch counts from here on, then with its whole length [s].
inline constexpr double kOverStretchS = 0.05;
/// Which tets are beyond their injury stretch, since when, and what that comes to.
class OverStretch {
 public:
    OverStretch(int tets, double frame_s);
    /// A check found the tet beyond its limit. The time between two such checks in a row counts.
    void beyond(int tet, int64_t frame, double stretch, double volume_m3, Tissue tissue) noexcept;
    /// A check found it below.
    void below(int tet) noexcept { since_[static_cast<size_t>(tet)] = -1; }
    /// Tissue asleep keeps its stretch and is not checked: brings its spells up to this frame.
    void catch_up(const Scene& scene, const State& state) noexcept;

    struct Sum {
        double volume_time_m3_s = 0, stretch = 0;
        int32_t tet = -1;

        template <class Visit>
        friend void fields(Of<Sum> auto& s, Visit&& visit) {
            auto& [volume_time_m3_s, stretch, tet] = s;
            visit.state(volume_time_m3_s, stretch, tet);
        }
    };
    /// What came together since the last call, by tissue.
    [[nodiscard]] std::array<Sum, kTissueCount> take() noexcept;

 private:
    /// True when the spell is long enough to count.
    bool extend(int tet, int64_t frame, double volume_m3, Tissue tissue) noexcept;
    std::vector<int32_t> since_, last_;  // (T) frames; since -1 = not beyond
    std::array<Sum, kTissueCount> sum_{};
    double frame_s_;

    template <class Visit>
    friend void fields(Of<OverStretch> auto& s, Visit&& visit) {
        auto& [since, last, sum, frame_s] = s;
        visit.state(since, last, sum);
        visit.constant(frame_s);
    }
};

/// Spells of one instrument. Each is entered when it ends.
struct ToolLedger {
    float contact_s = 0, peak_force_n = 0;  ///< Contact with the placode.
    float quiet_s = 0;                      ///< Since that contact was last felt (debounce).
    float energy_on_s = 0, energy_j = 0;    ///< Activation.
    float air_s = 0;                        ///< Current that meets no tissue.
    double air_until_s = 0;                 ///< When it last did: a short pause does not end it.
    float dwell_s = 0;                      ///< Current on one spot.
    double dwell_until_s = 0;               ///< When it last flowed there.
    Vec3 dwell_centre = Vec3::Zero();       ///< That spot, in W [m].
    Vec3 dwell_rest = Vec3::Zero();         ///< The same at rest [m].
    int32_t dwell_tet = -1;                 ///< Tet behind it, and its tissue.
    Tissue dwell_tissue = Tissue::kSkin;
    float placode_energised_s = 0, energised_peak_c = 0;
    float over_force_s = 0, over_force_peak_n = 0;
};
template <class Visit>
void fields(Of<ToolLedger> auto& s, Visit&& visit) {
    auto& [contact_s, peak_force_n, quiet_s, energy_on_s, energy_j, air_s, air_until_s, dwell_s,
           dwell_until_s, dwell_centre, dwell_rest, dwell_tet, dwell_tissue, placode_energised_s,
           energised_peak_c, over_force_s, over_force_peak_n] = s;
    visit.state(contact_s, peak_force_n, quiet_s, energy_on_s, energy_j, air_s, air_until_s,
                dwell_s, dwell_until_s, dwell_centre, dwell_rest, dwell_tet, dwell_tissue,
                placode_energised_s, energised_peak_c, over_force_s, over_force_peak_n);
}

struct LedgerState {
    explicit LedgerState(const Scene& scene);

    std::array<ToolLedger, kMaxTools> tools{};
    OverStretch over_stretch;
    std::vector<uint8_t> tether_known;      ///< Alive, as far as the ledger knows.
    std::vector<uint8_t> stretch_reported;  ///< (T) 1 = over-stretch is entered.
    std::vector<uint8_t> dose_reported;     ///< (V) bit 0 warning dose, bit 1 injury is entered.
    std::array<float, kTissueCount> over_stretch_pause_s{};
    float overheat_pause_s = 0, burn_pause_s = 0;
    float idle_s = 0;  ///< Since an instrument touched or carried current.
    float placode_peak_cem43_min = 0, placode_peak_c = 37, placode_burned_m3 = 0;
    float placode_now_c = 37;  ///< Hottest vertex of the placode in this frame.
    int last_substeps;         ///< As last entered.
};
template <class Visit>
void fields(Of<LedgerState> auto& s, Visit&& visit) {
    auto& [tools, over_stretch, tether_known, stretch_reported, dose_reported, over_stretch_pause_s,
           overheat_pause_s, burn_pause_s, idle_s, placode_peak_cem43_min, placode_peak_c,
           placode_burned_m3, placode_now_c, last_substeps] = s;
    visit.state(tools, over_stretch, tether_known, stretch_reported, dose_reported,
                over_stretch_pause_s, overheat_pause_s, burn_pause_s, idle_s,
                placode_peak_cem43_min, placode_peak_c, placode_burned_m3, placode_now_c,
                last_substeps);
}

}  // namespace placode::sim
