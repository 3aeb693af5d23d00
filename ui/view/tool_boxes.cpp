// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tool_boxes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace placode::view {

using namespace sim;

std::vector<ShadowCapsule> seen_capsules(const Snapshot& snapshot,
                                         const std::vector<ToolSpec>& tools, const Camera& camera) {
    constexpr int kSteps = 12;
    constexpr double kBeside = 1.35;
    std::vector<ShadowCapsule> seen;
    for (size_t i = 0; i < tools.size() && i < static_cast<size_t>(snapshot.tool_count); ++i) {
        if (!is_drawn(tools, i, snapshot)) continue;
        for (const ShadowCapsule& c : shadow_capsules(tools[i], snapshot.tools[i].pose)) {
            bool near = false;
            for (int k = 0; k <= kSteps && !near; ++k) {
                const auto place = place_in_picture(camera, c.a + k / double{kSteps} * (c.b - c.a));
                near = place && place->norm() < kBeside;
            }
            if (near) seen.push_back(c);
        }
    }
    return seen;
}

namespace {

// A capsule's axis in the picture, from its one end to the other; gaps where it is behind the lens.
struct Seen {
    Vec2 at;
    double half = 0;  // width there
};

std::vector<std::optional<Seen>> walk(const ShadowCapsule& c, const Camera& camera) {
    constexpr int kSteps = 64;
    constexpr double kBorder = 0.015, kFootMm = 1.8;
    const double focal = 1 / std::tan(camera.half_angle_rad);
    std::vector<std::optional<Seen>> seen;
    for (int k = 0; k <= kSteps; ++k) {
        const Vec3 at = c.a + k / double{kSteps} * (c.b - c.a);
        const auto place = place_in_picture(camera, at);
        // Jaws and the foot of a hook stand off the axis.
        const double near = std::max(2.0, (at - camera.position_mm).norm());
        seen.emplace_back();
        if (place)
            seen.back() = Seen{*place, std::max(2.5 * c.radius, kFootMm) * focal / near + kBorder};
    }
    return seen;
}

}  // namespace

// Pieces of a shaft, because one box around a slanting shaft is mostly empty.
std::vector<PictureBox> tool_boxes(const Snapshot& snapshot, const std::vector<ToolSpec>& tools,
                                   const Camera& camera) {
    constexpr double kPiece = 0.25;  // of the picture's radius
    std::vector<PictureBox> boxes;
    for (const ShadowCapsule& c : seen_capsules(snapshot, tools, camera)) {
        const auto seen = walk(c, camera);
        Vec2 start = Vec2::Zero();  // of the last box
        bool open = false;          // it may grow
        for (size_t k = 0; k + 1 < seen.size(); ++k) {
            const auto &a = seen[k], &b = seen[k + 1];
            if (!a || !b || std::min(a->at.norm() - a->half, b->at.norm() - b->half) > 1) {
                open = false;
                continue;
            }
            if (!open) {
                boxes.push_back({Vec2(1, 1), Vec2(-1, -1)});
                start = a->at;
            }
            PictureBox& box = boxes.back();
            for (const Seen& end : {*a, *b}) {
                const Vec2 half(end.half, end.half), low(-1, -1), high(1, 1);
                box.low = box.low.cwiseMin(end.at - half).cwiseMax(low);
                box.high = box.high.cwiseMax(end.at + half).cwiseMin(high);
            }
            open = (b->at - start).norm() < kPiece;
        }
    }
    return boxes;
}

}  // namespace placode::view
