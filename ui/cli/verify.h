// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "db/evidence.h"
#include "ui/cli/session.h"

namespace placode::cli {

/// db::verify_attempt with its progress on a terminal; Ctrl+C stops it, and the attempt waits on.
/// @param place " (3 of 20)", or nothing.
std::optional<curriculum::ReplayVerdict> verify(Session& session, int64_t attempt_id,
                                                const std::string& place = {});

}  // namespace placode::cli
