// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/smoke_renderer.h"

#include <algorithm>

namespace placode::view {

SmokeRenderer::SmokeRenderer() { mesh_.create({4, 2}); }

void SmokeRenderer::draw(const std::vector<Puff>& puffs, const Camera& camera) {
    if (puffs.empty()) return;
    std::vector<const Puff*> order;
    for (const Puff& p : puffs) order.push_back(&p);
    std::sort(order.begin(), order.end(), [&](const Puff* a, const Puff* b) {
        return (a->position_mm - camera.position_mm).squaredNorm() >
               (b->position_mm - camera.position_mm).squaredNorm();
    });
    std::vector<float> data;
    for (const Puff* p : order) {
        const double age = p->age_s / p->life_s,
                     near = (p->position_mm - camera.position_mm).norm();
        // Thin out with age, and where a puff would stick to the lens.
        const double opacity =
            p->opacity * std::min(1.0, 6 * age) * (1 - age) * std::clamp((near - 4) / 6, 0.0, 1.0);
        for (int corner = 0; corner < 6; ++corner) {
            for (int k = 0; k < 3; ++k) data.push_back(static_cast<float>(p->position_mm[k]));
            data.push_back(static_cast<float>(p->radius_mm));
            data.push_back(static_cast<float>(opacity));
            data.push_back(p->seed);
        }
    }
    program_.set("camera_right", camera.right);
    program_.set("camera_up", camera.up);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    mesh_.vertices(data.data(), data.size(), true);
    mesh_.draw(GL_TRIANGLES, static_cast<int>(data.size() / 6));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace placode::view
