// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every device there is, scripted operators too, by name.

#include <memory>
#include <string>
#include <vector>

#include "haptics/device.h"

namespace placode::haptics {

/// Opens by name. Throws DeviceError: unknown names list the known ones, absent hardware says what
/// is missing and how to install it.
[[nodiscard]] std::unique_ptr<DeviceGroup> open_device(const DeviceConfig& config);

/// What `--list-devices` prints: name, found or not, and why not.
struct DeviceListing {
    std::string name;
    bool available = false;
    std::string detail;              ///< What it is, or what is missing and how to install it.
    std::vector<std::string> found;  ///< Vendor, model and serial of hardware that answered.
};
/// Looks for hardware by opening it for a moment; takes up to some seconds.
[[nodiscard]] std::vector<DeviceListing> list_devices(const Station& station = {});

}  // namespace placode::haptics
