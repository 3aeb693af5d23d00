// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/catalogue/open_device.h"

#include <algorithm>

#include "haptics/gamepad_search.h"
#include "haptics/operators/operator_profile.h"
#include "sim/core/near_word.h"

namespace placode::haptics {

// The variants, one file each.
std::unique_ptr<DeviceGroup> open_mouse(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_keyboard(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_gamepad(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_spacemouse(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_openhaptics(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_haply(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_avatar(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_forcedimension(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_mouse_person(const DeviceConfig& config);
std::unique_ptr<DeviceGroup> open_script(const DeviceConfig& config, OperatorLevel level);

namespace {

constexpr std::string_view kScriptPrefix = "script:", kMousePerson = "script:mouse";

struct Variant {
    std::string_view name, detail;
    std::unique_ptr<DeviceGroup> (*open)(const DeviceConfig&);
    bool hardware = false;  // has to be there
};

constexpr std::string_view kGamepad = "gamepad";

constexpr Variant kVariants[] = {
    {"mouse", "tip in the picture's plane, wheel for depth; no force", open_mouse},
    {"keyboard", "fixed speeds; no force", open_keyboard},
    {kGamepad, "sticks and triggers; no force; needs a pad with a standard mapping", open_gamepad},
    {"spacemouse", "3Dconnexion SpaceMouse over spacenavd; no force", open_spacemouse, true},
    {"openhaptics", "Touch, Touch X, Omni over OpenHaptics", open_openhaptics, true},
    {"haply", "Haply Inverse3 over the Inverse service", open_haply, true},
    {"avatar", "Follou Haptic Avatar over serial lines", open_avatar, true},
    {"forcedimension", "Force Dimension omega, delta, sigma, lambda", open_forcedimension, true},
};

std::vector<std::string> known_names() {
    std::vector<std::string> names;
    for (const auto& variant : kVariants) names.emplace_back(variant.name);
    for (const auto level : operator_levels())
        names.push_back(std::string(kScriptPrefix) + std::string(operator_name(level)));
    names.emplace_back(kMousePerson);
    return names;
}

// Opens the device for a moment: what cannot be opened says why, what can says what it is.
DeviceListing look_for(const Variant& variant, const Station& station) {
    DeviceListing out{std::string(variant.name), true, std::string(variant.detail), {}};
    if (variant.name ==
        kGamepad) {  // Opened by the window, which takes it also when it comes later.
        const GamepadSearch search = look_for_gamepads();
        out.found = search.found;
        out.available = !search.found.empty();
        if (!out.available) out.detail = search.reason();
        return out;
    }
    if (!variant.hardware) return out;
    DeviceConfig config;
    config.name = out.name;
    config.station = station;
    config.tools.resize(2);
    config.tools[1].hand = sim::Hand::kLeft;
    try {
        const auto group = variant.open(config);
        for (const DeviceInfo& found : group->info()) {
            const std::string name =
                found.vendor + " " + found.model + (found.serial.empty() ? "" : " " + found.serial);
            if (out.found.empty() || out.found.back() != name) out.found.push_back(name);
        }
        group->stop();
    } catch (const DeviceError& error) {
        out.available = false;
        out.detail = error.what();
    }
    return out;
}

}  // namespace

std::unique_ptr<DeviceGroup> open_device(const DeviceConfig& config) {
    const std::string_view name = config.name;
    if (config.tools.empty() || config.tools.size() > sim::kMaxTools)
        throw DeviceError("device \"" + config.name + "\": asked to hold " +
                          std::to_string(config.tools.size()) + " tools; expected 1 to " +
                          std::to_string(sim::kMaxTools));
    if (name == kMousePerson) return open_mouse_person(config);
    if (name.starts_with(kScriptPrefix)) {
        if (const auto level = operator_level(name.substr(kScriptPrefix.size())))
            return open_script(config, *level);
    }
    for (const auto& variant : kVariants) {
        if (variant.name != name) continue;
        return variant.open(config);
    }
    std::string names;
    for (const std::string& known : known_names()) names += (names.empty() ? "" : ", ") + known;
    throw DeviceError("unknown device \"" + config.name + "\"; known are: " + names +
                      sim::did_you_mean(name, known_names()));
}

std::vector<DeviceListing> list_devices(const Station& station) {
    std::vector<DeviceListing> out;
    for (const auto& variant : kVariants) out.push_back(look_for(variant, station));
    for (const auto level : operator_levels())
        out.push_back({std::string(kScriptPrefix) + std::string(operator_name(level)),
                       true,
                       "scripted operator, seeded, runs in step with the simulation",
                       {}});
    out.push_back({std::string(kMousePerson),
                   true,
                   "the scripted expert with a mouse: window events through the mouse's mapping",
                   {}});
    return out;
}

}  // namespace placode::haptics
