// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reason_json.h"

#include <gtest/gtest.h>

namespace placode::db {
namespace THIS_TEST {

assessment::ReasonMeaning meaning() {
    assessment::ReasonMeaning made;
    made.pattern = "It opened{where}.";
    made.metric = "slit_burst_cmh2o";
    made.value = 1.0 / 3.0;
    made.count = 1;
    made.hour = 11;
    return made;
}

TEST(ReasonJson, APlaceAlongASlitIsKept) {
    for (const assessment::BetweenBites& between :
         {assessment::BetweenBites{2, 3, false}, assessment::BetweenBites{0, 1, true},
          assessment::BetweenBites{3, 0, false}}) {
        assessment::ReasonMeaning kept = meaning();
        kept.between = between;
        EXPECT_EQ(reason_from_json(reason_json(kept)), kept);
    }
}

/// Texts of older programs have no such word, and other reasons need none.
TEST(ReasonJson, WithoutAPlaceNothingIsWritten) {
    const std::string text = reason_json(meaning());
    EXPECT_EQ(text.find("between"), std::string::npos) << text;
    EXPECT_EQ(reason_from_json(text), meaning());
}

TEST(ReasonJson, AnOddPlaceIsNone) {
    std::string text = reason_json(meaning());
    text.back() = ',';
    for (const char* odd : {"\"between\":7}", "\"between\":[]}", "\"between\":[-2,-3]}",
                            "\"between\":[\"a\",null]}", "\"between\":{\"a\":1}}"})
        EXPECT_FALSE(reason_from_json(text + odd).between.any()) << odd;
}

}  // namespace THIS_TEST
}  // namespace placode::db
