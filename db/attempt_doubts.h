// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Why an attempt that is being saved proves nothing, as far as the store can tell: who signed its
// recording, whether it is known already, what it was begun for.

#include <optional>
#include <string>
#include <vector>

#include "db/records.h"
#include "db/void_reason.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// The attempt with a recording of this checksum, also one that a server does not show.
[[nodiscard]] std::optional<int64_t> attempt_with(Connection& connection,
                                                  const std::string& checksum);

/// An exam, or an attempt of a study: it counts only with a recording that was simulated again.
[[nodiscard]] bool matters(const AttemptResult& result) noexcept;

/// Within the transaction that saves it; of an exam as such: db/exam_check.h. Throws StoreError.
/// @param checksum of the recording file; empty without one.
[[nodiscard]] std::vector<VoidReason> doubts_in_store(StoreContext& context, const UserRecord& user,
                                                      const AttemptResult& result,
                                                      const std::string& checksum);

/// Of an attempt that is kept, when it is simulated again: as Attempts::doubt_about().
[[nodiscard]] std::optional<Said> doubt_in_store(StoreContext& context, int64_t attempt_id,
                                                 const std::string& recording_file);

}  // namespace placode::db
