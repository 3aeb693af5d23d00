// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The size of a picture as it is given on the command line.

#include <charconv>
#include <optional>
#include <string_view>

namespace placode::view {

struct PictureSize {
    int width = 0, height = 0;  ///< [px]
};

/// "WxH", whatever the locale. What sizes are allowed is the caller's to say.
[[nodiscard]] inline std::optional<PictureSize> picture_size(std::string_view text) {
    PictureSize size;
    const char* const end = text.data() + text.size();
    const auto [cross, wide] = std::from_chars(text.data(), end, size.width);
    if (wide != std::errc() || cross == end || *cross != 'x') return std::nullopt;
    const auto [last, high] = std::from_chars(cross + 1, end, size.height);
    if (high != std::errc() || last != end) return std::nullopt;
    return size;
}

}  // namespace placode::view
