// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recording file: an SQLite file of its own, committed at least every 0.5 s while an attempt
// runs, zstd chunks inside. Whatever was committed survives a crash or a power cut.

#include <memory>
#include <string>

#include "sim/step/recording.h"

namespace placode::db {

/// Sink for one attempt, used by the recorder thread. Throws StoreError when the file exists or
/// cannot be written. @param order order_checksum() of what the attempt was begun for
/// (db/recording_order.h), which is written before the first frame; empty = nothing.
[[nodiscard]] std::unique_ptr<sim::RecordingSink> create_recording_file(
    const std::string& path, const std::string& order = {});

/// Reads a whole file. A file without an end (crash) comes back with EndReason::kInterrupted and
/// the duration of what was committed. Throws StoreError: kNotFound, kDamaged naming the chunk and
/// saying how much before it is whole, or kTooNew. Any thread.
[[nodiscard]] sim::Recording read_recording_file(const std::string& path);

/// Adds what the haptic loop did (JSON of haptics/certificate.h) to a recording that has ended,
/// once. Throws StoreError.
void add_haptic_certificate(const std::string& path, const std::string& json);

/// The certificate in a recording file; empty: an older file, or one that ended in a crash. Throws
/// StoreError.
[[nodiscard]] std::string haptic_certificate(const std::string& path);

struct RecoveredRecording {
    sim::Recording recording;  ///< Everything before the damage; end as of a crash if it was lost.
    std::string damage;        ///< What is damaged and how much is whole; empty = nothing is.
};

/// As read_recording_file, but keeps what stands before a damaged chunk. Throws when not even the
/// header can be read.
[[nodiscard]] RecoveredRecording recover_recording_file(const std::string& path);

struct RecordingSummary {
    sim::RecordingHeader header;
    sim::RecordingEnd end;  ///< kInterrupted, with the time that was committed, after a crash.
};

/// Header and end without what lies between, which takes milliseconds instead of seconds. Throws
/// as recover_recording_file(); a damaged chunk is not seen.
[[nodiscard]] RecordingSummary recording_summary(const std::string& path);

/// Recording files (*.placode) in `folder` that no living program is writing to: the shell removes
/// a file once it is in the store, so these are left over from a crash. One that cannot be read is
/// listed as well: reading it says why. Sorted by name.
[[nodiscard]] std::vector<std::string> leftover_recordings(const std::string& folder);

}  // namespace placode::db
