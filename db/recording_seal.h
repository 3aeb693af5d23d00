// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The signature under a recording file: the computer that recorded it signs header, end,
// certificate and the checksums of all chunks when the attempt ends (db/station.h). One more line
// of the file's `meta`. Who changes a byte of the file later breaks it.

#include <string>

struct sqlite3;

namespace placode::db {

/// Signs what is in the file now, in place of an earlier signature. Nothing happens on a computer
/// that can have no key. @return an SQLite result code.
int sign_recording(sqlite3* database);

enum class RecordingSignature : uint8_t {
    kNone,   ///< Of a version before there were signatures, or of an attempt that broke off.
    kWrong,  ///< The file was changed, or signed by somebody without the key.
    kRight
};
struct RecordingSeal {
    RecordingSignature signature = RecordingSignature::kNone;
    std::string station;  ///< Public key of who signed; empty without a signature.
};
/// Throws StoreError for what is no recording, and when it cannot be read just now: a signature
/// that the disk did not give is not one that is missing.
[[nodiscard]] RecordingSeal recording_seal(const std::string& path);
[[nodiscard]] RecordingSeal recording_seal(sqlite3* database);

}  // namespace placode::db
