// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course.h"

#include <algorithm>
#include <set>

#include "curriculum/utc_time.h"

namespace placode::curriculum {

namespace {

constexpr int64_t kDayS = 86400;

/// One of its cases. A version whose cases were replaced takes nothing from who was examined
/// before: neither what was passed nor what was used up.
bool is_case_of(const Course& course, const CourseStage& stage, const AttemptOutcome& outcome) {
    if (outcome.exam_version != 0 && outcome.exam_version != course.version) return true;
    const std::vector<uint64_t>& seeds = stage.exam.seeds;
    return std::find(seeds.begin(), seeds.end(), outcome.seed) != seeds.end();
}

/// Done as this exam and under its conditions, whatever became of it.
bool is_exam_of(const Course& course, const CourseStage& stage, const AttemptOutcome& outcome) {
    return stage.mode == StageMode::kExam && outcome.task_id == stage.task_id &&
           outcome.exam_course == course.id && outcome.exam_stage == stage.id &&
           (!stage.exam.proctor || !outcome.proctor.empty()) &&
           (!stage.exam.haptic_certificate || outcome.certified) &&
           is_case_of(course, stage, outcome);
}

/// The case after `seed` in the list, then from the start; `due` where the list lacks it.
uint64_t seed_after(const std::vector<uint64_t>& seeds, uint64_t seed, uint64_t due) {
    auto next = std::find(seeds.begin(), seeds.end(), seed);
    if (next == seeds.end()) return due;
    return ++next == seeds.end() ? seeds.front() : *next;
}

/// One stage in the light of all outcomes: mastery that was reached once stays reached.
StageProgress stage_progress(const Course& course, const CourseStage& stage,
                             const std::vector<AttemptOutcome>& outcomes) {
    StageProgress progress;
    progress.status = StageStatus::kOpen;
    std::string last_met_utc;
    int outcomes_seen = 0, given_back = 0;
    if (!stage.exam.seeds.empty()) progress.next_seed = stage.exam.seeds.front();
    for (const AttemptOutcome& outcome : outcomes) {
        if (is_exam_of(course, stage, outcome)) {
            // Its case was seen, even where the machine spoilt the attempt.
            progress.next_seed = seed_after(stage.exam.seeds, outcome.seed, progress.next_seed);
            // A computer can be made slow: once is a mishap, and of more an educator judges, who
            // may grant another attempt.
            const bool spoilt = outcome.voided && given_back++ > 0;
            if (spoilt || (outcome.interrupted && !outcome.voided)) {
                // Whoever could leave an exam that goes badly could try as often as he likes.
                ++progress.attempts;
                if (outcome.unfinished) ++progress.unfinished;
                progress.streak = 0;
                continue;
            }
        }
        // Else whoever leaves every attempt that goes badly has met the benchmark "in a row".
        if (outcome.given_up && outcome.task_id == stage.task_id && stage.mode != StageMode::kExam)
            progress.streak = 0;
        if (!counts_for(course, stage, outcome)) continue;
        if (outcome.not_attempted) {
            ++progress.attempts;  // of an exam: counts_for() lets no other one in
            continue;
        }
        progress.best_points =
            outcomes_seen++ == 0 ? outcome.points : std::max(progress.best_points, outcome.points);
        ++progress.attempts;
        progress.last_critical = outcome.critical;
        const bool met = stage.mode == StageMode::kFamiliarisation ||
                         (outcome.points >= stage.benchmark_points && !outcome.critical);
        // One that was kept back may be from before another that missed.
        const int step = outcome.late && stage.mode != StageMode::kExam ? 0 : 1;
        progress.streak = met ? progress.streak + step : 0;
        if (met) last_met_utc = std::max(last_met_utc, outcome.at_utc);
        if (progress.streak >= stage.consecutive && progress.status != StageStatus::kMastered) {
            progress.status = StageStatus::kMastered;
            progress.mastered_utc = outcome.at_utc;
            progress.limited = progress.attempts;
        }
    }
    if (progress.status != StageStatus::kMastered) progress.limited = progress.attempts;
    if (progress.status == StageStatus::kMastered && stage.remind_after_days > 0) {
        if (const auto last = utc_seconds(last_met_utc))
            progress.refresh_utc = utc_text(*last + stage.remind_after_days * kDayS);
    }
    return progress;
}

void apply_limit(const CourseStage& stage, const ExtraAttempts& extra, StageProgress& progress) {
    if (stage.max_attempts == 0) return;
    const auto more = extra.find(stage.id);
    const int allowed = stage.max_attempts + (more == extra.end() ? 0 : more->second);
    progress.attempts_left = std::max(0, allowed - progress.limited);
    if (progress.status == StageStatus::kOpen && progress.attempts_left == 0)
        progress.status = StageStatus::kExhausted;
}

}  // namespace

const char* stage_mode_name(StageMode mode) {
    switch (mode) {
        case StageMode::kFamiliarisation:
            return "familiarisation";
        case StageMode::kPractice:
            return "practice";
        case StageMode::kExam:
            return "exam";
    }
    return "";
}

const CourseStage* Course::stage(const std::string& stage_id) const {
    for (const CourseStage& candidate : stages)
        if (candidate.id == stage_id) return &candidate;
    return nullptr;
}

bool counts_for(const Course& course, const CourseStage& stage, const AttemptOutcome& outcome) {
    if (outcome.task_id != stage.task_id || outcome.interrupted || outcome.voided) return false;
    if (stage.mode != StageMode::kExam) return !outcome.not_attempted;
    return is_exam_of(course, stage, outcome);
}

CourseProgress course_progress(const Course& course, const std::vector<AttemptOutcome>& outcomes,
                               const std::string& now_utc, const ExtraAttempts& extra) {
    CourseProgress progress;
    std::set<std::string> mastered;
    // Exams begin by the store's clock. Practice has that of the computer where it was done, which
    // whoever sits there can set before each attempt, so that the bad ones sort behind.
    std::vector<AttemptOutcome> as_saved = outcomes;
    std::stable_sort(as_saved.begin(), as_saved.end(),
                     [](const auto& a, const auto& b) { return a.saved < b.saved; });
    for (const CourseStage& stage : course.stages) {
        const bool exam = stage.mode == StageMode::kExam;
        StageProgress own = stage_progress(course, stage, exam ? outcomes : as_saved);
        apply_limit(stage, extra, own);
        const auto now = utc_seconds(now_utc), refresh = utc_seconds(own.refresh_utc);
        own.refresh_due = now && refresh && *now >= *refresh;
        if (own.status == StageStatus::kMastered) {
            mastered.insert(stage.id);
            progress.mastered_utc = std::max(progress.mastered_utc, own.mastered_utc);
        }
        progress.stages.push_back(std::move(own));
    }
    progress.mastered = mastered.size() == course.stages.size();
    if (!progress.mastered) progress.mastered_utc.clear();
    for (size_t i = 0; i < course.stages.size(); ++i) {
        StageProgress& own = progress.stages[i];
        for (const std::string& id : course.stages[i].requires_stages) {
            const CourseStage* required = course.stage(id);
            if (required != nullptr && !mastered.contains(id))
                own.missing.push_back(required->task_id);
        }
        if (!own.missing.empty() && own.status == StageStatus::kOpen)
            own.status = StageStatus::kLocked;
        if (progress.next_stage < 0 && own.status == StageStatus::kOpen)
            progress.next_stage = static_cast<int>(i);
    }
    return progress;
}

}  // namespace placode::curriculum
