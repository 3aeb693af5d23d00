// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device.h"

#include <algorithm>

#include "haptics/operator_model.h"

namespace placode::haptics {

// The variants, one file each.
std::unique_ptr<DeviceGroup> open_mouse(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_keyboard(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_gamepad(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_script(const DeviceConfig& config, OperatorLevel level);

namespace {

constexpr std::string_view kScriptPrefix = "script:";

struct Variant {
    std::string_view name, detail;
    std::unique_ptr<DeviceGroup> (*open)(const DeviceConfig&);  // null: no driver in this version
};

constexpr Variant kVariants[] = {
    {"mouse", "tip in the picture's plane, wheel for depth; no force", open_mouse},
    {"keyboard", "fixed speeds; no force", open_keyboard},
    {"gamepad", "sticks and triggers; no force; needs a pad with a standard mapping", open_gamepad},
    {"spacemouse", "3Dconnexion SpaceMouse over spacenavd", nullptr},
    {"openhaptics", "Touch, Touch X, Omni over OpenHaptics", nullptr},
    {"haply", "Haply Inverse3", nullptr},
    {"avatar", "Follou Haptic Avatar", nullptr},
    {"forcedimension", "Force Dimension omega, delta, sigma, lambda", nullptr},
};

std::string usable_names() {
    std::string names;
    for (const auto& variant : kVariants)
        if (variant.open != nullptr) names += std::string(variant.name) + ", ";
    for (const auto level : operator_levels())
        names += std::string(kScriptPrefix) + std::string(operator_name(level)) + ", ";
    names.resize(names.size() - 2);
    return names;
}

std::string unsupported(const Variant& variant) {
    return "device \"" + std::string(variant.name) + "\" (" + std::string(variant.detail) +
           ") is not supported by this version: it has no driver for it. Use one of: " +
           usable_names() + ".";
}

}  // namespace

std::unique_ptr<DeviceGroup> open_device(const DeviceConfig& config) {
    const std::string_view name = config.name;
    if (config.tools.empty() || config.tools.size() > sim::kMaxTools)
        throw DeviceError("device \"" + config.name + "\": asked to hold " +
                          std::to_string(config.tools.size()) + " tools; expected 1 to " +
                          std::to_string(sim::kMaxTools));
    if (name.starts_with(kScriptPrefix)) {
        if (const auto level = operator_level(name.substr(kScriptPrefix.size())))
            return open_script(config, *level);
    }
    for (const auto& variant : kVariants) {
        if (variant.name != name) continue;
        if (variant.open == nullptr) throw DeviceError(unsupported(variant));
        return variant.open(config);
    }
    throw DeviceError("unknown device \"" + config.name + "\"; known are: " + usable_names() + ".");
}

std::vector<DeviceListing> list_devices() {
    std::vector<DeviceListing> out;
    for (const auto& variant : kVariants) {
        const bool available = variant.open != nullptr;
        out.push_back(
            {std::string(variant.name), available,
             available ? std::string(variant.detail)
                       : "not supported by this version (" + std::string(variant.detail) + ")"});
    }
    for (const auto level : operator_levels())
        out.push_back({std::string(kScriptPrefix) + std::string(operator_name(level)), true,
                       "scripted operator, seeded, runs in step with the simulation"});
    return out;
}

std::vector<ControlHelp> controls(std::string_view device) {
    if (device == "mouse")
        return {{"Move the tip in the picture", "move the mouse"},
                {"Go deeper / come back", "wheel away from you / towards you (1 mm a notch)"},
                {"Cut (yellow pedal)", "hold the left button, or X"},
                {"Coagulate (blue pedal)", "hold the right button, or C"},
                {"Precision (a fifth of the motion)", "hold Ctrl"},
                {"Clutch: move the mouse, not the tip", "hold Space"},
                {"Turn the instrument", "hold Shift and move sideways"},
                {"Steer the scope", "hold the middle button and move; wheel for distance"},
                {"Other hand, when there are two", "Tab"},
                {"Finish the task", "Enter"}};
    if (device == "keyboard")
        return {{"Move the tip left, right, up, down in the picture", "A, D, W, S"},
                {"Go deeper / come back", "F / R"},
                {"Cut (yellow pedal); slows the tip", "hold X"},
                {"Coagulate (blue pedal); slows the tip", "hold C"},
                {"Precision (a tenth of the speed)", "hold Ctrl"},
                {"Stop the hand", "hold Space"},
                {"Turn the instrument", "Q / E"},
                {"Other hand, when there are two", "Tab"},
                {"Finish the task", "Enter"}};
    if (device == "gamepad")
        return {{"Move the tip in the picture", "left stick"},
                {"Go deeper / come back", "right trigger / left trigger"},
                {"Cut (yellow pedal)", "hold the lower button (A or cross)"},
                {"Coagulate (blue pedal)", "hold the right button (B or circle)"},
                {"Precision (a tenth of the speed)", "hold the left bumper"},
                {"Turn the instrument", "right stick sideways"},
                {"Stop the hand", "hold Space on the keyboard"},
                {"Finish the task", "Start, or Enter on the keyboard"}};
    return {};
}

}  // namespace placode::haptics
