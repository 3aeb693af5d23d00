// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Simple figures from the painter's quads and rings. Angles in radians, clockwise from up; lengths
// in pixels. Private to sim/view.

#include "ui/view/text.h"

namespace placode::view::shapes {

/// A line with soft edges.
void stroke(TextPainter& paint, const sim::Vec2& from, const sim::Vec2& to, double width,
            const Colour& colour);
/// Part of a ring.
void arc(TextPainter& paint, const sim::Vec2& centre, double radius, double width, double from,
         double to, const Colour& colour);
/// Part of a disc.
void wedge(TextPainter& paint, const sim::Vec2& centre, double radius, double from, double to,
           const Colour& colour);
/// A box with round corners; the colour must be opaque.
void rounded(TextPainter& paint, double x, double y, double width, double height, double radius,
             const Colour& colour);
/// An open arrow head whose point is at `tip` and looks along `way` (of length 1).
void chevron(TextPainter& paint, const sim::Vec2& tip, const sim::Vec2& offset, double size,
             double width, const Colour& colour);
/// Shaft and head.
void arrow(TextPainter& paint, const sim::Vec2& from, const sim::Vec2& to, double size,
           double width, const Colour& colour);

}  // namespace placode::view::shapes
