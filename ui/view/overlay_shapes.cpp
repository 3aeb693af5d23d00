// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlay_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace placode::view::shapes {

using namespace sim;

namespace {

Vec2 at(double angle) { return {std::sin(angle), -std::cos(angle)}; }

void bar(TextPainter& paint, const Vec2& from, const Vec2& to, double half, const Colour& colour) {
    const Vec2 offset = to - from;
    const double length = offset.norm();
    if (length < 1e-9) return;
    const Vec2 across = half / length * Vec2(-offset.y(), offset.x());
    paint.quad({Vec2(from - across), Vec2(to - across), Vec2(to + across), Vec2(from + across)},
               colour);
}

int pieces(double radius, double angle) {
    return std::clamp(static_cast<int>(std::abs(angle) * std::sqrt(radius)) + 2, 2, 72);
}

}  // namespace

void stroke(TextPainter& paint, const Vec2& from, const Vec2& to, double width,
            const Colour& colour) {
    // A faint border, because quads have hard edges.
    for (const auto& [wider, share] : {std::pair{0.8, 0.35F}, {0.35, 0.5F}, {0.0, 1.0F}})
        bar(paint, from, to, 0.5 * width + wider, colour.faded(share));
}

void arc(TextPainter& paint, const Vec2& centre, double radius, double width, double from,
         double to, const Colour& colour) {
    const int count = pieces(radius, to - from);
    const double inner = radius - 0.5 * width, outer = radius + 0.5 * width;
    for (int i = 0; i < count; ++i) {
        const Vec2 a = at(from + (to - from) * i / count),
                   b = at(from + (to - from) * (i + 1) / count);
        paint.quad({Vec2(centre + outer * a), Vec2(centre + outer * b), Vec2(centre + inner * b),
                    Vec2(centre + inner * a)},
                   colour);
    }
}

void wedge(TextPainter& paint, const Vec2& centre, double radius, double from, double to,
           const Colour& colour) {
    arc(paint, centre, 0.5 * radius, radius, from, to, colour);
}

void rounded(TextPainter& paint, double x, double y, double width, double height, double radius,
             const Colour& colour) {
    const double r = std::min({radius, 0.5 * width, 0.5 * height});
    paint.box(x + r, y, width - 2 * r, height, colour);
    paint.box(x, y + r, r, height - 2 * r, colour);
    paint.box(x + width - r, y + r, r, height - 2 * r, colour);
    for (const double cx : {x + r, x + width - r})
        for (const double cy : {y + r, y + height - r}) paint.ring(cx, cy, r, 0, colour);
}

void chevron(TextPainter& paint, const Vec2& tip, const Vec2& offset, double size, double width,
             const Colour& colour) {
    const Vec2 across(-offset.y(), offset.x());
    for (const double side : {-0.7, 0.7})
        stroke(paint, tip, tip - size * offset + side * size * across, width, colour);
}

void arrow(TextPainter& paint, const Vec2& from, const Vec2& to, double size, double width,
           const Colour& colour) {
    const Vec2 offset = to - from;
    if (offset.norm() < 1e-6) return;
    stroke(paint, from, to, width, colour);
    chevron(paint, to, offset.normalized(), size, width, colour);
}

}  // namespace placode::view::shapes
