// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far the light beside the lens reaches, as depths seen from it: flaps and walls of a wound
// throw shadows on tissue. Instruments do so by themselves (shaders/shared.glsl). Source: Williams
// 1978, "Casting curved shadows on curved surfaces".

#include "ui/view/camera.h"
#include "ui/view/gl_program.h"

namespace placode::view {

class ShadowMap {
 public:
    ShadowMap() = default;
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    /// What is drawn until end() throws shadows. `light` sees at least what the camera sees.
    void begin(const Camera& light);
    void end() const;
    void bind(int unit) const;
    [[nodiscard]] const Mat4f& projection() const { return projection_; }

 private:
    void create();
    GlProgram program_{"depth_vertex", "depth"};
    GLuint texture_ = 0, framebuffer_ = 0;
    Mat4f projection_ = Mat4f::Identity();
};

}  // namespace placode::view
