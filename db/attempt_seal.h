// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The seal of an attempt: what this centre states about it, as a page of text under the signature
// of the computer that states it. Whoever holds the page and the recording file can check both
// without Placode (examples/check_seal.py).

#include <cstdint>
#include <string>

namespace placode::db {

class Store;

/// First line of every seal.
inline constexpr const char* kSealTitle = "Placode seal of an attempt 1";

/// Lines "name: value" in UTF-8: whose attempt it is, task and case, exam and proctor, score,
/// whether it counts and why not, what simulating it again gave, checksums, and who states it; last
/// the signature over all lines above it. Of a letter that is not seen (an end of a line as well)
/// stands U+FFFD.
/// @param recording_file the attempt's recording, as Attempts::extract_recording() wrote it.
/// @throws StoreError kNotFound; kUnavailable on a computer that can have no key; kRefused where a
/// server does not trust its key. A file trusts the computer that has it, and the page says so.
[[nodiscard]] std::string attempt_seal(Store& store, int64_t attempt_id,
                                       const std::string& recording_file,
                                       const std::string& now_utc);

/// True when the text is a seal to the letter and the computer that it names signed it. Whether
/// that computer is one of the centre's is for the reader: `placodectl station list`.
[[nodiscard]] bool seal_is_right(const std::string& text);

}  // namespace placode::db
