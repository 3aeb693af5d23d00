// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands inside a recording file: header and end as JSON, and chunks of inputs, samples and
// events. A chunk is written field by field (no padding), every record XORed with the one before,
// bytes of equal place together, then zstd: smooth movement leaves mostly zeros.

#include <span>
#include <string>
#include <vector>

#include "db/packing.h"
#include "db/raw_sqlite.h"
#include "sim/step/recording.h"

namespace placode::db {

/// "PLRC" in the file's header says that it is a recording.
inline constexpr int kRecordingApplicationId = 0x504c5243;

/// The two tables, to the letter: a file with any other is no recording.
inline constexpr const char* kMetaTable =
    "CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL, checksum TEXT NOT NULL) STRICT";
inline constexpr const char* kChunksTable =
    "CREATE TABLE chunks (id INTEGER PRIMARY KEY, kind TEXT NOT NULL, first INTEGER NOT NULL, "
    "count INTEGER NOT NULL, checksum TEXT NOT NULL, content BLOB NOT NULL) STRICT";

/// What a recording may take: an hour of attempt has about half of the second, its chunks a few MiB
/// at most. A few kB of zstd can say that they are as many GB.
inline constexpr size_t kMostChunkBytes = size_t{64} << 20, kMostRecordingBytes = size_t{1} << 30;
/// At most three are written in a quarter of a second: ten hours of them.
inline constexpr int64_t kMostChunks = 500'000;

/// Frames before a stage: two hours of them, in the chunks "given".
inline constexpr int64_t kMostGivenFrames = 7'200'000;
/// Of them in one chunk, some 10 MB before they are packed.
inline constexpr size_t kGivenInChunk = 60'000;

[[nodiscard]] Bytes encode_chunk(std::span<const sim::Input> records);
[[nodiscard]] Bytes encode_chunk(std::span<const sim::Sample> records);
[[nodiscard]] Bytes encode_chunk(std::span<const sim::Event> records);

/// Appends `count` records. Throws StoreError(kDamaged) when the bytes are not that.
void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Input>& out);
void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Sample>& out);
void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Event>& out);

/// JSON with exact doubles; 64-bit unsigned numbers as decimal text.
[[nodiscard]] std::string header_to_json(const sim::RecordingHeader& header);
[[nodiscard]] std::string end_to_json(const sim::RecordingEnd& end);
/// Throw StoreError(kDamaged) naming the key.
[[nodiscard]] sim::RecordingHeader header_from_json(const std::string& json);
[[nodiscard]] sim::RecordingEnd end_from_json(const std::string& json);

/// A recording file, to ask for a line of its `meta`. Throws StoreError, which begins with
/// `operation`, for what is no recording.
[[nodiscard]] ForeignDatabase open_recording(const std::string& path, const std::string& operation);

/// Rolls back what a killed writer left half done, so that the bytes of the file are the recording.
/// Does nothing for a file that is no recording. Throws StoreError where the disk fails or another
/// program holds the file: its bytes would be half of a change.
void settle_recording_file(const std::string& path);

}  // namespace placode::db
