// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every public method of the store with what it asks for, and a call of it. A method that is not
// listed here fails store_rights_test, which calls all of them for everybody.

#include <functional>
#include <string>
#include <vector>

#include "db/access.h"
#include "tests/rights_world.h"

namespace placode::test {

using db::Action;

/// Of what the action is asked: of nothing in particular, of a group that nobody teaches, or of the
/// subject's person, group, or attempt.
enum class About : uint8_t { kNothing, kNewGroup, kPerson, kGroup, kAttempt };

struct Needed {
    Action action;
    About about = About::kNothing;
};

/// What a call may reach for.
struct Call {
    db::Store& store;
    const RightsWorld& world;
    const Belongings& subject;
    int64_t me = 0;    ///< Who acts; for a program the educator, for nobody 0.
    std::string file;  ///< A name for a file that is not there.
    std::string recording;
};

struct Method {
    const char* name = "";       ///< "accounts.create"
    std::vector<Needed> needs;   ///< All of them; none: also nobody may.
    std::vector<Action> either;  ///< And one of these, on anybody's data, where there are any.
    std::function<void(Call&)> call;
    /// Who sees an attempt: kViewAttempts of its owner, and of a study either that of everybody's
    /// or kRunQuestionnaire.
    bool sight = false;
    bool fails = false;  ///< Also for who may: there is nothing to do it with.
};

inline std::vector<Method> methods_of_accounts() {
    const std::vector<Needed> manages{{Action::kManageUsers}};
    return {
        {"accounts.create",
         manages,
         {},
         [](Call& c) { c.store.accounts().create(trainee("new")); }},
        {"accounts.create_all",
         manages,
         {},
         [](Call& c) {
             size_t at = 0;
             c.store.accounts().create_all({{trainee("listed"), 0}}, at);
         }},
        {"accounts.sign_in",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().sign_in(c.subject.login, kPassword); }},
        {"accounts.confirm",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.accounts().confirm(c.subject.login, kPassword); }},
        {"accounts.set_password",
         {{Action::kSetPassword, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().set_password(c.subject.person, "quiet river 77"); }},
        {"accounts.set_active",
         {{Action::kManageUsers, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().set_active(c.subject.person, false); }},
        {"accounts.set_roles",
         {{Action::kManageUsers, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().set_roles(c.subject.person, 3); }},
        {"accounts.list",
         {{Action::kViewPersonalData}},
         {},
         [](Call& c) { (void)c.store.accounts().list(); }},
        {"accounts.find",
         {{Action::kViewPersonalData, About::kPerson}},
         {},
         [](Call& c) { (void)c.store.accounts().find(c.subject.person); }},
        {"accounts.find_login",
         {{Action::kViewPersonalData, About::kPerson}},
         {},
         [](Call& c) { (void)c.store.accounts().find_login(c.subject.login); }},
        {"accounts.find_staff",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.accounts().find_staff("teacher"); }},
        {"accounts.any", {}, {}, [](Call& c) { (void)c.store.accounts().any(); }},
        {"accounts.may_sign_in",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().may_sign_in(c.subject.login); }},
        {"accounts.demonstrators",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().demonstrators(); }},
        {"accounts.begin_alone",
         manages,
         {},
         [](Call& c) { c.store.accounts().begin_alone("Guest"); },
         false,
         true},
        {"accounts.local_profile",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().local_profile(); }},
        {"accounts.enter", {}, {}, [](Call& c) { (void)c.store.accounts().enter(); }},
        {"accounts.name_local_profile",
         {{Action::kUseStore}},
         {},
         [](Call& c) { c.store.accounts().name_local_profile(trainee("new")); },
         false,
         true},
        {"accounts.set_pin",
         {{Action::kSetPin, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().set_pin(c.subject.person, "2580"); }},
        {"accounts.set_pin",
         {{Action::kSetPassword, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().set_pin(c.subject.person, ""); }},
        {"accounts.has_pin",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().has_pin(c.subject.person); }},
        {"accounts.unlock",
         {},
         {},
         [](Call& c) { (void)c.store.accounts().unlock(c.subject.person, "2580"); }},
        {"accounts.invite",
         manages,
         {},
         [](Call& c) {
             c.store.accounts().invite({0, 1, 0, "", {}, {}, "2099-01-01", {}});
         }},
        {"accounts.invitations",
         manages,
         {},
         [](Call& c) { (void)c.store.accounts().invitations(); }},
        {"accounts.accept_invitation",
         {},
         {},
         [](Call& c) { c.store.accounts().accept_invitation("no code", trainee("new")); },
         false,
         true},
        {"accounts.request_erasure",
         {{Action::kRequestErasure, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().request_erasure(c.subject.person, "I leave."); }},
        {"accounts.erasure_requests",  // Others get the own one: TheOwnOfListsIsGiven.
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.accounts().erasure_requests(); }},
        {"accounts.erase",
         {{Action::kErase, About::kPerson}},
         {},
         [](Call& c) { c.store.accounts().erase(c.subject.person, true); }},
    };
}

