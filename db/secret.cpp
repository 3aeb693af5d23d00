// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/secret.h"

#include <sodium.h>

#include <algorithm>

namespace placode::db {
namespace {

/// Longer than what a string keeps within itself: those bytes would move with the object.
constexpr size_t kOwnMemory = 64;

}  // namespace

void wipe(std::string& text) noexcept {
    sodium_memzero(text.data(), text.capacity());
    text.clear();
}

Secret::Secret(const std::string& text) { take(text); }

Secret::~Secret() { drop(); }

Secret::Secret(Secret&& other) noexcept { text_.swap(other.text_); }

Secret& Secret::operator=(Secret&& other) noexcept {
    if (this != &other) {
        drop();
        text_.swap(other.text_);
    }
    return *this;
}

void Secret::take(const std::string& text) {
    text_.reserve(std::max(kOwnMemory, text.size()));
    // Locks and, on Linux, leaves the pages out of core files. Refused beyond the limit of locked
    // memory: the text is overwritten all the same.
    (void)sodium_mlock(text_.data(), text_.capacity());
    text_ = text;
}

void Secret::drop() noexcept {
    if (text_.capacity() < kOwnMemory) return;             // Moved from, or never filled.
    (void)sodium_munlock(text_.data(), text_.capacity());  // Overwrites first.
    wipe(text_);
}

}  // namespace placode::db
