// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a patch touches (sim/contact/patch_contact.h).

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/fields.h"

namespace placode::sim {

struct Scene;

/// A face of the tissue, the one opposite to corner `face` of `tet`, and a point of it.
struct TissueSpot {
    int32_t tet = -1;  ///< -1 = none.
    int32_t face = 0;
    std::array<float, 3> weight{};
};
template <class Visit>
void fields(Of<TissueSpot> auto& s, Visit&& visit) {
    auto& [tet, face, weight] = s;
    visit.state(tet, face, weight);
}
template <>
inline constexpr bool kPlainBytes<TissueSpot> = true;

/// A vertex of the patch against the tissue.
struct PatchTouch {
    int32_t tet = -1, face = 0;  ///< Nearest face of the tissue; -1 = none within reach.
    int32_t presses = 0;         ///< 1 = its spring is set in this substep.
    TissueSpot anchor;           ///< Where friction holds it; none while it does not press.
};
template <class Visit>
void fields(Of<PatchTouch> auto& s, Visit&& visit) {
    auto& [tet, face, presses, anchor] = s;
    visit.state(tet, face, presses, anchor);
}
template <>
inline constexpr bool kPlainBytes<PatchTouch> = true;

/// Empty in a scene without a patch. Sized by the constructor, never grows.
struct PatchState {
    explicit PatchState(const Scene& scene);

    std::vector<PatchTouch> touch;  ///< (vertices of the patch)
    /// Vertices of the tissue that bear it, the first `loaded_count`.
    std::vector<int32_t> loaded;
    int32_t loaded_count = 0;
    std::vector<uint8_t> listed;               ///< (V) 1 = among `loaded`.
    std::vector<std::array<float, 3>> load_n;  ///< (V) On the tissue [N].
    std::vector<std::array<float, 3>> told_n;  ///< (V) The load when the tissue was last woken [N].
};
template <class Visit>
void fields(Of<PatchState> auto& s, Visit&& visit) {
    auto& [touch, loaded, loaded_count, listed, load_n, told_n] = s;
    visit.state(touch, loaded_count, listed, load_n, told_n);
    visit.state_of(loaded_count, loaded);
}

}  // namespace placode::sim
