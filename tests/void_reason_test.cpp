// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the store keeps of the reasons why an attempt does not count means the same when it is read.

#include "db/void_reason.h"

#include <gmock/gmock.h>

using namespace placode::db;
using testing::ElementsAre;
using testing::IsEmpty;

namespace THIS_TEST {

const std::vector<VoidReason> kAll{
    {VoidCause::kTuned, 0, 0, {}},
    {VoidCause::kGiven, 2, 0, {}},
    {VoidCause::kDevice, 0, 0, Said::as_is("40 drop-outs of the force loop")},
    {VoidCause::kFewPictures, 0, 20, {}},
    {VoidCause::kFewPictures, 1, 20, {}},
    {VoidCause::kFewPictures, 19, 20, {}},
    {VoidCause::kNotRealTime, 94, 95, {}},
    {VoidCause::kTaskUnknown, 0, 0, Said::as_is("it version 1")},
    {VoidCause::kUnsigned, 0, 0, Said::as_is(kNobody)},
    {VoidCause::kNoRecording, 0, 0, {}},
    {VoidCause::kOrderDiffers, 0, 0, {}},
    {VoidCause::kOrderMissing, 0, 0, {}},
    {VoidCause::kProctor, 0, 0, {}},
    {VoidCause::kExamClosed, 0, 0, Said::as_is("all attempts are used")},
    {VoidCause::kClock, 0, 0, Said::as_is("2026-02-01T00:00:00Z")},
    {VoidCause::kTaskVersion, 0, 0, Said::as_is("it version 1")}};

TEST(VoidReason, EveryListIsReadAsItWasWritten) {
    EXPECT_EQ(void_text({}), "");
    EXPECT_THAT(void_reasons(""), IsEmpty());
    EXPECT_EQ(void_reasons(void_text(kAll)), kAll);
    for (const VoidReason& reason : kAll)
        EXPECT_THAT(void_reasons(void_text({reason})), ElementsAre(reason));
}

TEST(VoidReason, StoresOfEarlierVersionsMeanTheSame) {
    EXPECT_THAT(void_reasons("The computer was too slow: 1 pictures a second, 20 are needed"),
                ElementsAre(VoidReason{VoidCause::kFewPictures, 1, 20, {}}));
    // Nearly one of ours is not: it is shown as it stands.
    for (const char* other : {"The computer was too slow: x pictures a second, 20 are needed",
                              "The computer was too slow: 3 pictures a second, 20 are needed!",
                              "The computer was too slow: 99999999999 pictures a second, 20 are "
                              "needed",
                              "Begun at stage 2", "Begun at stage x, what came before it was given",
                              "2 device faults"}) {
        const auto read = void_reasons(other);
        ASSERT_EQ(read.size(), 1u);
        EXPECT_EQ(read[0].cause, VoidCause::kDevice) << other;
        EXPECT_EQ(read[0].detail.english(), other);
    }
}

// What a program of today writes: parts that have a translation of their own.
const std::vector<VoidReason> kMeant{
    {VoidCause::kDevice, 0, 0,
     Said::that("%1 device faults (at most %2); the last error was %3").with(3).with(0).with("E7")},
    {VoidCause::kReplayDiffers, 0, 0,
     Said::that("%1 at %2 s").with(Said::that("a sample")).with("2.500")},
    {VoidCause::kUnsound, 0, 0, Said::that("sample %1 has a tip that lies nowhere").with(12)},
    {VoidCause::kFewPictures, 19, 20, {}}};

TEST(VoidReason, TheMeaningIsReadAsItWasWritten) {
    EXPECT_EQ(void_meaning({}), "");
    for (const auto& all : {kAll, kMeant})
        EXPECT_EQ(void_reasons(void_text(all), void_meaning(all)), all) << void_meaning(all);
    EXPECT_NE(void_reasons(void_text(kMeant)), kMeant) << "the text alone means less";
}

TEST(VoidReason, AMeaningThatSaysSomethingElseThanItsTextIsNone) {
    const std::string text = void_text(kAll);
    for (const std::string& meaning :
         {void_meaning(kMeant), std::string(), std::string("[]"), std::string("{}"),
          std::string("no JSON"), std::string(R"([{"cause":"tuned"},7,null])"),
          std::string(R"([{"cause":"of a later program"}])")})
        EXPECT_EQ(void_reasons(text, meaning), kAll) << meaning;
    EXPECT_THAT(void_reasons("", void_meaning(kMeant)), IsEmpty());
    EXPECT_EQ(not_done("interrupted", R"({"interrupted":true,"void":[{"cause":"?"}]})").voids,
              std::vector<VoidReason>{});
    EXPECT_TRUE(not_done("interrupted", R"({"least_s":5})").interrupted);
}

TEST(VoidReason, WhatAStepsReasonMeansIsReadAsItWasWritten) {
    EXPECT_EQ(not_done_meaning({}), "");
    NotDone why;
    why.ended_s = 2;
    why.least_s = 60;
    why.voids = kMeant;
    EXPECT_EQ(not_done(not_done_text(why), not_done_meaning(why)), why);
    why = {};
    why.interrupted = true;
    why.note = "the pedal; void: of sense";
    EXPECT_EQ(not_done(not_done_text(why), not_done_meaning(why)), why);
}

TEST(VoidReason, WhyAStepIsNotDoneIsReadAsItWasWritten) {
    EXPECT_EQ(not_done_text({}), "");
    for (const bool interrupted : {false, true})
        for (const int ended : {0, 2})
            for (const bool voids : {false, true}) {
                if (interrupted && ended > 0) continue;  // said once: it was broken off
                NotDone why;
                why.interrupted = interrupted;
                why.ended_s = ended;
                why.least_s = ended > 0 ? 60 : 0;
                if (voids) why.voids = kAll;
                EXPECT_EQ(not_done(not_done_text(why)), why) << not_done_text(why);
            }
    NotDone own;
    own.note = "the pedal was unplugged; void of sense";
    EXPECT_EQ(not_done(not_done_text(own)), own) << "a coordinator's own words";
    EXPECT_EQ(not_done("interrupted; void: 2 device faults").voids.at(0).detail.english(),
              "2 device faults");
}

}  // namespace THIS_TEST
