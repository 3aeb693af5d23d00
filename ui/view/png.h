// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures to files.

#include <cstdint>
#include <string>
#include <vector>

namespace placode::view {

/// Writes 8-bit RGB rows from the top (height x width x 3). Throws ViewError.
void write_png(const std::string& path, int width, int height, const std::vector<uint8_t>& rgb);

}  // namespace placode::view
