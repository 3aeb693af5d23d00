// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/controls_setup.h"

#include "curriculum/usual_time.h"

namespace placode::ui {

bool is_in_window(std::string_view device) {
    return device == "mouse" || device == "keyboard" || device == "gamepad";
}

bool has_window_hands(std::string_view device) {
    return is_in_window(device) || device == "spacemouse";
}

ControlsSetup controls_setup(const curriculum::Task& task, const Arguments& arguments) {
    ControlsSetup setup;
    setup.mode = arguments.mode;
    setup.planned_line = arguments.aids.planned_line;
    setup.usual_s = curriculum::usual_time_s(task);
    setup.least_s = arguments.least_s;
    setup.gamepad = arguments.device == "gamepad";
    setup.window_hands = has_window_hands(arguments.device);
    // Nobody starts in the dark; the steps of a practice task say it themselves.
    setup.help_first = is_in_window(arguments.device) && task.steps.empty() &&
                       curriculum::conduct_of(arguments.mode).help;
    setup.language = arguments.language;
    setup.layout = arguments.layout;
    return setup;
}

}  // namespace placode::ui
