// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A wound that is there from the start: which vertices are its walls.

#include <array>
#include <cstdint>
#include <vector>

namespace placode::sim {

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

    [[nodiscard]] bool present() const noexcept { return layers > 0; }
    /// 0 for vertices that cuts have added: they are no walls of this wound.
    [[nodiscard]] int side_of(int32_t v) const noexcept {
        return static_cast<size_t>(v) < side.size() ? side[static_cast<size_t>(v)] : 0;
    }
};

}  // namespace placode::sim
