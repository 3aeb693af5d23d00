// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "db/evidence.h"
#include "ui/cli/session.h"

namespace placode::cli {

/// db::verify_attempt with its progress on a terminal; Ctrl+C stops it, and the attempt waits on.
std::optional<curriculum::ReplayVerdict> verify(Session& session, int64_t attempt_id);

}  // namespace placode::cli
