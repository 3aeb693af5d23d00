// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small owners of OpenGL objects: programs from embedded shaders, textures, render targets.

#include <epoxy/gl.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::view {

/// The view cannot work: no display, no OpenGL 3.3, no font. Says what is missing and what to do.
class ViewError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

using Mat4f = Eigen::Matrix4f;

/// Text of ui/view/shaders/NAME.glsl, embedded at build time; empty when there is none.
[[nodiscard]] std::string_view shader_text(std::string_view name);

/// A linked program. Main (GL) thread only, like everything here.
class GlProgram {
 public:
    /// Names of embedded shaders; `shared.glsl` is put before the fragment shader, and before that
    /// a line `#define OPTION` for each word of `options`. Throws ViewError with the driver's log.
    GlProgram(std::string_view vertex, std::string_view fragment, const std::string& options = {});
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    void use() const;
    void set(const char* name, float value);
    void set(const char* name, int value);
    void set(const char* name, float x, float y);
    void set(const char* name, const sim::Vec3& value);
    void set(const char* name, const Mat4f& value);
    /// Array of vec4 (n x 4 floats).
    void set_array(const char* name, const float* values, int count);

 private:
    [[nodiscard]] GLint location(const char* name);
    GLuint program_ = 0;
    std::map<std::string, GLint, std::less<>> locations_;
};

/// A 2-D texture.
class GlTexture {
 public:
    GlTexture() = default;
    ~GlTexture();
    GlTexture(GlTexture&& other) noexcept;
    GlTexture& operator=(GlTexture&& other) noexcept;

    struct Format {
        GLenum internal = GL_RGBA8, format = GL_RGBA, type = GL_UNSIGNED_BYTE;
        bool mipmap = false, repeat = false;
    };
    /// (Re)allocates and fills; `pixels` may be null.
    void load(int width, int height, const Format& format, const void* pixels);
    /// Writes a part of what load() allocated, as bytes; `pixels` and `width` are of the whole.
    struct Part {
        int x = 0, y = 0, width = 0, height = 0;
    };
    void replace(const Part& part, int width, const uint8_t* pixels) const;
    void bind(int unit) const;
    [[nodiscard]] GLuint id() const { return id_; }

 private:
    GLuint id_ = 0;
};

/// Colour texture, with depth (renderbuffer) when asked; multisampled targets are resolved.
class GlTarget {
 public:
    GlTarget() = default;
    ~GlTarget();
    GlTarget(const GlTarget&) = delete;
    GlTarget& operator=(const GlTarget&) = delete;

    /// Reallocates only when something changed. Throws ViewError when the driver refuses.
    void allocate(int width, int height, GLenum format, bool depth, int samples = 0);
    void begin() const;    ///< Binds and sets the viewport.
    void resolve() const;  ///< Multisample to texture; nothing otherwise.
    [[nodiscard]] const GlTexture& texture() const { return texture_; }
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_; }  ///< Of the texture.
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

 private:
    void release();
    GlTexture texture_;
    GLuint framebuffer_ = 0, multisample_ = 0, colour_buffer_ = 0, depth_buffer_ = 0;
    int width_ = 0, height_ = 0, samples_ = 0;
    GLenum format_ = 0;
};

/// Vertex array with one interleaved float buffer and an optional index buffer.
class GlMesh {
 public:
    GlMesh() = default;
    ~GlMesh();
    GlMesh(const GlMesh&) = delete;
    GlMesh& operator=(const GlMesh&) = delete;

    /// `sizes`: components of attributes 0, 1, ... in one vertex.
    void create(const std::vector<int>& sizes);
    void vertices(const float* data, size_t floats, bool dynamic);
    void indices(const std::vector<unsigned>& data);
    /// Draws the indices, or `count` vertices when there are none.
    void draw(GLenum mode, int count = 0) const;

 private:
    GLuint array_ = 0, vertex_buffer_ = 0, index_buffer_ = 0;
    int index_count_ = 0;
    size_t vertex_capacity_ = 0;
};

/// Draws one triangle that covers the viewport (needs the `screen` vertex shader).
void draw_screen_triangle();

}  // namespace placode::view
