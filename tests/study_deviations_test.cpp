// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What did not go as the protocol says follows from what was recorded, on both engines.

#include "db/study_deviations.h"

#include <gmock/gmock.h>

#include "db/study_conduct.h"
#include "db/study_records.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::DeviationKind;

namespace THIS_TEST {

World* const world = World::install();

constexpr const char* kStudy = R"({"id":"pilot","version":1,"title":{"en":"t"},"steps":[
  {"id":"practice","kind":"familiarisation","task":"diathermy_ring","max_s":120},
  {"id":"run","kind":"procedure","task":"diathermy_ring","min_s":30,"device":"mouse"},
  {"id":"run2","kind":"procedure","task":"diathermy_ring"},
  {"id":"extra","kind":"procedure","task":"diathermy_ring","required":false}]})";

sim::Event event(sim::EventKind kind, float value, float value2) {
    sim::Event one;
    one.kind = kind;
    one.value = value;
    one.value2 = value2;
    return one;
}

class StudyDeviations : public EngineTest {
 protected:
    void ready() override {
        store = open();
        carl = store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
        store->act_as("carl");
        db::DefinitionRecord definition;
        definition.kind = "study";
        definition.id = "pilot";
        definition.json = kStudy;
        store->definitions().publish(definition);
        code = store->studies().new_participant("pilot");
    }
    db::StepRecord step(const std::string& name) {
        db::StepRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.step = name;
        return record;
    }
    int64_t perform(const std::string& name, const std::string& device, double duration_s,
                    std::vector<sim::Event> events = {},
                    sim::EndReason end = sim::EndReason::kFinished,
                    assessment::Verdict verdict = assessment::Verdict::kNotYet) {
        db::AttemptResult result;
        result.score.verdict = verdict;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = "2026-01-02T03:04:05.000Z";
        result.header.device = device;
        result.end.reason = end;
        result.end.duration_s = duration_s;
        result.events = std::move(events);
        result.study = {"pilot", code};
        auto record = step(name);
        record.attempt_id = save_recorded(*store, carl, result, folder.path().string());
        db::record_attempt_step(*store, record);
        return record.attempt_id;
    }
    [[nodiscard]] std::vector<DeviationKind> kinds() {
        std::vector<DeviationKind> list;
        for (const auto& each : db::study_deviations(*store, "pilot")) list.push_back(each.kind);
        return list;
    }

    std::unique_ptr<db::Store> store;
    int64_t carl = 0;
    std::string code;
};

INSTANTIATE_TEST_SUITE_P(Engines, StudyDeviations, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StudyDeviations, AStudyThatGoesAsItsProtocolSaysHasNone) {
    perform("practice", "mouse", 20, {event(sim::EventKind::kPaused, 60, 1)});
    perform("run", "mouse", 40, {event(sim::EventKind::kMachineSpeed, 1, 60)});
    perform("run2", "mouse", 5);
    EXPECT_TRUE(kinds().empty()) << "pauses while getting used to the instruments are no matter";
}

TEST_P(StudyDeviations, PausesAndSlowSpellsAreSummedUpForAProcedure) {
    using sim::EventKind;
    const int64_t id =
        perform("run", "mouse", 40,
                {event(EventKind::kPaused, 4, 0), event(EventKind::kPaused, 2.5F, 1),
                 event(EventKind::kSlowSpell, 3, 9), event(EventKind::kMachineSpeed, 0.99F, 31)});
    const auto found = db::study_deviations(*store, "pilot");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].kind, DeviationKind::kPaused);
    EXPECT_EQ(found[0].count, 2);
    EXPECT_DOUBLE_EQ(found[0].seconds, 6.5);
    EXPECT_EQ(found[0].causes,
              (std::set<sim::PauseCause>{sim::PauseCause::kMenu, sim::PauseCause::kHelp}));
    EXPECT_EQ(found[0].attempt_id, id);
    EXPECT_EQ(found[0].participant, code);
    EXPECT_EQ(found[1].kind, DeviationKind::kSlowMachine);
    EXPECT_EQ(found[1].count, 1);
    EXPECT_EQ(found[1].text, "") << "slow for a moment, and good enough on the whole";
    EXPECT_TRUE(db::study_deviations(*store, "pilot", "P999-X").empty());
}

