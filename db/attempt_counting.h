// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which attempts count. One that the machine spoilt, that was broken off, or that only shows how
// something is done, is kept and counts for nothing: neither mastery nor standings, grades, norms,
// standards, cohort or studies. What a script did counts for demonstration accounts
// (db/attempt_rows.h): for anybody else a record that was read says that it is void.

#include <string>
#include <vector>

#include "db/store.h"
#include "db/void_reason.h"

namespace placode::db {

/// Why an attempt does not count, from what happened in it: tissue or generator were tuned, or the
/// computer was too slow. Nobody measures the speed of scripts and windowless runs: they have no
/// wall clock to keep to.
[[nodiscard]] std::vector<VoidReason> void_reasons(const std::vector<sim::Event>& events);

/// The same, and what its recording says of how it began: what was given counts for nobody.
[[nodiscard]] std::vector<VoidReason> void_causes(const AttemptResult& result);

/// Why a stored attempt is void for cause; empty: it is not.
[[nodiscard]] std::vector<VoidReason> why_void(const AttemptRecord& attempt);

/// Neither broken off, nor void for cause, and something was tried.
[[nodiscard]] bool counts(const AttemptRecord& attempt) noexcept;

/// The stage that it began with; 0 = the beginning.
[[nodiscard]] int given_stage(const AttemptRecord& attempt) noexcept;

/// True when nothing but the machine is why the attempt does not count: it was neither left, nor
/// idle, nor tuned, nor was something given.
[[nodiscard]] bool machine_at_fault(const AttemptRecord& attempt) noexcept;

/// What was recorded proves nothing: neither an exam nor of a study any more, but practice.
[[nodiscard]] bool not_verified(const AttemptRecord& attempt) noexcept;

/// Others are judged only by what can be compared: throws StoreError kRefused, beginning with
/// `what`, unless both are of the same version of the task and were scored under the same rubric.
void need_same_rules(const std::string& what, const AttemptRecord& a, const AttemptRecord& b);

/// Attempts at the same task of whose it is, oldest first: of the person, or of the participant
/// within the study.
[[nodiscard]] std::vector<AttemptRecord> other_attempts(Store& store, const AttemptRecord& attempt);

}  // namespace placode::db
