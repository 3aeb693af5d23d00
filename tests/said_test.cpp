// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/said.h"

#include <gmock/gmock.h>

#include <map>

#include "db/course_conduct.h"
#include "db/said_json.h"
#include "tests/store_cases.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using db::Said;
using db::StoreError;
using Kind = StoreError::Kind;

/// In a language in which the words stand in another order.
std::string in_reverse(const Said& said, const char* code = "pl") {
    const std::map<std::string, std::string> words{
        {"%1 of %2 are left", "z %2 zostało %1"}, {"the step %1", "krok %1"}, {"rest", "reszta"}};
    return said.in(code, [&](const char* sentence) { return words.at(sentence); });
}

TEST(Said, FillsItsPlacesInEveryLanguage) {
    const Said said = Said::that("%1 of %2 are left").with(3).with("12 \"x\"");
    EXPECT_EQ(said.english(), "3 of 12 \"x\" are left");
    EXPECT_EQ(in_reverse(said), "z 12 \"x\" zostało 3");
}

TEST(Said, APlaceInWhatIsFilledInStays) {
    const Said said = Said::that("%1 of %2 are left").with("%2 and %1").with("100 %");
    EXPECT_EQ(said.english(), "%2 and %1 of 100 % are left");
    EXPECT_EQ(in_reverse(said), "z 100 % zostało %2 and %1");
    EXPECT_EQ(Said::as_is("%1 stays").english(), "%1 stays");
}

TEST(Said, APartIsSaidInTheSameLanguage) {
    const Said said = Said::that("the step %1").with(Said::listed("rest"));
    EXPECT_EQ(said.english(), "the step rest");
    EXPECT_EQ(in_reverse(said), "krok reszta");
    const Said title = Said::that("the step %1").with(Said::as_is(curriculum::LocalText{"a", "b"}));
    EXPECT_EQ(title.english(), "the step a");
    EXPECT_EQ(in_reverse(title), "krok b");
    EXPECT_EQ(in_reverse(title, "en"), "krok a");
}

TEST(Said, IsKeptAndReadAsItWas) {
    for (const Said& said : {Said(), Said::that("rest"), Said::as_is("12 \"x\" %1 ż"),
                             Said::as_is(curriculum::LocalText{"a", "b"}),
                             Said::that("%1 of %2 are left").with(3).with(""),
                             Said::that("%1 of %2 are left")
                                 .with(Said::that("the step %1").with(Said::listed("rest")))
                                 .with(Said::as_is(curriculum::LocalText{"a", "b"}))})
        EXPECT_EQ(db::said_of_json(db::said_json(said)), said) << said.english();
    EXPECT_EQ(db::said_of_json({{"says", 7}, {"with", "x"}}), Said()) << "says nothing";
}

TEST(Said, AnErrorHasTheEnglishAndTheMeaning) {
    const StoreError error(Kind::kRefused, "open x: ", Said::that("it ended at %1").with("noon"));
    const StoreError copy = error;
    EXPECT_STREQ(copy.what(), "open x: it ended at noon");
    ASSERT_NE(copy.said(), nullptr);
    EXPECT_EQ(copy.said()->english(), "it ended at noon");
    EXPECT_EQ(StoreError(Kind::kLocked, "open x: database is locked").said(), nullptr);
}

class SaidTest : public StoreTest {};

// What scripts read is as it was; what the shell translates goes along.
TEST_P(SaidTest, TheStoreSaysBoth) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    const auto taken = failure_of([&] { store->accounts().create(trainee("anna")); });
    EXPECT_THAT(taken.what(), testing::EndsWith(": the login is taken; choose another one"));
    ASSERT_NE(taken.said(), nullptr);
    EXPECT_EQ(taken.said()->english(), "the login is taken; choose another one");
    const auto easy = failure_of([&] { store->accounts().set_password(anna, "short"); });
    EXPECT_THAT(easy.what(),
                testing::EndsWith(": the length of the password is 5; it needs at least 10"));
    ASSERT_NE(easy.said(), nullptr);
    EXPECT_EQ(easy.said()->english(), "the length of the password is 5; it needs at least 10");
    const auto course = failure_of(
        [&] { (void)db::issue_certificate(*store, anna, "first_steps", "2026-11-21T12:00:00Z"); });
    EXPECT_THAT(course.what(),
                testing::StartsWith("certificate of first_steps: not mastered yet. "));
    ASSERT_NE(course.said(), nullptr);
    EXPECT_NE(course.said()->in("pl", [](const char* english) { return std::string(english); }),
              course.said()->english())
        << "why it is not mastered has its own Polish";
    const auto gone = failure_of([&] { (void)store->attempts().detail(999); });
    EXPECT_EQ(gone.said(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Engines, SaidTest, testing::Values("Sqlite"), engine_name);

}  // namespace THIS_TEST
