// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What placode-sim was asked to do.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "curriculum/conduct.h"
#include "haptics/control_layout.h"
#include "ui/attempt/replay_control.h"

namespace placode::ui {

/// Bad input or usage: exit status 2. The message is complete and for the user.
class UsageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

struct Arguments {
    std::string task, device = "mouse", record, language = "en";
    std::string order;  ///< db::order_checksum() of what it is begun for; empty = nothing.
    std::string play;   ///< Recording to replay, from `--device play:FILE`.
    std::string screenshot_folder;
    double screenshot_every_s = 5;
    double duration_s = 0;  ///< 0 = the task's limit.
    int threads = 2;
    int stage = 0;  ///< Of the task, to begin at; 0 = the beginning.
    uint64_t seed = 1;
    int width = 1280, height = 800;
    bool size_given = false;  ///< By --size; else a window takes the size of the last one.
    std::optional<std::pair<int, int>> place;  ///< Of the window on the desktop [px].
    int scope_angle_deg = -1;                  ///< -1 = as the task says.
    bool headless = false, fast = false, status = false, demonstration = false;
    bool fullscreen = false, list_devices = false, json = false;
    std::string preset, author;  ///< Tuned numbers to load; who tunes, for what is saved.
    /// From --exam or --study.
    curriculum::AttemptMode mode = curriculum::AttemptMode::kPractice;
    curriculum::Aids aids = curriculum::conduct_of(curriculum::AttemptMode::kPractice).aids;
    double least_s = 0;  ///< A study's least duration; 0 = none.
    bool mute = false, list_presets = false;
    int volume_percent = -1;  ///< -1 = as set before.
    haptics::ControlLayout layout;
    bool limits_file = false, station_file = false;
    std::string test_device;    ///< Try this device, or "pedals"; empty = no.
    double test_force_n = 0.5;  ///< Ceiling of the force of that test.
    bool control = false;       ///< Replay: obey lines on standard input, stay at the end.
    ReplayWish wish;            ///< Replay: camera, speed and the moment to start with.
};

/// What a window or a picture may measure [px].
[[nodiscard]] constexpr bool is_window_size(int width, int height) {
    return width >= 160 && height >= 120 && width <= 7680 && height <= 4320;
}

/// Throws UsageError. Prints help or version itself and then sets `exit_now`.
[[nodiscard]] Arguments parse_arguments(int argc, char** argv, bool& exit_now);

}  // namespace placode::ui
