// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Anatomy, operators, allocation to arms and bootstraps follow these numbers: they never change.

#include "sim/core/random.h"

#include <gtest/gtest.h>

namespace THIS_TEST {

using namespace placode::sim;

TEST(Random, GivesTheNumbersOfTheAuthorsProgram) {
    // https://prng.di.unimi.it/splitmix64.c with x = 1234567, as in the lists of Rosetta Code.
    SplitMix64 random(1234567);
    for (const uint64_t expected :
         {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
          4593380528125082431ULL, 16408922859458223821ULL})
        EXPECT_EQ(random.next(), expected);
}

TEST(Random, UniformLiesBetweenItsEnds) {
    SplitMix64 random(1);
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double value = random.uniform(-2, 4);
        ASSERT_GE(value, -2);
        ASSERT_LT(value, 4);
        sum += value;
    }
    EXPECT_NEAR(sum / 100000, 1, 0.02);  // 3.7 standard errors
}

TEST(Random, UniformIsTheUpper53Bits) {
    SplitMix64 one(99), same(99);
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(one.uniform(), static_cast<double>(same.next() >> 11) / 9007199254740992.0);
}

}  // namespace THIS_TEST
