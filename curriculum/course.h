// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A course: stages in order, what opens each of them, what masters it, and where somebody stands.
// A published version is never edited; a change is a new version with a reason.

#include <map>
#include <string>
#include <vector>

#include "curriculum/task.h"

namespace placode::curriculum {

enum class StageMode : uint8_t {
    kFamiliarisation,  ///< Counts whatever the score: to get to know instruments and field.
    kPractice,
    kExam  ///< Counts only what was done under the stage's exam conditions.
};
[[nodiscard]] const char* stage_mode_name(StageMode mode);

/// Conditions of an exam stage.
struct ExamRule {
    std::vector<uint64_t> seeds;      ///< Used in this order, one an attempt; then from the start.
    bool proctor = true;              ///< A proctor's name is required.
    bool haptic_certificate = false;  ///< The device's certificate is required.
};

struct CourseStage {
    std::string id;  ///< Unique in the course; the task's id where the file gives none.
    std::string task_id;
    StageMode mode = StageMode::kPractice;
    std::vector<std::string> requires_stages;  ///< Ids of stages that must be mastered first.
    double benchmark_points = 70;              ///< Score that counts.
    int consecutive = 2;        ///< This many times in a row, without a critical error.
    int max_attempts = 0;       ///< kExam only; 0 = no limit.
    int remind_after_days = 0;  ///< Skill decay: asks for one more after so many days; 0 = never.
    ExamRule exam;              ///< kExam only.
};

struct Course {
    std::string id;
    int version = 1;
    LocalText title, description;
    std::vector<CourseStage> stages;
    std::string json;  ///< The text it was read from, for the store.
    [[nodiscard]] const CourseStage* stage(const std::string& stage_id) const;
};

/// The outcome of one attempt, as far as a course cares. Oldest first in lists; what was practised
/// counts in the order in which it was saved.
struct AttemptOutcome {
    std::string task_id;
    double points = 0;
    bool critical = false;
    bool interrupted = false;  ///< Does not count; of an exam it uses up an attempt.
    /// Left or tuned by the person, late enough that it said how it went: it does not count, and
    /// ends what was met in a row.
    bool given_up = false;
    std::string at_utc = {};  ///< Start of the attempt; empty = unknown.
    uint64_t seed = 0;
    std::string exam_course = {}, exam_stage = {};  ///< Done as this exam; empty = practice.
    int exam_version = 0;  ///< Of the course that the exam was begun in; 0 = unknown.
    std::string proctor = {};
    bool certified = false;  ///< On a device with a haptic certificate.
    bool voided = false;     ///< Void for cause: the machine failed. Does not count.
    /// Nothing was done: neither met nor missed. An exam has shown its lesion, so there it uses up
    /// an attempt.
    bool not_attempted = false;
    bool unfinished = false;  ///< An exam that was begun and of which nothing was saved.
    int64_t saved = 0;  ///< Grows from each that is saved to the next; 0 = unknown, or none is.
    /// Says that it began before the one of its task that was saved before it: it was kept back, or
    /// their clocks differ. It lengthens no row of practice.
    bool late = false;
};

/// So long an attempt may be left or tuned without ending what was met in a row [s]: a wrong device
/// or a bad start is seen by then, and how it goes is not.
inline constexpr double kGiveUpAfterS = 10;

enum class StageStatus : uint8_t {
    kLocked,
    kOpen,
    kMastered,
    kExhausted  ///< All attempts used without mastery.
};

struct StageProgress {
    StageStatus status = StageStatus::kLocked;
    int streak = 0;    ///< Benchmarks met in a row, up to now; whoever gives one up begins anew.
    int attempts = 0;  ///< That count; of an exam also those that were left.
    /// Of `attempts`, those that the limit counts: up to the one that mastered it. What is repeated
    /// after that, as to refresh the skill, is not limited.
    int limited = 0;
    double best_points = 0;
    std::vector<std::string> missing;  ///< Task ids of the stages that still lock it.
    int attempts_left = -1;            ///< Towards mastery; -1 = no limit.
    bool last_critical = false;        ///< The last attempt had a critical error.
    std::string mastered_utc;          ///< Of the attempt that mastered it.
    std::string refresh_utc;           ///< From when the skill is to be refreshed; empty = never.
    bool refresh_due = false;
    uint64_t next_seed = 0;  ///< kExam: the case after the one that was shown last.
    int unfinished = 0;      ///< kExam: of `attempts`, those that were begun and never saved.
};

struct CourseProgress {
    std::vector<StageProgress> stages;
    int next_stage = -1;       ///< First open, not mastered stage; -1 = none.
    bool mastered = false;     ///< All stages.
    std::string mastered_utc;  ///< When the last of them was.
};

/// Attempts that an educator has granted beyond a stage's limit, by stage id.
using ExtraAttempts = std::map<std::string, int>;

/// By id of a shipped course, or by path. Throws DefinitionError; also when a task is not there.
[[nodiscard]] Course load_course(const std::string& id_or_file);
/// From a text that is to become a version. `origin` is used in messages.
[[nodiscard]] Course load_course_text(const std::string& json, const std::string& origin);
/// From the text of a version that a store keeps. A limit of practice, which was allowed once, is
/// left out.
[[nodiscard]] Course load_published_course(const std::string& json, const std::string& origin);
/// What an editor saves: load_course_text() of it gives the same course (but for `json`).
[[nodiscard]] std::string course_json(const Course& course);

/// True when the outcome belongs to the stage: right task, finished, and for an exam done under its
/// conditions. What another version of the course had for cases was checked when it was saved.
[[nodiscard]] bool counts_for(const Course& course, const CourseStage& stage,
                              const AttemptOutcome& outcome);

/// @param now_utc for reminders; empty = none are due.
[[nodiscard]] CourseProgress course_progress(const Course& course,
                                             const std::vector<AttemptOutcome>& outcomes,
                                             const std::string& now_utc = {},
                                             const ExtraAttempts& extra = {});

}  // namespace placode::curriculum
