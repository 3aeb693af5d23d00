// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store with a row in nearly every table, each put there by the program's own way: for tests of
// what has to reach all of them.

#include "curriculum/questionnaire.h"
#include "db/study_conduct.h"
#include "tests/recorded_attempt.h"
#include "tests/store_cases.h"

namespace placode::test {

struct FullStore {
    int64_t anna = 0, bert = 0, attempt_id = 0;

    /// @param other the same store, opened once more: somebody signs in there
    void fill(db::Store& store, db::Store& other, const TemporaryFolder& folder) {
        anna = store.accounts().create(trainee("anna"));
        db::NewUser teacher = trainee("bert");
        teacher.roles = static_cast<db::Roles>(db::Role::kAdministrator) |
                        static_cast<db::Roles>(db::Role::kEducator);
        bert = store.accounts().create(teacher);
        ASSERT_EQ(other.accounts().sign_in("bert", kPassword).outcome, db::SignInOutcome::kOk);
        store.act_as("bert");
        store.accounts().set_pin(anna, "4711");
        const int64_t group = store.groups().create("Spring");
        store.groups().set_role(group, anna, db::GroupRole::kMember);
        store.accounts().invite({0, 1, group, "for the spring", {}, {}, "2099-01-01", {}});
        fillAttempts(store, folder);
        db::GrantRecord grant;
        grant.user_id = anna;
        grant.course_id = "fetoscopy";
        grant.stage_id = "exam";
        grant.attempts = 2;
        grant.reason = "power cut";
        store.courses().grant_attempts(grant);
        store.accounts().request_erasure(anna, "moves away");
        db::AttemptResult of_study = make_result("scissors_resection");
        of_study.header.mode = "study";
        fillStudy(store, save_recorded(store, bert, of_study, folder.path().string()));
    }

 private:
    void fillAttempts(db::Store& store, const TemporaryFolder& folder) {
        write_recording(folder.file("one.placode"));
        db::AttemptResult result = make_result();
        result.recording_file = folder.file("one.placode");
        attempt_id = store.attempts().save(anna, result);
        db::RescoreRecord rescore;
        rescore.attempt_id = attempt_id;
        rescore.metrics = result.metrics;
        rescore.score = result.score;
        rescore.score.rubric_version = 5;
        store.attempts().save_rescore(rescore);
        db::CommentRecord comment;
        comment.attempt_id = attempt_id;
        comment.author_id = bert;
        comment.text = "slower here";
        store.reviews().add_comment(comment);
        db::RatingRecord rating;
        rating.attempt_id = attempt_id;
        rating.rater_id = bert;
        rating.questionnaire_id = "sus";
        rating.questionnaire_version = 1;
        rating.answers = {{"q1", "3"}};
        store.reviews().save_rating(rating);
    }

    static void fillStudy(db::Store& store, int64_t attempt) {
        const std::string code = store.studies().new_participant("pilot");
        const auto sus = curriculum::load_questionnaire("sus");
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        for (const auto& item : sus.items) record.answers[item.id] = "4";
        record.changes = {{sus.items[0].id, "3", "4", "2026-01-01T00:00:00Z"}};
        const int64_t answer = db::submit_answers(store, sus, record);
        store.records().correct_answers(answer, 1, {{sus.items[0].id, "2"}}, "a slip");
        store.records().save_second_entry({answer, record.answers, {}, {}});
        db::StepRecord step;
        step.study_id = "pilot";
        step.participant = code;
        step.step = "run";
        step.attempt_id = attempt;
        step.state = db::StepState::kDone;
        store.studies().record_step(step);
        store.records().note_step("pilot", code, 1, "run", "the lamp failed");
        store.records().repeat_step("pilot", code, 1, "run", "the lamp failed");
        store.studies().set_participant_device("pilot", code, "mouse");
        store.records().save_consent_signature("pilot", code, "M1 2 L3 4");
        store.records().lock("pilot", code);
        const std::string other = store.studies().new_participant("pilot");
        store.studies().withdraw("pilot", other, db::WithdrawalMode::kStop, "not given");
    }
};

}  // namespace placode::test
