// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where OpenGL draws: a window, or nowhere (off-screen, needs no display). Main thread only.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ui/view/window_event.h"

namespace placode::view {

struct ContextSettings {
    int width = 1280, height = 800;  ///< [px]
    bool fullscreen = false;
    std::string title = "Placode";
    std::optional<std::pair<int, int>> place;  ///< Upper left corner on the desktop [px].
    bool floating = false;                     ///< Above other windows.
};

class GlContext {
 public:
    virtual ~GlContext() = default;
    [[nodiscard]] virtual int width() const = 0;   ///< Of the framebuffer [px].
    [[nodiscard]] virtual int height() const = 0;  ///< Of the framebuffer [px].
    /// Of the window, as the desktop measures it; of the framebuffer where there is no window.
    [[nodiscard]] virtual std::pair<int, int> window_size() const { return {width(), height()}; }
    /// Several pictures off-screen: what is drawn next, on this thread, goes into this one. Throws
    /// ViewError, e.g. while another thread holds it.
    virtual void make_current() {}
    /// Another thread may take it.
    virtual void let_go() noexcept {}
    virtual void swap() {}
    /// Handles events and brings `input` up to date; its totals only grow.
    virtual void poll(sim::WindowInput&) {}
    /// Hides and holds the pointer, so that motion has no end (off while a menu is open).
    virtual void capture_pointer(bool) {}
    /// Pointer in framebuffer pixels, y down.
    virtual void pointer(double& x, double& y) const { x = y = -1; }
    [[nodiscard]] virtual bool close_requested() const { return false; }
    /// What happened since the last call, in order; a window that is to close stays open.
    [[nodiscard]] virtual WindowEvents events() { return {}; }
};

/// GLFW window with an OpenGL 3.3 core context, current on this thread. Throws ViewError.
[[nodiscard]] std::unique_ptr<GlContext> open_window(const ContextSettings& settings);
/// EGL without a surface: works with no display at all. Where EGL offers no surfaceless display,
/// as with some drivers of graphics cards, the first card that draws. Throws ViewError.
[[nodiscard]] std::unique_ptr<GlContext> open_offscreen(const ContextSettings& settings);

}  // namespace placode::view
