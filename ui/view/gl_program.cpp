// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/gl_program.h"

#include <cstddef>
#include <sstream>
#include <utility>

namespace placode::view {

using namespace sim;
namespace {

GLuint compile(GLenum kind, std::string_view name, const std::string& options = {}) {
    const std::string_view body = shader_text(name);
    if (body.empty()) throw ViewError("no embedded shader \"" + std::string(name) + "\"");
    std::string source = "#version 330 core\n";
    std::istringstream words(options);
    for (std::string option; words >> option;) source += "#define " + option + '\n';
    if (kind == GL_FRAGMENT_SHADER) source += shader_text("shared");
    source += body;
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == GL_FALSE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<size_t>(length));
        glDeleteShader(shader);
        throw ViewError("the graphics driver refuses shader \"" + std::string(name) + "\": " + log);
    }
    return shader;
}

}  // namespace

GlProgram::GlProgram(std::string_view vertex, std::string_view fragment,
                     const std::string& options) {
    const GLuint v = compile(GL_VERTEX_SHADER, vertex);
    const GLuint f = compile(GL_FRAGMENT_SHADER, fragment, options);
    program_ = glCreateProgram();
    glAttachShader(program_, v);
    glAttachShader(program_, f);
    glLinkProgram(program_);
    glDeleteShader(v);
    glDeleteShader(f);
    GLint ok = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &ok);
    if (ok == GL_FALSE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<size_t>(length));
        throw ViewError("the graphics driver cannot link \"" + std::string(fragment) +
                        "\": " + log);
    }
}

GlProgram::~GlProgram() {
    if (program_ != 0) glDeleteProgram(program_);
}

void GlProgram::use() const { glUseProgram(program_); }

GLint GlProgram::location(const char* name) {
    const auto found = locations_.find(name);
    if (found != locations_.end()) return found->second;
    const GLint place = glGetUniformLocation(program_, name);
    locations_.emplace(name, place);
    return place;
}

void GlProgram::set(const char* name, float value) { glUniform1f(location(name), value); }
void GlProgram::set(const char* name, int value) { glUniform1i(location(name), value); }
void GlProgram::set(const char* name, float x, float y) { glUniform2f(location(name), x, y); }
void GlProgram::set(const char* name, const Vec3& value) {
    glUniform3f(location(name), static_cast<float>(value.x()), static_cast<float>(value.y()),
                static_cast<float>(value.z()));
}
void GlProgram::set(const char* name, const Mat4f& value) {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}
void GlProgram::set_array(const char* name, const float* values, int count) {
    glUniform4fv(location(name), count, values);
}

GlTexture::~GlTexture() {
    if (id_ != 0) glDeleteTextures(1, &id_);
}
GlTexture::GlTexture(GlTexture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
GlTexture& GlTexture::operator=(GlTexture&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

void GlTexture::load(int width, int height, const Format& format, const void* pixels) {
    if (id_ == 0) glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), width, height, 0,
                 format.format, format.type, pixels);
    const GLint wrap = format.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    format.mipmap ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    if (format.mipmap) glGenerateMipmap(GL_TEXTURE_2D);
}

void GlTexture::replace(const Part& part, int width, const uint8_t* pixels) const {
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, width);
    glTexSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, part.width, part.height, GL_RGBA,
                    GL_UNSIGNED_BYTE,
                    pixels + 4 * (static_cast<ptrdiff_t>(part.y) * width + part.x));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GlTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, id_);
}

GlTarget::~GlTarget() { release(); }

void GlTarget::release() {
    if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
    if (multisample_ != 0) glDeleteFramebuffers(1, &multisample_);
    if (colour_buffer_ != 0) glDeleteRenderbuffers(1, &colour_buffer_);
    if (depth_buffer_ != 0) glDeleteRenderbuffers(1, &depth_buffer_);
    framebuffer_ = multisample_ = colour_buffer_ = depth_buffer_ = 0;
}

void GlTarget::allocate(int width, int height, GLenum format, bool depth, int samples) {
    if (width == width_ && height == height_ && format == format_ && samples == samples_) return;
    release();
    width_ = width;
    height_ = height;
    format_ = format;
    samples_ = samples;
    const bool bytes = format == GL_RGBA8;
    texture_.load(width, height,
                  {format, GL_RGBA, bytes ? GLenum(GL_UNSIGNED_BYTE) : GLenum(GL_FLOAT)}, nullptr);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
    if (samples > 0) {
        glGenFramebuffers(1, &multisample_);
        glBindFramebuffer(GL_FRAMEBUFFER, multisample_);
        glGenRenderbuffers(1, &colour_buffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, colour_buffer_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  colour_buffer_);
    }
    if (depth) {
        glGenRenderbuffers(1, &depth_buffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, depth_buffer_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width,
                                         height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  depth_buffer_);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw ViewError("the graphics driver offers no render target of " + std::to_string(width) +
                        "x" + std::to_string(height) + "; try a smaller --size");
    }
}

void GlTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, multisample_ != 0 ? multisample_ : framebuffer_);
    glViewport(0, 0, width_, height_);
}

void GlTarget::resolve() const {
    if (multisample_ == 0) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisample_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

GlMesh::~GlMesh() {
    if (array_ != 0) glDeleteVertexArrays(1, &array_);
    if (vertex_buffer_ != 0) glDeleteBuffers(1, &vertex_buffer_);
    if (index_buffer_ != 0) glDeleteBuffers(1, &index_buffer_);
}

void GlMesh::create(const std::vector<int>& sizes) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glGenBuffers(1, &vertex_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    int total = 0;
    for (const int size : sizes) total += size;
    int offset = 0;
    for (size_t i = 0; i < sizes.size(); ++i) {
        glEnableVertexAttribArray(static_cast<GLuint>(i));
        glVertexAttribPointer(
            static_cast<GLuint>(i), sizes[i], GL_FLOAT, GL_FALSE,
            total * static_cast<int>(sizeof(float)),
            reinterpret_cast<const void*>(sizeof(float) * static_cast<size_t>(offset)));
        offset += sizes[i];
    }
}

void GlMesh::vertices(const float* data, size_t floats, bool dynamic) {
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    const auto bytes = static_cast<GLsizeiptr>(floats * sizeof(float));
    if (floats > vertex_capacity_) {
        glBufferData(GL_ARRAY_BUFFER, bytes, data, dynamic ? GL_STREAM_DRAW : GL_STATIC_DRAW);
        vertex_capacity_ = floats;
    } else {
        glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, data);
    }
}

void GlMesh::indices(const std::vector<unsigned>& data) {
    glBindVertexArray(array_);
    if (index_buffer_ == 0) glGenBuffers(1, &index_buffer_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(unsigned)),
                 data.data(), GL_DYNAMIC_DRAW);
    index_count_ = static_cast<int>(data.size());
}

void GlMesh::draw(GLenum mode, int count) const {
    glBindVertexArray(array_);
    if (index_count_ > 0) {
        glDrawElements(mode, index_count_, GL_UNSIGNED_INT, nullptr);
    } else if (count > 0) {
        glDrawArrays(mode, 0, count);
    }
}

void draw_screen_triangle() {
    // A vertex array must be bound in a core profile even when nothing is read from it.
    GLuint empty = 0;
    glGenVertexArrays(1, &empty);
    glBindVertexArray(empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &empty);
}

}  // namespace placode::view
