// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How much is computed per picture, and the order in which things are left out where pictures are
// slow: first shadows of tissue, then smooth edges, then pixels, then what lens and camera add and
// the finest of a wound, then pixels again.

namespace placode::view {

struct Quality {
    double render_scale = 1;  ///< Pixels computed per pixel shown, along each side.
    int samples = 0;          ///< Multisampling.
    bool plain = false;       ///< No bloom, grain or coloured rim; lens and film at render scale.
    bool shadows = false;     ///< Of tissue on tissue.
};

/// One step simpler. False when it is as simple as it gets.
[[nodiscard]] bool make_simpler(Quality& quality);
/// One step richer. False when it is as rich as it gets.
[[nodiscard]] bool make_richer(Quality& quality);
/// Whether `quality` asks for nothing that `most` does not.
[[nodiscard]] bool no_richer_than(const Quality& quality, const Quality& most);
/// Where the processor draws, to start with: it never stutters through its first second.
[[nodiscard]] Quality software_quality(Quality wanted, int height_px);

}  // namespace placode::view
