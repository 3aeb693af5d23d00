// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// People and attempts to look at. Every attempt is really simulated, by a scripted operator;
// everything is marked as demonstration.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "curriculum/attempt_runner.h"
#include "db/store.h"

namespace placode::db {

struct DemonstrationPerson {
    const char *login, *name;
    Role role;
};
[[nodiscard]] std::span<const DemonstrationPerson> demonstration_people() noexcept;

/// Who makes it, with which scripted operator.
struct DemonstrationAttempt {
    const char *login, *device;
    uint64_t seed;
};
[[nodiscard]] std::span<const DemonstrationAttempt> demonstration_attempts() noexcept;

/// Creates those who are missing, with kDemonstrationPassword; never changes an account that is
/// there. Returns the logins that are new. Throws StoreError.
std::vector<std::string> add_demonstration_people(Store& store);

/// Whether the store has this attempt at this task. Throws StoreError.
/// @pre its person has an account.
[[nodiscard]] bool has_demonstration(Store& store, const DemonstrationAttempt& attempt,
                                     const std::string& task);

/// Simulates and records it into `file`, as fast as it goes.
/// @param go_on  Asked ten times a second; false closes the attempt.
/// @returns false when it was closed so. Throws DefinitionError, StoreError.
[[nodiscard]] bool record_demonstration(
    const DemonstrationAttempt& attempt, const std::string& task, int threads,
    const std::string& file, const std::function<bool(const curriculum::AttemptStatus&)>& go_on);

}  // namespace placode::db
