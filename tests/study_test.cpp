// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "curriculum/questionnaire.h"

namespace placode::curriculum {
namespace THIS_TEST {

TEST(Study, ShipsTheSeedPapersProtocolInItsOrder) {
    const StudyProtocol study = load_study("face_content_validity");
    std::vector<std::string> steps;
    for (const StudyStep& step : study.steps) steps.push_back(step.id);
    EXPECT_EQ(steps, (std::vector<std::string>{"consent", "demographics", "briefing",
                                               "familiarisation", "procedure_1", "procedure_2",
                                               "procedure_3", "face_validity"}));
    EXPECT_EQ(study.step("familiarisation")->max_s, 120) << "two minutes at most";
    EXPECT_FALSE(study.step("procedure_1")->time_limit_s) << "the paper set no time limit";
    EXPECT_EQ(study.step("procedure_1")->min_s, 60) << "one press of a key is no procedure";
    EXPECT_EQ(study.step("procedure_1")->device, "") << "the coordinator chooses, once";
    EXPECT_FALSE(study.reason.empty()) << "version 2 says why";
    EXPECT_TRUE(study.needs_consent());
    EXPECT_NE(study.source.find("Korzeniowski"), std::string::npos);
    for (const StudyStep& step : study.steps) {
        EXPECT_FALSE(step.title.pl.empty()) << step.id;
        if (!step.task.empty()) {
            EXPECT_NO_THROW((void)load_task(step.task)) << step.id;
        }
    }
}

TEST(Study, EveryShippedQuestionnaireNamesSourceAndLicenceAndSpeaksBothLanguages) {
    const auto ids = list_definitions("questionnaires");
    for (const char* needed :
         {"demographics", "face_validity", "nasa_tlx", "osats", "presence", "sus"})
        EXPECT_NE(std::find(ids.begin(), ids.end(), needed), ids.end()) << needed;
    for (const std::string& id : ids) {
        const Questionnaire q = load_questionnaire(id);
        EXPECT_FALSE(q.source.empty()) << id;
        EXPECT_FALSE(q.licence.empty()) << id;
        EXPECT_FALSE(q.title.pl.empty()) << id;
        for (const QuestionnaireItem& item : q.items) EXPECT_FALSE(item.text.pl.empty()) << item.id;
    }
}

DefinitionError failure_of(const std::string& json) {
    try {
        (void)load_study_text(json, "test.json");
    } catch (const DefinitionError& error) {
        return error;
    }
    ADD_FAILURE() << "was accepted";
    return {"", "", ""};
}

std::string with_steps(const std::string& steps, const std::string& more = "") {
    return R"({"id":"s","version":1,"title":{"en":"t"},)" + more + R"("steps":[)" + steps + "]}";
}

TEST(Study, RefusesAStepWithoutWhatItNeedsAndNamesThePlace) {
    EXPECT_EQ(failure_of(with_steps(R"({"id":"a","kind":"procedure"})")).pointer(), "/steps/0");
    EXPECT_EQ(failure_of(with_steps(R"({"id":"a","kind":"familiarisation","task":"t"})")).pointer(),
              "/steps/0");
    const DefinitionError twice =
        failure_of(with_steps(R"({"id":"a","kind":"briefing","text":[{"en":"x"}]},
                      {"id":"a","kind":"briefing","text":[{"en":"x"}]})"));
    EXPECT_EQ(twice.pointer(), "/steps/1/id");
    EXPECT_EQ(failure_of(with_steps(R"({"id":"a","kind":"consent"})")).pointer(), "/consent");
    EXPECT_EQ(failure_of(with_steps(R"({"id":"a","kind":"nap"})")).pointer(), "/steps/0/kind");
    EXPECT_EQ(failure_of(with_steps(R"({"id":"a","kind":"procedure","task":"t"})",
                                    R"("arms":{"names":[{"en":"x"},{"en":"y"}],"block_size":3},)"))
                  .pointer(),
              "/arms/block_size");
}

TEST(Study, TheProtocolSetsDeviceAidsAndLeastDuration) {
    const StudyProtocol study = load_study_text(
        with_steps(R"({"id":"a","kind":"procedure","task":"t","device":"mouse","min_s":30,)"
                   R"("aids":["warnings","depth"]},{"id":"b","kind":"procedure","task":"t",)"
                   R"("aids":[]},{"id":"c","kind":"familiarisation","task":"t","max_s":60})"),
        "test.json");
    EXPECT_EQ(study.step("a")->device, "mouse");
    EXPECT_EQ(study.step("a")->min_s, 30);
    EXPECT_EQ(aid_names(study.step("a")->allowed_aids()), "warnings,depth");
    EXPECT_EQ(aid_names(study.step("b")->allowed_aids()), "") << "an empty list allows none";
    EXPECT_EQ(study.step("c")->allowed_aids(), conduct_of(AttemptMode::kStudy).aids);
    EXPECT_TRUE(study.step("c")->is_attempt());
}

TEST(Study, RefusesRulesOfAnAttemptThatCannotHoldAndNamesThePlace) {
    const auto pointer = [](const std::string& step) {
        return failure_of(with_steps(step)).pointer();
    };
    EXPECT_EQ(pointer(R"({"id":"a","kind":"procedure","task":"t","aids":["x_ray"]})"),
              "/steps/0/aids/0");
    EXPECT_EQ(pointer(R"({"id":"a","kind":"procedure","task":"t","min_s":-1})"), "/steps/0/min_s");
    EXPECT_EQ(pointer(R"({"id":"a","kind":"procedure","task":"t","device":"the mouse"})"),
              "/steps/0/device");
    EXPECT_EQ(pointer(R"({"id":"a","kind":"procedure","task":"t","min_s":30,"time_limit_s":20})"),
              "/steps/0/min_s");
    EXPECT_EQ(pointer(R"({"id":"a","kind":"familiarisation","task":"t","min_s":61,"max_s":60})"),
              "/steps/0/min_s");
    EXPECT_EQ(pointer(R"({"id":"a","kind":"briefing","text":[{"en":"x"}],"device":"mouse"})"),
              "/steps/0/device");
}

TEST(Study, AllocationIsBalancedInEveryBlockAndTheSameForTheSameSeed) {
    Arms arms{{{"x", ""}, {"y", ""}}, 4};
    bool differs = false;
    for (const uint64_t seed : {1ULL, 2ULL, 77ULL}) {
        for (int block = 0; block < 25; ++block) {
            int ones = 0;
            for (int i = 1; i <= 4; ++i) {
                const int arm = allocated_arm(arms, seed, 4 * block + i);
                EXPECT_EQ(arm, allocated_arm(arms, seed, 4 * block + i));
                differs = differs || arm != allocated_arm(arms, seed + 1, 4 * block + i);
                ones += arm;
            }
            EXPECT_EQ(ones, 2) << "seed " << seed << " block " << block;
        }
    }
    EXPECT_TRUE(differs) << "the seed has no effect";
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
