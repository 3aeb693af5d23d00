// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// rights_of_methods.h, for studies, their records, the audit trail and the store itself.

#include "tests/rights_of_training.h"

namespace placode::test {

inline std::vector<Method> methods_of_studies() {
    constexpr const char* kStudy = RightsWorld::kStudy;
    const std::vector<Needed> runs{{Action::kRunQuestionnaire}};
    const std::vector<Action> reads{Action::kRunQuestionnaire, Action::kExportStudy};
    return {
        {"studies.ids",
         {},
         {Action::kRunQuestionnaire, Action::kExportStudy, Action::kViewAudit},
         [](Call& c) { (void)c.store.studies().ids(); }},
        {"studies.with_participants",
         {},
         reads,
         [](Call& c) { (void)c.store.studies().with_participants(); }},
        {"studies.new_participant",
         runs,
         {},
         [](Call& c) { c.store.studies().new_participant(kStudy); }},
        {"studies.participants",
         {},
         reads,
         [](Call& c) { (void)c.store.studies().participants(kStudy); }},
        {"studies.set_participant_device",
         runs,
         {},
         [](Call& c) { c.store.studies().set_participant_device(kStudy, c.world.code, "mouse"); }},
        {"studies.record_step",
         runs,
         {},
         [](Call& c) {
             db::StepRecord step;
             step.study_id = kStudy;
             step.participant = c.world.code;
             step.step = "another";
             c.store.studies().record_step(step);
         }},
        {"studies.steps",
         {},
         {Action::kRunQuestionnaire, Action::kExportStudy, Action::kViewAttempts},
         [](Call& c) { (void)c.store.studies().steps(kStudy); }},
        {"studies.save_answers",
         runs,
         {},
         [](Call& c) {
             db::AnswerRecord record;
             record.study_id = kStudy;
             record.participant = c.world.code;
             record.questionnaire_id = "osats";
             c.store.studies().save_answers(record);
         }},
        {"studies.answers", {}, reads, [](Call& c) { (void)c.store.studies().answers(kStudy); }},
        {"studies.withdraw",
         runs,
         {},
         [](Call& c) {
             c.store.studies().withdraw(kStudy, c.world.code, db::WithdrawalMode::kErase, "asked");
         }},
        {"studies.erase_kept",
         runs,
         {},
         [](Call& c) {
             c.store.studies().erase_kept(kStudy, c.world.code, "2020-01-01T00:00:00Z");
         }},
    };
}

inline std::vector<Method> methods_of_records() {
    constexpr const char* kStudy = RightsWorld::kStudy;
    const std::vector<Needed> runs{{Action::kRunQuestionnaire}};
    const std::vector<Action> reads{Action::kRunQuestionnaire, Action::kExportStudy};
    return {
        {"records.lock", runs, {}, [](Call& c) { c.store.records().lock(kStudy, c.world.code); }},
        {"records.sign",
         runs,
         {},
         [](Call& c) {
             c.store.records().sign(kStudy, c.world.locked, "coordinator", kPassword, "read");
         }},
        {"records.unlock",
         runs,
         {},
         [](Call& c) { c.store.records().unlock(kStudy, c.world.locked, "a slip"); }},
        {"records.events", {}, reads, [](Call& c) { (void)c.store.records().events(kStudy); }},
        {"records.states", {}, reads, [](Call& c) { (void)c.store.records().states(kStudy); }},
        {"records.correct_answers",
         runs,
         {},
         [](Call& c) {
             c.store.records().correct_answers(c.world.answers, 1, {{c.world.item, "2"}}, "a slip");
         }},
        {"records.corrections",
         {},
         reads,
         [](Call& c) { (void)c.store.records().corrections(kStudy); }},
        {"records.save_second_entry",
         runs,
         {},
         [](Call& c) {
             db::SecondEntry entry;
             entry.answer_id = c.world.answers;
             for (const auto& each : curriculum::load_questionnaire("sus").items)
                 entry.answers[each.id] = "3";
             c.store.records().save_second_entry(entry);
         }},
        {"records.second_entries",
         {},
         reads,
         [](Call& c) { (void)c.store.records().second_entries(kStudy); }},
        {"records.repeat_step",
         runs,
         {},
         [](Call& c) {
             c.store.records().repeat_step(kStudy, c.world.code, 1, "procedure", "a power cut");
         }},
        {"records.note_step",
         runs,
         {},
         [](Call& c) {
             c.store.records().note_step(kStudy, c.world.code, 1, "procedure", "left-handed");
         }},
        {"records.step_notes",
         {},
         reads,
         [](Call& c) { (void)c.store.records().step_notes(kStudy); }},
        {"records.save_consent_signature",
         runs,
         {},
         [](Call& c) {
             c.store.records().save_consent_signature(kStudy, c.world.code, "M0 0L1 1");
         }},
        {"records.consent_signature",
         {},
         reads,
         [](Call& c) { (void)c.store.records().consent_signature(kStudy, c.world.code); }},
    };
}

inline std::vector<Method> methods_of_the_store() {
    const std::vector<Needed> uses{{Action::kUseStore}};
    return {
        {"audit.write",
         {{Action::kActAs, About::kPerson}},
         {},
         [](Call& c) {
             // As pages and commands do, or did: a log-in, a name, a path.
             c.store.audit().write(
                 c.subject.login, "export", "user " + c.subject.login,
                 "/home/" + c.subject.login + "/x.pdf, for Name of " + c.subject.login);
         }},
        {"audit.trail",
         {{Action::kViewAudit}},
         {},
         [](Call& c) { (void)c.store.audit().trail(3); }},
        {"audit.of_action",
         {{Action::kViewAudit}},
         {},
         [](Call& c) { (void)c.store.audit().of_action("sign_in"); }},
        {"audit.naming",
         {{Action::kViewAudit}},
         {},
         [](Call& c) { (void)c.store.audit().naming({c.subject.login}); }},
        {"audit.set_aside",
         {{Action::kManageUsers}},
         {},
         [](Call& c) { c.store.audit().set_aside(1, "it fits"); },
         false,
         true},
        {"audit.first", uses, {}, [](Call& c) { (void)c.store.audit().first(); }},
        {"audit.stations",
         {{Action::kViewAudit}},
         {},
         [](Call& c) { (void)c.store.audit().stations(); }},
        {"audit.trusted_keys",
         {{Action::kViewAudit}},
         {},
         [](Call& c) { (void)c.store.audit().trusted_keys(); }},
        {"audit.own_station", uses, {}, [](Call& c) { (void)c.store.audit().own_station(); }},
        {"audit.standing_of",
         uses,
         {},
         [](Call& c) { (void)c.store.audit().standing_of(std::string(64, '0')); }},
        {"audit.trust_station",
         {{Action::kManageUsers}},
         {},
         [](Call& c) { c.store.audit().trust_station(db::new_key_pair().public_key); }},
        {"audit.head", {{Action::kBackup}}, {}, [](Call& c) { (void)c.store.audit().head(); }},
        {"audit.check_head",
         {{Action::kBackup}},
         {},
         [](Call& c) {
             std::vector<std::string> problems;
             c.store.audit().check_head({}, problems);
         }},
        {"audit.check_chain",
         {{Action::kBackup}},
         {},
         [](Call& c) {
             std::vector<std::string> problems;
             c.store.audit().check_chain(problems);
         }},
        {"store.check", {{Action::kBackup}}, {}, [](Call& c) { (void)c.store.check(); }},
        {"store.role_problems",
         {{Action::kBackup}},
         {},
         [](Call& c) { (void)c.store.role_problems(); }},
        {"store.give_station_role",
         {{Action::kActAs}},
         {},
         [](Call& c) { c.store.give_station_role(); },
         false,
         true},  // A file has no log-ins, and a station is not the owner.
        {"store.backup",
         {{Action::kBackup}},
         {},
         [](Call& c) { c.store.backup(c.file); },
         false,
         true},  // A station is not the owner of the tables.
        {"store.move_to",
         {{Action::kBackup}},
         {},
         [](Call& c) {
             db::MoveOptions look;
             look.dry_run = true;
             (void)c.store.move_to("sqlite:" + c.file, look);
         },
         false,
         true},  // A file moves to a server only, and a station is not the owner.
        {"store.url", {}, {}, [](Call& c) { (void)c.store.url(); }},
        {"store.act_as",  // A program's name is the program's.
         {{Action::kReplay}},
         {},
         [](Call& c) { c.store.act_as("somebody else"); }},
        {"store.act_for",
         {{Action::kActAs, About::kPerson}},
         {},
         [](Call& c) { c.store.act_for(c.subject.person); }},
        {"store.sign_out", {}, {}, [](Call& c) { c.store.sign_out(); }},
    };
}

inline std::vector<Method> all_methods() {
    std::vector<Method> all;
    for (const auto& part : {methods_of_accounts(), methods_of_attempts(), methods_of_training(),
                             methods_of_definitions(), methods_of_studies(), methods_of_records(),
                             methods_of_the_store()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace placode::test
