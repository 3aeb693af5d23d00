// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The course "short" of one exam, "final", whose cases come in turn.

#include <string>
#include <vector>

#include "db/store.h"

namespace placode::test {

/// As its JSON. @param rules of the stage, each with a comma behind it. @param seeds of the exam.
inline std::string exam_course(const std::string& task, const std::string& seeds,
                               const std::string& rules = {}) {
    return R"({"id":"short","version":1,"title":{"en":"Short"},"stages":[{"id":"final",)" + rules +
           R"("task_id":")" + task +
           R"(","mode":"exam","consecutive":1,"benchmark_points":0,"exam":{"seeds":[)" + seeds +
           R"(],"proctor":false}}]})";
}

/// Publishes it.
inline void publish_exam(db::Store& store, const std::string& task, const std::string& seeds,
                         const std::string& rules = {}) {
    db::DefinitionRecord course;
    course.kind = "course";
    course.id = "short";
    course.version = 1;
    course.json = exam_course(task, seeds, rules);
    course.reason = "test";
    store.definitions().publish(course);
}

/// Has a person do it. Gives the number of the assignment.
inline int64_t assign_exam(db::Store& store, int64_t user) {
    db::AssignmentRecord assignment;
    assignment.course_id = "short";
    assignment.course_version = 1;
    assignment.user_id = user;
    return store.courses().assign(assignment);
}

}  // namespace placode::test
