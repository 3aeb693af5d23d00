// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Status for whoever started this program: one JSON object a line on standard output.

#include <string>

#include "curriculum/attempt_runner.h"

namespace placode::ui {

/// Prints and flushes when `enabled`; otherwise silent.
class StatusLine {
 public:
    explicit StatusLine(bool enabled) : enabled_(enabled) {}
    /// At most twice a second unless `now`.
    void print(const curriculum::AttemptStatus& status, bool now = false);
    /// Last line. `recording` empty = none.
    void end(const curriculum::AttemptStatus& status, const std::string& reason,
             const std::string& recording, const std::string& detail = {},
             const std::string& haptics = {});

 private:
    bool enabled_;
    double last_s_ = -1;  // monotonic
};

[[nodiscard]] std::string reason_text(sim::EndReason reason);

}  // namespace placode::ui
