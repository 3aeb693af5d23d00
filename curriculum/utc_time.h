// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Dates as they stand in files and in the store: ISO 8601, UTC.

#include <cstdint>
#include <optional>
#include <string>

namespace placode::curriculum {

/// Seconds since 1970 of "2026-11-21" (midnight), "2026-11-21T18:03:00Z" or with ".123Z" (the
/// fraction is dropped). Nothing for anything else, also for a day that does not exist.
[[nodiscard]] std::optional<int64_t> utc_seconds(const std::string& text);

/// "2026-11-21T18:03:00Z".
[[nodiscard]] std::string utc_text(int64_t seconds);

/// The day of utc_text(): "2026-11-21".
[[nodiscard]] std::string utc_day(int64_t seconds);

}  // namespace placode::curriculum
