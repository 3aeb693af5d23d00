// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a recording was begun for. Whoever starts an attempt keeps an order beside the recording:
// person, exam with its proctor, study. The recording holds the order's checksum from before the
// first frame, under the signature of the computer (db/recording_seal.h), so that an order that was
// changed later does not fit. It holds no more than that: recordings are passed on, and names stay
// apart from training data.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "db/void_reason.h"

namespace placode::db {

inline constexpr const char* kOrderKey = "order";  ///< Of the file's `meta`.

/// Behind the name of a recording: the file with its order.
inline constexpr std::string_view kOrderSuffix = ".order.json";
[[nodiscard]] inline std::string order_file(const std::string& recording_file) {
    return recording_file + std::string(kOrderSuffix);
}

/// What lies beside a recording, as far as it says whose the attempt is.
struct BesideRecording {
    int64_t user_id = 0;             ///< 0: it does not say.
    std::string study, participant;  ///< "" for none.
    std::string text;                ///< The whole, also of what is no order.
};
/// Nothing where there is no file, or it cannot be read.
[[nodiscard]] std::optional<BesideRecording> order_beside(const std::string& recording_file);

/// Of the text of an order, hexadecimal. The text should hold something that nobody guesses.
[[nodiscard]] std::string order_checksum(const std::string& order);

/// True for what order_checksum() gives.
[[nodiscard]] bool is_order_checksum(const std::string& text);

/// The checksum in a recording file; empty: it was begun without an order, or by an older version.
/// Throws StoreError.
[[nodiscard]] std::string recorded_order(const std::string& recording_file);

/// kOrderDiffers where the recording was begun with another order than `order`. kOrderMissing where
/// it matters and `order` or the recording's checksum is not there.
/// @param order text, "" for none. @param matters true for exams and attempts of studies. Throws
/// StoreError for what is no recording.
[[nodiscard]] std::optional<VoidCause> order_doubt(const std::string& recording_file,
                                                   const std::string& order, bool matters);

}  // namespace placode::db
