// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What frames cost in the scenes that cost most: a needle and its thread in a row of bites, and a
// patch that lies, hangs and is dragged. Every state stands next to the same field and hands
// without needle or patch.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/frame_parts.h"

namespace placode::bench {

struct HardScene {
    const char* name;
    /// With so many threads. `quick` = fewer frames of a state where the next does not begin there.
    std::vector<FrameParts> (*measure)(int threads, bool quick);
    std::shared_ptr<const sim::Scene> (*field)();
};
[[nodiscard]] std::span<const HardScene> hard_scenes() noexcept;

/// The field of `suture_run`, made longer; eight bites of one thread of 150 mm are laid into it as
/// a needle's circle goes, and the needle in the jaws of a driver hangs on. A second driver presses
/// beside the row.
[[nodiscard]] std::vector<FrameParts> measure_suture_scene(int threads, bool quick);
[[nodiscard]] std::shared_ptr<const sim::Scene> suture_scene();

/// The field of `patch_place` with a patch of 25 x 15 mm (750 triangles) and a grasper.
[[nodiscard]] std::vector<FrameParts> measure_patch_scene(int threads, bool quick);
[[nodiscard]] std::shared_ptr<const sim::Scene> patch_scene();

}  // namespace placode::bench
