// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/session_sound.h"

#include <algorithm>

#include "ui/attempt/user_settings.h"

namespace placode::ui {

namespace {

SoundSettings sound_settings(const Arguments& arguments) {
    SoundSettings settings = load_sound_settings();
    if (arguments.volume_percent >= 0) settings.volume = arguments.volume_percent / 100.0;
    settings.muted = settings.muted || arguments.mute;
    return settings;
}

}  // namespace

SessionSound::SessionSound(const Arguments& arguments) : sound_(sound_settings(arguments)) {}

double SessionSound::listen(const sim::Snapshot& snapshot, double time_limit_s, bool warnings) {
    const SoundScore::Wish wish = score_.listen(snapshot, time_limit_s, !warnings);
    sound_.play(wish);
    return wish.left_s;
}

std::string SessionSound::change(Command command) {
    SoundSettings settings = sound_.settings();
    settings.muted = command == Command::kMute && !settings.muted;
    if (command == Command::kLouder) settings.volume = std::min(1.0, settings.volume + 0.1);
    if (command == Command::kSofter) settings.volume = std::max(0.0, settings.volume - 0.1);
    sound_.set(settings);
    save_sound_settings(settings);
    return !sound_.problem().empty() ? "No sound on this computer"
           : settings.muted          ? "Sound off"
                                     : "Sound on";
}

}  // namespace placode::ui
