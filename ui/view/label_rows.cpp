// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/label_rows.h"

#include <algorithm>
#include <cmath>

namespace placode::view {

namespace {

bool overlap(const LabelBox& a, const LabelBox& b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

}  // namespace

double free_row(const std::vector<LabelBox>& placed, const LabelBox& wanted, double top,
                double bottom, double gap) {
    constexpr int kFarthest = 4;  // farther away nobody knows what a label belongs to
    const auto lies_over = [&](double y) {
        return std::any_of(placed.begin(), placed.end(), [&](const LabelBox& other) {
            return overlap({wanted.x, y, wanted.w, wanted.h}, other);
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

LabelBox first_free(const std::vector<LabelBox>& placed, const std::vector<LabelBox>& places) {
    for (const LabelBox& place : places) {
        if (std::none_of(placed.begin(), placed.end(),
                         [&](const LabelBox& other) { return overlap(place, other); }))
            return place;
    }
    return places.empty() ? LabelBox{} : places.front();
}

}  // namespace placode::view
