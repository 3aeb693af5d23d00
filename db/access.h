// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who may do what: decided here, once, for shell and command line alike.

#include "db/records.h"
#include "db/said.h"

namespace placode::db {

class Store;

enum class Action : uint8_t {
    kPerformAttempt,
    kViewAttempts,
    kViewPersonalData,
    kManageUsers,
    kRunQuestionnaire,
    kExportStudy,
    kBackup,
    kViewAudit,
    kManageCourses,  ///< Publish and import courses.
    kAssignCourses,  ///< Assign to people and groups, grant further attempts.
    kManageGroups,
    kIssueCertificate,  ///< Of a course that is mastered.
    kReviewAttempts,    ///< Marks, comments, human ratings.
    kSetStandards,      ///< Benchmarks, norm packs, rescoring under a new rubric.
    kExportPersonalData,
    kRequestErasure,
    kErase,        ///< Carry out a request for erasure.
    kUseStore,     ///< What everybody may who has signed in, such as to read what is published.
    kSetPassword,  ///< Of an account; also take its PIN away.
    kSetPin,       ///< Choose a PIN.
    kSaveAttempt,  ///< Also one that a crash left over.
    kRemark,       ///< On an attempt.
    kReplay,       ///< Keep what simulating an attempt again gave.
    kActAs,        ///< Sign a remark, a rating, an entry of the audit trail.
};

/// Whose data it is: the own, that of somebody within one's group (or in no group at all), or that
/// of somebody in groups of others only.
enum class Scope : uint8_t { kOwn, kOther, kGroup };

/// True when somebody with `roles` may do `action` on data of that scope.
[[nodiscard]] bool allowed(Roles roles, Action action, Scope scope) noexcept;

/// kGroup when `subject` is in no group, or in one that `actor` teaches. Throws StoreError.
[[nodiscard]] Scope scope_between(Store& store, int64_t actor, int64_t subject);

/// kGroup for its own educators, and for everybody while it has none.
[[nodiscard]] Scope scope_of_group(const GroupRecord& group, int64_t actor);

/// Ids of the people whom `actor` reaches: oneself, who is in no group, and who is in one that
/// `actor` teaches. One look at the groups for all of them; agrees with Groups::in_reach().
[[nodiscard]] std::vector<int64_t> reached_people(Store& store, int64_t actor);

/// Reason in plain words for a refusal, naming the role that could.
[[nodiscard]] Said refusal(Action action);
/// Whether it is one of these: it names roles, and nothing of the store.
[[nodiscard]] bool is_about_rights(const Said& said);

}  // namespace placode::db
