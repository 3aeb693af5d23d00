// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How smooth the rim of a cut is, what it costs to make it so, and what it does to the mesh.

#include "sim/anatomy/operative_field.h"

namespace placode::bench {

/// Snips across and along the planned incision of a field, each in an untouched one.
struct CutRow {
    double snap = 0;  ///< Scene::cut_snap.
    int snips = 0, slides = 0, refused = 0;
    double rms_mm = 0, max_mm = 0;      ///< Of the rim from its line, on the surface at rest.
    double length_over_path = 0;        ///< Length of the rim against that line.
    double least_quality = 1;           ///< tet_quality() after the snips; whole mesh.
    double frame_us = 0, worst_us = 0;  ///< Of a frame that slides: its slides, median and most.
    double energy_jump = 0;             ///< Largest of a frame, of the elastic energy around.
};

/// @param spec with any tools: they are replaced by scissors.
[[nodiscard]] CutRow measure_cuts(sim::OperativeFieldSpec spec, double snap, int snips);

}  // namespace placode::bench
