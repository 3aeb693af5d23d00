// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/depth_cue.h"

#include <algorithm>
#include <cmath>

#include "ui/view/tissue_mesh.h"

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;

// Beyond these the shadow is not drawn, and it fades before; see depth_shadow.glsl.
constexpr double kShaftMm = 11, kFadesMm = 8, kHighestMm = 12;
constexpr float kSpreadMm = 3.5F, kBorderMm = 1.2F;
constexpr float kTriangleMm = 2;  // no edge is longer by much
constexpr float kLongMm = 6;      // in the plane: a shaft that lies, and reaches out of its shadow

float soft_step(float low, float high, float v) {
    const float t = std::clamp((v - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

Vector3f corner(const DrawnTissue& tissue, unsigned index) {
    const float* p = &tissue.vertices[static_cast<size_t>(index) * kTissueVertexFloats];
    return {p[0], p[1], p[2]};
}

}  // namespace

DepthCue::DepthCue() : program_("depth_shadow_vertex", "depth_shadow") { mesh_.create({3, 1}); }

/// The highest tissue on the vertical through the tip counts: what lies below it is hidden.
void DepthCue::drop_on(const Drop& drop, const std::array<Vector3f, 3>& p) {
    const auto cross2 = [&](size_t i, size_t j) {
        const float ax = p[i].x() - drop.tip.x(), ay = p[i].y() - drop.tip.y();
        const float bx = p[j].x() - drop.tip.x(), by = p[j].y() - drop.tip.y();
        return ax * by - ay * bx;
    };
    const float a = cross2(1, 2), b = cross2(2, 0), c = cross2(0, 1);
    const bool inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    const float sum = a + b + c;
    if (!inside || std::abs(sum) < 1e-9F) return;
    const double z = static_cast<double>((a * p[0].z() + b * p[1].z() + c * p[2].z()) / sum);
    if (drop.foot->found && drop.foot->foot_mm.z() >= z) return;
    drop.foot->found = true;
    drop.foot->foot_mm =
        Vec3(static_cast<double>(drop.tip.x()), static_cast<double>(drop.tip.y()), z);
    drop.foot->height_mm = static_cast<double>(drop.tip.z()) - z;
}

bool DepthCue::Drop::is_about(const Vector3f& p) const {
    return p.x() > low[0] && p.x() < high[0] && p.y() > low[1] && p.y() < high[1];
}

DepthCue::Drop::Place DepthCue::Drop::place(const Vector3f& p) const {
    const Eigen::Vector2f from = p.head<2>() - tip.head<2>();
    const float along =
        std::clamp(from.dot(shaft) / std::max(shaft.squaredNorm(), 1e-6F), 0.0F, 1.0F);
    return {along, (from - along * shaft).norm()};
}

float DepthCue::Drop::share(const Place& at) const {
    const float lies = soft_step(0.5F * kLongMm, kLongMm, shaft.norm());
    return strength * (1 - soft_step(kSpreadMm - kBorderMm, kSpreadMm, at.aside)) *
           (1 - lies * soft_step(0.6F, 1, at.along));
}

void DepthCue::update(const Snapshot& snapshot, const std::vector<ToolSpec>& tools,
                      std::span<const DrawnTissue> parts) {
    before_ = feet_;
    feet_.fill({});
    below_.clear();
    drops_.clear();
    for (size_t i = 0; i < tools.size() && i < static_cast<size_t>(snapshot.tool_count); ++i) {
        const ToolSnapshot& tool = snapshot.tools[i];
        if (tool.kind == ToolKind::kScope || tool.engaged == 0) continue;
        const Vec3 tip = 1000 * tool.pose.p;
        const Vec3 back = tip - kShaftMm * (tool.pose.q * Vec3::UnitZ());
        const Vector3f a = tip.cast<float>(), b = back.cast<float>();
        Drop drop;
        drop.tip = a;
        drop.shaft = (b - a).head<2>();
        for (int k = 0; k < 2; ++k) {
            drop.low[k] = std::min(a[k], b[k]) - kSpreadMm - kTriangleMm;
            drop.high[k] = std::max(a[k], b[k]) + kSpreadMm + kTriangleMm;
        }
        // What hung high above the field in the picture before throws no shadow in this one.
        if (before_[i].found)
            drop.strength =
                1 - soft_step(kFadesMm, kHighestMm, static_cast<float>(before_[i].height_mm));
        drop.foot = &feet_[i];
        drops_.push_back(drop);
    }
    if (drops_.empty()) return;
    for (const DrawnTissue& part : parts) collect(part);
}

void DepthCue::collect(const DrawnTissue& tissue) {
    for (size_t k = 0; k + 2 < tissue.indices.size(); k += 3) {
        const Vector3f first = corner(tissue, tissue.indices[k]);
        if (std::none_of(drops_.begin(), drops_.end(),
                         [&](const Drop& drop) { return drop.is_about(first); }))
            continue;
        const std::array<Vector3f, 3> p{first, corner(tissue, tissue.indices[k + 1]),
                                        corner(tissue, tissue.indices[k + 2])};
        std::array<float, 3> share{};
        for (const Drop& drop : drops_) {
            for (size_t c = 0; c < 3; ++c) {
                const Drop::Place at = drop.place(p[c]);
                if (c == 0 && at.aside < kSpreadMm) drop_on(drop, p);
                share[c] = std::max(share[c], drop.share(at));
            }
        }
        if (share[0] + share[1] + share[2] == 0) continue;
        for (size_t c = 0; c < 3; ++c) {
            below_.insert(below_.end(), p[c].data(), p[c].data() + 3);
            below_.push_back(share[c]);
        }
    }
}

void DepthCue::draw() {
    if (below_.empty()) return;
    // The same places as the tissue itself, a hair nearer.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDepthMask(GL_FALSE);
    mesh_.vertices(below_.data(), below_.size(), true);
    mesh_.draw(GL_TRIANGLES, static_cast<int>(below_.size() / 4));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace placode::view
