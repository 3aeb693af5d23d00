// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sound of an attempt: what is heard of the simulation, and the loudness that the keys change.

#include <string>

#include "sim/step/snapshot.h"
#include "ui/attempt/arguments.h"
#include "ui/attempt/attempt_controls.h"
#include "ui/attempt/sound.h"

namespace placode::ui {

/// Main thread.
class SessionSound {
 public:
    explicit SessionSound(const Arguments& arguments);

    /// Plays what this moment sounds like; returns the seconds that the clock's alarm announces, 0
    /// = none.
    double listen(const sim::Snapshot& snapshot, double time_limit_s, bool warnings);
    void silence() { sound_.silence(); }
    /// kMute, kLouder or kSofter; kept for the next attempt. Returns what it is now (English).
    [[nodiscard]] std::string change(Command command);

 private:
    Sound sound_;
    SoundScore score_;
};

}  // namespace placode::ui
