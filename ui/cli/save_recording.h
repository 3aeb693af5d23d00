// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a finished recording file to an attempt in the store.

#include "ui/cli/session.h"

namespace placode::cli {

struct SavedAttempt {
    int64_t id = 0;
    assessment::Score score;
    double duration_s = 0;
};

/// Computes metrics and score by the task that the recording carries, and saves both with the
/// recording in one transaction. Throws StoreError or DefinitionError; the file stays as it is.
/// @param exam under which exam it was made; default: practice.
SavedAttempt save_recording(Session& session, int64_t user_id, const std::string& file,
                            const db::ExamContext& exam = {});

}  // namespace placode::cli
