// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/control_help.h"

namespace placode::haptics {

std::vector<ControlHelp> controls(std::string_view device) {
    if (device == "mouse")
        return {{"Move the tip in the picture", "move the mouse"},
                {"Go deeper / come back",
                 "wheel away from you / towards you (half a millimetre; with Shift 2 mm)"},
                {"Cut (yellow pedal)", "hold the left button, or X"},
                {"Coagulate (blue pedal)", "hold the right button, or C"},
                {"Precision (a fifth of the motion)", "hold Ctrl"},
                {"Clutch: move the mouse, not the tip", "hold Space"},
                {"Turn the instrument", "hold Shift and move sideways"},
                {"Steer the scope", "hold the middle button and move; wheel for distance"},
                {"Other hand, when there are two", "Tab"},
                {"Finish the task", "hold Enter"}};
    if (device == "keyboard")
        return {{"Move the tip left, right, up, down in the picture", "A, D, W, S"},
                {"Go deeper / come back", "F / R"},
                {"Cut (yellow pedal); slows the tip", "hold X"},
                {"Coagulate (blue pedal); slows the tip", "hold C"},
                {"Precision (a tenth of the speed)", "hold Ctrl"},
                {"Stop the hand", "hold Space"},
                {"Turn the instrument", "Q / E"},
                {"Steer the scope", "arrow keys"},
                {"Other hand, when there are two", "Tab"},
                {"Finish the task", "hold Enter"}};
    if (device == "gamepad")
        return {{"Move the tip in the picture", "left stick"},
                {"Go deeper / come back", "right trigger / left trigger"},
                {"Cut (yellow pedal)", "hold the lower button (A or cross)"},
                {"Coagulate (blue pedal)", "hold the right button (B or circle)"},
                {"Precision (a tenth of the speed)", "hold the left bumper"},
                {"Turn the instrument", "right stick sideways"},
                {"Stop the hand", "hold Space on the keyboard"},
                {"Finish the task", "Start for the menu, or hold Enter"}};
    if (device == "spacemouse")
        return {{"Move the tip in the picture", "push the cap sideways and up or down"},
                {"Go deeper / come back", "push the cap away from you / pull it"},
                {"Cut (yellow pedal)", "hold the left button, or the yellow pedal"},
                {"Coagulate (blue pedal)", "hold the right button, or the blue pedal"},
                {"Turn the instrument", "twist the cap"},
                {"Stop the hand", "hold Space on the keyboard"},
                {"Other hand, when there are two", "Tab"},
                {"Finish the task", "hold Enter"}};
    if (device == "openhaptics" || device == "haply" || device == "forcedimension")
        return {{"Move the handle outside the body", "move the arm; the port inverts"},
                {"Cut (yellow pedal)", "yellow pedal, or the first button"},
                {"Coagulate (blue pedal)", "blue pedal, or the third button"},
                {"Close the jaws", "hold the first button, or the arm's gripper"},
                {"Turn the instrument", "turn the stylus"},
                {"Clutch: move the arm, not the handle", "hold the second button"},
                {"Other instrument", "tap the second button, or Tab"},
                {"Finish the task", "hold Enter"}};
    if (device == "avatar")
        return {{"Move the instrument in its port", "move the handle; the port inverts"},
                {"Cut (yellow pedal)", "yellow pedal"},
                {"Coagulate (blue pedal)", "blue pedal"},
                {"Close the jaws", "close the handle"},
                {"Turn the instrument", "turn the handle"},
                {"Other instrument", "Tab"},
                {"Finish the task", "hold Enter"}};
    return {};
}

}  // namespace placode::haptics
