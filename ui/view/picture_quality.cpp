// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/picture_quality.h"

#include <algorithm>
#include <iterator>

namespace placode::view {

namespace {

constexpr double kScales[] = {0.3, 0.45, 0.6, 0.8, 1.0, 1.25};
constexpr double kPlainScale = 0.6;  // at and below it the camera's effects are not worth theirs
constexpr int kMostSamples = 4;

const double* step_of(double scale) {
    const auto* at = std::lower_bound(std::begin(kScales), std::end(kScales), scale - 1e-6);
    return at == std::end(kScales) ? at - 1 : at;
}

}  // namespace

bool make_simpler(Quality& quality) {
    if (quality.shadows) {
        quality.shadows = false;
        return true;
    }
    if (quality.samples > 0) {
        quality.samples = 0;
        return true;
    }
    const double* at = step_of(quality.render_scale);
    if (!quality.plain && *at <= kPlainScale) return quality.plain = true;
    if (at == std::begin(kScales)) return false;
    quality.render_scale = *(at - 1);
    return true;
}

bool make_richer(Quality& quality) {
    const double* at = step_of(quality.render_scale);
    if (quality.plain && *at >= kPlainScale) {
        quality.plain = false;
        return true;
    }
    if (at + 1 != std::end(kScales)) {
        quality.render_scale = *(at + 1);
        return true;
    }
    if (quality.samples < kMostSamples) {
        quality.samples = kMostSamples;
        return true;
    }
    if (quality.shadows) return false;
    return quality.shadows = true;
}

bool no_richer_than(const Quality& quality, const Quality& most) {
    return quality.render_scale <= most.render_scale + 1e-6 && quality.samples <= most.samples &&
           (quality.plain || !most.plain) && (!quality.shadows || most.shadows);
}

Quality software_quality(Quality wanted, int height_px) {
    constexpr int kLargePx = 800;  // of a window, from which on fewer pixels are computed
    wanted.samples = 0;
    wanted.shadows = false;
    wanted.render_scale = std::min(wanted.render_scale, height_px > kLargePx ? kPlainScale : 0.8);
    return wanted;
}

}  // namespace placode::view
