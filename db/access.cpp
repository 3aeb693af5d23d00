// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/access.h"

#include <algorithm>
#include <array>
#include <set>

#include "db/store.h"

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
    Roles own, group, other;  ///< Roles that may, on their own data and on other people's.
    const char* what;
    const char* who;
};

// An administrator keeps accounts and therefore sees names, but no scores. A coordinator works with
// pseudonyms and therefore sees no names but the own one. An educator sees the attempts of the
// whole centre, and acts (assigns, judges, certifies) on the own groups and on people without a
// group.
constexpr std::array<Rule, 24> kRules{{
    {Action::kPerformAttempt, kEverybody, kNobody, kNobody, "perform an attempt",
     "everybody, in their own name"},
    {Action::kViewAttempts, kEverybody, kEducator, kEducator, "see other people's attempts",
     "an educator"},
    {Action::kViewPersonalData, kEverybody, kEducator | kAdministrator, kEducator | kAdministrator,
     "see other people's personal data", "an educator or an administrator"},
    {Action::kManageUsers, kAdministrator, kAdministrator, kAdministrator, "manage accounts",
     "an administrator"},
    {Action::kRunQuestionnaire, kCoordinator, kCoordinator, kCoordinator,
     "have a questionnaire answered", "a coordinator"},
    {Action::kExportStudy, kCoordinator, kCoordinator, kCoordinator, "export the data of a study",
     "a coordinator"},
    {Action::kBackup, kAdministrator, kAdministrator, kAdministrator,
     "back up, restore or check the store", "an administrator"},
    {Action::kViewAudit, kAdministrator, kAdministrator, kAdministrator, "see the audit trail",
     "an administrator"},
    {Action::kManageCourses, kEducator, kEducator, kEducator, "publish courses", "an educator"},
    {Action::kAssignCourses, kEducator, kEducator, kNobody,
     "assign courses to this person or group", "an educator of the group"},
    {Action::kManageGroups, kEducator | kAdministrator, kEducator | kAdministrator, kAdministrator,
     "change groups", "an educator of the group or an administrator"},
    {Action::kIssueCertificate, kEverybody, kEducator, kNobody, "issue this person's certificate",
     "the person, or an educator of the group,"},
    {Action::kReviewAttempts, kNobody, kEducator, kNobody, "review this person's attempts",
     "an educator of the group, not the person,"},
    {Action::kSetStandards, kEducator, kEducator, kEducator, "set standards or rescore",
     "an educator"},
    {Action::kExportPersonalData, kEverybody, kNobody, kNobody, "export another person's data",
     "the person"},
    {Action::kRequestErasure, kEverybody, kNobody, kNobody, "ask for another person's erasure",
     "the person"},
    {Action::kErase, kNobody, kAdministrator, kAdministrator, "erase a person",
     "an administrator, not the person,"},
    {Action::kUseStore, kEverybody, kEverybody, kEverybody, "use the store without signing in",
     "everybody who has signed in"},
    {Action::kSetPassword, kEverybody, kAdministrator, kAdministrator,
     "set another person's password", "the person or an administrator"},
    {Action::kSetPin, kEverybody, kNobody, kNobody, "choose another person's PIN", "the person"},
    {Action::kSaveAttempt, kEverybody, kAdministrator, kAdministrator,
     "save another person's attempt", "the person or an administrator"},
    {Action::kRemark, kEverybody, kEducator, kNobody, "remark on this person's attempts",
     "the person, or an educator of the group,"},
    {Action::kReplay, kNobody, kNobody, kNobody, "say what simulating an attempt again gave",
     "only the program itself"},
    {Action::kActAs, kEverybody, kNobody, kNobody, "act in another person's name", "the person"},
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
    const Roles may = scope == Scope::kOwn     ? rule->own
                      : scope == Scope::kGroup ? rule->group
                                               : rule->other;
    return (roles & may) != 0;
}

Scope scope_between(Store& store, int64_t actor, int64_t subject) {
    if (actor == subject) return Scope::kOwn;
    return store.groups().in_reach(actor, subject) ? Scope::kGroup : Scope::kOther;
}

Scope scope_of_group(const GroupRecord& group, int64_t actor) {
    const auto& all = group.educators;
    const bool teaches = std::find(all.begin(), all.end(), actor) != all.end();
    return teaches || all.empty() ? Scope::kGroup : Scope::kOther;
}

std::vector<int64_t> reached_people(Store& store, int64_t actor) {
    std::set<int64_t> grouped, taught;
    for (const GroupRecord& group : store.groups().list()) {
        const bool teaches = std::find(group.educators.begin(), group.educators.end(), actor) !=
                             group.educators.end();
        for (const auto* list : {&group.members, &group.educators})
            for (const int64_t id : *list) {
                grouped.insert(id);
                if (teaches) taught.insert(id);
            }
    }
    std::vector<int64_t> reached;
    for (const UserRecord& user : store.accounts().list())
        if (user.id == actor || !grouped.contains(user.id) || taught.contains(user.id))
            reached.push_back(user.id);
    return reached;
}

std::string refusal(Action action) {
    const Rule* rule = rule_of(action);
    if (rule == nullptr) return "nobody may do this";
    return std::string("you may not ") + rule->what + "; " + rule->who + " can";
}

}  // namespace placode::db
