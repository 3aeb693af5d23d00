// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/access.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "db/said.h"
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
    {Action::kPerformAttempt, kEverybody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "perform an attempt"),
     QT_TRANSLATE_NOOP("Said", "everybody, in their own name")},
    {Action::kViewAttempts, kEverybody, kEducator, kEducator,
     QT_TRANSLATE_NOOP("Said", "see other people's attempts"),
     QT_TRANSLATE_NOOP("Said", "an educator")},
    {Action::kViewPersonalData, kEverybody, kEducator | kAdministrator, kEducator | kAdministrator,
     QT_TRANSLATE_NOOP("Said", "see other people's personal data"),
     QT_TRANSLATE_NOOP("Said", "an educator or an administrator")},
    {Action::kManageUsers, kAdministrator, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "manage accounts"), QT_TRANSLATE_NOOP("Said", "an administrator")},
    {Action::kRunQuestionnaire, kCoordinator, kCoordinator, kCoordinator,
     QT_TRANSLATE_NOOP("Said", "have a questionnaire answered"),
     QT_TRANSLATE_NOOP("Said", "a coordinator")},
    {Action::kExportStudy, kCoordinator, kCoordinator, kCoordinator,
     QT_TRANSLATE_NOOP("Said", "export the data of a study"),
     QT_TRANSLATE_NOOP("Said", "a coordinator")},
    {Action::kBackup, kAdministrator, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "back up, restore or check the store"),
     QT_TRANSLATE_NOOP("Said", "an administrator")},
    {Action::kViewAudit, kAdministrator, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "see the audit trail"),
     QT_TRANSLATE_NOOP("Said", "an administrator")},
    {Action::kManageCourses, kEducator, kEducator, kEducator,
     QT_TRANSLATE_NOOP("Said", "publish courses"), QT_TRANSLATE_NOOP("Said", "an educator")},
    {Action::kAssignCourses, kEducator, kEducator, kNobody,
     QT_TRANSLATE_NOOP("Said", "assign courses to this person or group"),
     QT_TRANSLATE_NOOP("Said", "an educator of the group")},
    {Action::kManageGroups, kEducator | kAdministrator, kEducator | kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "change groups"),
     QT_TRANSLATE_NOOP("Said", "an educator of the group or an administrator")},
    {Action::kIssueCertificate, kEverybody, kEducator, kNobody,
     QT_TRANSLATE_NOOP("Said", "issue this person's certificate"),
     QT_TRANSLATE_NOOP("Said", "the person, or an educator of the group,")},
    {Action::kReviewAttempts, kNobody, kEducator, kNobody,
     QT_TRANSLATE_NOOP("Said", "review this person's attempts"),
     QT_TRANSLATE_NOOP("Said", "an educator of the group, not the person,")},
    {Action::kSetStandards, kEducator, kEducator, kEducator,
     QT_TRANSLATE_NOOP("Said", "set standards or rescore"),
     QT_TRANSLATE_NOOP("Said", "an educator")},
    {Action::kExportPersonalData, kEverybody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "export another person's data"),
     QT_TRANSLATE_NOOP("Said", "the person")},
    {Action::kRequestErasure, kEverybody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "ask for another person's erasure"),
     QT_TRANSLATE_NOOP("Said", "the person")},
    {Action::kErase, kNobody, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "erase a person"),
     QT_TRANSLATE_NOOP("Said", "an administrator, not the person,")},
    {Action::kUseStore, kEverybody, kEverybody, kEverybody,
     QT_TRANSLATE_NOOP("Said", "use the store without signing in"),
     QT_TRANSLATE_NOOP("Said", "everybody who has signed in")},
    {Action::kSetPassword, kEverybody, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "set another person's password"),
     QT_TRANSLATE_NOOP("Said", "the person or an administrator")},
    {Action::kSetPin, kEverybody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "choose another person's PIN"),
     QT_TRANSLATE_NOOP("Said", "the person")},
    {Action::kSaveAttempt, kEverybody, kAdministrator, kAdministrator,
     QT_TRANSLATE_NOOP("Said", "save another person's attempt"),
     QT_TRANSLATE_NOOP("Said", "the person or an administrator")},
    {Action::kRemark, kEverybody, kEducator, kNobody,
     QT_TRANSLATE_NOOP("Said", "remark on this person's attempts"),
     QT_TRANSLATE_NOOP("Said", "the person, or an educator of the group,")},
    {Action::kReplay, kNobody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "say what simulating an attempt again gave"),
     QT_TRANSLATE_NOOP("Said", "only the program itself")},
    {Action::kActAs, kEverybody, kNobody, kNobody,
     QT_TRANSLATE_NOOP("Said", "act in another person's name"),
     QT_TRANSLATE_NOOP("Said", "the person")},
}};

constexpr const char* kMayNot = QT_TRANSLATE_NOOP("Said", "you may not %1; %2 can");

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

Said refusal(Action action) {
    const Rule* rule = rule_of(action);
    if (rule == nullptr) return Said::as_is(std::string("nobody may do this"));
    return Said::listed(kMayNot).with(Said::listed(rule->what)).with(Said::listed(rule->who));
}

bool is_about_rights(const Said& said) {
    return said.sentence() != nullptr && std::string_view(said.sentence()) == kMayNot;
}

}  // namespace placode::db
