// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is next in a course, and why, in plain words: one pure function for every page and command.

#include <string>
#include <vector>

#include "curriculum/course.h"

namespace placode::curriculum {

enum class NextKind : uint8_t {
    kWait,       ///< The assignment begins later.
    kRefresh,    ///< A mastered stage is due again: a rare skill decays.
    kStart,      ///< First stage that is open and was never tried.
    kContinue,   ///< Tried, not mastered.
    kExam,       ///< An exam stage is open.
    kExhausted,  ///< Nothing is open: attempts are used up.
    kFinished    ///< All mastered, nothing due.
};
[[nodiscard]] const char* next_kind_name(NextKind kind);

/// When a course is to be done; empty = no such date.
struct CourseDates {
    std::string starts_utc, due_utc;
};

struct NextStep {
    NextKind kind = NextKind::kFinished;
    int stage = -1;  ///< Into Course::stages; -1 = nothing to do.
    std::string stage_id, task_id;
    uint64_t seed = 0;       ///< kExam, also kRefresh of one: the seed to use.
    int to_go = 0;           ///< Benchmarks in a row that are missing.
    int attempts_left = -1;  ///< -1 = no limit.
    bool overdue = false;    ///< The course's own date has passed.
    int days_left = -1;      ///< Whole days to that date; -1 = none or passed.
    LocalText reason;        ///< Why, one or two sentences.
};

/// `titles` gives a task's title by id, for the words; a task without one is named by its id.
[[nodiscard]] NextStep next_step(const Course& course, const CourseProgress& progress,
                                 const std::map<std::string, LocalText>& titles,
                                 const CourseDates& dates, const std::string& now_utc);

}  // namespace placode::curriculum
