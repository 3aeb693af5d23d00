// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// FNV-1a, 64 bits: states and results are compared by it, nothing is protected by it.
// Source: https://datatracker.ietf.org/doc/html/draft-eastlake-fnv

#include <cstddef>
#include <cstdint>

namespace placode::sim {

class FnvHash {
 public:
    void bytes(const void* data, size_t size) noexcept {
        const auto* p = static_cast<const unsigned char*>(data);
        for (size_t i = 0; i < size; ++i) value_ = (value_ ^ p[i]) * 1099511628211ULL;
    }
    [[nodiscard]] uint64_t value() const noexcept { return value_; }

 private:
    uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace placode::sim
