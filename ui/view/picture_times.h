// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a picture costs, measured: from the state of the tissue to the finished picture, off screen.

#include <span>
#include <string>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/fetoscope_view.h"
#include "ui/view/picture_size.h"

namespace placode::view {

inline constexpr int kLeastPictures = 10;  ///< That a median is made of.

struct PictureTimes {
    PictureSize size;
    Quality quality;
    std::string renderer;    ///< As OpenGL calls it.
    std::vector<double> ms;  ///< Wall clock of each picture.
};

/// Draws every moment once, or until `seconds` are over, but never fewer than kLeastPictures. The
/// first few are not counted: shaders are compiled then, and caches filled.
/// @param save  File for the last picture (PNG); empty = none.
/// @pre `moments` is not empty.
[[nodiscard]] PictureTimes time_pictures(const ViewField& field,
                                         std::span<const sim::Snapshot> moments,
                                         const PictureSize& size, const Quality& quality,
                                         double seconds, const std::string& save);

/// From the richest to the plainest.
[[nodiscard]] std::vector<Quality> all_qualities();

}  // namespace placode::view
