// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/post_process.h"

#include <algorithm>
#include <cmath>

#include "sim/view/lens.h"

namespace placode::sim {
namespace {

constexpr double kIrisS = 0.35;        // time constant of the automatic exposure
constexpr float kMeanTarget = 0.125F;  // by eye: lit skin lands near 0.5 linear

}  // namespace

Circle picture_circle(int width, int height) {
    return {0.5 * width, 0.5 * height, 0.49 * std::min(width, height)};
}

PostProcess::PostProcess()
    : bright_("screen_vertex", "bright"),
      meter_("screen_vertex", "meter"),
      blur_("screen_vertex", "blur"),
      compose_("screen_vertex", "compose") {
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
    const int small = std::max(16, size / 4);
    quarter_.allocate(small, small, GL_RGBA16F, false);
    ping_.allocate(small, small, GL_RGBA16F, false);
    pong_.allocate(small, small, GL_RGBA16F, false);

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
    meter_.set("adapt", first_ ? 1.0F : static_cast<float>(1 - std::exp(-settings.dt_s / kIrisS)));
    meter_.set("target", kMeanTarget);
    draw_screen_triangle();
    current_ = next;
    first_ = false;

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

    glBindFramebuffer(GL_FRAMEBUFFER, settings.output);
    glViewport(0, 0, settings.width, settings.height);
    picture.bind(0);
    from->texture().bind(1);
    exposure_[static_cast<size_t>(current_)].texture().bind(2);
    compose_.use();
    compose_.set("picture", 0);
    compose_.set("bloom", 1);
    compose_.set("exposure_map", 2);
    compose_.set("window_px", static_cast<float>(settings.width),
                 static_cast<float>(settings.height));
    compose_.set("circle_centre", static_cast<float>(settings.circle.x),
                 static_cast<float>(settings.circle.y));
    compose_.set("circle_radius", static_cast<float>(settings.circle.radius));
    compose_.set("haze", static_cast<float>(settings.haze));
    compose_.set("noise_seed", static_cast<float>(settings.noise_seed % 997U) * 0.37F);
    compose_.set("dim", static_cast<float>(settings.dim));
    set_lens(settings.lens);
    draw_screen_triangle();
}

void PostProcess::set_lens(const Lens* lens) {
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
    compose_.set_array("drops", drops.data(), kMostDrops);
    compose_.set("drop_count", count);
    compose_.set("lens_fog", lens != nullptr ? static_cast<float>(lens->fog()) : 0.0F);
    compose_.set("cloth", lens != nullptr ? static_cast<float>(lens->cloth()) : 2.0F);
}

}  // namespace placode::sim
