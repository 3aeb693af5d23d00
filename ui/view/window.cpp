// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The window, and what mouse, keyboard and gamepad say. This file and window_keys.cpp know GLFW.

#include <epoxy/gl.h>
// epoxy stands before GLFW, which would otherwise bring its own gl.h.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "ui/view/gl_context.h"
#include "ui/view/gl_program.h"
#include "ui/view/held_keys.h"
#include "ui/view/window_keys.h"

namespace placode::view {

using namespace sim;
namespace {

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "unknown reason";
}

/// A window higher than the screen would hide the forces at its lower edge, and the way out.
void fit_to_screen(int& width, int& height) {
    GLFWmonitor* screen = glfwGetPrimaryMonitor();
    if (screen == nullptr) return;
    int x = 0, y = 0, widest = 0, highest = 0;
    glfwGetMonitorWorkarea(screen, &x, &y, &widest, &highest);
    if (widest <= 0 || highest <= 0) return;
    const double share =
        std::min({1.0, static_cast<double>(widest) / width, static_cast<double>(highest) / height});
    width = static_cast<int>(width * share);
    height = static_cast<int>(height * share);
}

/// In the middle: some desktops put a large window where a part of it hangs over the edge.
void put_on_screen(GLFWwindow* window, int width, int height) {
    GLFWmonitor* screen = glfwGetPrimaryMonitor();
    if (screen == nullptr) return;
    int x = 0, y = 0, widest = 0, highest = 0;
    glfwGetMonitorWorkarea(screen, &x, &y, &widest, &highest);
    if (widest < width || highest < height) return;
    int left = 0, top = 0, right = 0, bottom = 0;
    glfwGetWindowFrameSize(window, &left, &top, &right, &bottom);
    glfwSetWindowPos(window, x + std::max(left, (widest - width) / 2),
                     y + std::max(top, (highest - height) / 2));
}

/// After the window was moved or sized no motion is the hand's for so long [s].
constexpr double kSettlesS = 0.15;
/// Nor in so many polls: the first pictures of a new size may take longer than that, and what
/// happened meanwhile is told after them.
constexpr int kSettlesPolls = 3;
/// As much motion in one report may be the pointer's that is pushed into a window which shrinks: it
/// waits until the window would have told. Careful work is a few counts a report.
constexpr double kQuickCounts = 40;
constexpr double kQuickWaitsS = 0.03;

class GlfwWindow final : public GlContext {
 public:
    explicit GlfwWindow(const ContextSettings& settings) {
        if (glfwInit() == GLFW_FALSE) {
            throw ViewError("no display to open a window on (" + last_error() +
                            "); start it from a desktop, under xvfb-run, or with --headless");
        }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_FLOATING, settings.floating ? GLFW_TRUE : GLFW_FALSE);
        GLFWmonitor* monitor = settings.fullscreen ? glfwGetPrimaryMonitor() : nullptr;
        int width = settings.width, height = settings.height;
        if (monitor != nullptr) {
            const GLFWvidmode* mode = glfwGetVideoMode(monitor);
            width = mode->width;
            height = mode->height;
        } else {
            fit_to_screen(width, height);
        }
        window_ = glfwCreateWindow(width, height, settings.title.c_str(), monitor, nullptr);
        if (window_ == nullptr) {
            const std::string reason = last_error();
            glfwTerminate();
            throw ViewError("OpenGL 3.3 is not available here (" + reason +
                            "); install the graphics driver or libgl1-mesa-dri, or use --headless");
        }
        // A desktop that places windows by itself (Wayland) refuses; nothing is lost then.
        if (settings.place && monitor == nullptr)
            glfwSetWindowPos(window_, settings.place->first, settings.place->second);
        else if (monitor == nullptr)
            put_on_screen(window_, width, height);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, this);
        // A click that begins and ends between two polls (a slow picture) still counts.
        glfwSetInputMode(window_, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            self(w).on_key(key, scancode, action);
            if (action == GLFW_PRESS && (mods & GLFW_MOD_CONTROL) != 0)
                self(w).on_letter(glfwGetKeyName(key, scancode));
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { self(w).on_char(code); });
        glfwSetScrollCallback(window_,
                              [](GLFWwindow* w, double, double y) { self(w).state_.wheel += y; });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
            self(w).on_button(button, action == GLFW_PRESS);
        });
        glfwSetWindowCloseCallback(
            window_, [](GLFWwindow* w) { self(w).happened({.kind = WindowEvent::Kind::kClose}); });
        glfwSetCursorPosCallback(
            window_, [](GLFWwindow* w, double x, double y) { self(w).on_motion(x, y); });
        // A window that is moved or sized moves under the pointer: no motion of a hand.
        glfwSetWindowPosCallback(window_, [](GLFWwindow* w, int, int) { self(w).on_place(); });
        glfwSetWindowSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w).on_place(); });
        glfwSetWindowFocusCallback(
            window_, [](GLFWwindow* w, int focused) { self(w).on_focus(focused == GLFW_TRUE); });
        glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int iconified) {
            if (iconified == GLFW_TRUE) self(w).happened({.kind = WindowEvent::Kind::kHidden});
        });
    }
    ~GlfwWindow() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }

    [[nodiscard]] int width() const override { return framebuffer().first; }
    [[nodiscard]] int height() const override { return framebuffer().second; }
    [[nodiscard]] std::pair<int, int> window_size() const override {
        int w = 0, h = 0;
        glfwGetWindowSize(window_, &w, &h);
        return {w, h};
    }
    void swap() override { glfwSwapBuffers(window_); }
    [[nodiscard]] bool close_requested() const override {
        return glfwWindowShouldClose(window_) == GLFW_TRUE;
    }

    void poll(WindowInput& input) override {
        glfwPollEvents();
        let_go_unseen();
        take_quick_motion();
        unsettled_polls_ = std::max(0, unsettled_polls_ - 1);
        const auto button = [&](int b) {
            return state_.focused && glfwGetMouseButton(window_, b) == GLFW_PRESS;
        };
        state_.left = button(GLFW_MOUSE_BUTTON_LEFT);
        state_.right = button(GLFW_MOUSE_BUTTON_RIGHT);
        state_.middle = button(GLFW_MOUSE_BUTTON_MIDDLE);
        poll_gamepad();
        state_.t_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                          std::chrono::steady_clock::now().time_since_epoch())
                          .count();
        input = state_;
    }

    [[nodiscard]] WindowEvents events() override {
        glfwSetWindowShouldClose(window_, GLFW_FALSE);
        return std::exchange(events_, {});
    }

    void capture_pointer(bool capture) override {
        if (capture == captured_) return;
        captured_ = capture;
        on_place();  // the pointer jumps when the mode changes
        glfwSetInputMode(window_, GLFW_CURSOR, capture ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        if (glfwRawMouseMotionSupported() == GLFW_TRUE) {
            glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, capture ? GLFW_TRUE : GLFW_FALSE);
        }
    }

    void pointer(double& x, double& y) const override {
        int w = 1, h = 1;
        glfwGetWindowSize(window_, &w, &h);
        glfwGetCursorPos(window_, &x, &y);
        x *= static_cast<double>(width()) / std::max(w, 1);
        y *= static_cast<double>(height()) / std::max(h, 1);
    }

 private:
    static GlfwWindow& self(GLFWwindow* window) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    }
    [[nodiscard]] std::pair<int, int> framebuffer() const {
        int w = 0, h = 0;
        glfwGetFramebufferSize(window_, &w, &h);
        return {w, h};
    }
    // A reader that never asks (a replay) must not make the list grow.
    void happened(const WindowEvent& event) {
        if (events_.size() < 1024) events_.push_back(event);
    }
    void on_button(int button, bool down) {
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        happened({.kind = WindowEvent::Kind::kButton,
                  .button = static_cast<uint8_t>(button),
                  .down = down});
    }
    void on_char(unsigned code) {
        if (code < 0x20 || code > 0xFFFF) return;
        happened({.kind = WindowEvent::Kind::kLetter, .letter = static_cast<char32_t>(code)});
    }
    // With Ctrl held (precision) a key types no letter, but L must wipe the lens all the same.
    void on_letter(const char* name) {
        if (name != nullptr && name[0] != '\0' && name[1] == '\0')
            on_char(static_cast<unsigned char>(name[0]));
    }
    void on_key(int key, int scancode, int action) {
        if (key == GLFW_KEY_BACKSPACE && action != GLFW_RELEASE) {
            happened({.kind = WindowEvent::Kind::kLetter, .letter = U'\b'});
        }
        const Key name = key_of(key);
        // GLFW takes a press for a repeat where it was not told of the release before.
        if ((action == GLFW_REPEAT && held_.has(key)) || name == Key::kCount) return;
        const bool down = action != GLFW_RELEASE;
        if (down)
            held_.pressed(key, scancode);
        else
            held_.released(key);
        const auto i = static_cast<size_t>(name);
        state_.down[i] = down;
        if (down) ++state_.presses[i];
        happened({.kind = WindowEvent::Kind::kKey,
                  .key = name,
                  .down = down,
                  .letter = down ? other_letter(glfwGetKeyName(key, scancode)) : char32_t{0}});
    }
    void let_go_unseen() {
        if (!held_.due(glfwGetTime())) return;
        const auto keyboard = keys_of_keyboard();
        if (!keyboard) return;
        for (const int code : held_.lost(*keyboard)) {
            const Key name = key_of(code);
            state_.down[static_cast<size_t>(name)] = false;
            happened({.kind = WindowEvent::Kind::kKey, .key = name, .unseen = true});
        }
    }
    // The pointer is kept inside a window that shrinks, in jumps that follow one another; the first
    // is often told before the new size is.
    void on_place() {
        has_last_ = false;
        placed_s_ = glfwGetTime();
        unsettled_polls_ = kSettlesPolls;
        quick_x_ = quick_y_ = 0;
    }
    void on_motion(double x, double y) {
        const double now = glfwGetTime();
        if (has_last_ && captured_ && unsettled_polls_ == 0 && now > placed_s_ + kSettlesS) {
            const double dx = x - last_x_, dy = y - last_y_;
            if (std::max(std::abs(dx), std::abs(dy)) < kQuickCounts) {
                state_.mouse_x += dx;
                state_.mouse_y += dy;
            } else {
                if (quick_x_ == 0 && quick_y_ == 0) quick_s_ = now;
                quick_x_ += dx;
                quick_y_ += dy;
            }
        }
        last_x_ = x;
        last_y_ = y;
        has_last_ = true;
    }
    /// What waited is the hand's: the window has not moved meanwhile.
    void take_quick_motion() {
        if ((quick_x_ == 0 && quick_y_ == 0) || glfwGetTime() < quick_s_ + kQuickWaitsS) return;
        state_.mouse_x += std::exchange(quick_x_, 0);
        state_.mouse_y += std::exchange(quick_y_, 0);
    }
    // A key that is let go while another window has the focus is never reported: pedals must stop.
    void on_focus(bool focused) {
        state_.focused = focused;
        if (!focused) {
            state_.down.reset();
            held_.clear();
        }
        happened({.kind = WindowEvent::Kind::kFocus, .down = focused});
        has_last_ = false;
    }
    void poll_gamepad() {
        GLFWgamepadstate pad;
        state_.gamepad = false;
        for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST && !state_.gamepad; ++id) {
            if (glfwJoystickIsGamepad(id) == GLFW_FALSE ||
                glfwGetGamepadState(id, &pad) == GLFW_FALSE)
                continue;
            state_.gamepad = true;
            for (size_t a = 0; a < state_.gamepad_axis.size(); ++a)
                state_.gamepad_axis[a] = pad.axes[a];
            const bool start_before = (state_.gamepad_buttons & kStartButton) != 0;
            state_.gamepad_buttons = 0;
            for (unsigned b = 0; b < 15; ++b) {
                if (pad.buttons[b] == GLFW_PRESS)
                    state_.gamepad_buttons |= static_cast<uint16_t>(1U << b);
            }
            if (!start_before && (state_.gamepad_buttons & kStartButton) != 0)
                happened({.kind = WindowEvent::Kind::kStart, .down = true});
        }
    }

    GLFWwindow* window_ = nullptr;
    static constexpr uint16_t kStartButton = 1U << GLFW_GAMEPAD_BUTTON_START;
    WindowInput state_;
    WindowEvents events_;
    HeldKeys held_;
    double last_x_ = 0, last_y_ = 0;
    bool has_last_ = false, captured_ = false;
    double placed_s_ = -1;                            ///< When the window was moved or sized last.
    int unsettled_polls_ = 0;                         ///< Polls until motion is a hand's again.
    double quick_x_ = 0, quick_y_ = 0, quick_s_ = 0;  ///< Motion that waits, and since when.
};

}  // namespace

std::unique_ptr<GlContext> open_window(const ContextSettings& settings) {
    return std::make_unique<GlfwWindow>(settings);
}

}  // namespace placode::view
