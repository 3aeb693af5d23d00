// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/secret.h"

#include <sodium.h>

#include <algorithm>
#include <utility>

#include "db/password.h"
#include "db/store_error.h"

namespace placode::db {

void wipe(std::string& text) noexcept {
    sodium_memzero(text.data(), text.capacity());
    text.clear();
}

// Not a string: only whole pages can be left out of a core file, and a string's bytes share theirs.
Secret::Secret(std::string_view text) : size_(text.size()) {
    if (text.empty()) return;
    need_sodium();
    bytes_ = static_cast<char*>(sodium_malloc(size_));
    if (bytes_ == nullptr)
        throw StoreError(StoreError::Kind::kUnavailable,
                         "keep a secret: no memory is free; close other programs");
    std::copy(text.begin(), text.end(), bytes_);
}

Secret::~Secret() { sodium_free(bytes_); }  // Overwrites first.

Secret::Secret(Secret&& other) noexcept
    : bytes_(std::exchange(other.bytes_, nullptr)), size_(std::exchange(other.size_, 0)) {}

Secret& Secret::operator=(Secret&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    std::swap(size_, other.size_);
    return *this;
}

}  // namespace placode::db
