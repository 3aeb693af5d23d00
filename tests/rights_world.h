// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// People, groups, attempts and a study for the tests of who may do what: everybody who acts has
// data of their own, of their group and of others to reach for.

#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "curriculum/course.h"
#include "curriculum/definitions.h"
#include "curriculum/study.h"
#include "curriculum/task.h"
#include "db/study_conduct.h"
#include "tests/store_cases.h"

namespace placode::test {

/// Whose data a method is asked for. A study's belong to nobody: they count as the group's.
enum class Subject : uint8_t { kOwn, kGroup, kOther, kStudy };
inline constexpr std::array kSubjects{Subject::kOwn, Subject::kGroup, Subject::kOther,
                                      Subject::kStudy};

/// What there is of one person.
struct Belongings {
    int64_t person = 0, group = 0, attempt = 0, assignment = 0, remark = 0;
    std::string login;
};

/// A shipped text under another version: somebody has changed it. @param id of its own, if any.
inline std::string changed(const std::string& json, int version, const char* id = nullptr) {
    QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    object["version"] = version;
    if (id != nullptr) object["id"] = id;
    return QJsonDocument(object).toJson().toStdString();
}

/// Ids of everything that was put into the store.
struct RightsWorld {
    static constexpr const char* kStudy = "pilot";
    /// Logins of who act, each with one role; they all teach "Ours".
    static constexpr std::array<std::pair<const char*, db::Role>, 4> kActors{
        {{"trainee", db::Role::kTrainee},
         {"educator", db::Role::kEducator},
         {"coordinator", db::Role::kCoordinator},
         {"administrator", db::Role::kAdministrator}}};

    std::map<std::string, Belongings> of;  ///< By login.
    int64_t ours = 0, theirs = 0, free = 0, teacher = 0;
    std::string code, locked, item;
    int64_t answers = 0;

    [[nodiscard]] const Belongings& subject(const std::string& actor, Subject whose) const {
        return of.at(whose == Subject::kOwn     ? actor
                     : whose == Subject::kGroup ? "grouped"
                     : whose == Subject::kOther ? "stranger"
                                                : "loner");
    }

    void fill(db::Store& store, const TemporaryFolder& folder) {
        for (const auto& [login, role] : kActors) add(store, login, role);
        add(store, "spare", db::Role::kAdministrator);  // Another one has to stay.
        for (const char* login : {"grouped", "stranger", "loner"})
            add(store, login, db::Role::kTrainee);
        teacher = add(store, "teacher", db::Role::kEducator);
        ours = store.groups().create("Ours");
        theirs = store.groups().create("Theirs");
        free = store.groups().create("Free");
        for (const auto& [login, role] : kActors)
            store.groups().set_role(ours, of[login].person, db::GroupRole::kEducator);
        store.groups().set_role(ours, of["grouped"].person, db::GroupRole::kMember);
        store.groups().set_role(theirs, teacher, db::GroupRole::kEducator);
        store.groups().set_role(theirs, of["stranger"].person, db::GroupRole::kMember);
        publishCourse(store);
        write_recording(folder.file("one.placode"));
        for (auto& [login, mine] : of) {
            mine.group = login == "stranger" ? theirs : login == "loner" ? free : ours;
            addWork(store, folder, mine, login == "loner");
        }
        addStudy(store);
    }

 private:
    int64_t add(db::Store& store, const std::string& login, db::Role role) {
        db::NewUser user = trainee(login);
        user.roles = static_cast<db::Roles>(role);
        of[login].login = login;
        return of[login].person = store.accounts().create(user);
    }

    static void publishCourse(db::Store& store) {
        const curriculum::Course course = curriculum::load_course("first_steps");
        db::DefinitionRecord definition;
        definition.kind = "course";
        definition.id = course.id;
        definition.version = course.version;
        definition.json = course.json;
        store.definitions().publish(definition);
    }

    void addWork(db::Store& store, const TemporaryFolder& folder, Belongings& mine, bool study) {
        if (study) {
            code = store.studies().new_participant(kStudy);
            locked = store.studies().new_participant(kStudy);
        }
        db::AttemptResult result = make_result();
        // What a script did would be nobody's skill.
        result.header.demonstration = study;
        result.recording_file = folder.file("one.placode");
        if (study) result.study = {kStudy, code};
        mine.attempt = store.attempts().save(mine.person, result);
        db::AssignmentRecord assignment;
        assignment.course_id = "first_steps";
        assignment.course_version = curriculum::load_course("first_steps").version;
        assignment.user_id = mine.person;
        mine.assignment = store.courses().assign(assignment);
        mine.remark =
            store.reviews().add_comment({0, mine.attempt, teacher, "", -1, "Slower.", ""});
    }

    void addStudy(db::Store& store) {
        const auto sus = curriculum::load_questionnaire("sus");
        db::AnswerRecord record;
        record.study_id = kStudy;
        record.participant = code;
        record.questionnaire_id = "sus";
        for (const auto& each : sus.items) record.answers[each.id] = "4";
        item = sus.items.front().id;
        answers = db::submit_answers(store, sus, record);
        db::StepRecord step;
        step.study_id = kStudy;
        step.participant = code;
        step.step = "procedure";
        step.attempt_id = of["loner"].attempt;
        store.studies().record_step(step);
        store.records().lock(kStudy, locked);
    }
};

}  // namespace placode::test
