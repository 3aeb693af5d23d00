// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sentences of help and hints name the keys as delivered; here they name the keys that a person
// has chosen. In both languages of the program.

#include <string>
#include <string_view>

#include "haptics/control_layout.h"
#include "haptics/hint_device.h"

namespace placode::haptics {

/// Whether `does` is done by its key with this device, and not by something of the device itself
/// (a letter may be a button there): Tab, Space, lens and sound with every one.
[[nodiscard]] bool is_key_with(HintDevice device, sim::Key does) noexcept;

/// Name of a key in a language: "Space" is "Spacja" in Polish.
[[nodiscard]] std::string key_name_in(sim::Key key, std::string_view language);

/// `text` with the keys, mouse buttons and sticks of `layout` in place of those as delivered.
/// Of the keys those that are keys with this device. Without a change in the layout the text is
/// the same.
[[nodiscard]] std::string in_layout(std::string_view text, const ControlLayout& layout,
                                    HintDevice device, std::string_view language);

}  // namespace placode::haptics
