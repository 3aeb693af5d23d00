// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What surrounds the simulated field, so that nothing ends in the dark: the back around it (skirt),
// what lies beside and below it (bed), the floor of an opened sac, the wall of the uterus. Drawn,
// never operated on. Vertices as in tissue_mesh.h.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/drawn_mesh.h"
#include "ui/view/view_field.h"

namespace placode::view {

/// The back beyond the field: follows the field's edge, never moves.
[[nodiscard]] DrawnMesh build_skirt(const ViewField& field);
/// The inside of the uterus: an ellipsoid of gas around the fetal back.
[[nodiscard]] DrawnMesh build_wall();
/// What is seen through an opened sac: the floor of the canal under a film of fluid. It reaches on
/// below the skin edge, or its grid would show against the dark. Empty without a sac.
[[nodiscard]] DrawnMesh build_floor(const sim::CanalFloor& floor);

/// Fascia and muscle beside and below the field: seen through what was cut out at its rim or down
/// to its bottom. Drawn only near what was cut.
class Bed {
 public:
    explicit Bed(const ViewField& field);
    /// Yields with tissue that is pressed down; does not rise with tissue that is lifted.
    void follow(const sim::Snapshot& snapshot);
    /// After the surface has changed: what of it can be seen.
    void choose(const sim::Snapshot& snapshot);
    [[nodiscard]] const DrawnMesh& mesh() const { return mesh_; }

 private:
    static constexpr int kCells = 64;
    [[nodiscard]] int cell_of(const std::array<float, 3>& rest_m) const;
    DrawnMesh mesh_;
    std::vector<int> vertex_of_;
    std::vector<float> field_z_;              // of the field's vertices at rest [mm]
    std::vector<std::array<float, 3>> rest_;  // (V) [m]
    std::vector<unsigned> all_;
    std::vector<uint8_t> near_cut_;  // (kCells x kCells)
    float low_ = 0, cell_m_ = 0.001F;
};

}  // namespace placode::view
