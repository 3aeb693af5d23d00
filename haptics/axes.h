// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Axes of a device in our frame D (x right, y up, z towards the operator), as a setting: vendors do
// not agree, and some do not say.

#include <string_view>

#include "haptics/device.h"

namespace placode::haptics {

/// "x z -y": our x is the device's x, our y its z, our z minus its y. The matrix takes a vector of
/// the device to D; its transpose takes a force back. Throws DeviceError for what is no turn of
/// right-handed axes.
[[nodiscard]] Mat3 device_axes(std::string_view text, std::string_view key);

}  // namespace placode::haptics
