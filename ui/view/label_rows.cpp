// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/label_rows.h"

#include <algorithm>
#include <cmath>

namespace placode::sim {

double free_row(const std::vector<LabelBox>& placed, const LabelBox& wanted, double top,
                double bottom, double gap) {
    constexpr int kFarthest = 4;  // farther away nobody knows what a label belongs to
    const auto lies_over = [&](double y) {
        return std::any_of(placed.begin(), placed.end(), [&](const LabelBox& other) {
            return wanted.x < other.x + other.w && other.x < wanted.x + wanted.w &&
                   y < other.y + other.h && other.y < y + wanted.h;
        });
    };
    // Right below or above what is in the way, not a whole row away.
    std::vector<double> heights{wanted.y};
    for (const LabelBox& other : placed) {
        heights.push_back(other.y + other.h + gap);
        heights.push_back(other.y - wanted.h - gap);
    }
    std::stable_sort(heights.begin(), heights.end(), [&](double a, double b) {
        return std::abs(a - wanted.y) < std::abs(b - wanted.y);
    });
    for (const double y : heights) {
        const bool near = std::abs(y - wanted.y) <= kFarthest * (wanted.h + gap);
        if (near && y >= top && y + wanted.h <= bottom && !lies_over(y)) return y;
    }
    return wanted.y;
}

}  // namespace placode::sim
