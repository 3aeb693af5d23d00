// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The operation as the fetoscope shows it: draws a Snapshot into a window, or off-screen for
// screenshots. Main thread only; owns the OpenGL context.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/view/gl_context.h"
#include "ui/view/lens.h"
#include "ui/view/overlay.h"
#include "ui/view/picture_quality.h"
#include "ui/view/view_field.h"

namespace placode::view {

struct ViewSettings {
    int width = 1280, height = 800;  ///< [px]
    bool offscreen = false;          ///< No display needed, no window shown.
    bool fullscreen = false;
    bool adaptive = true;  ///< Follow the frame time; off for reproducible pictures.
    Quality quality;       ///< To start with.
    std::string title = "Placode";
    std::string greeting;  ///< Stands in the window until the first picture; "" = nothing.
    std::optional<std::pair<int, int>> place;  ///< Upper left corner on the desktop [px].
    bool floating = false;                     ///< Above other windows, also those in use.
};

class FetoscopeView {
 public:
    /// Throws ViewError: no display, no OpenGL 3.3, no font; says what to do.
    FetoscopeView(const ViewField& field, const ViewSettings& settings);
    ~FetoscopeView();

    /// Draws one picture and shows it. False when there was none to draw: the window is minimised,
    /// or nothing is in the snapshot yet.
    bool draw(const sim::Snapshot& snapshot, const OverlayState& overlay);
    /// Lets smoke and haze go on between pictures, without drawing.
    void observe(const sim::Snapshot& snapshot);
    /// Wipes the lens; takes a second of simulated time.
    void wipe_lens();
    /// What is on the lens.
    [[nodiscard]] const Lens& lens() const;
    /// True when the processor draws: leave some of it to the physics.
    [[nodiscard]] bool software() const;
    /// What OpenGL calls what draws.
    [[nodiscard]] const std::string& renderer() const;
    /// One step simpler (ui/view/picture_quality.h), and it stays so until enrich(). False when it
    /// is as simple as it gets.
    bool simplify();
    /// One step back towards what it began with. False when it is there.
    bool enrich();
    /// Window, mouse, keyboard, gamepad. Off-screen: nothing happens.
    void poll(sim::WindowInput& input);
    [[nodiscard]] bool close_requested() const;
    /// What happened at the window since the last call, in order; it then stays open when somebody
    /// wanted to close it. Off-screen: nothing.
    [[nodiscard]] WindowEvents events();
    /// Pointer in the picture [px], y down; (-1, -1) off-screen.
    [[nodiscard]] std::pair<double, double> pointer() const;
    void capture_pointer(bool capture);
    /// Place of the tuning panel under the pointer, -1 = none (ui/view/tuning_view.h).
    [[nodiscard]] int tuning_item_under_pointer() const;
    /// Menu item under the pointer, -1 = none.
    [[nodiscard]] int menu_item_under_pointer() const;

    /// Off-screen: the next picture may be drawn by another thread.
    void let_go() noexcept;
    /// The last picture, rows from the top (height x width x 3).
    [[nodiscard]] std::vector<uint8_t> pixels();
    /// Writes the last picture as PNG. Throws ViewError when the file cannot be written.
    void save_png(const std::string& path);
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// Of the window, as the desktop measures it.
    [[nodiscard]] std::pair<int, int> window_size() const;
    /// First OpenGL error since the last call, 0 = none.
    [[nodiscard]] unsigned gl_error();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::view
