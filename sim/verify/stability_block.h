// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The block that the stability cases disturb, and how far it is from its rest shape. Private to
// sim/verify.

#include <string>

#include "sim/solver/soft_body.h"
#include "sim/verify/stability_cases.h"

namespace placode::sim {

inline constexpr double kCell = 0.001;  ///< Edge of the block's cells [m].
inline constexpr int kCells = 6;        ///< Along each side.

/// What a case changes on the block (5 kPa, nu 0.45, cells of 1 mm, free; VBD with its usual 4
/// substeps a frame, XPBD with the 8 that its Courant number asks for).
struct StabilityBlock {
    double poissons_ratio = 0.45, frame_s = 1e-3, damping_per_s = 20;
    double dense_kg_m3 = 1000;  ///< Of its upper half.
    double thin_m = 0;          ///< Thickness of the middle layer, 0 = like the others.
    bool hold_bottom = false;
    Vec3 gravity = Vec3::Zero();
};

[[nodiscard]] SoftBodySpec block_spec(const StabilityBlock& block, Method method);

/// Where vertex v is [m].
[[nodiscard]] Vec3 place_of(const SoftBodyState& state, int32_t v);

struct BlockShape {
    double worst_edge = 0;  ///< |length / rest - 1|
    int inverted = 0;
    bool finite = true;
    /// Edges within 2 % of their rest length.
    [[nodiscard]] bool sound() const { return finite && inverted == 0 && worst_edge < 0.02; }
};

[[nodiscard]] BlockShape shape_of(const SoftBody& body, const SoftBodyState& state);

/// "12.3 um".
[[nodiscard]] std::string length_text(double metres);

/// Follows a shape that was disturbed: when was it back for good?
class BlockWatch {
 public:
    void look(double time, const BlockShape& shape);
    void finish(StabilityResult& result, bool restored) const;

 private:
    BlockShape last_;
    double back_ = -1;
    bool left_ = false, never_finite_ = false;
};

}  // namespace placode::sim
