// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/access.h"

#include <array>

namespace placode::db {
namespace {

constexpr Roles kNobody = 0;
constexpr Roles kTrainee = static_cast<Roles>(Role::kTrainee);
constexpr Roles kEducator = static_cast<Roles>(Role::kEducator);
constexpr Roles kCoordinator = static_cast<Roles>(Role::kCoordinator);
constexpr Roles kAdministrator = static_cast<Roles>(Role::kAdministrator);
constexpr Roles kEverybody = kTrainee | kEducator | kCoordinator | kAdministrator;

struct Rule {
    Action action;
    Roles own, other;  ///< Roles that may, on their own data and on other people's.
    const char* what;
    const char* who;
};

// An administrator keeps accounts and therefore sees names, but no scores. A coordinator works with
// pseudonyms and therefore sees no names but the own one.
constexpr std::array<Rule, 8> kRules{{
    {Action::kPerformAttempt, kEverybody, kNobody, "perform an attempt",
     "everybody, in their own name"},
    {Action::kViewAttempts, kEverybody, kEducator, "see other people's attempts", "an educator"},
    {Action::kViewPersonalData, kEverybody, kEducator | kAdministrator,
     "see other people's personal data", "an educator or an administrator"},
    {Action::kManageUsers, kAdministrator, kAdministrator, "manage accounts", "an administrator"},
    {Action::kRunQuestionnaire, kCoordinator, kCoordinator, "have a questionnaire answered",
     "a coordinator"},
    {Action::kExportStudy, kCoordinator, kCoordinator, "export the data of a study",
     "a coordinator"},
    {Action::kBackup, kAdministrator, kAdministrator, "back up, restore or check the store",
     "an administrator"},
    {Action::kViewAudit, kAdministrator, kAdministrator, "see the audit trail", "an administrator"},
}};

const Rule* rule_of(Action action) noexcept {
    for (const Rule& rule : kRules)
        if (rule.action == action) return &rule;
    return nullptr;
}

}  // namespace

bool allowed(Roles roles, Action action, Scope scope) noexcept {
    const Rule* rule = rule_of(action);
    if (rule == nullptr) return false;
    return (roles & (scope == Scope::kOwn ? rule->own : rule->other)) != 0;
}

std::string refusal(Action action) {
    const Rule* rule = rule_of(action);
    if (rule == nullptr) return "nobody may do this";
    return std::string("you may not ") + rule->what + "; " + rule->who + " can";
}

}  // namespace placode::db
