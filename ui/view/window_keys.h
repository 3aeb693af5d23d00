// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which key of the window is which, by its place, and what a keyboard that has no Latin letters
// prints on it. No GLFW types.

#include "haptics/window_input.h"

namespace placode::view {

/// `code`: GLFW_KEY_...; Key::kCount where it means nothing here.
[[nodiscard]] sim::Key key_of(int code) noexcept;

/// The letter that a key types, by its name in UTF-8, where it is no ASCII; else 0. `name` may be
/// null.
[[nodiscard]] char32_t other_letter(const char* name) noexcept;

}  // namespace placode::view
