// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the surface is gone, as a smooth field over the rest plane: elements are removed whole, and
// this is what their edge looks like to the eye. The pixel shader takes the rim from its contour
// and how open a wound is from its width.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/view_field.h"

namespace placode::view {

/// Part of the map that changed, in texels.
struct MapPart {
    int x = 0, y = 0, width = 0, height = 0;
};

class WoundMap {
 public:
    static constexpr int kSize = 384;
    /// Over the box `low_mm` to `high_mm` of the rest plane.
    WoundMap(const ViewField& field, const sim::Vec2& low_mm, const sim::Vec2& high_mm);

    /// Follows the snapshot; what changed, empty where nothing did.
    MapPart update(const sim::Snapshot& snapshot);
    /// (kSize x kSize x 4): share that is gone within 0.3 mm, the same within 1 mm, slope of the
    /// first along x and y (0.5 = level).
    [[nodiscard]] const std::vector<uint8_t>& pixels() const { return pixels_; }
    /// Share that is gone within 0.3 mm of a place at rest [mm], 0 to 1.
    [[nodiscard]] double gone_at(const sim::Vec2& mm) const;

 private:
    struct Top {
        std::array<int, 3> corners{};  // ascending
        std::array<sim::Vec2, 3> place;
        bool gone = false, here = false;
    };
    [[nodiscard]] int top_of(std::array<int, 3> corners) const;
    void fill(const Top& top);
    void blur(const MapPart& part);

    sim::Vec2 low_, texels_per_mm_;
    std::vector<Top> tops_;    // sorted by corners
    std::vector<float> mask_;  // (kSize x kSize) 1 = gone
    std::vector<uint8_t> pixels_;
    int whole_ = 0;
    uint32_t version_ = 0;
    size_t triangle_count_ = 0;
};

}  // namespace placode::view
