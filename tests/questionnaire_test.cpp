// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/questionnaire.h"

#include <gtest/gtest.h>

#include <fstream>

namespace placode::curriculum {
namespace THIS_TEST {

Questionnaire sample() {
    Questionnaire q;
    q.id = "sample";
    q.items.resize(4);
    q.items[0].id = "A";
    q.items[1].id = "age";
    q.items[1].kind = ItemKind::kNumber;
    q.items[1].number_min = 18;
    q.items[1].number_max = 120;
    q.items[2].id = "choice";
    q.items[2].kind = ItemKind::kChoice;
    q.items[2].choices = {{"yes", "tak"}, {"no", "nie"}};
    q.items[2].required = false;
    q.items[3].id = "comment";
    q.items[3].kind = ItemKind::kText;
    q.items[3].required = false;
    return q;
}

TEST(Questionnaire, ShipsTheSeedPapersItemsWordForWord) {
    const Questionnaire q = load_questionnaire("face_validity");
    const std::vector<std::pair<std::string, std::string>> printed{
        {"A", "Rate the realism of the behaviour of virtual tissue"},
        {"B", "Rate the realism of the behaviour of virtual laparoscopes"},
        {"C", "Rate the realism of the interactions between virtual laparoscopes and tissues"},
        {"D", "Rate the realism of the laparoscopic hardware (how realistic it feels)"},
        {"E", "Rate the visual realism of the simulator (how realistic it looks)"},
        {"F", "Rate the overall realism of the simulator"}};
    ASSERT_GE(q.items.size(), printed.size());
    for (size_t i = 0; i < printed.size(); ++i) {
        const QuestionnaireItem& item = q.items[i];
        EXPECT_EQ(item.id, printed[i].first);
        EXPECT_EQ(item.text.en, printed[i].second);
        EXPECT_FALSE(item.text.pl.empty());
        EXPECT_EQ(item.kind, ItemKind::kLikert);
        EXPECT_EQ(item.scale_min, 1);
        EXPECT_EQ(item.scale_max, 5);
        EXPECT_EQ(item.anchor_low.en, "very unrealistic");
        EXPECT_EQ(item.anchor_high.en, "very realistic");
        EXPECT_TRUE(item.required);
    }
}

TEST(Questionnaire, CallsAQuestionAsTheParticipantSeesIt) {
    Questionnaire q = sample();
    EXPECT_EQ(question_mark(q, q.items[0]), "A");  // as it was printed
    EXPECT_EQ(question_mark(q, q.items[1]), "1");
    EXPECT_EQ(question_mark(q, q.items[3]), "3");
    q.items[2].show_if = ShowIf{"age", {"30"}};
    const Answers hides{{"age", "31"}}, shows{{"age", "30"}};
    EXPECT_EQ(question_mark(q, q.items[3], &hides), "2") << "a hidden question leaves no gap";
    EXPECT_EQ(question_mark(q, q.items[3], &shows), "3");
}

TEST(Questionnaire, AcceptsACompleteSetOfAnswers) {
    EXPECT_FALSE(check_answers(sample(), {{"A", "5"}, {"age", "42.5"}, {"choice", "1"}}));
    EXPECT_FALSE(check_answers(sample(), {{"A", "1"}, {"age", "18"}, {"comment", "=1+1"}}));
}

std::string problem_of(const Questionnaire& questionnaire, const Answers& answers) {
    const auto problem = check_answers(questionnaire, answers);
    return problem ? problem->english() : "";
}

TEST(Questionnaire, SaysWhichAnswerIsWrongAndWhy) {
    const Questionnaire q = sample();
    EXPECT_EQ(problem_of(q, {{"age", "40"}}), "item A needs an answer");
    EXPECT_EQ(problem_of(q, {{"A", ""}, {"age", "40"}}), "item A needs an answer");
    EXPECT_EQ(problem_of(q, {{"A", "6"}, {"age", "40"}}), "item A: 6 is above 5");
    EXPECT_EQ(problem_of(q, {{"A", "0"}, {"age", "40"}}), "item A: 0 is below 1");
    EXPECT_EQ(problem_of(q, {{"A", "2.5"}, {"age", "40"}}), "item A: 2.5 is not a whole number");
    EXPECT_EQ(problem_of(q, {{"A", "4"}, {"age", "190"}}), "item age: 190 is above 120");
    EXPECT_EQ(problem_of(q, {{"A", "4"}, {"age", "4o"}}), "item age: \"4o\" is not a number");
    EXPECT_EQ(problem_of(q, {{"A", "4"}, {"age", "nan"}}), "item age: \"nan\" is not a number");
    EXPECT_EQ(problem_of(q, {{"A", "4"}, {"age", "40"}, {"choice", "2"}}),
              "item choice: 2 is above 1");
    EXPECT_EQ(problem_of(q, {{"A", "4"}, {"age", "40"}, {"Z", "1"}}),
              "item Z is not part of questionnaire sample");
}

TEST(Questionnaire, RefusesABadDefinitionWithFileAndPointer) {
    const std::string file = testing::TempDir() + "broken_questionnaire.json";
    std::ofstream(file) << R"({"id":"q","version":1,"title":{"en":"t"},"items":[
        {"id":"A","kind":"likert","text":{"en":"x"}},{"id":"A","kind":"stars","text":{"en":"y"}}]})";
    try {
        (void)load_questionnaire(file);
        FAIL() << "was accepted";
    } catch (const DefinitionError& error) {
        EXPECT_EQ(error.file(), file);
        EXPECT_EQ(error.pointer(), "/items/1/kind");
        EXPECT_NE(std::string(error.what()).find("\"stars\""), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("\"likert\""), std::string::npos) << error.what();
    }
}

TEST(Questionnaire, AnUnknownIdListsTheKnownOnes) {
    try {
        (void)load_questionnaire("no_such");
        FAIL() << "was found";
    } catch (const DefinitionError& error) {
        EXPECT_NE(std::string(error.what()).find("face_validity"), std::string::npos);
    }
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
