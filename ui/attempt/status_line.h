// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Status for whoever started this program: one JSON object a line on standard output.

#include <unistd.h>

#include <chrono>
#include <optional>
#include <string>

#include "curriculum/attempt_runner.h"
#include "ui/attempt/line_output.h"

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

/// Prints and flushes when `enabled`; otherwise silent. Whoever reads a pipe may hang: the attempt
/// does not wait for that, the lines of meanwhile are dropped, each as a whole.
class StatusLine {
 public:
    /// `stream`: where the lines go, standard output but for tests; stays open.
    explicit StatusLine(bool enabled, int stream = STDOUT_FILENO);
    void set_replay(const ReplayStatus& replay) { replay_ = replay; }
    /// At most ten times a second unless `now`.
    void print(const curriculum::AttemptStatus& status, bool now = false);
    /// Last line; waits at most kPatience for a pipe that is full. `recording` empty = none.
    void end(const curriculum::AttemptStatus& status, const std::string& reason,
             const std::string& recording, const std::string& detail = {},
             const std::string& haptics = {});

    static constexpr std::chrono::milliseconds kPatience{3000};

 private:
    std::optional<LineOutput> output_;
    std::optional<ReplayStatus> replay_;
    double last_s_ = -1;  // monotonic
};

[[nodiscard]] std::string reason_text(sim::EndReason reason);

}  // namespace placode::ui
