// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A few seconds of moving surface in bytes: of the tissue only what can be seen, places in steps of
// 8 um, every picture as its difference to the one before. docs/web.md has the layout;
// ui/web/review/part.js reads it.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/step/snapshot.h"

namespace placode::reports {

inline constexpr double kReviewStepM = 8e-6;  ///< Of a place; a pixel shows some 40 um.
/// A place rests until it is more steps away: trembling tissue would be most of the bytes.
inline constexpr int kReviewRestSteps = 2;
inline constexpr double kReviewLeastM = -0.262144;  ///< Place 0: 16 bits reach 524 mm.
inline constexpr uint32_t kReviewPartVersion = 3;
inline constexpr int kReviewToolFloats = 9;    ///< Place, w x y z, jaw [rad], force [N].
inline constexpr int kReviewNeedleFloats = 7;  ///< Place, w x y z; all 0 = not in the field.

/// What is drawn of a moment, as the part keeps it.
class ReviewPart {
 public:
    void add(const sim::Snapshot& moment);
    [[nodiscard]] int pictures() const noexcept { return static_cast<int>(pictures_.size()); }
    /// All of it, compressed by zlib (RFC 1950). Empty without pictures.
    [[nodiscard]] std::string encoded() const;

 private:
    using Place = std::array<uint16_t, 3>;
    using Damage = std::array<uint8_t, 3>;  ///< Blanched, dried, charred: 0 to 255.
    struct Picture {
        float time_s = 0;
        uint32_t surface = 0;
        std::vector<Place> x;             ///< By vertex of the body.
        std::vector<Damage> damage;       ///< The same.
        std::vector<Place> lines;         ///< The planned one, then that around marked tissue.
        std::vector<uint8_t> line_flags;  ///< 1 = cut there; 2 = of the second line.
        std::vector<float> tools;         ///< kReviewToolFloats of each.
        std::vector<uint8_t> tool_flags;
        std::array<float, kReviewNeedleFloats> needle{};  ///< Of a suture needle.
        std::vector<Place> thread;                        ///< From its swage on.
    };
    struct Surface {
        uint32_t version = 0;
        std::vector<sim::SurfaceTriangle> triangles;
    };
    struct Numbering;

    [[nodiscard]] Numbering numbering() const;
    void put_surfaces(std::string& words, std::string& bytes, const Numbering& numbering) const;
    void put_damage(std::string& bytes, const Numbering& numbering) const;
    void put_places(std::string& bytes, const Numbering& numbering) const;
    [[nodiscard]] bool has_needle() const;
    void put_threads(std::string& bytes) const;

    std::vector<Picture> pictures_;
    std::vector<Surface> surfaces_;
};

}  // namespace placode::reports