TEST_P(StudyDeviations, EndedEarlyBrokenOffSlowAndRepeatedAreListedInOrder) {
    perform("run", "mouse", 12);
    perform("run", "mouse", 3, {}, sim::EndReason::kInterrupted);
    perform("run", "mouse", 40, {event(sim::EventKind::kMachineSpeed, 1, 7)});
    const int64_t wrong = perform("run", "mouse", 45);
    store->records().repeat_step("pilot", code, 1, "run", "the pedal was unplugged");
    perform("run", "mouse", 50);
    store->records().note_step("pilot", code, 1, "run", "coughed");
    const auto found = db::study_deviations(*store, "pilot");
    EXPECT_EQ(kinds(),
              (std::vector<DeviationKind>{DeviationKind::kEndedEarly, DeviationKind::kInterrupted,
                                          DeviationKind::kSlowMachine, DeviationKind::kRepeated,
                                          DeviationKind::kNote}));
    EXPECT_EQ(found[0].seconds, 12);
    EXPECT_EQ(found[0].expected_s, 30);
    EXPECT_THAT(found[2].text, testing::HasSubstr("7 pictures a second"));
    EXPECT_EQ(found[3].attempt_id, wrong);
    EXPECT_EQ(found[3].text, "the pedal was unplugged");
    EXPECT_EQ(found[3].by, "carl");
    EXPECT_EQ(found[4].text, "coughed");
}

TEST_P(StudyDeviations, AProcedureInWhichNothingWasDoneIsKeptAndSaidEverywhere) {
    perform("practice", "mouse", 45, {}, sim::EndReason::kFinished,
            assessment::Verdict::kNotAttempted);
    EXPECT_TRUE(kinds().empty()) << "getting used to the instruments is no data";
    perform("run", "mouse", 45, {}, sim::EndReason::kFinished, assessment::Verdict::kNotAttempted);
    const auto found = db::study_deviations(*store, "pilot");
    ASSERT_EQ(kinds(), std::vector<DeviationKind>{DeviationKind::kNothingDone});
    EXPECT_EQ(found[0].seconds, 45);
    EXPECT_EQ(found[0].step, "run");
    EXPECT_STREQ(db::deviation_name(found[0].kind), "nothing_done");
    const auto progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_EQ(progress.done, 2) << "it is kept, and the coordinator decides";
    EXPECT_EQ(progress.idle, std::vector<std::string>{"1/run"});
    store->records().repeat_step("pilot", code, 1, "run", "nobody operated");
    EXPECT_TRUE(db::study_progress(*store, "pilot").at(0).idle.empty());
    // Too short says it already.
    perform("run", "mouse", 5, {}, sim::EndReason::kFinished, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(kinds().back(), DeviationKind::kEndedEarly);
}

TEST_P(StudyDeviations, AnotherDeviceThanTheProtocolsOrTheChosenOne) {
    store->studies().set_participant_device("pilot", code, "gamepad");
    perform("run", "gamepad", 40);   // The protocol says mouse.
    perform("run2", "gamepad", 40);  // The coordinator chose it.
    auto found = db::study_deviations(*store, "pilot");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, DeviationKind::kOtherDevice);
    EXPECT_EQ(found[0].text, "gamepad");
    EXPECT_EQ(found[0].expected, "mouse");
    perform("extra", "keyboard", 40);
    found = db::study_deviations(*store, "pilot");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].expected, "gamepad");
}

TEST_P(StudyDeviations, ASkippedStepIsOneUnlessItMayBeLeftOut) {
    for (const char* name : {"run2", "extra"}) {
        auto record = step(name);
        record.state = db::StepState::kSkipped;
        store->studies().record_step(record);
    }
    const auto found = db::study_deviations(*store, "pilot");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, DeviationKind::kSkipped);
    EXPECT_EQ(found[0].step, "run2");
    EXPECT_STREQ(db::deviation_name(found[0].kind), "skipped");
}

}  // namespace THIS_TEST
