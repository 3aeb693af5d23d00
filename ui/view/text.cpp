// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace placode::view {

using namespace sim;
namespace {

constexpr int kAtlas = 1024;
constexpr double kScale[3] = {0.82, 1.0, 1.75};

std::string read_font(const char* file) {
    const char* folder = std::getenv("PLACODE_FONTS");
    const std::string path =
        std::string(folder != nullptr ? folder : "/usr/share/fonts/truetype/dejavu") + "/" + file;
    std::ifstream in(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (bytes.empty()) {
        throw ViewError("font " + path + " is missing; install the package fonts-dejavu-core");
    }
    return bytes;
}

// Latin with Polish, dashes, quotes, arrows.
std::vector<int> code_points() {
    std::vector<int> codes;
    for (int c = 32; c < 127; ++c) codes.push_back(c);
    for (int c = 160; c < 384; ++c) codes.push_back(c);
    for (const int c : {0x2013, 0x2014, 0x2018, 0x2019, 0x201C, 0x201D, 0x201E, 0x2022, 0x2026,
                        0x2190, 0x2191, 0x2192, 0x2193, 0x2212, 0x2265, 0xFFFD}) {
        codes.push_back(c);
    }
    return codes;
}

}  // namespace

uint32_t next_code_point(std::string_view text, size_t& at) {
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
    const uint8_t first = byte(at++);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : -1;
    if (more < 0 || at + static_cast<size_t>(more) > text.size()) return 0xFFFD;
    uint32_t code = first & (0x3FU >> more);
    for (int i = 0; i < more; ++i) {
        if ((byte(at) & 0xC0U) != 0x80U) return 0xFFFD;
        code = (code << 6U) | (byte(at++) & 0x3FU);
    }
    return code;
}

TextPainter::TextPainter()
    : program_("overlay_vertex", "overlay"),
      regular_(read_font("DejaVuSans.ttf")),
      bold_(read_font("DejaVuSans-Bold.ttf")) {
    mesh_.create({4, 4, 2});
}

void TextPainter::rasterise(double unit) {
    unit_ = unit;
    std::vector<unsigned char> pixels(size_t{kAtlas} * kAtlas, 0);
    stbtt_pack_context pack;
    if (stbtt_PackBegin(&pack, pixels.data(), kAtlas, kAtlas, 0, 1, nullptr) == 0) {
        throw ViewError("not enough memory for the letters");
    }
    std::vector<int> codes = code_points();
    for (size_t s = 0; s < 3; ++s) {
        const auto* font =
            reinterpret_cast<const unsigned char*>((s == 2 ? bold_ : regular_).data());
        std::vector<stbtt_packedchar> packed(codes.size());
        stbtt_pack_range range{};
        range.font_size = static_cast<float>(unit * kScale[s]);
        range.array_of_unicode_codepoints = codes.data();
        range.num_chars = static_cast<int>(codes.size());
        range.chardata_for_range = packed.data();
        stbtt_PackFontRanges(&pack, font, 0, &range, 1);
        glyphs_[s].clear();
        for (size_t i = 0; i < codes.size(); ++i) {
            const stbtt_packedchar& c = packed[i];
            glyphs_[s][static_cast<uint32_t>(codes[i])] = {static_cast<float>(c.x0) / kAtlas,
                                                           static_cast<float>(c.y0) / kAtlas,
                                                           static_cast<float>(c.x1) / kAtlas,
                                                           static_cast<float>(c.y1) / kAtlas,
                                                           c.xoff,
                                                           c.yoff,
                                                           c.xoff2,
                                                           c.yoff2,
                                                           c.xadvance};
        }
    }
    stbtt_PackEnd(&pack);
    letters_.load(kAtlas, kAtlas, {GL_R8, GL_RED, GL_UNSIGNED_BYTE}, pixels.data());
}

void TextPainter::begin(int width, int height, double unit) {
    width_ = width;
    height_ = height;
    // The atlas holds up to about 26 px; larger windows get larger quads of the same letters.
    const double wanted = std::clamp(std::round(unit), 9.0, 26.0);
    if (wanted != unit_) rasterise(wanted);
    vertices_.clear();
}

const TextPainter::Glyph* TextPainter::glyph(uint32_t code, TextSize size) const {
    const auto& table = glyphs_[static_cast<size_t>(size)];
    auto found = table.find(code);
    if (found == table.end()) found = table.find(0xFFFD);
    return found == table.end() ? nullptr : &found->second;
}

double TextPainter::text_width(std::string_view text, TextSize size) const {
    double width = 0;
    for (size_t at = 0; at < text.size();) {
        const Glyph* g = glyph(next_code_point(text, at), size);
        if (g != nullptr) width += g->advance;
    }
    return width;
}

double TextPainter::line_height(TextSize size) const {
    return std::round(1.42 * unit_ * kScale[static_cast<size_t>(size)]);
}

std::vector<std::string> TextPainter::wrapped(std::string_view text, TextSize size,
                                              double width) const {
    std::vector<std::string> lines;
    std::string line;
    size_t at = 0;
    while (at < text.size()) {
        const size_t end = std::min(text.find(' ', at), text.size());
        const std::string word(text.substr(at, end - at));
        const std::string longer = line.empty() ? word : line + " " + word;
        if (!line.empty() && text_width(longer, size) > width) {
            lines.push_back(line);
            line = word;
        } else {
            line = longer;
        }
        at = end + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

void TextPainter::corner(double x, double y, double u, double v, const Colour& c, float kind,
                         float parameter) {
    const float row[10] = {static_cast<float>(x),
                           static_cast<float>(y),
                           static_cast<float>(u),
                           static_cast<float>(v),
                           c.r,
                           c.g,
                           c.b,
                           c.a,
                           kind,
                           parameter};
    vertices_.insert(vertices_.end(), std::begin(row), std::end(row));
}

void TextPainter::text(double x, double y, std::string_view text, TextSize size,
                       const Colour& colour, Align align) {
    const double width = align == Align::kLeft ? 0 : text_width(text, size);
    double pen = std::round(x - (align == Align::kCentre ? 0.5 * width : width));
    y = std::round(y);
    for (size_t at = 0; at < text.size();) {
        const Glyph* g = glyph(next_code_point(text, at), size);
        if (g == nullptr) continue;
        const double x0 = std::round(pen + g->x0), y0 = y + g->y0;
        const double x1 = x0 + g->x1 - g->x0, y1 = y + g->y1;
        for (const int k : {0, 1, 2, 0, 2, 3}) {
            const bool right = k == 1 || k == 2, low = k >= 2;
            corner(right ? x1 : x0, low ? y1 : y0, right ? g->u1 : g->u0, low ? g->v1 : g->v0,
                   colour, 0, 0);
        }
        pen += g->advance;
    }
}

void TextPainter::box(double x, double y, double width, double height, const Colour& colour) {
    quad({Vec2(x, y), Vec2(x + width, y), Vec2(x + width, y + height), Vec2(x, y + height)},
         colour);
}

void TextPainter::quad(const std::array<Vec2, 4>& c, const Colour& colour) {
    for (const size_t k : {0, 1, 2, 0, 2, 3}) corner(c[k].x(), c[k].y(), 0, 0, colour, 1, 0);
}

void TextPainter::ring(double x, double y, double radius, double inner_share,
                       const Colour& colour) {
    for (const int k : {0, 1, 2, 0, 2, 3}) {
        const double u = k == 1 || k == 2 ? 1 : -1, v = k >= 2 ? 1 : -1;
        corner(x + u * radius, y + v * radius, u, v, colour, 2, static_cast<float>(inner_share));
    }
}

void TextPainter::draw() {
    if (vertices_.empty()) return;
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    letters_.bind(0);
    program_.set("letters", 0);
    program_.set("window_px", static_cast<float>(width_), static_cast<float>(height_));
    mesh_.vertices(vertices_.data(), vertices_.size(), true);
    mesh_.draw(GL_TRIANGLES, static_cast<int>(vertices_.size() / 10));
    glDisable(GL_BLEND);
}

}  // namespace placode::view
