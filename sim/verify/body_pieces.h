// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The connected pieces of a scene's body. Private to sim/verify.

#include <vector>

#include "sim/verify/verification_scene.h"

namespace placode::sim {

struct BodyPieces {
    std::vector<int32_t> of_vertex;  ///< (V) piece of every vertex.
    std::vector<uint8_t> held;       ///< (pieces) axes bits: something of the piece is held there.
};

/// Connected by tets and by the triangles of sheets. @param held (V) axes bits.
[[nodiscard]] BodyPieces pieces_of(const VerificationScene& scene,
                                   const std::vector<uint8_t>& held);

}  // namespace placode::sim
