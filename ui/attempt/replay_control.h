// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a watcher of a replay wants: camera, speed, pause, a moment. Asked for in the window by keys
// and, with --control, by lines on standard input:
//   camera scope|above|left|feet|near    speed 0.1..8    seek SECONDS    pause    play    quit

#include <string>
#include <string_view>

#include "ui/view/fetoscope_view.h"

namespace placode::ui {

enum class ReplayCamera : uint8_t {
    kScope,  ///< As it was operated.
    kAbove,
    kLeft,  ///< From the patient's left.
    kFeet,
    kNear  ///< Close to the first instrument's tip.
};
inline constexpr int kReplayCameras = 5;
inline constexpr double kSlowest = 0.1, kFastest = 8;
/// False when there is no camera of that name.
[[nodiscard]] bool camera_named(std::string_view name, ReplayCamera& camera);
[[nodiscard]] const char* camera_name(ReplayCamera camera);

struct ReplayWish {
    ReplayCamera camera = ReplayCamera::kScope;
    double speed = 1;
    bool paused = false, quit = false;
    double seek_s = -1;   ///< A moment to go to; taken by the session, which sets it back to -1.
    std::string problem;  ///< What was not understood last; empty = nothing.
};

/// Carries out one line. What is out of range is refused with the reason in `problem`.
void apply_line(std::string_view line, ReplayWish& wish);

/// Lines on standard input, without waiting for them. Main thread.
class LineInput {
 public:
    /// The next whole line without its end; false: none has come yet.
    [[nodiscard]] bool next(std::string& line);
    /// Who wrote is gone.
    [[nodiscard]] bool closed() const { return closed_; }

 private:
    std::string pending_;
    bool closed_ = false;
};

/// Carries out what has come on standard input. Main thread.
class ControlInput {
 public:
    void poll(ReplayWish& wish);

 private:
    LineInput input_;
};

/// Keys of the window: Space and Esc pause, arrows, V, Q closes.
class ReplayKeys {
 public:
    void apply(const sim::WindowInput& input, double now_s, ReplayWish& wish);

 private:
    [[nodiscard]] int presses_of(const sim::WindowInput& input, sim::Key key);
    sim::WindowInput last_;
};

/// Moves the scope of a snapshot to where the camera stands, so that the view looks from there.
void place_camera(ReplayCamera camera, const std::vector<sim::ToolSpec>& tools,
                  sim::Snapshot& snapshot);

}  // namespace placode::ui
