// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether what a program had to say has reached standard output.

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace placode::ui {

/// Says on standard error that standard output did not take all that was to stand there. `status`,
/// or 1 in the place of 0: a script would go on with half a text.
/// @param reason errno of what could not be written; 0 = not known.
[[nodiscard]] inline int not_arrived(const char* program, int status, int reason) {
    const std::string why = reason == 0 ? "" : " (" + std::generic_category().message(reason) + ")";
    std::fprintf(stderr,
                 "%s: standard output: cannot be written%s; what should stand there is not "
                 "whole\n",
                 program, why.c_str());
    return status == 0 ? 1 : status;
}

/// `status`, or what not_arrived() makes of it where standard output took not all. Whoever reads
/// through a pipe may have seen enough. For what was written by stdio, or by a std::cout that is in
/// step with it. At the end of a program.
[[nodiscard]] inline int arrived(const char* program, int status) {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    // Known only where the last of it failed.
    const int reason = errno;
    struct stat kind {};
    const bool is_pipe =
        ::fstat(STDOUT_FILENO, &kind) == 0 && (S_ISFIFO(kind.st_mode) || S_ISSOCK(kind.st_mode));
    if (reason == EPIPE || (reason == 0 && is_pipe)) return status;
    return not_arrived(program, status, reason);
}

}  // namespace placode::ui
