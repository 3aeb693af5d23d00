// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <set>
#include <thread>

#include "curriculum/definitions.h"
#include "curriculum/task.h"

namespace placode::reports {
namespace THIS_TEST {

/// Turns every sentence round, so that a test sees which places were filled.
class Mirror : public QTranslator {
 public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* text, const char*,
                                    int) const override {
        if (qstrcmp(context, "Reason") != 0) return {};
        const QString english = QString::fromUtf8(text);
        if (english == "once") return "raz";
        if (english == "%1 times") return "%1 razy";
        if (english == " at %1 o'clock") return " na godzinie %1";
        if (english == " between bites %1 and %2") return " między ściegami %1 i %2";
        return "PL " + english;
    }
};

class WordsTest : public testing::Test {
 protected:
    void SetUp() override { QCoreApplication::installTranslator(&mirror); }
    void TearDown() override { QCoreApplication::removeTranslator(&mirror); }
    Mirror mirror;
};

assessment::Reason reason_of(const std::string& pattern, double value = 0, int count = 0,
                             int hour = 0, const std::string& metric = {}) {
    assessment::Reason reason;
    reason.meaning = {pattern, {}, metric, value, count, hour};
    reason.text = assessment::english_words(reason.meaning, 0);
    return reason;
}

/// The places of a sentence, in the order of the alphabet.
std::multiset<std::string> places_of(const std::string& pattern) {
    std::multiset<std::string> places;
    for (size_t at = pattern.find('{'); at != std::string::npos; at = pattern.find('{', at + 1))
        places.insert(pattern.substr(at, pattern.find('}', at) - at + 1));
    return places;
}

TEST(Words, EveryReasonOfTheShippedTasksSpeaksBothLanguages) {
    for (const std::string& id : curriculum::list_definitions("tasks"))
        for (const auto& item : curriculum::load_task(id).rubric.items) {
            EXPECT_FALSE(item.reason_pl.empty()) << id << ": " << item.reason;
            EXPECT_EQ(places_of(item.reason_pl), places_of(item.reason)) << id << ": " << item.id;
        }
}

TEST(Words, WithoutATranslatorTheSentenceStays) {
    EXPECT_EQ(reason_words(reason_of("{value} mm3 of the placode was cut{where}.", 0.44, 1, 3)),
              QString("0.44 mm³ of the placode was cut at 3 o'clock."));
}

TEST_F(WordsTest, NumbersPlacesAndCountsAreSaidInTheLanguage) {
    EXPECT_EQ(reason_words(reason_of("The needle rested {value} s on one spot{where}.", 3.2, 1, 4)),
              "PL The needle rested " + QLocale().toString(3.2, 'f', 1) +
                  " s on one spot na godzinie 4.");
    EXPECT_EQ(reason_words(reason_of("The placode was touched {times}, first{where}.", 3, 3)),
              QString("PL The placode was touched 3 razy, first."));
    EXPECT_EQ(reason_words(reason_of("The pedal was pressed in the air, {times}.", 1, 1)),
              QString("PL The pedal was pressed in the air, raz."));
    EXPECT_EQ(reason_words(reason_of("No piece of tissue was taken out.")),
              QString("PL No piece of tissue was taken out."));
}

TEST_F(WordsTest, NumbersBeyondAMillionAndNamesOfMetricsAreKept) {
    EXPECT_EQ(reason_words(reason_of("The placode was pressed with {value} mN.", 1e300)),
              QString("PL The placode was pressed with 1e+300 mN."));
    EXPECT_EQ(
        reason_words(reason_of("Not recorded, so this is no pass: {metric}.", 0, 0, 0, "buried_s")),
        QString("PL Not recorded, so this is no pass: Tip stuck in tissue."));
}

TEST(Words, ADroppedNeedleSaysFromHowHighItFell) {
    assessment::LedgerEntry entry;
    entry.kind = sim::EventKind::kNeedleDropped;
    entry.lane = assessment::HarmLane::kForce;
    entry.value = 6;  // the step
    entry.value2 = 0.008;
    EXPECT_EQ(ledger_words(entry), "Needle dropped, " + QLocale().toString(8.0, 'f', 1) + " mm");
}

TEST(Words, AnEducatorsOwnWordingIsSaidInItsOwnLanguage) {
    const QLocale before;
    assessment::Reason reason = reason_of("My own words, {value} {unit}.", 12.25, 0, 0, "dwell_s");
    reason.meaning.pattern_pl = "Moje własne słowa, {value} {unit}.";
    EXPECT_EQ(reason_words(reason), QString("My own words, 12.2 s."));
    QLocale::setDefault(QLocale(QLocale::Polish));
    EXPECT_EQ(reason_words(reason), QString("Moje własne słowa, 12,2 s."));
    QLocale::setDefault(before);
}

TEST_F(WordsTest, APlaceAlongASlitIsSaidInTheLanguage) {
    assessment::Reason reason = reason_of("It opened{where}.", 0, 1, 11);
    reason.meaning.between = {3, 2, false};
    EXPECT_EQ(reason_words(reason), QString("PL It opened między ściegami 2 i 3."));
    EXPECT_EQ(between_words({0, 1, true}), QString("PL  between the upper end and bite 1"));
    EXPECT_EQ(between_words({3, 0, false}), QString("PL  between bite 3 and the right end"));
    EXPECT_EQ(between_words({}), QString());
}

TEST(Words, EveryScoreKeepsWhatItsReasonsMean) {
    assessment::Rubric rubric;
    rubric.items.resize(2);
    rubric.items[0].metric = "buried_s";
    rubric.items[1].metric = "target_error_mm";
    rubric.items[1].points_per_unit = 1;
    const auto reasons = assessment::score_attempt(rubric, {}, {}).reasons;
    ASSERT_EQ(reasons.size(), 2U);
    for (const auto& reason : reasons) {
        EXPECT_FALSE(reason.meaning.pattern.empty()) << reason.text;
        EXPECT_EQ(reason.text, assessment::english_words(reason.meaning, reason.points));
    }
    rubric.attempted_by = {"energy_j"};
    EXPECT_FALSE(assessment::score_attempt(rubric, {}, {}).reasons[0].meaning.pattern.empty());
}

// A portal answers several readers at once, each in a thread.
TEST_F(WordsTest, AThreadMaySpeakAnotherLanguageThanTheProgram) {
    const QLocale polish(QLocale::Polish);
    assessment::Reason reason = reason_of("My own words, {value} {unit}.", 12.25, 0, 0, "dwell_s");
    reason.meaning.pattern_pl = "Moje własne słowa, {value} {unit}.";
    EXPECT_EQ(with_spoken_sign("3.5"), QString("3.5"));
    std::thread([&] {
        const Speaking here(polish);
        EXPECT_EQ(spoken().language(), QLocale::Polish);
        EXPECT_EQ(reason_words(reason), QString("Moje własne słowa, 12,2 s."));
        EXPECT_EQ(with_spoken_sign("3.5"), QString("3,5"));
        {
            const Speaking again(QLocale::c());
            EXPECT_EQ(with_spoken_sign("3.5"), QString("3.5"));
        }
        EXPECT_EQ(spoken().language(), QLocale::Polish);
        std::thread([] { EXPECT_EQ(spoken(), QLocale()); }).join();
    }).join();
    EXPECT_EQ(spoken(), QLocale());
}

TEST_F(WordsTest, WhatAnOlderProgramScoredStays) {
    assessment::Reason old;
    old.text = "The needle rested 3 s at 4 o'clock, 2 mm3.";
    EXPECT_EQ(reason_words(old), QString("The needle rested 3 s at 4 o'clock, 2 mm³."));
}

}  // namespace THIS_TEST
}  // namespace placode::reports

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
