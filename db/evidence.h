// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A score is evidence: how a recording becomes an attempt. It is judged by the published task and
// rubric, found by id and version in the store or in the program's own data. What the recording
// carries is compared with them and never used: whoever writes a file writes its rubric, too.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/replay_check.h"
#include "curriculum/task.h"
#include "db/store.h"
#include "db/void_reason.h"

namespace placode::db {

/// The task of that id and version as it was published: by the store, else by the program
/// (curriculum/shipped_definitions.h), never by a folder.
/// @param version 0 = the newest that the store keeps. @param id never a path.
[[nodiscard]] std::optional<curriculum::Task> published_task(Store& store, const std::string& id,
                                                             int version);

/// "not replayed", "waiting", "identical", "differs".
[[nodiscard]] const char* replay_name(ReplayState state) noexcept;

/// The program's own task of that id (curriculum/shipped_definitions.h), whatever its version;
/// nullopt: it has none.
[[nodiscard]] std::optional<curriculum::Task> shipped_task(const std::string& id);

/// How the recording's task compares with the published one.
struct TaskEvidence {
    std::optional<curriculum::Task> task;  ///< Published; absent: there is none to judge by.
    std::vector<VoidReason> doubts;        ///< Empty: the recording is of that task.
};
[[nodiscard]] TaskEvidence task_evidence(Store& store, const sim::Recording& recording);

/// Header, end, events, metrics and score of a recording that becomes an attempt, with what is in
/// doubt of it. Without a published task, or where something that scoring needs is missing, it has
/// no points. `recording_file`, exam and study are the caller's to fill in.
[[nodiscard]] AttemptResult judged(Store& store, const sim::Recording& recording);

/// Keeps the text of the program's task in the store, so that its version means one text for good
/// and old recordings still have a task to be judged by. Does nothing for any other.
void publish_task_on_first_use(Store& store, const std::string& id, int version);

/// The build and instruction set that alone can simulate the attempt again, "placode 0.1.0 AVX2";
/// empty: this one can, or the recording does not say. Without what a terminal would obey: whoever
/// writes a recording chooses the text.
[[nodiscard]] std::string build_waited_for(const AttemptRecord& record);

/// Told the share that is done, 0..1; false stops.
using ReplayProgress = std::function<bool(double share)>;
/// Simulates a stored attempt again, compares what the store says of it with what the recording
/// gives under the published rubric, and keeps what came of it. What was stopped, or cannot be
/// judged here, stays as it was: nullopt. That is a task which is not published; a recording of
/// another build or instruction set: its last bits are other ones, and that proves nothing against
/// anybody, so its facts and its signature are compared, once by each version; other points by an
/// earlier version of this program; and an attempt of which a server does not take this log-in's
/// word (Attempts::judges_replay()). Throws StoreError.
std::optional<curriculum::ReplayVerdict> verify_attempt(Store& store, int64_t attempt_id,
                                                        const ReplayProgress& progress = {});

}  // namespace placode::db
