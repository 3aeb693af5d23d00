// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a patch (Scene::patch) lies over the lesion: how far it reaches beyond the placode's edge,
// what of the placode it leaves open, what of it lies in folds. All along the skin's plane (z = 0
// of W); on a curved back the way along the skin is a little longer. docs/patch.md

#include <vector>

#include "sim/contact/sheet_cover.h"
#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// Points of the placode's edge that are looked at: every 5 degrees of a round one.
inline constexpr int kPatchEdgePoints = 72;
/// Farther beyond the edge nobody looks [m].
inline constexpr double kMostOverlapM = 0.010;

/// Watches a patch. The constructor allocates, nothing else does but events().
class PatchCover {
 public:
    PatchCover() = default;  ///< Of a scene without a patch or without a placode: not there().
    explicit PatchCover(const Scene& scene);

    [[nodiscard]] bool there() const noexcept { return !edge_.empty(); }
    /// Where patch and edge lie now. @pre there().
    void look(const Scene& scene, const State& state) noexcept;
    [[nodiscard]] SheetCover& sheet() noexcept { return sheet_; }
    /// (kPatchEdgePoints) The placode's edge where it lies now, in the order of the scene's line.
    [[nodiscard]] const std::vector<EdgePoint>& edge() const noexcept { return edge_; }
    /// kPatchEdge and kPatchFold of the patch as it lies, without their time.
    [[nodiscard]] std::vector<Event> events(const Scene& scene, const State& state);

 private:
    std::vector<EdgePoint> rest_, edge_;  // (points)
    std::vector<int32_t> vertex_;         // (points) of the surface, nearest at rest: moves them
    std::vector<std::array<Vec3, 3>> corners_;
    SheetCover sheet_;
};

/// Vertex of the patch's rim that is nearest to the placode's middle at rest, -1 without a patch:
/// where to take hold of it. And the one in the patch's middle.
struct PatchHandles {
    int32_t rim = -1, middle = -1;
    std::array<int32_t, 4> corner{-1, -1, -1, -1};  ///< In the order of its lattice, round it.
};
[[nodiscard]] PatchHandles patch_handles(const Scene& scene);

/// Height of the tissue at rest below a place in the plane [m]: that of the nearest vertex.
[[nodiscard]] double height_at_rest(const Scene& scene, const Vec2& place);

/// Middle of the placode's edge at rest [m]; the origin without one.
[[nodiscard]] Vec2 placode_middle(const Scene& scene) noexcept;

}  // namespace placode::sim
