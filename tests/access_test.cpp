// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/access.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

using namespace placode::db;

namespace {

constexpr std::array kActions{Action::kPerformAttempt,   Action::kViewAttempts,
                              Action::kViewPersonalData, Action::kManageUsers,
                              Action::kRunQuestionnaire, Action::kExportStudy,
                              Action::kBackup,           Action::kViewAudit};

using Right = std::pair<Action, Scope>;

// Written out once more by hand, role by role: the table in access.cpp is by action.
const std::map<Role, std::set<Right>>& expected() {
    static const std::set<Right> own{{Action::kPerformAttempt, Scope::kOwn},
                                     {Action::kViewAttempts, Scope::kOwn},
                                     {Action::kViewPersonalData, Scope::kOwn}};
    static const auto with = [](std::set<Right> more) {
        more.insert(own.begin(), own.end());
        return more;
    };
    static const std::map<Role, std::set<Right>> rights{
        {Role::kTrainee, own},
        {Role::kEducator, with({{Action::kViewAttempts, Scope::kOther},
                                {Action::kViewPersonalData, Scope::kOther}})},
        {Role::kCoordinator, with({{Action::kRunQuestionnaire, Scope::kOwn},
                                   {Action::kRunQuestionnaire, Scope::kOther},
                                   {Action::kExportStudy, Scope::kOwn},
                                   {Action::kExportStudy, Scope::kOther}})},
        {Role::kAdministrator, with({{Action::kManageUsers, Scope::kOwn},
                                     {Action::kManageUsers, Scope::kOther},
                                     {Action::kViewPersonalData, Scope::kOther},
                                     {Action::kBackup, Scope::kOwn},
                                     {Action::kBackup, Scope::kOther},
                                     {Action::kViewAudit, Scope::kOwn},
                                     {Action::kViewAudit, Scope::kOther}})}};
    return rights;
}

}  // namespace

TEST(Access, EveryRoleMayDoExactlyWhatIsItsOwn) {
    for (const auto& [role, rights] : expected()) {
        for (const Action action : kActions)
            for (const Scope scope : {Scope::kOwn, Scope::kOther})
                EXPECT_EQ(allowed(static_cast<Roles>(role), action, scope),
                          rights.contains({action, scope}))
                    << "role " << int(role) << " action " << int(action) << " scope " << int(scope);
    }
}

TEST(Access, WithoutARoleNothingIsAllowed) {
    for (const Action action : kActions)
        for (const Scope scope : {Scope::kOwn, Scope::kOther})
            EXPECT_FALSE(allowed(0, action, scope));
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
    EXPECT_NE(refusal(Action::kViewAttempts).find("educator"), std::string::npos);
    EXPECT_NE(refusal(Action::kExportStudy).find("coordinator"), std::string::npos);
    EXPECT_NE(refusal(Action::kBackup).find("administrator"), std::string::npos);
}
