// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the store keeps about an attempt is said in the language of the program.

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QTranslator>

#include "db/attempt_counting.h"
#include "reports/words.h"

using namespace placode;
using namespace placode::reports;

namespace THIS_TEST {

/// Says everything of the list with a mark before it: what has none was not recognised.
class Marked : public QTranslator {
 public:
    QString translate(const char* context, const char* text, const char*, int) const override {
        const std::string list = context;
        return list == "Deviation" || list == db::Said::kContext ? "~" + QString::fromUtf8(text)
                                                                 : QString();
    }
    bool isEmpty() const override { return false; }
};

class ConductWords : public testing::Test {
 protected:
    ConductWords() {
        static int argc = 1;
        static char name[] = "conduct_words_test";
        static char* argv[] = {name, nullptr};
        static QCoreApplication application(argc, argv);
        QCoreApplication::installTranslator(&translator);
    }
    ~ConductWords() override { QCoreApplication::removeTranslator(&translator); }

    Marked translator;
};

TEST_F(ConductWords, EveryReasonOfASlowMachineIsSaidInTheProgramsLanguage) {
    for (const float pictures : {1.0F, 12.4F, 19.9F})
        for (const float speed : {0.07F, 0.94F}) {
            sim::Event event;
            event.kind = sim::EventKind::kMachineSpeed;
            event.value = speed;
            event.value2 = pictures;
            const QStringList parts =
                void_words(db::void_text(db::void_reasons({event}))).split(QStringLiteral("; "));
            ASSERT_EQ(parts.size(), 2);
            EXPECT_TRUE(parts[0].contains("too slow"));
            EXPECT_FALSE(parts[1].contains("too slow")) << "it was said already";
            for (const QString& part : parts) {
                EXPECT_TRUE(part.startsWith('~')) << part.toStdString();
                EXPECT_FALSE(part.contains("%1")) << part.toStdString();
            }
        }
    EXPECT_EQ(void_words("40 drop-outs"), "40 drop-outs") << "figures for technicians stay";
}

TEST_F(ConductWords, EveryDoubtIsSaidInTheProgramsLanguage) {
    for (int i = 0; i <= static_cast<int>(db::VoidCause::kTaskVersion); ++i) {
        const auto cause = static_cast<db::VoidCause>(i);
        if (!db::is_doubt(cause)) continue;
        const QString said = void_words(db::void_text({{cause, 0, 0, db::Said::as_is("this")}}));
        EXPECT_TRUE(said.startsWith("~Practice, not verified: ")) << said.toStdString();
        EXPECT_FALSE(said.contains("%1")) << said.toStdString();
    }
    EXPECT_EQ(void_words("Practice, not verified: nothing was recorded"),
              "~Practice, not verified: nothing was recorded");
}

TEST_F(ConductWords, WhatIsNamedIsSaidInTheProgramsLanguageWhereItsMeaningWasKept) {
    const std::vector<db::VoidReason> differs{
        {db::VoidCause::kReplayDiffers, 0, 0,
         db::Said::that("%1 at %2 s").with(db::Said::that("a sample")).with("2.500")}};
    EXPECT_EQ(void_words(db::void_text(differs), db::void_meaning(differs)),
              "~Practice, not verified: simulated again it differs (~~a sample at 2.500 s)");
    EXPECT_EQ(void_words(db::void_text(differs)),
              "~Practice, not verified: simulated again it differs (a sample at 2.500 s)")
        << "of an older program";
    const std::vector<db::VoidReason> device{
        {db::VoidCause::kDevice, 0, 0,
         db::Said::that("%1 device faults (at most %2)").with(3).with(0)}};
    EXPECT_EQ(void_words(db::void_text(device), db::void_meaning(device)),
              "~3 device faults (at most 0)");
    db::NotDone why;
    why.voids = device;
    EXPECT_EQ(not_done_words(db::not_done_text(why), db::not_done_meaning(why)),
              "~3 device faults (at most 0)");
    db::Deviation slow;
    slow.kind = db::DeviationKind::kSlowMachine;
    slow.text = db::void_text(device);
    slow.meaning = db::void_meaning(device);
    EXPECT_EQ(deviation_words(slow), "~Does not count: ~3 device faults (at most 0).");
    EXPECT_EQ(deviation_words(slow, Language::kEnglish),
              "Does not count: 3 device faults (at most 0).");
}

TEST_F(ConductWords, WhyAnAttemptDoesNotCountSaysWhatThePersonDidFirst) {
    db::AttemptRecord attempt;
    attempt.duration_s = 5;
    EXPECT_EQ(not_counted_words(attempt), "") << "it counts";
    attempt.void_reason = "The computer was too slow: 14 pictures a second, 20 are needed";
    EXPECT_EQ(not_counted_words(attempt, Language::kEnglish), "the computer was too slow");
    // Every reason, once.
    attempt.void_reason +=
        "; The computer was too slow: the simulation ran at 82 % of real time, "
        "95 % are needed; 40 drop-outs of the force loop; 2 device faults";
    EXPECT_EQ(not_counted_words(attempt, Language::kEnglish),
              "the force device did not work as it must; the computer was too slow");
    attempt.void_reason += "; Tissue or generator was tuned";
    attempt.verdict = assessment::Verdict::kNotAttempted;
    attempt.end = sim::EndReason::kInterrupted;
    EXPECT_EQ(not_counted_words(attempt),
              "~left after 5 s; ~nothing was done; ~tissue or generator was tuned; ~the force "
              "device did not work as it must; ~the computer was too slow");
    attempt.void_reason.clear();
    attempt.end = sim::EndReason::kFinished;
    EXPECT_EQ(not_counted_words(attempt), "~nothing was done");
    EXPECT_EQ(void_words("Tissue or generator was tuned"), "~Tissue or generator was tuned");
    attempt.verdict = assessment::Verdict::kNotYet;
    attempt.void_reason = db::void_text({{db::VoidCause::kGiven, 2, 0, {}}});
    EXPECT_EQ(not_counted_words(attempt), "~begun at stage 2");
    EXPECT_EQ(void_words(attempt.void_reason), "~Begun at stage 2, what came before it was given");
    EXPECT_EQ(not_counted_words(attempt, Language::kEnglish), "begun at stage 2");
}

TEST(ConductWordsInEnglish, APartOfASentenceHasNoCapital) {
    EXPECT_EQ(not_done_words("ended after 2 s, before the least duration of 60 s; void: The "
                             "computer was too slow: 3 pictures a second, 20 are needed"),
              "it ended after 2 s, before 60 s were over; the computer was too slow: 3 pictures a "
              "second, 20 are needed");
    EXPECT_EQ(void_words("Tissue or generator was tuned; The computer was too slow: 3 pictures a "
                         "second, 20 are needed"),
              "Tissue or generator was tuned; the computer was too slow: 3 pictures a second, 20 "
              "are needed");
}

TEST_F(ConductWords, WhyAStepIsStillToBeDone) {
    EXPECT_EQ(not_done_words("interrupted"), "~broken off");
    EXPECT_EQ(not_done_words("ended after 12 s, before the least duration of 60 s"),
              "~it ended after 12 s, before 60 s were over");
    EXPECT_TRUE(
        not_done_words("void: The computer was too slow: 3 pictures a second, 20 are needed")
            .startsWith("~The computer"));
    EXPECT_EQ(not_done_words("ended after 2 s, before the least duration of 60 s; void: The "
                             "computer was too slow: 3 pictures a second, 20 are needed"),
              "~it ended after 2 s, before 60 s were over; ~The computer was too slow: 3 pictures "
              "a second, 20 are needed");
    EXPECT_EQ(not_done_words("the pedal was unplugged"), "the pedal was unplugged")
        << "a coordinator's own words";
}

TEST_F(ConductWords, DeviationsAreSaidInTheProgramsLanguageAndInEnglishForFiles) {
    db::Deviation one;
    one.kind = db::DeviationKind::kPaused;
    one.count = 2;
    one.seconds = 12.4;
    one.causes = {sim::PauseCause::kMenu, sim::PauseCause::kFocus, sim::PauseCause::kDevice,
                  sim::PauseCause::kAsleep};
    EXPECT_EQ(
        deviation_words(one, Language::kEnglish),
        "Stood still twice, 12 s in all (menu, another window in front, the device was gone, the "
        "computer was asleep).");
    EXPECT_TRUE(deviation_words(one).startsWith("~Stood still ~twice"));
    one.text = std::string(1, 'x');
    for (int i = 0; i < db::kDeviationKinds; ++i) {
        one.kind = static_cast<db::DeviationKind>(i);
        EXPECT_FALSE(deviation_words(one, Language::kEnglish).isEmpty()) << i;
        EXPECT_FALSE(deviation_title(one.kind, Language::kEnglish).startsWith('~')) << i;
        EXPECT_TRUE(deviation_title(one.kind).startsWith('~')) << i;
    }
}

}  // namespace THIS_TEST
