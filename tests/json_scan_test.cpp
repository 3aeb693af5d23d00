// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/json_scan.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace placode::haptics {
namespace THIS_TEST {

TEST(JsonScan, WalksObjectsAndArraysAndSkipsTheRest) {
    JsonScan scan(
        R"( {"a":{"deep":[1,{"x":"}]\""}]},"b":[1.5,-2e3],"c":"text","d":true,"e":null} )");
    std::vector<double> numbers;
    std::string text;
    bool truth = false;
    std::vector<std::string> keys;
    EXPECT_TRUE(scan.object([&](std::string_view key) {
        keys.emplace_back(key);
        if (key == "b") scan.array([&] { numbers.push_back(scan.number(0)); });
        if (key == "c") text = scan.text();
        if (key == "d") truth = scan.truth(false);
    }));
    EXPECT_FALSE(scan.failed());
    EXPECT_EQ(keys, (std::vector<std::string>{"a", "b", "c", "d", "e"}));
    EXPECT_EQ(numbers, (std::vector<double>{1.5, -2000}));
    EXPECT_EQ(text, "text");
    EXPECT_TRUE(truth);
}

TEST(JsonScan, GivesTheOtherwiseForAnotherKindAndTakesNothing) {
    JsonScan scan(R"({"a":"7","b":7})");
    double a = 0, b = 0;
    scan.object([&](std::string_view key) {
        if (key == "a") a = scan.number(-1);
        if (key == "b") b = scan.number(-1);
    });
    EXPECT_EQ(a, -1);
    EXPECT_EQ(b, 7);
    EXPECT_FALSE(scan.failed());
}

TEST(JsonScan, FailsForBrokenTextAndNeverRunsPastIt) {
    for (const std::string& text : std::vector<std::string>{
             "", "{", "{\"a\"", "{\"a\":", "{\"a\":1", "{\"a\":1,", "{\"a\":1,}", "{a:1}", "[1]",
             "{\"a\":[1,2}", "{\"a\":\"x", "{\"a\":\"x\\", "{\"a\":tru}", "{\"a\" 1}"}) {
        JsonScan scan(text);
        const bool good = scan.object([](std::string_view) {});
        EXPECT_FALSE(good && !scan.failed()) << text;
    }
    std::string deep;
    for (int i = 0; i < 5000; ++i) deep += "{\"a\":";
    JsonScan scan(deep);
    EXPECT_FALSE(scan.object([](std::string_view) {}));
    EXPECT_TRUE(scan.failed()) << "depth is limited: a servo thread has a small stack";
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
