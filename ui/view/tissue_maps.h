// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Textures that stick to the rest shape: where the anatomy's borders run, vessels, skin flecks and
// tileable noise. Baked once per scene from its seed, so that the pixel shader only looks up.

#include "ui/view/gl_program.h"
#include "ui/view/view_field.h"

namespace placode::view {

/// Plain pixels, for tests and upload.
struct BakedMaps {
    sim::Vec2 low_mm = sim::Vec2(-24, -18),
              high_mm = sim::Vec2(24, 18);  ///< Rest box that the maps cover.
    int border_size = 0;                    ///< Width = height of `borders`.
    std::vector<float> borders;             ///< (n x n x 2) d_p, d_s [mm], negative inside.
    int vessel_size = 0;
    std::vector<uint8_t> vessels;  ///< (n x n x 4) placode, arteriole, venule, unused.
    int skin_size = 0;
    std::vector<uint8_t> skin;  ///< (n x n x 4) tileable: vernix, lanugo, mottle, pores.
    int noise_size = 0;
    std::vector<uint8_t> noise;  ///< (n x n x 4) tileable: fbm, fbm 2, slope x, slope y.
};
inline constexpr double kSkinTileMm = 24.0;

[[nodiscard]] BakedMaps bake_maps(const ViewField& field);

struct TissueMaps {
    explicit TissueMaps(const BakedMaps& baked);
    /// Binds to units 0..3: borders, vessels, skin, noise.
    void bind() const;
    GlTexture borders, vessels, skin, noise;
    sim::Vec2 low_mm, high_mm;
};

}  // namespace placode::view
