// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sound of an attempt: the generator's tones (cut and coagulation differ, as on a real one), the
// hiss of boiling tissue, and alarms. Everything is synthesised; without an audio device nothing
// happens, and `problem` says why. Main thread.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/step/snapshot.h"

namespace placode::ui {

enum class Tone : uint8_t { kCut, kCoag, kHiss };  ///< Go on while they are on.
enum class Alarm : uint8_t { kContact, kHeat, kTime };
inline constexpr int kTones = 3, kAlarms = 3;
inline constexpr int kSampleRate = 44100;

/// One second that can be repeated without a click [-1, 1].
[[nodiscard]] std::vector<float> synthesise(Tone tone);
[[nodiscard]] std::vector<float> synthesise(Alarm alarm);

struct SoundSettings {
    double volume = 0.6;  ///< 0 to 1.
    bool muted = false;
};
/// From $XDG_CONFIG_HOME/placode/sound; defaults where there is none.
[[nodiscard]] SoundSettings load_sound_settings();
/// Quietly does nothing where the folder cannot be written.
void save_sound_settings(const SoundSettings& settings);

/// What shall be heard of a snapshot. Pure: decides, makes no noise.
class SoundScore {
 public:
    struct Wish {
        double cut = 0, coag = 0, hiss = 0;  ///< 0 = silent, 1 = full.
        std::vector<Alarm> alarms;           ///< That begin now.
        int left_s =
            0;  ///< With Alarm::kTime: so much time is left [s], for those who do not hear.
    };
    /// @param exam warnings are silent then, as on the screen; the clock is not.
    [[nodiscard]] Wish listen(const sim::Snapshot& snapshot, double time_limit_s, bool exam);

 private:
    bool touching_ = false;
    double heat_at_s_ = -1e9, touch_at_s_ = -1e9, last_s_ = -1, message_at_s_ = -1e9;
};

/// Plays it, or does not.
class Sound {
 public:
    enum class Output : uint8_t {
        kDevice,   ///< What the computer has.
        kLoopback  ///< Into memory, for tests.
    };
    explicit Sound(const SoundSettings& settings, Output output = Output::kDevice);
    ~Sound();
    /// Empty, or why there is nothing to hear.
    [[nodiscard]] const std::string& problem() const;
    void play(const SoundScore::Wish& wish);
    void silence();  ///< Pause, end.
    void set(const SoundSettings& settings);
    [[nodiscard]] const SoundSettings& settings() const;
    /// Loopback only: the next samples (mono). Empty where the library cannot do it.
    [[nodiscard]] std::vector<float> render(int samples);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::ui
