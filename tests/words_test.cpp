// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <set>

#include "curriculum/definitions.h"
#include "curriculum/task.h"

namespace placode::reports {
namespace {

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
        return "PL " + english;
    }
};

class WordsTest : public testing::Test {
 protected:
    void SetUp() override { QCoreApplication::installTranslator(&mirror); }
    void TearDown() override { QCoreApplication::removeTranslator(&mirror); }
    Mirror mirror;
};

TEST(Words, EveryReasonOfTheShippedTasksHasAPattern) {
    const auto known = reason_patterns();
    const std::set<std::string> patterns(known.begin(), known.end());
    for (const std::string& id : curriculum::list_definitions("tasks"))
        for (const auto& item : curriculum::load_task(id).rubric.items)
            EXPECT_TRUE(patterns.contains(item.reason)) << id << ": " << item.reason;
}

TEST(Words, WithoutATranslatorTheSentenceStays) {
    EXPECT_EQ(reason_words("0.4 mm3 of the placode was cut at 3 o'clock."),
              QString("0.4 mm³ of the placode was cut at 3 o'clock."));
}

TEST_F(WordsTest, NumbersPlacesAndCountsAreKept) {
    EXPECT_EQ(reason_words("The needle rested 3.2 s with energy on one spot at 4 o'clock."),
              "PL The needle rested " + QLocale().toString(3.2, 'f', 1) +
                  " s with energy on one spot na godzinie 4.");
    EXPECT_EQ(reason_words("The placode was touched 3 times, first."),
              QString("PL The placode was touched 3 razy, first."));
    EXPECT_EQ(reason_words("The pedal was pressed in the air for over 1 s, once."),
              QString("PL The pedal was pressed in the air for over 1 s, raz."));
    EXPECT_EQ(reason_words("No piece of tissue was taken out."),
              QString("PL No piece of tissue was taken out."));
}

TEST_F(WordsTest, NumbersBeyondAMillionAndNamesOfMetricsAreKept) {
    EXPECT_EQ(reason_words("The placode was pressed with 1e+300 mN; 20 mN is the limit."),
              QString("PL The placode was pressed with 1e+300 mN; 20 mN is the limit."));
    EXPECT_EQ(reason_words("Not recorded, so this is no pass: Tip below the surface."),
              QString("PL Not recorded, so this is no pass: Tip below the surface."));
    EXPECT_EQ(reason_words("Nothing was done: this attempt does not count."),
              QString("PL Nothing was done: this attempt does not count."));
}

TEST(Words, WhatTheScoreSaysByItselfHasAPattern) {
    const auto known = reason_patterns();
    const std::set<std::string> patterns(known.begin(), known.end());
    assessment::Rubric rubric;
    rubric.items.resize(2);
    rubric.items[0].metric = "buried_s";
    rubric.items[1].metric = "target_error_mm";
    rubric.items[1].points_per_unit = 1;
    for (const auto& reason : assessment::score_attempt(rubric, {}, {}).reasons) {
        const std::string text = reason.text.substr(0, reason.text.find(": ")) + ": {metric}.";
        EXPECT_TRUE(patterns.contains(text)) << text;
    }
    rubric.attempted_by = {"energy_j"};
    EXPECT_TRUE(patterns.contains(assessment::score_attempt(rubric, {}, {}).reasons[0].text));
}

TEST_F(WordsTest, AnUnknownSentenceStays) {
    EXPECT_EQ(reason_words("An educator's own reason, 3 s."),
              QString("An educator's own reason, 3 s."));
}

}  // namespace
}  // namespace placode::reports

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
