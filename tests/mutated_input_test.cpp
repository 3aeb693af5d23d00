// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a loader is given, it loads or refuses with its own exception: no crash, no hang, no
// other exception. Every loader gets files of the project, changed at random from a fixed seed.
// PLACODE_MUTATIONS=N tries N changes of each file. scripts/fuzz.sh lets libFuzzer look for more,
// under AddressSanitizer and UBSan.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "sim/core/random.h"
#include "tests/bars.h"
#include "tests/loaders.h"

using namespace placode;
using namespace placode::test;
namespace fs = std::filesystem;

namespace THIS_TEST {

/// What breaks parsers: ends of ranges, wrong types, brackets, other encodings.
const std::vector<std::string>& words() {
    static const std::vector<std::string> all{"-1",
                                              "0",
                                              "1e300",
                                              "-1e308",
                                              "1e-320",
                                              "NaN",
                                              "null",
                                              "true",
                                              "[]",
                                              "{}",
                                              "\"\"",
                                              "\"",
                                              "{",
                                              "}",
                                              "[",
                                              "]",
                                              ",",
                                              ":",
                                              "\n",
                                              "\r\n",
                                              "\t",
                                              "99999999999999999999",
                                              "2147483648",
                                              "-9223372036854775808",
                                              "../../../etc/passwd",
                                              "%00",
                                              "\\u0000",
                                              "\xff\xfe",
                                              "\xc3\x28",
                                              std::string(3, '\0'),
                                              std::string(300, '9'),
                                              std::string(200, '['),
                                              "\"id\":",
                                              "\"extends\":"};
    return all;
}

std::string mutated(std::string text, sim::SplitMix64& random) {
    const auto below = [&](size_t n) {
        return n == 0 ? 0 : static_cast<size_t>(random.next() % n);
    };
    const size_t changes = 1 + below(4);
    for (size_t i = 0; i < changes; ++i) {
        const size_t at = below(text.size() + 1), length = 1 + below(40);
        switch (below(7)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(random.next());
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, words()[below(words().size())]);
                break;
            case 3:  // another word in the place of a number or name
                text.replace(at, std::min(length, text.size() - at),
                             words()[below(words().size())]);
                break;
            case 4:
                text.insert(at, text.substr(below(text.size() + 1), length));
                break;
            case 5:
                text.resize(at);
                break;
            default: {
                const size_t digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos) text.insert(digit, words()[below(8)]);
            }
        }
    }
    return text;
}

class MutatedInput : public testing::TestWithParam<Loader> {};

/// Milliseconds in truth: the limit is for what hangs.
void load(const Loader& loader, const std::string& text, const std::string& what) {
    const auto begin = std::chrono::steady_clock::now();
    try {
        loader.load(text);
    } catch (const std::exception& error) {
        EXPECT_TRUE(is_refusal(error)) << what << ": " << error.what();
        EXPECT_LT(std::string(error.what()).size(), 4000u) << what << ": nobody reads that";
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << what;
}

INSTANTIATE_TEST_SUITE_P(Loaders, MutatedInput, testing::ValuesIn(loaders()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(MutatedInput, IsLoadedOrRefused) {
    const Loader& loader = GetParam();
    const std::vector<Seed> seeds = loader.seeds();
    ASSERT_FALSE(seeds.empty());
    const char* set = std::getenv("PLACODE_MUTATIONS");
    const int each = set != nullptr ? std::atoi(set) : times(500, 20000);
    for (const Seed& seed : seeds) {
        ASSERT_FALSE(seed.content.empty()) << seed.name;
        sim::SplitMix64 random(std::hash<std::string>{}(seed.name));
        for (int i = 0; i < each; ++i)
            load(loader, mutated(seed.content, random), seed.name + " change " + std::to_string(i));
    }
    for (const std::string& word : words()) load(loader, word, "\"" + word + "\"");
    load(loader, "", "nothing");
}

/// What libFuzzer found once (scripts/fuzz.sh), so that it never comes back.
TEST_P(MutatedInput, WhatWasFoundOnceIsLoadedOrRefused) {
    const fs::path found = fs::path(PLACODE_SOURCE_DIR) / "tests/data/fuzz" / GetParam().name;
    if (!fs::exists(found)) GTEST_SKIP() << "nothing was found";
    for (const auto& entry : fs::directory_iterator(found))
        load(GetParam(), content_of(entry.path()), entry.path().filename().string());
}

}  // namespace THIS_TEST
