// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the commands of courses share.

#include <string>

#include "ui/cli/session.h"

namespace placode::cli {

struct CourseOptions {
    std::string id, file, user, group, reason, out, from, due, at, stage, new_id;
    int version = 0, attempts = 1;
    int64_t assignment = 0;
};

// course_assignment_commands.cpp
int course_assign(const Context& context, const CourseOptions& options);
int course_unassign(const Context& context, const CourseOptions& options);
int course_assignments(const Context& context, const CourseOptions& options);
int course_grant(const Context& context, const CourseOptions& options);

// course_next_command.cpp
int course_next(const Context& context, const CourseOptions& options);

}  // namespace placode::cli
