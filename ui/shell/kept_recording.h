// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recording of a stored attempt, for pages that are complete without it, too.

#include <QString>

#include "db/store.h"
#include "ui/shell/attempt_order.h"

namespace placode::ui {

/// Writes the recording to `file` and reads it. False when the attempt was kept without one, which
/// is no fault. Any thread, with a store of that thread.
[[nodiscard]] inline bool take_recording(db::Store& store, int64_t attempt_id, const QString& file,
                                         sim::Recording& recording) {
    try {
        store.attempts().extract_recording(attempt_id, file.toStdString());
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kNotFound) return false;
        throw;
    }
    recording = recording_of_file(file);
    return true;
}

}  // namespace placode::ui
