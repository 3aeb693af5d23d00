// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// EGL on Mesa's surfaceless platform, else on a graphics card by itself: no X, no Wayland, no
// window.

#include <epoxy/egl.h>

#include <algorithm>
#include <array>

#include "ui/view/gl_context.h"
#include "ui/view/gl_program.h"

namespace placode::view {

using namespace sim;
namespace {

class OffscreenContext final : public GlContext {
 public:
    explicit OffscreenContext(const ContextSettings& settings)
        : width_(settings.width), height_(settings.height) {
        if (!epoxy_has_egl()) fail("libEGL is not installed");
        // Asked for before it is called: epoxy ends the program for a function that is not there.
        if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
            fail("EGL finds no driver");
        if (!opened(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                             nullptr)) &&
            !open_card())
            fail("EGL offers no surfaceless display and no graphics card");
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("EGL offers no desktop OpenGL");
        const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0) {
            const EGLint any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                  EGL_NONE};
            if (eglChooseConfig(display_, any, &config, 1, &count) == EGL_FALSE || count == 0) {
                fail("EGL offers no configuration for OpenGL");
            }
        }
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        if (context_ == EGL_NO_CONTEXT) fail("OpenGL 3.3 is not available");
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            fail("the OpenGL context cannot be made current");
        }
    }
    ~OffscreenContext() override { release(); }
    [[nodiscard]] int width() const override { return width_; }
    [[nodiscard]] int height() const override { return height_; }
    void make_current() override {
        // Which kind of OpenGL is meant is a matter of each thread.
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
            throw ViewError("the picture cannot be drawn on this thread: another one holds it");
    }
    void let_go() noexcept override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

 private:
    bool opened(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
            return false;
        display_ = display;
        return true;
    }
    /// The first card whose driver answers.
    bool open_card() {
        if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
            !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
            return false;
        std::array<EGLDeviceEXT, 16> cards{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(cards.size()), cards.data(), &count) ==
            EGL_FALSE)
            return false;
        return std::any_of(cards.begin(), cards.begin() + count, [&](EGLDeviceEXT card) {
            return opened(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, card, nullptr));
        });
    }
    void release() {
        if (display_ == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        // The display stays: a process has one, and other pictures may be drawn with it.
        display_ = EGL_NO_DISPLAY;
    }
    [[noreturn]] void fail(const std::string& what) {
        release();
        throw ViewError("cannot draw off-screen: " + what +
                        "; install libegl1 and libgl1-mesa-dri, or go on without pictures");
    }
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    int width_, height_;
};

}  // namespace

std::unique_ptr<GlContext> open_offscreen(const ContextSettings& settings) {
    return std::make_unique<OffscreenContext>(settings);
}

}  // namespace placode::view
