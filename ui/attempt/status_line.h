// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Status for whoever started this program: one JSON object a line on standard output.

#include <optional>
#include <string>

#include "curriculum/attempt_runner.h"

namespace placode::ui {

/// What a replay adds to its lines.
struct ReplayStatus {
    bool paused = false;
    double speed = 1;      ///< Asked for.
    double pace = 0;       ///< Reached: simulated seconds a second, 0 = not known.
    double target_s = -1;  ///< Where it is simulating to without a picture; -1 = it plays.
    const char* camera = "scope";
    std::string problem;  ///< A command that was not understood.
};

/// Prints and flushes when `enabled`; otherwise silent.
class StatusLine {
 public:
    explicit StatusLine(bool enabled) : enabled_(enabled) {}
    void set_replay(const ReplayStatus& replay) { replay_ = replay; }
    /// At most ten times a second unless `now`.
    void print(const curriculum::AttemptStatus& status, bool now = false);
    /// Last line. `recording` empty = none.
    void end(const curriculum::AttemptStatus& status, const std::string& reason,
             const std::string& recording, const std::string& detail = {},
             const std::string& haptics = {});

 private:
    bool enabled_;
    std::optional<ReplayStatus> replay_;
    double last_s_ = -1;  // monotonic
};

[[nodiscard]] std::string reason_text(sim::EndReason reason);

}  // namespace placode::ui
