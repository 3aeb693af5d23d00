// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/post_process.h"

#include <algorithm>
#include <cmath>

#include "ui/view/lens.h"

namespace placode::view {

using namespace sim;
namespace {

constexpr double kIrisS = 0.35;        // time constant of the automatic exposure
constexpr float kMeanTarget = 0.125F;  // by eye: lit skin lands near 0.5 linear
constexpr std::array<float, 3> kSurround{0.0045F, 0.0050F, 0.0058F};  // also in compose.glsl

bool lies_on(const Lens* lens) {
    return lens != nullptr && (!lens->drops().empty() || lens->fog() > 0 || lens->cloth() < 1.5);
}

float encoded(float linear) {
    return linear < 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

}  // namespace

Circle picture_circle(int width, int height) {
    return {0.5 * width, 0.5 * height, 0.49 * std::min(width, height)};
}

PostProcess::PostProcess()
    : bright_("screen_vertex", "bright"),
      meter_("screen_vertex", "meter"),
      blur_("screen_vertex", "blur") {
    for (GlTarget& e : exposure_) {
        e.allocate(1, 1, GL_RGBA16F, false);
        e.begin();
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
}

void PostProcess::run(const GlTexture& picture, int size, const PostSettings& settings) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    meter(picture, size, settings.dt_s);
    const float dim = static_cast<float>(settings.dim);
    glBindFramebuffer(GL_FRAMEBUFFER, settings.output);
    glClearColor(encoded(kSurround[0]) * dim, encoded(kSurround[1]) * dim,
                 encoded(kSurround[2]) * dim, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (settings.plain) {
        plain_.allocate(size, size, GL_RGBA8, false);
        PostSettings small = settings;
        small.width = small.height = size;
        small.circle = {0.5 * size, 0.5 * size, 0.5 * size};
        small.output = plain_.framebuffer();
        compose(picture, size, small);
        stretch(settings);
        return;
    }
    bloom(size).texture().bind(1);
    compose(picture, size, settings);
}

void PostProcess::meter(const GlTexture& picture, int size, double dt_s) {
    const int small = std::max(16, size / 4);
    quarter_.allocate(small, small, GL_RGBA16F, false);
    quarter_.begin();
    picture.bind(0);
    exposure_[static_cast<size_t>(current_)].texture().bind(1);
    bright_.use();
    bright_.set("picture", 0);
    bright_.set("exposure_map", 1);
    bright_.set("texel", 2.0F / static_cast<float>(size), 2.0F / static_cast<float>(size));
    draw_screen_triangle();

    const int next = 1 - current_;
    exposure_[static_cast<size_t>(next)].begin();
    quarter_.texture().bind(0);
    exposure_[static_cast<size_t>(current_)].texture().bind(1);
    meter_.use();
    meter_.set("bright", 0);
    meter_.set("previous", 1);
    meter_.set("adapt", first_ ? 1.0F : static_cast<float>(1 - std::exp(-dt_s / kIrisS)));
    meter_.set("target", kMeanTarget);
    draw_screen_triangle();
    current_ = next;
    first_ = false;
}

const GlTarget& PostProcess::bloom(int size) {
    const int small = std::max(16, size / 4);
    ping_.allocate(small, small, GL_RGBA16F, false);
    pong_.allocate(small, small, GL_RGBA16F, false);
    blur_.use();
    blur_.set("picture", 0);
    const GlTarget* from = &quarter_;
    for (int pass = 0; pass < 4; ++pass) {
        const GlTarget& to = pass % 2 == 0 ? ping_ : pong_;
        to.begin();
        from->texture().bind(0);
        const float step = (pass < 2 ? 1.0F : 2.4F) / static_cast<float>(small);
        blur_.set("direction", pass % 2 == 0 ? step : 0.0F, pass % 2 == 0 ? 0.0F : step);
        draw_screen_triangle();
        from = &to;
    }
    return *from;
}

void PostProcess::compose(const GlTexture& picture, int size, const PostSettings& settings) {
    const bool wet = !settings.plain && lies_on(settings.lens);
    const std::string options = settings.plain ? "PLAIN" : wet ? "WET" : "";
    const Circle& c = settings.circle;
    const auto scissor = [&](const PictureBox& box) {
        const auto at = [&](double middle, double share) { return middle + share * c.radius; };
        const int x = static_cast<int>(std::floor(at(c.x, box.low.x()))),
                  y = static_cast<int>(std::floor(at(c.y, box.low.y())));
        glScissor(x, y, static_cast<int>(std::ceil(at(c.x, box.high.x()))) - x + 1,
                  static_cast<int>(std::ceil(at(c.y, box.high.y()))) - y + 1);
    };
    glEnable(GL_SCISSOR_TEST);
    // Nothing but the surround lies beyond the circle.
    scissor({Vec2(-1, -1), Vec2(1, 1)});
    compose_with(options + (settings.smooth ? " SMOOTH" : ""), picture, size, settings);
    // Fog and droplets blur more than steps show, and cost too much to be computed twice.
    for (const PictureBox& box : wet ? std::vector<PictureBox>() : settings.edges) {
        scissor(box);
        compose_with(options + " SMOOTH", picture, size, settings);
    }
    glDisable(GL_SCISSOR_TEST);
}

void PostProcess::compose_with(const std::string& options, const GlTexture& picture, int size,
                               const PostSettings& settings) {
    glBindFramebuffer(GL_FRAMEBUFFER, settings.output);
    glViewport(0, 0, settings.width, settings.height);
    picture.bind(0);
    exposure_[static_cast<size_t>(current_)].texture().bind(2);
    GlProgram& program =
        compose_.try_emplace(options, "screen_vertex", "compose", options).first->second;
    program.use();
    program.set("picture", 0);
    program.set("bloom", 1);
    program.set("texel", 1.0F / static_cast<float>(size), 1.0F / static_cast<float>(size));
    program.set("exposure_map", 2);
    program.set("window_px", static_cast<float>(settings.width),
                static_cast<float>(settings.height));
    program.set("circle_centre", static_cast<float>(settings.circle.x),
                static_cast<float>(settings.circle.y));
    program.set("circle_radius", static_cast<float>(settings.circle.radius));
    program.set("haze", static_cast<float>(settings.haze));
    program.set("noise_seed", static_cast<float>(settings.noise_seed % 997U) * 0.37F);
    program.set("dim", static_cast<float>(settings.dim));
    set_lens(program, settings.lens);
    draw_screen_triangle();
}

void PostProcess::stretch(const PostSettings& settings) const {
    const Circle& c = settings.circle;
    const auto px = [](double at) { return static_cast<GLint>(std::lround(at)); };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, settings.output);
    glBlitFramebuffer(0, 0, plain_.width(), plain_.height(), px(c.x - c.radius), px(c.y - c.radius),
                      px(c.x + c.radius), px(c.y + c.radius), GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, settings.output);
    glViewport(0, 0, settings.width, settings.height);
}

void PostProcess::set_lens(GlProgram& program, const Lens* lens) {
    std::array<float, 4 * kMostDrops> drops{};
    int count = 0;
    if (lens != nullptr) {
        for (const LensDrop& drop : lens->drops()) {
            if (count == kMostDrops) break;
            const auto i = static_cast<size_t>(4 * count++);
            drops[i] = static_cast<float>(drop.at.x());
            drops[i + 1] = static_cast<float>(drop.at.y());
            drops[i + 2] = static_cast<float>(drop.radius);
            drops[i + 3] = static_cast<float>(drop.strength);
        }
    }
    program.set_array("drops", drops.data(), kMostDrops);
    program.set("drop_count", count);
    program.set("lens_fog", lens != nullptr ? static_cast<float>(lens->fog()) : 0.0F);
    program.set("cloth", lens != nullptr ? static_cast<float>(lens->cloth()) : 2.0F);
}

}  // namespace placode::view
