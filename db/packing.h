// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bytes made small (zstd) and proved whole (BLAKE2b).

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace placode::db {

using Bytes = std::vector<std::byte>;

/// zstd, level 3: about 300 MB/s here, so that a chunk of 0.5 s costs under a millisecond.
[[nodiscard]] Bytes compress(std::span<const std::byte> bytes);
/// Size that a compressed frame says it has; 0 = it does not say.
[[nodiscard]] size_t stated_size(std::span<const std::byte> packed);
/// Throws StoreError(kDamaged) when the content is not exactly `size` bytes of good zstd.
[[nodiscard]] Bytes decompress(std::span<const std::byte> packed, size_t size);

/// What checksum_hex() gives for the content, which is never in memory as a whole: a few kB of zstd
/// can hold as many GB of zeros. Throws StoreError(kDamaged) as decompress() does.
[[nodiscard]] std::string checksum_of_packed(std::span<const std::byte> packed, size_t size);

/// Appends a text of any content, so that no two lists of texts give the same whole.
inline void add_text(std::string& all, const std::string& text) {
    all += std::to_string(text.size()) + ":" + text + ";";
}

/// BLAKE2b-256, hexadecimal.
[[nodiscard]] std::string checksum_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::string checksum_hex(const std::string& text);

}  // namespace placode::db
