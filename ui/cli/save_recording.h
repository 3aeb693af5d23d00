// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a finished recording file to an attempt in the store.

#include "ui/cli/session.h"

namespace placode::cli {

struct SavedAttempt {
    int64_t id = 0;
    db::AttemptDetail attempt;  ///< As it was saved.
    double duration_s = 0;
};

/// Computes metrics and score by the published task (db/evidence.h) and saves both with the
/// recording in one transaction. Throws StoreError: kDamaged for what cannot be scored, kConflict
/// for a recording that the store has already; the file stays as it is.
/// @param exam under which exam it was made; default: practice.
SavedAttempt save_recording(db::Store& store, int64_t user_id, const std::string& file,
                            const db::ExamContext& exam = {});

}  // namespace placode::cli
