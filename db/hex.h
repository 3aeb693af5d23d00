// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Keys, signatures and checksums as text: two hexadecimal digits a byte, small letters.

#include <sodium.h>

#include <span>
#include <string>
#include <string_view>

namespace placode::db {

[[nodiscard]] inline std::string hex_of(std::span<const unsigned char> bytes) {
    std::string digits(2 * bytes.size() + 1, '\0');
    sodium_bin2hex(digits.data(), digits.size(), bytes.data(), bytes.size());
    digits.pop_back();
    return digits;
}

/// Whether `hex` is just as many bytes as `bytes` has; they are in there then.
[[nodiscard]] inline bool bytes_of_hex(std::string_view hex, std::span<unsigned char> bytes) {
    size_t read = 0;
    return hex.size() == 2 * bytes.size() &&
           sodium_hex2bin(bytes.data(), bytes.size(), hex.data(), hex.size(), nullptr, &read,
                          nullptr) == 0 &&
           read == bytes.size();
}

}  // namespace placode::db
