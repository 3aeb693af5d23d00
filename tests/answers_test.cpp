// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to every kind of item, branching, and the published scores of SUS and Raw TLX.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include <gtest/gtest.h>

#include "curriculum/questionnaire.h"

namespace placode::curriculum {
namespace THIS_TEST {

Questionnaire sample() {
    return load_questionnaire_text(R"({"id":"q","version":3,"title":{"en":"t"},"items":[
      {"id":"used","kind":"choice","text":{"en":"x"},"choices":[{"en":"no"},{"en":"yes"}]},
      {"id":"which","kind":"multiple","text":{"en":"x"},"choices":[{"en":"a"},{"en":"b"},{"en":"c"}],
       "show_if":{"item":"used","any_of":["1"]}},
      {"id":"name_c","kind":"text","text":{"en":"x"},"show_if":{"item":"which","any_of":["2"]}},
      {"id":"day","kind":"date","text":{"en":"x"},"required":false},
      {"id":"pain","kind":"visual_analogue","text":{"en":"x"},"required":false},
      {"id":"likert","kind":"likert","text":{"en":"x"},"scale_min":-3,"scale_max":3,
       "not_applicable":true,"reverse":true,"required":false}]})",
                                   "sample");
}

std::string problem_of(const Answers& answers) {
    const auto problem = check_answers(sample(), answers);
    return problem ? problem->english() : "";
}

TEST(Answers, EveryKindIsChecked) {
    EXPECT_EQ(problem_of({{"used", "0"}, {"day", "2024-02-29"}, {"pain", "62.5"}}), "");
    EXPECT_EQ(problem_of({{"used", "0"}, {"day", "2023-02-29"}}),
              "item day: \"2023-02-29\" is not a date such as 2026-11-21");
    EXPECT_EQ(problem_of({{"used", "0"}, {"day", "2023-2-9"}}),
              "item day: \"2023-2-9\" is not a date such as 2026-11-21");
    EXPECT_EQ(problem_of({{"used", "0"}, {"pain", "101"}}), "item pain: 101 is above 100");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "0;1"}}), "");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "3"}}), "item which: 3 is above 2");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "1;0"}}),
              "item which: \"1;0\" names its choices twice or not in order");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "0;"}}),
              "item which: \"0;\" is not a list of choices such as \"0;2\"");
    EXPECT_EQ(problem_of({{"used", "0"}, {"likert", "NA"}}), "");
    EXPECT_EQ(problem_of({{"used", "NA"}}), "item used: \"NA\" is not offered here");
    EXPECT_EQ(problem_of({{"used", "0"}, {"likert", "-4"}}), "item likert: -4 is below -3");
}

TEST(Answers, BranchingAsksForWhatIsShownAndRefusesWhatIsHidden) {
    EXPECT_EQ(problem_of({{"used", "1"}}), "item which needs an answer");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "0;2"}}), "item name_c needs an answer");
    EXPECT_EQ(problem_of({{"used", "1"}, {"which", "0;2"}, {"name_c", "x"}}), "");
    EXPECT_EQ(problem_of({{"used", "0"}, {"which", "0"}}),
              "item which is answered, but hidden by the answer to item used");
    const Questionnaire q = sample();
    EXPECT_FALSE(is_shown(q, q.items[2], {{"used", "0"}, {"which", "2"}}))
        << "what hides a question hides all that hang on it";
}

/// SUS answers in the order of its items.
Answers sus(const std::vector<int>& values) {
    Answers answers;
    for (size_t i = 0; i < values.size(); ++i) {
        std::string id = i < 9 ? "sus0" : "sus";
        id += std::to_string(i + 1);
        answers[id] = std::to_string(values[i]);
    }
    return answers;
}

TEST(Answers, SusIsScoredAsItsAuthorScoresIt) {
    const Questionnaire q = load_questionnaire("sus");
    ASSERT_EQ(q.items.size(), 10u);
    const auto score = [&](const std::vector<int>& values) {
        return scale_scores(q, sus(values)).at(0).value;
    };
    EXPECT_EQ(score({5, 1, 5, 1, 5, 1, 5, 1, 5, 1}), 100.0);
    EXPECT_EQ(score({1, 5, 1, 5, 1, 5, 1, 5, 1, 5}), 0.0);
    EXPECT_EQ(score({3, 3, 3, 3, 3, 3, 3, 3, 3, 3}), 50.0);
    // The worked example of Brooke 1996: contributions sum to 22, score 55.
    EXPECT_EQ(score({5, 4, 2, 1, 2, 3, 2, 4, 5, 2}), 55.0);
    EXPECT_EQ(score({5, 4, 2, 1, 2, 3, 2, 4, 5}), std::nullopt) << "an item is missing";
}

TEST(Answers, RawTlxIsTheMeanOfItsSixScales) {
    const Questionnaire q = load_questionnaire("nasa_tlx");
    const Answers answers{{"mental_demand", "70"},   {"physical_demand", "40"},
                          {"temporal_demand", "10"}, {"performance", "20"},
                          {"effort", "80"},          {"frustration", "50"}};
    ASSERT_FALSE(check_answers(q, answers));
    EXPECT_EQ(scale_scores(q, answers).at(0).value, 45.0);
}

TEST(Answers, ReverseKeyedItemsAreTurnedRoundAndNotApplicableOnesLeftOut) {
    const Questionnaire q = load_questionnaire("presence");
    Answers answers;
    for (const auto& item : q.items) answers[item.id] = item.reverse ? "1" : "7";
    EXPECT_EQ(scale_scores(q, answers).at(0).value, 7.0);
    answers["hands"] = kNotApplicable;
    EXPECT_EQ(scale_scores(q, answers).at(0).value, 7.0);
    EXPECT_EQ(scale_scores(q, answers).at(0).answered, 7);
    answers["there"] = answers["absorbed"] = kNotApplicable;
    EXPECT_EQ(scale_scores(q, answers).at(0).value, std::nullopt) << "5 of 8 are too few";
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
