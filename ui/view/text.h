// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letters: DejaVu Sans rasterised by stb_truetype into one texture, and the boxes and rings of the
// overlay, collected as quads and drawn in one call.

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ui/view/gl_program.h"

namespace placode::view {

struct Colour {
    float r = 1, g = 1, b = 1, a = 1;  ///< sRGB-encoded, as on the screen.
    [[nodiscard]] Colour faded(float share) const { return {r, g, b, a * share}; }
};

enum class TextSize { kSmall, kNormal, kLarge };
enum class Align { kLeft, kCentre, kRight };

/// One code point of UTF-8 text; moves `at` on. Damaged bytes become U+FFFD.
[[nodiscard]] uint32_t next_code_point(std::string_view text, size_t& at);

class TextPainter {
 public:
    /// Throws ViewError when the font is missing.
    TextPainter();

    /// Starts a new overlay; `unit` is the height of normal text [px].
    void begin(int width, int height, double unit);
    void text(double x, double y, std::string_view text, TextSize size, const Colour& colour,
              Align align = Align::kLeft);  ///< y = baseline [px], down.
    [[nodiscard]] double text_width(std::string_view text, TextSize size) const;
    [[nodiscard]] double line_height(TextSize size) const;
    /// Lines no wider than `width` [px].
    [[nodiscard]] std::vector<std::string> wrapped(std::string_view text, TextSize size,
                                                   double width) const;
    void box(double x, double y, double width, double height, const Colour& colour);
    void ring(double x, double y, double radius, double inner_share, const Colour& colour);
    /// Four corners in order [px].
    void quad(const std::array<sim::Vec2, 4>& corners, const Colour& colour);
    void draw();

 private:
    struct Glyph {
        float u0, v0, u1, v1, x0, y0, x1, y1, advance;
    };
    void rasterise(double unit);
    [[nodiscard]] const Glyph* glyph(uint32_t code, TextSize size) const;
    void corner(double x, double y, double u, double v, const Colour& colour, float kind,
                float parameter);

    GlProgram program_;
    GlTexture letters_;
    GlMesh mesh_;
    std::string regular_, bold_;  // font files
    std::array<std::map<uint32_t, Glyph>, 3> glyphs_;
    double unit_ = 0;
    int width_ = 1, height_ = 1;
    std::vector<float> vertices_;
};

}  // namespace placode::view
