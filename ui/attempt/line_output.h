// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines for whoever started this program. Whoever reads a pipe may hang: nothing here waits for
// that.

#include <unistd.h>

#include <chrono>
#include <string>

namespace placode::ui {

/// Into a pipe that nobody reads lines are dropped, each as a whole. Elsewhere by stdio. One
/// thread.
class LineOutput {
 public:
    /// `stream`: where the lines go, standard output but for tests; stays open.
    explicit LineOutput(int stream = STDOUT_FILENO);
    ~LineOutput();
    LineOutput(const LineOutput&) = delete;
    LineOutput& operator=(const LineOutput&) = delete;
    /// `line` with its end. Waits at most `patience` for a pipe that is full.
    void send(const std::string& line, std::chrono::milliseconds patience = {});

 private:
    int pipe_ = -1;     // where the lines go; -1 = no pipe, by stdio
    std::string rest_;  // of a line that the pipe took in part
};

}  // namespace placode::ui