inline std::vector<Method> methods_of_attempts() {
    const std::vector<Needed> all{{Action::kViewAttempts}};
    const std::vector<Needed> persons{{Action::kViewAttempts, About::kPerson}};
    return {
        {"attempts.save",
         {{Action::kSaveAttempt, About::kPerson}},
         {},
         [](Call& c) { c.store.attempts().save(c.subject.person, make_result()); }},
        {"attempts.save",
         {{Action::kRunQuestionnaire}},
         {},
         [](Call& c) {
             db::AttemptResult result = make_result();
             result.study = {RightsWorld::kStudy, c.world.code};
             c.store.attempts().save(c.subject.person, result);
         }},
        {"attempts.list", all, {}, [](Call& c) { (void)c.store.attempts().list(0); }},
        {"attempts.list",
         persons,
         {},
         [](Call& c) { (void)c.store.attempts().list(c.subject.person); }},
        {"attempts.detail",
         {},
         {},
         [](Call& c) { (void)c.store.attempts().detail(c.subject.attempt); },
         true},
        {"attempts.details",
         {},
         {},
         [](Call& c) { (void)c.store.attempts().details({c.subject.attempt}); },
         true},
        {"attempts.records",
         {},
         {},
         [](Call& c) { (void)c.store.attempts().records({c.subject.attempt}); },
         true},
        {"attempts.owner_of",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.attempts().owner_of(c.subject.attempt); }},
        {"attempts.extract_recording",
         {},
         {},
         [](Call& c) { c.store.attempts().extract_recording(c.subject.attempt, c.file); },
         true},
        {"attempts.find_recording",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.attempts().find_recording(c.recording); }},
        {"attempts.waiting_for_replay",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.attempts().waiting_for_replay(); }},
        {"attempts.never_replayed",
         {{Action::kUseStore}},
         {},
         [](Call& c) { (void)c.store.attempts().never_replayed(); }},
        {"attempts.was_read",
         {{Action::kReplay}},
         {},
         [](Call& c) { (void)c.store.attempts().was_read(c.subject.attempt); }},
        {"attempts.set_read",
         {{Action::kReplay}},
         {},
         [](Call& c) { c.store.attempts().set_read(c.subject.attempt); }},
        {"attempts.judges_replay",
         {{Action::kReplay}},
         {},
         [](Call& c) { (void)c.store.attempts().judges_replay(c.subject.attempt); }},
        {"attempts.doubt_about",
         {{Action::kReplay}},
         {},
         [](Call& c) { (void)c.store.attempts().doubt_about(c.subject.attempt, c.recording); }},
        {"attempts.set_replay",
         {{Action::kReplay}},
         {},
         [](Call& c) {
             c.store.attempts().set_replay(c.subject.attempt, db::ReplayState::kIdentical);
         }},
        {"attempts.check_recordings",
         {{Action::kBackup}},
         {},
         [](Call& c) {
             std::vector<std::string> problems;
             c.store.attempts().check_recordings(problems);
         }},
        {"attempts.save_rescore",
         {{Action::kSetStandards}},
         {},
         [](Call& c) {
             db::RescoreRecord rescore;
             rescore.attempt_id = c.subject.attempt;
             rescore.score.rubric_id = "ring";
             rescore.score.rubric_version = 77;
             c.store.attempts().save_rescore(rescore);
         }},
        {"attempts.rescores",
         {},
         {},
         [](Call& c) { (void)c.store.attempts().rescores(c.subject.attempt); },
         true},
        {"attempts.page", all, {}, [](Call& c) { (void)c.store.attempts().page({}); }},
        {"attempts.page",
         persons,
         {},
         [](Call& c) {
             db::AttemptFilter filter;
             filter.user_id = c.subject.person;
             (void)c.store.attempts().page(filter);
         }},
        {"attempts.points", all, {}, [](Call& c) { (void)c.store.attempts().points(0); }},
        {"attempts.tasks", all, {}, [](Call& c) { (void)c.store.attempts().tasks(); }},
        {"attempts.standings", all, {}, [](Call& c) { (void)c.store.attempts().standings(0); }},
        {"attempts.recent_means",
         all,
         {},
         [](Call& c) { (void)c.store.attempts().recent_means("diathermy_ring", 3); }},
    };
}

}  // namespace placode::test
