// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an editor of courses needs: every problem of a draft at once and where it is, changes that
// keep the stages consistent, and undo. Pure values; no window.

#include <cstdint>
#include <string>
#include <vector>

#include "curriculum/course.h"

namespace placode::curriculum {

enum class CourseFault : uint8_t {
    kId,              ///< Not letters, digits, _ . or -
    kTitle,           ///< No English title.
    kNoStages,        ///< Or more than 100.
    kTask,            ///< No such task.
    kStageId,         ///< Not letters, digits, _ . or -
    kStageIdTwice,    ///< Two stages of one id.
    kRequires,        ///< Waits for a stage that is not an earlier one.
    kBenchmark,       ///< Not from 0 to 100 points.
    kConsecutive,     ///< Not from 1 to 20.
    kPracticeLimit,   ///< A limit on a stage that is no exam.
    kTooFewAttempts,  ///< The limit is below the number that is wanted in a row, or above 1000.
    kRemind,          ///< Not from 0 to 3650 days.
    kNoSeeds,         ///< An exam without seeds, or with more than 100.
    kSeedTwice,
};

struct CourseProblem {
    CourseFault fault = CourseFault::kId;
    int stage = -1;       ///< -1 = the course itself.
    std::string pointer;  ///< JSON pointer of the field, "/stages/0/task_id".
    std::string value;    ///< What was found.
};

/// Everything that load_course_text() or load_course() would refuse, in the order of the file;
/// empty = may be published. @param tasks ids that exist.
[[nodiscard]] std::vector<CourseProblem> check_course(const Course& course,
                                                      const std::vector<std::string>& tasks);

/// A stage of the task at the end, open once the one before it is mastered; its id is made unique.
void add_stage(Course& course, const std::string& task_id);
/// Another task; an id that came from the old one (add_stage()) comes from the new one.
void set_task(Course& course, size_t index, const std::string& task_id);
/// Also takes it out of what others wait for. @pre 0 <= index < stages.
void remove_stage(Course& course, size_t index);
/// Moves to `to`; nobody waits for a later stage afterwards. @pre both are stages.
void move_stage(Course& course, size_t from, size_t to);
/// The others wait for it under its new id.
void rename_stage(Course& course, size_t index, const std::string& id);

/// "1, 2, 3" and back. Throws std::invalid_argument naming the word that is no number from 0 to
/// 2^53 - 1.
[[nodiscard]] std::string seeds_text(const std::vector<uint64_t>& seeds);
[[nodiscard]] std::vector<uint64_t> seeds_of_text(const std::string& text);

/// A draft with its past.
class CourseDraft {
 public:
    explicit CourseDraft(Course course) : now_(std::move(course)) {}
    [[nodiscard]] const Course& course() const noexcept { return now_; }
    /// Changes one after the other with the same key (typing in one field) are one step; an empty
    /// key is a step of its own. A change that changes nothing is none.
    void change(Course course, const std::string& key = {});
    void undo();  ///< Does nothing without a past.
    void redo();
    [[nodiscard]] bool can_undo() const noexcept { return !past_.empty(); }
    [[nodiscard]] bool can_redo() const noexcept { return !future_.empty(); }

 private:
    Course now_;
    std::vector<Course> past_, future_;
    std::string key_;
};

}  // namespace placode::curriculum
