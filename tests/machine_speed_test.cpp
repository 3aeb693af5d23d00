// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/machine_speed.h"

#include <gtest/gtest.h>

#include <vector>

namespace placode::curriculum {
namespace THIS_TEST {

/// A computer with a clock of its own: so many frames and pictures in each second.
class Computer {
 public:
    Computer() { speed.start(now_, 0); }
    void second(double frames, double pictures) {
        for (int i = 0; i < 1000; ++i) {
            now_ += std::chrono::milliseconds(1);
            shown_ += pictures / 1000;
            const auto spell =
                speed.frame(now_, frames / 1e6, static_cast<uint64_t>(shown_ + 1e-6), 1);
            if (spell) spells.push_back(*spell);
        }
    }
    MachineSpeed speed;
    std::vector<sim::Event> spells;

 private:
    MachineSpeed::Clock::time_point now_{};
    double shown_ = 0;
};

TEST(MachineSpeed, OneThatKeepsUpCounts) {
    Computer computer;
    EXPECT_FALSE(computer.speed.closing(0));
    EXPECT_FALSE(computer.speed.counts_for_nothing());
    for (int i = 0; i < 20; ++i) computer.second(1000, 60);
    EXPECT_NEAR(computer.speed.real_time(), 1, 1e-9);
    EXPECT_NEAR(computer.speed.pictures_hz(), 60, 1);
    EXPECT_FALSE(computer.speed.counts_for_nothing());
    const auto end = computer.speed.closing(20);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->kind, sim::EventKind::kMachineSpeed);
    EXPECT_NEAR(end->value, 1, 1e-6);
}

TEST(MachineSpeed, SlowMotionDoesNot) {
    Computer computer;
    for (int i = 0; i < 10; ++i) computer.second(900, 60);
    EXPECT_NEAR(computer.speed.real_time(), 0.9, 1e-6);
    EXPECT_TRUE(computer.speed.slow());
    EXPECT_TRUE(computer.speed.counts_for_nothing());
}

TEST(MachineSpeed, ASlideShowDoesNot) {
    Computer computer;
    for (int i = 0; i < 10; ++i) computer.second(1000, 12);
    EXPECT_NEAR(computer.speed.pictures_hz(), 12, 1);
    EXPECT_TRUE(computer.speed.counts_for_nothing());
}

TEST(MachineSpeed, LessThanAPictureASecondIsNotTakenForNoWindow) {
    Computer computer;
    for (int i = 0; i < 20; ++i) computer.second(1000, i % 3 == 0 ? 1 : 0);
    ASSERT_TRUE(computer.speed.closing(20));
    EXPECT_GT(computer.speed.closing(20)->value2, 0);
    EXPECT_LT(computer.speed.closing(20)->value2, 20);
    Computer headless;
    for (int i = 0; i < 5; ++i) headless.second(1000, 0);
    EXPECT_EQ(headless.speed.closing(5)->value2, 0);
}

TEST(MachineSpeed, OneBadSecondInTenIsForgivenThreeAreNot) {
    Computer computer;
    for (int i = 0; i < 20; ++i) computer.second(1000, i % 10 == 3 ? 5 : 50);
    EXPECT_FALSE(computer.speed.counts_for_nothing());
    for (int i = 0; i < 5; ++i) computer.second(1000, 5);
    EXPECT_TRUE(computer.speed.counts_for_nothing());
}

TEST(MachineSpeed, ASlowStartCostsNoAttempt) {
    // Shaders are compiled and the picture is made simpler while the first step is under way.
    Computer computer;
    for (int i = 0; i < 5; ++i) computer.second(1000, 9);
    EXPECT_TRUE(computer.speed.counts_for_nothing()) << "nothing better was seen yet";
    for (int i = 0; i < 6; ++i) computer.second(1000, 40);
    EXPECT_FALSE(computer.speed.counts_for_nothing()) << computer.speed.pictures_hz();
    // But one that was slow for half of its time does not count, however short it is.
    Computer half;
    for (int i = 0; i < 4; ++i) half.second(1000, i < 2 ? 40 : 9);
    EXPECT_FALSE(half.speed.counts_for_nothing());
    half.second(1000, 9);
    EXPECT_TRUE(half.speed.counts_for_nothing());
}

TEST(MachineSpeed, ASpellIsToldWhenItIsOver) {
    Computer computer;
    computer.second(1000, 60);
    for (int i = 0; i < 4; ++i) computer.second(1000, i == 2 ? 7 : 15);
    EXPECT_TRUE(computer.spells.empty());
    computer.second(1000, 60);
    ASSERT_EQ(computer.spells.size(), 1U);
    EXPECT_NEAR(computer.spells[0].value, 4, 0.01);
    EXPECT_NEAR(computer.spells[0].value2, 7, 1);
    computer.second(1000, 10);  // a hiccup is no spell
    computer.second(1000, 60);
    EXPECT_EQ(computer.spells.size(), 1U);
}

TEST(MachineSpeed, TimeOfAPauseIsNobodysFault) {
    MachineSpeed speed;
    MachineSpeed::Clock::time_point now{};
    speed.start(now, 0);
    now += std::chrono::seconds(60);  // in the menu
    speed.start(now, 600);
    uint64_t pictures = 600;
    for (int i = 0; i < 2000; ++i) {
        now += std::chrono::milliseconds(1);
        if (i % 20 == 0) ++pictures;
        (void)speed.frame(now, 1e-3, pictures, 0);
    }
    EXPECT_NEAR(speed.real_time(), 1, 1e-6);
    EXPECT_FALSE(speed.counts_for_nothing());
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
