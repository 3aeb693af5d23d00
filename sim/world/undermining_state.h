// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Jaws that spread, and a plane that parts.

#include <cstdint>
#include <vector>

#include "sim/core/fields.h"

namespace placode::sim {

struct Scene;

/// How far the jaws of one tool really stand apart.
struct SpreadJaws {
    float rad = -1;    ///< Between them; -1 = not known before the first frame.
    float push_n = 0;  ///< Force of tissue that shuts them, on the jaw that bears less, mean of the
                       ///< last frame [N].
};
template <class Visit>
void fields(Of<SpreadJaws> auto& s, Visit&& visit) {
    auto& [rad, push_n] = s;
    visit.state(rad, push_n);
}
template <>
inline constexpr bool kPlainBytes<SpreadJaws> = true;

/// Empty in a scene without jaws that spread and without a plane.
struct UnderminingState {
    explicit UnderminingState(const Scene& scene);

    std::vector<SpreadJaws> jaws;     ///< (tools) or empty.
    std::vector<uint8_t> over_count;  ///< (faces) Checks in a row above the plane's strength.
};
template <class Visit>
void fields(Of<UnderminingState> auto& s, Visit&& visit) {
    auto& [jaws, over_count] = s;
    visit.state(jaws, over_count);
}

}  // namespace placode::sim
