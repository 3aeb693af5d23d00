// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A text that must not outlive its use: a passphrase, the secret half of a key.

#include <cstddef>
#include <string>
#include <string_view>

namespace placode::db {

/// Overwrites the bytes, also those behind the text's end, and empties it.
void wipe(std::string& text) noexcept;

/// In pages of its own, which are overwritten when it goes, are in no core file, and stay out of
/// swap where the limit of locked memory allows it. Nothing copies it.
class Secret {
 public:
    Secret() = default;
    /// Throws StoreError(kUnavailable) when there is no memory for it.
    explicit Secret(std::string_view text);
    ~Secret();
    Secret(Secret&& other) noexcept;
    Secret& operator=(Secret&& other) noexcept;
    Secret(const Secret&) = delete;
    Secret& operator=(const Secret&) = delete;

    [[nodiscard]] std::string_view text() const noexcept { return {bytes_, size_}; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

 private:
    char* bytes_ = nullptr;
    size_t size_ = 0;
};

}  // namespace placode::db
