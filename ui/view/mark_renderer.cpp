// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/mark_renderer.h"

#include <algorithm>
#include <array>

namespace placode::view {

using sim::Vec3;

MarkRenderer::MarkRenderer() { mesh_.create({4}); }

bool MarkRenderer::follow(const sim::Snapshot& snapshot, const Camera& camera, bool contour) {
    points_.clear();
    const auto add = [&](const std::array<float, 3>& p, float kind) {
        const Vec3 mm = 1000 * Vec3(p[0], p[1], p[2]);
        const Vec3 lifted = mm + 0.15 * (camera.position_mm - mm).normalized();
        for (int k = 0; k < 3; ++k) points_.push_back(static_cast<float>(lifted[k]));
        points_.push_back(kind);
    };
    for (size_t i = 0; contour && i < snapshot.contour.size(); ++i) {
        const bool cut = i < snapshot.contour_cut.size() && snapshot.contour_cut[i] != 0;
        add(snapshot.contour[i], cut ? 1.0F : 0.0F);
    }
    for (size_t i = 0; i < snapshot.resect_line.size(); ++i) {
        const bool cut = i < snapshot.resect_cut.size() && snapshot.resect_cut[i] != 0;
        add(snapshot.resect_line[i], cut ? 1.0F : 2.0F);
    }
    return !points_.empty();
}

void MarkRenderer::draw(int size) {
    program_.set("point_size", std::max(2.0F, static_cast<float>(size) / 220.0F));
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    mesh_.vertices(points_.data(), points_.size(), true);
    mesh_.draw(GL_POINTS, static_cast<int>(points_.size() / 4));
    glDisable(GL_BLEND);
}

}  // namespace placode::view
