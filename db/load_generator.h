// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A full store to measure with: really simulated attempts, multiplied. Every copy says from which
// attempt it comes and belongs to an account that cannot be signed in to.

#include <cstdint>
#include <functional>
#include <string>

namespace placode::db {

struct LoadOrder {
    int users = 1000;
    int64_t attempts = 100000;
    int group_size = 50;
    uint64_t seed = 1;
    /// As what people did: every copy is sealed, so that checking the store costs what it would.
    bool sealed = false;
    /// Told now and then; false stops, and nothing is kept.
    std::function<bool(int64_t done, int64_t total)> progress;
};

struct LoadResult {
    int64_t first_user = 0, first_group = 0;
    int users = 0, groups = 0;
    int64_t attempts = 0, sources = 0;
    int64_t rows = 0;  ///< In all tables of attempts, of the copies alone.
    bool cancelled = false;
};

/// Multiplies the attempts that the store holds, without their recordings: points follow a learning
/// curve with scatter, metrics are scaled by 0.9 to 1.1, days spread over two years. The same order
/// gives the same rows. One transaction. Throws StoreError(kRefused) for a store without an attempt
/// to multiply, or with people of its own: it is no place for copies.
[[nodiscard]] LoadResult generate_load(const std::string& store_url, const LoadOrder& order);

}  // namespace placode::db
