// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What connectivity alone does not show: tets that lie inside each other, vertices that lie on each
// other without being joined. Private to sim/mesh_io.

#include <string>
#include <vector>

#include "sim/mesh_io/mesh_io.h"

namespace placode::sim {

/// A sentence for each kind, with the numbers of the file; none for a sound mesh. Found are
/// tets around the middle of another tet or around a vertex that is not theirs: an overlap of less
/// than that stays unseen. @pre no tet is flat, all points of tets are finite.
[[nodiscard]] std::vector<std::string> overlap_warnings(const FileMesh& file);

}  // namespace placode::sim
