// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to hear, as samples, and when.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string_view>
#include <system_error>

#include "ui/attempt/sound.h"
#include "ui/attempt/user_settings.h"

namespace placode::ui {

namespace {

constexpr const char* kSoundFile = "sound";
constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kAlarmPauseS = 1.5;   // the same alarm no more often
constexpr double kFullHissM3S = 2e-9;  // a 12 W cut boils about 2 mm3/s

/// Whole periods in a second, so that the loop has no seam.
std::vector<float> chord(std::initializer_list<std::pair<int, double>> partials, double wobble_hz,
                         double wobble) {
    std::vector<float> out(kSampleRate);
    for (size_t i = 0; i < out.size(); ++i) {
        const double t = static_cast<double>(i) / kSampleRate;
        double x = 0;
        for (const auto& [hz, share] : partials) x += share * std::sin(kTwoPi * hz * t);
        out[i] =
            static_cast<float>(x * (1 - wobble * (0.5 - 0.5 * std::cos(kTwoPi * wobble_hz * t))));
    }
    return out;
}

/// Noise without its low half; the end is faded into the beginning.
std::vector<float> hiss() {
    constexpr int kFade = 2048;
    std::vector<float> raw(kSampleRate + kFade);
    uint32_t random = 2463534242U;
    double low = 0, last = 0;
    for (float& x : raw) {
        random ^= random << 13;
        random ^= random >> 17;
        random ^= random << 5;
        const double white = static_cast<double>(random) / 4294967296.0 * 2 - 1;
        low += 0.45 * (white - low);
        x = static_cast<float>(0.6 * (low - last));
        last += 0.2 * (low - last);
    }
    std::vector<float> out(raw.begin(), raw.begin() + kSampleRate);
    for (int i = 0; i < kFade; ++i) {
        const double share = static_cast<double>(i) / kFade;
        const auto k = static_cast<size_t>(i);
        out[k] = static_cast<float>(out[k] * std::sqrt(share) +
                                    raw[k + kSampleRate] * std::sqrt(1 - share));
    }
    return out;
}

/// Tones one after the other, each with soft edges.
std::vector<float> beeps(std::initializer_list<std::pair<double, double>> notes, double gap_s) {
    std::vector<float> out;
    for (const auto& [hz, seconds] : notes) {
        const auto n = static_cast<size_t>(seconds * kSampleRate);
        for (size_t i = 0; i < n; ++i) {
            const double t = static_cast<double>(i) / kSampleRate;
            const double edge = std::min({1.0, t / 0.008, (seconds - t) / 0.03});
            out.push_back(static_cast<float>(
                0.5 * edge * (std::sin(kTwoPi * hz * t) + 0.3 * std::sin(2 * kTwoPi * hz * t))));
        }
        out.insert(out.end(), static_cast<size_t>(gap_s * kSampleRate), 0.0F);
    }
    return out;
}

}  // namespace

std::vector<float> synthesise(Tone tone) {
    switch (tone) {
        case Tone::kCut:  // higher and steady
            return chord({{660, 0.34}, {1320, 0.12}, {1980, 0.05}}, 1, 0);
        case Tone::kCoag:  // lower and beating: never taken for the other
            return chord({{392, 0.38}, {784, 0.10}, {1176, 0.06}}, 12, 0.35);
        case Tone::kHiss:
            return hiss();
    }
    return {};
}

std::vector<float> synthesise(Alarm alarm) {
    switch (alarm) {
        case Alarm::kContact:
            return beeps({{880, 0.11}, {660, 0.16}}, 0.03);
        case Alarm::kHeat:
            return beeps({{1175, 0.09}, {1175, 0.09}, {1175, 0.16}}, 0.06);
        case Alarm::kTime:
            return beeps({{523, 0.22}, {784, 0.40}}, 0.02);
    }
    return {};
}

SoundSettings load_sound_settings() {
    SoundSettings settings;
    std::ifstream in(settings_file(kSoundFile));
    in.imbue(std::locale::classic());
    std::string word;
    while (in >> word) {
        double value = 0;
        if (!(in >> value)) break;
        if (word == "volume" && value >= 0 && value <= 1) settings.volume = value;
        if (word == "muted") settings.muted = value != 0;
    }
    return settings;
}

void save_sound_settings(const SoundSettings& settings) {
    std::error_code error;
    std::filesystem::create_directories(settings_file(kSoundFile).parent_path(), error);
    std::ofstream out(settings_file(kSoundFile));
    out.imbue(std::locale::classic());
    out << "volume " << settings.volume << "\nmuted " << (settings.muted ? 1 : 0) << '\n';
}

SoundScore::Wish SoundScore::listen(const sim::Snapshot& snapshot, double time_limit_s, bool exam) {
    Wish wish;
    const double now = snapshot.time_s;
    if (snapshot.paused != 0 || snapshot.finished != 0) return wish;
    bool touching = false;
    for (int i = 0; i < snapshot.tool_count; ++i) {
        const sim::ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        const bool live = tool.energised != 0;
        // Both pedals at once give nothing, as at the generator.
        if (live && tool.pedals == sim::kPedalCut) wish.cut = 1;
        if (live && tool.pedals == sim::kPedalCoag) wish.coag = 1;
        touching = touching ||
                   (tool.in_contact != 0 && tool.engaged != 0 &&
                    tool.kind != sim::ToolKind::kScope && tool.touched == sim::Tissue::kPlacode);
    }
    wish.hiss = std::clamp(static_cast<double>(snapshot.vapour_rate_m3_s) / kFullHissM3S, 0.0, 1.0);
    if (!exam && touching && !touching_ && now - touch_at_s_ > kAlarmPauseS) {
        wish.alarms.push_back(Alarm::kContact);
        touch_at_s_ = now;
    }
    touching_ = touching;
    const std::string_view message(snapshot.message.data());
    const double said_at = now - snapshot.message_age_s;
    const bool hot = message == "Placode heated" || message == "Placode burned";
    if (!exam && hot && said_at > message_at_s_ + 1e-6 && now - heat_at_s_ > kAlarmPauseS) {
        wish.alarms.push_back(Alarm::kHeat);
        heat_at_s_ = now;
    }
    message_at_s_ = std::max(message_at_s_, said_at);
    for (const double left : {60.0, 10.0}) {
        const double at = time_limit_s - left;
        if (at > 5 && last_s_ >= 0 && last_s_ < at && now >= at) {
            wish.alarms.push_back(Alarm::kTime);
            wish.left_s = static_cast<int>(left);
        }
    }
    last_s_ = now;
    return wish;
}

}  // namespace placode::ui
