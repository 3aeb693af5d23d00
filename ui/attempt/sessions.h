// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The three ways to run: with a window, without one, and a recording again.

#include "curriculum/attempt_runner.h"
#include "haptics/window_input.h"
#include "sim/core/exchange.h"
#include "ui/attempt/arguments.h"
#include "ui/attempt/screenshots.h"
#include "ui/attempt/status_line.h"

namespace placode::ui {

/// Set by SIGINT and SIGTERM.
[[nodiscard]] bool stop_requested() noexcept;
/// True after SIGUSR1: the shell asks to end the attempt here and score what was done.
[[nodiscard]] bool finish_requested() noexcept;
void catch_stop_signals();

/// Runs until finished; draws, handles keys and menu. Main thread.
void run_in_window(curriculum::AttemptRunner& runner, sim::Latest<sim::WindowInput>& input,
                   const Arguments& arguments, StatusLine& status);
/// Runs until finished; draws only when pictures are asked for.
void run_headless(curriculum::AttemptRunner& runner, const Arguments& arguments,
                  StatusLine& status);
/// Re-simulates `arguments.play`; exit status 0 = identical, 1 = not.
[[nodiscard]] int run_replay(const Arguments& arguments, StatusLine& status);

/// Tries a device by itself (`arguments.test_device`), or watches foot pedals: status lines on
/// standard output, commands on standard input. Exit status 0. Throws DeviceError.
[[nodiscard]] int run_device_test(const Arguments& arguments);

}  // namespace placode::ui
