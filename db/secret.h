// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A text that must not outlive its use: a passphrase, the secret half of a key.

#include <string>

namespace placode::db {

/// Overwrites the bytes, also those behind the text's end, and empties it.
void wipe(std::string& text) noexcept;

/// Overwritten when it goes; nothing copies it. Where the system allows it, its pages are kept out
/// of swap and of core files for as long as it lives.
class Secret {
 public:
    Secret() = default;
    explicit Secret(const std::string& text);
    ~Secret();
    Secret(Secret&& other) noexcept;
    Secret& operator=(Secret&& other) noexcept;
    Secret(const Secret&) = delete;
    Secret& operator=(const Secret&) = delete;

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] bool empty() const noexcept { return text_.empty(); }

 private:
    void take(const std::string& text);
    void drop() noexcept;

    std::string text_;
};

}  // namespace placode::db
