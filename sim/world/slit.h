// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A wound that is there from the start: which vertices are its walls.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace placode::sim {

/// Fluid below a slit is put under pressure when the attempt is over: sim/step/watertight.h.
/// The leak is measured at 6 and at 12.5 cmH2O, the range that was measured in the sac during
/// repair. Source: J Pediatr Surg 2020;55:726 (abstract).
struct WatertightSpec {
    static constexpr double kPassPa = 588.4, kGoodPa = 1225.8;
    double most_pa = 3922.7;       ///< The pressure rises no further: 40 cmH2O. Planning value.
    double burst_m3_s = 1.667e-7;  ///< A leak that counts as burst: 10 ml/min. Planning value.
};

/// A slit runs from one tip to the other and parts some layers from the surface down. At stations
/// along it the vertices of both walls stand opposite to each other. Never changes.
struct Slit {
    static constexpr int kMostLevels = 5;
    /// Levels 0 (surface) to `layers` (where the floor begins) of one wall; the rest is -1.
    using Column = std::array<int32_t, kMostLevels>;
    struct Station {
        Column left{}, right{};  ///< Walking from the first tip to the last.
    };

    int layers = 0;  ///< That are parted.
    std::vector<Station> stations;
    /// (V) 1 and -1 = left and right wall above the floor; empty without a slit.
    std::vector<int8_t> side;
    std::optional<WatertightSpec> watertight;  ///< Absent = nobody tests it.

    [[nodiscard]] bool present() const noexcept { return layers > 0; }
    /// 0 for vertices that cuts have added: they are no walls of this wound.
    [[nodiscard]] int side_of(int32_t v) const noexcept {
        return static_cast<size_t>(v) < side.size() ? side[static_cast<size_t>(v)] : 0;
    }
};

}  // namespace placode::sim
