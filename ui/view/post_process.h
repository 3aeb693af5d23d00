// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What lens, camera and monitor do to the linear picture: metering, bloom, distortion, film curve.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ui/view/gl_program.h"
#include "ui/view/tool_boxes.h"

namespace placode::view {

class Lens;

/// Where the round picture lies in the window [px].
struct Circle {
    double x = 0, y = 0, radius = 1;
};
/// Fills the height, in the middle.
[[nodiscard]] Circle picture_circle(int width, int height);

struct PostSettings {
    Circle circle;
    int width = 0, height = 0;  ///< Of the output [px].
    GLuint output = 0;          ///< Framebuffer.
    double dt_s = 0;            ///< Since the last picture, for the slow iris.
    double haze = 0, dim = 1;
    const Lens* lens = nullptr;  ///< Fog and droplets on it; null = clean.
    uint32_t noise_seed = 0;
    bool smooth = false;            ///< Steps at edges are softened everywhere,
    std::vector<PictureBox> edges;  ///< or here, while the lens is clean.
    bool plain = false;  ///< At the picture's size and stretched; no bloom, grain, coloured rim.
};

class PostProcess {
 public:
    PostProcess();
    void run(const GlTexture& picture, int size, const PostSettings& settings);

 private:
    void meter(const GlTexture& picture, int size, double dt_s);
    const GlTarget& bloom(int size);
    void compose(const GlTexture& picture, int size, const PostSettings& settings);
    void compose_with(const std::string& options, const GlTexture& picture, int size,
                      const PostSettings& settings);
    void stretch(const PostSettings& settings) const;
    static void set_lens(GlProgram& program, const Lens* lens);
    GlProgram bright_, meter_, blur_;
    std::map<std::string, GlProgram> compose_;  // by options; made when first needed
    GlTarget quarter_, ping_, pong_, plain_;
    std::array<GlTarget, 2> exposure_;
    int current_ = 0;
    bool first_ = true;
};

}  // namespace placode::view
