// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Labels in the picture that would lie over each other are moved apart, up or down.

#include <vector>

namespace placode::view {

/// A label's place in the window, y downwards [px].
struct LabelBox {
    double x = 0, y = 0, w = 0, h = 0;
};

/// The height nearest to `wanted.y`, below before above, at which it lies over none of `placed`
/// and stays within `top` to `bottom`; rows are `gap` apart. `wanted.y` where there is none near.
[[nodiscard]] double free_row(const std::vector<LabelBox>& placed, const LabelBox& wanted,
                              double top, double bottom, double gap);

/// The first of `places` that lies over none of `placed`; the first of all where there is none.
[[nodiscard]] LabelBox first_free(const std::vector<LabelBox>& placed,
                                  const std::vector<LabelBox>& places);

}  // namespace placode::view
