// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/sound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <numbers>

namespace placode::ui {
namespace THIS_TEST {

/// Share of one frequency in a signal, by its Fourier sum.
double share_of(const std::vector<float>& x, double hz) {
    std::complex<double> sum;
    for (size_t i = 0; i < x.size(); ++i)
        sum += static_cast<double>(x[i]) *
               std::polar(1.0, -2 * std::numbers::pi * hz * static_cast<double>(i) / kSampleRate);
    return 2 * std::abs(sum) / static_cast<double>(x.size());
}
double loudness(const std::vector<float>& x) {
    double sum = 0;
    for (const float v : x) sum += static_cast<double>(v) * static_cast<double>(v);
    return x.empty() ? 0 : std::sqrt(sum / static_cast<double>(x.size()));
}

sim::Snapshot snapshot(double time_s) {
    sim::Snapshot s;
    s.time_s = time_s;
    s.tool_count = 1;
    s.tools[0].engaged = 1;
    return s;
}

TEST(Sound, CutAndCoagulationAreDifferentTonesWithoutASeam) {
    const auto cut = synthesise(Tone::kCut), coag = synthesise(Tone::kCoag);
    EXPECT_GT(share_of(cut, 660), 10 * share_of(cut, 392));
    EXPECT_GT(share_of(coag, 392), 10 * share_of(coag, 660));
    for (const auto& tone : {cut, coag}) {
        ASSERT_EQ(tone.size(), static_cast<size_t>(kSampleRate));
        float step = 0;
        for (size_t i = 1; i < tone.size(); ++i)
            step = std::max(step, std::abs(tone[i] - tone[i - 1]));
        EXPECT_LE(std::abs(tone.front() - tone.back()), 1.01F * step);  // as smooth as elsewhere
    }
}

TEST(Sound, NothingClipsAndAlarmsBeginAndEndQuietly) {
    for (int i = 0; i < kAlarms; ++i) {
        const auto alarm = synthesise(static_cast<Alarm>(i));
        EXPECT_LT(std::abs(alarm.front()), 0.02F);
        EXPECT_LT(std::abs(alarm.back()), 0.02F);
        for (const float x : alarm) EXPECT_LE(std::abs(x), 1.0F);
    }
    for (const float x : synthesise(Tone::kHiss)) ASSERT_LE(std::abs(x), 1.0F);
}

TEST(Sound, TonesFollowTheEnergyAndAlarmsSoundOnce) {
    SoundScore score;
    sim::Snapshot s = snapshot(1);
    s.tools[0].energised = 1;
    s.tools[0].pedals = sim::kPedalCut;
    EXPECT_EQ(score.listen(s, 0, false).cut, 1);
    s.tools[0].pedals = sim::kPedalCoag;
    EXPECT_EQ(score.listen(s, 0, false).coag, 1);
    s.tools[0].energised = 0;
    EXPECT_EQ(score.listen(s, 0, false).coag, 0);
    s.tools[0].in_contact = 1;
    s.tools[0].touched = sim::Tissue::kPlacode;
    EXPECT_EQ(score.listen(s, 0, false).alarms, std::vector{Alarm::kContact});
    s.time_s = 1.1;
    EXPECT_TRUE(score.listen(s, 0, false).alarms.empty());  // still the same touch
    std::strcpy(s.message.data(), "Placode heated");
    s.message_age_s = 0.05F;
    EXPECT_EQ(score.listen(s, 0, false).alarms, std::vector{Alarm::kHeat});
}

TEST(Sound, AnExamWarnsOfTheTimeOnly) {
    SoundScore score;
    sim::Snapshot s = snapshot(59.9);
    s.tools[0].in_contact = 1;
    s.tools[0].touched = sim::Tissue::kPlacode;
    EXPECT_TRUE(score.listen(s, 120, true).alarms.empty());
    s.time_s = 60.05;  // a minute left
    const SoundScore::Wish last_minute = score.listen(s, 120, true);
    EXPECT_EQ(last_minute.alarms, std::vector{Alarm::kTime});
    EXPECT_EQ(last_minute.left_s, 60) << "said in words, too";
}

TEST(Sound, PausedIsSilent) {
    SoundScore score;
    sim::Snapshot s = snapshot(1);
    s.tools[0].energised = 1;
    s.tools[0].pedals = sim::kPedalCut;
    s.paused = 1;
    EXPECT_EQ(score.listen(s, 0, false).cut, 0);
}

TEST(Sound, WhatIsPlayedIsHeardInTheLoopback) {
    Sound sound({.volume = 1.0, .muted = false}, Sound::Output::kLoopback);
    if (!sound.problem().empty()) GTEST_SKIP() << sound.problem();
    EXPECT_LT(loudness(sound.render(4410)), 1e-3);
    sound.play({.cut = 1, .coag = 0, .hiss = 0, .alarms = {}});
    (void)sound.render(8820);  // the mixer fades in
    const auto cut = sound.render(22050);
    EXPECT_GT(share_of(cut, 660), 0.05);
    EXPECT_LT(share_of(cut, 392), 0.1 * share_of(cut, 660));
    sound.play({.cut = 0, .coag = 0, .hiss = 0, .alarms = {Alarm::kHeat}});
    (void)sound.render(2205);
    EXPECT_GT(share_of(sound.render(4410), 1175), 0.02);
    sound.play({.cut = 1, .coag = 0, .hiss = 0, .alarms = {}});
    sound.set({.volume = 1.0, .muted = true});
    (void)sound.render(44100);
    EXPECT_LT(loudness(sound.render(4410)), 1e-3);
}

TEST(Sound, AComputerWithoutAudioSaysSoAndGoesOn) {
    setenv("ALSOFT_DRIVERS", "none", 1);  // as on a machine without a sound card
    Sound sound({}, Sound::Output::kDevice);
    unsetenv("ALSOFT_DRIVERS");
    sound.play({.cut = 1, .coag = 0, .hiss = 1, .alarms = {Alarm::kTime}});
    sound.silence();
    EXPECT_TRUE(sound.render(100).empty());
}

TEST(Sound, TheSettingIsKept) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "placode_sound";
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    save_sound_settings({.volume = 0.3, .muted = true});
    const SoundSettings settings = load_sound_settings();
    unsetenv("XDG_CONFIG_HOME");
    std::filesystem::remove_all(folder);
    EXPECT_NEAR(settings.volume, 0.3, 1e-6);
    EXPECT_TRUE(settings.muted);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
