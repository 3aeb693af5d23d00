// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a program leaves when it crashes: a text file on this computer with its version, the signal
// and the calls that led there. Nothing is sent anywhere; a person reads it first. It holds no data
// of the attempt or the store: names of functions and files of the program only.

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "ui/diagnostics/program_log.h"

namespace placode::ui {

/// From here on a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, an exception that nobody caught)
/// leaves "PROGRAM-PID.crash" in the folder, and the process ends by the signal as it would have.
/// Once a process, at its start. Does nothing under a sanitizer, which reports by itself.
/// @param version stays valid.
void report_crashes(const std::filesystem::path& folder, LogWord program, const char* version);

/// Opens the log and watches for crashes: the first thing that a program does.
void begin_diagnostics(LogWord program);

struct CrashReport {
    std::filesystem::path file;
    std::string program;   ///< "placode-sim"
    std::time_t time = 0;  ///< When it was written.
    std::string text;      ///< With "~" for the home folder: it has a person's log-in.
};
inline constexpr int kMostCrashReports = 10;

/// The newest first. Those beyond kMostCrashReports are removed.
[[nodiscard]] std::vector<CrashReport> crash_reports(const std::filesystem::path& folder);

}  // namespace placode::ui
