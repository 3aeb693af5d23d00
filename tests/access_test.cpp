// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/access.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "db/said.h"

using namespace placode::db;

namespace THIS_TEST {

constexpr std::array kActions{Action::kPerformAttempt,
                              Action::kViewAttempts,
                              Action::kViewPersonalData,
                              Action::kManageUsers,
                              Action::kRunQuestionnaire,
                              Action::kExportStudy,
                              Action::kBackup,
                              Action::kViewAudit,
                              Action::kManageCourses,
                              Action::kAssignCourses,
                              Action::kManageGroups,
                              Action::kIssueCertificate,
                              Action::kReviewAttempts,
                              Action::kSetStandards,
                              Action::kExportPersonalData,
                              Action::kRequestErasure,
                              Action::kErase,
                              Action::kUseStore,
                              Action::kSetPassword,
                              Action::kSetPin,
                              Action::kSaveAttempt,
                              Action::kRemark,
                              Action::kReplay,
                              Action::kActAs};
constexpr std::array kScopes{Scope::kOwn, Scope::kGroup, Scope::kOther};

// Written out once more by hand, role by role: the table in access.cpp is by action. Each action
// with the scopes in which the role may: o = own, g = group, x = other.
using Rights = std::map<Action, std::string>;
const Rights kOwnOnly{{Action::kPerformAttempt, "o"},
                      {Action::kViewAttempts, "o"},
                      {Action::kViewPersonalData, "o"},
                      {Action::kIssueCertificate, "o"},
                      {Action::kExportPersonalData, "o"},
                      {Action::kRequestErasure, "o"},
                      {Action::kUseStore, "ogx"},
                      {Action::kSetPassword, "o"},
                      {Action::kSetPin, "o"},
                      {Action::kSaveAttempt, "o"},
                      {Action::kRemark, "o"},
                      {Action::kActAs, "o"}};

Rights with(const Rights& more) {
    Rights rights = kOwnOnly;
    for (const auto& [action, scopes] : more) rights[action] = scopes;
    return rights;
}

const std::map<Role, Rights>& expected() {
    static const std::map<Role, Rights> rights{
        {Role::kTrainee, kOwnOnly},
        {Role::kEducator, with({{Action::kViewAttempts, "ogx"},
                                {Action::kViewPersonalData, "ogx"},
                                {Action::kManageCourses, "ogx"},
                                {Action::kSetStandards, "ogx"},
                                {Action::kAssignCourses, "og"},
                                {Action::kManageGroups, "og"},
                                {Action::kIssueCertificate, "og"},
                                {Action::kReviewAttempts, "g"},
                                {Action::kRemark, "og"}})},
        {Role::kCoordinator,
         with({{Action::kRunQuestionnaire, "ogx"}, {Action::kExportStudy, "ogx"}})},
        {Role::kAdministrator, with({{Action::kManageUsers, "ogx"},
                                     {Action::kViewPersonalData, "ogx"},
                                     {Action::kBackup, "ogx"},
                                     {Action::kViewAudit, "ogx"},
                                     {Action::kManageGroups, "ogx"},
                                     {Action::kErase, "gx"},
                                     {Action::kSetPassword, "ogx"},
                                     {Action::kSaveAttempt, "ogx"}})}};
    return rights;
}

bool expects(const Rights& rights, Action action, Scope scope) {
    const auto found = rights.find(action);
    const char letter = scope == Scope::kOwn ? 'o' : scope == Scope::kGroup ? 'g' : 'x';
    return found != rights.end() && found->second.find(letter) != std::string::npos;
}

TEST(Access, EveryRoleMayDoExactlyWhatIsItsOwn) {
    for (const auto& [role, rights] : expected()) {
        for (const Action action : kActions)
            for (const Scope scope : kScopes)
                EXPECT_EQ(allowed(static_cast<Roles>(role), action, scope),
                          expects(rights, action, scope))
                    << "role " << int(role) << " action " << int(action) << " scope " << int(scope);
    }
}

TEST(Access, WithoutARoleNothingIsAllowed) {
    for (const Action action : kActions)
        for (const Scope scope : kScopes) EXPECT_FALSE(allowed(0, action, scope));
}

TEST(Access, TwoRolesAddUp) {
    const Roles both = static_cast<Roles>(Role::kEducator) | static_cast<Roles>(Role::kCoordinator);
    EXPECT_TRUE(allowed(both, Action::kViewAttempts, Scope::kOther));
    EXPECT_TRUE(allowed(both, Action::kExportStudy, Scope::kOther));
    EXPECT_FALSE(allowed(both, Action::kManageUsers, Scope::kOther));
}

TEST(Access, AnUnknownActionIsAllowedToNobody) {
    EXPECT_FALSE(allowed(0xff, static_cast<Action>(200), Scope::kOwn));
}

TEST(Access, ARefusalNamesTheRoleThatCould) {
    EXPECT_NE(refusal(Action::kViewAttempts).english().find("educator"), std::string::npos);
    EXPECT_NE(refusal(Action::kExportStudy).english().find("coordinator"), std::string::npos);
    EXPECT_TRUE(is_about_rights(refusal(Action::kViewAttempts)));
    EXPECT_FALSE(is_about_rights(Said::that("you may not")));
    EXPECT_FALSE(is_about_rights(Said::as_is("you may not %1; %2 can")));
    EXPECT_NE(refusal(Action::kBackup).english().find("administrator"), std::string::npos);
}

}  // namespace THIS_TEST
