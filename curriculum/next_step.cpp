// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/next_step.h"

#include <algorithm>
#include <array>

#include "curriculum/bilingual.h"
#include "curriculum/utc_time.h"

namespace placode::curriculum {
namespace {

constexpr int64_t kDayS = 86400;

std::string day_of(const std::string& utc) {
    const auto seconds = utc_seconds(utc);
    return seconds ? utc_day(*seconds) : utc;
}

LocalText day_text(const std::string& utc) { return Bilingual::as_is(day_of(utc)); }
LocalText points(double value) { return Bilingual::number(value, 4); }

/// Everything a sentence may need.
struct Case {
    const CourseStage& stage;
    const StageProgress& own;
    LocalText title;
};

Case case_of(const Course& course, const CourseProgress& progress, size_t i,
             const std::map<std::string, LocalText>& titles) {
    const CourseStage& stage = course.stages[i];
    const auto found = titles.find(stage.task_id);
    LocalText title{stage.task_id, stage.task_id};
    if (found != titles.end()) title = {found->second.in("en"), found->second.in("pl")};
    return {stage, progress.stages[i], title};
}

void add(LocalText& text, const LocalText& more) {
    text.en += (text.en.empty() ? "" : " ") + more.en;
    text.pl += (text.pl.empty() ? "" : " ") + more.pl;
}

void add_limit(const Case& c, LocalText& text) {
    if (c.own.attempts_left >= 0)
        add(text, Bilingual::count_phrase("%n attempt(s) is (are) left.", c.own.attempts_left));
}

LocalText why_refresh(const Case& c) {
    LocalText text = Bilingual::phrase(
        "\"%1\" was mastered, but not repeated since; from %2 the skill fades. Reach %3 points "
        "once more.",
        {c.title, day_text(c.own.refresh_utc), points(c.stage.benchmark_points)});
    if (c.stage.mode == StageMode::kExam && c.stage.exam.proctor)
        add(text, Bilingual::phrase("A proctor has to be present."));
    return text;
}

LocalText why_start(const Case& c) {
    if (c.stage.mode == StageMode::kFamiliarisation)
        return Bilingual::phrase(
            "Get to know instruments and field with \"%1\"; any finished attempt counts.",
            {c.title});
    // Attempts that do not count may have been made: nothing is said of trying.
    LocalText text = Bilingual::count_phrase(
        "\"%1\" is your next stage: no attempt of yours counts there yet. To master it, reach at "
        "least %2 points, %n time(s) in a row.",
        c.stage.consecutive, {c.title, points(c.stage.benchmark_points)});
    add_limit(c, text);
    return text;
}

LocalText why_continue(const Case& c, int to_go) {
    const LocalText benchmark = points(c.stage.benchmark_points);
    LocalText text;
    if (c.own.last_critical)
        add(text,
            Bilingual::phrase("The last attempt had a critical error, so the count begins again."));
    else if (c.own.streak == 0)
        add(text, Bilingual::phrase("Best so far: %1 of the %2 points needed.",
                                    {points(c.own.best_points), benchmark}));
    add(text,
        Bilingual::count_phrase("\"%1\" needs %n more attempt(s) in a row at %2 points or above.",
                                to_go, {c.title, benchmark}));
    add_limit(c, text);
    return text;
}

LocalText why_exam(const Case& c) {
    LocalText text = Bilingual::phrase(
        "Exam, attempt %1: \"%2\" without aids, case %3, %4 points.",
        {Bilingual::as_is(std::to_string(c.own.attempts + 1)), c.title,
         Bilingual::as_is(std::to_string(c.own.next_seed)), points(c.stage.benchmark_points)});
    if (c.stage.exam.proctor) add(text, Bilingual::phrase("A proctor has to be present."));
    add_limit(c, text);
    return text;
}

LocalText why_finished(const CourseProgress& progress) {
    std::string earliest;
    for (const StageProgress& own : progress.stages)
        if (!own.refresh_utc.empty() && (earliest.empty() || own.refresh_utc < earliest))
            earliest = own.refresh_utc;
    LocalText text = Bilingual::phrase("All stages are mastered.");
    if (!earliest.empty())
        add(text, Bilingual::phrase("The next repetition is due on %1.", {day_text(earliest)}));
    return text;
}

/// The stage whose attempts are used up, for the words.
LocalText why_exhausted(const Course& course, const CourseProgress& progress,
                        const std::map<std::string, LocalText>& titles) {
    for (size_t i = 0; i < course.stages.size(); ++i) {
        if (progress.stages[i].status != StageStatus::kExhausted) continue;
        const Case c = case_of(course, progress, i, titles);
        return Bilingual::phrase("All %1 attempts at \"%2\" are used; ask an educator for more.",
                                 {Bilingual::as_is(std::to_string(c.own.attempts)), c.title});
    }
    return Bilingual::phrase("Nothing is open.");
}

void set_dates(const CourseDates& dates, const std::string& now_utc, NextStep& next) {
    const auto now = utc_seconds(now_utc), due = utc_seconds(dates.due_utc);
    if (!now || !due || next.kind == NextKind::kFinished) return;
    // A day is due to its end.
    next.overdue = *now >= *due + (dates.due_utc.size() == 10 ? kDayS : 0);
    if (next.overdue) {
        add(next.reason, Bilingual::phrase("The course was due on %1.", {day_text(dates.due_utc)}));
        return;
    }
    next.days_left = static_cast<int>(std::max<int64_t>(0, *due - *now) / kDayS);
    add(next.reason, Bilingual::phrase("The course is due on %1.", {day_text(dates.due_utc)}));
}

void choose(const Course& course, const CourseProgress& progress,
            const std::map<std::string, LocalText>& titles, NextStep& next) {
    const auto take = [&](size_t i, NextKind kind) {
        next.kind = kind;
        next.stage = static_cast<int>(i);
        next.stage_id = course.stages[i].id;
        next.task_id = course.stages[i].task_id;
        next.attempts_left = progress.stages[i].attempts_left;
    };
    // A skill that fades comes first: what is built on it would be built on sand.
    for (size_t i = 0; i < course.stages.size(); ++i) {
        if (!progress.stages[i].refresh_due) continue;
        take(i, NextKind::kRefresh);
        next.to_go = 1;
        next.attempts_left = -1;
        if (course.stages[i].mode == StageMode::kExam) next.seed = progress.stages[i].next_seed;
        next.reason = why_refresh(case_of(course, progress, i, titles));
        return;
    }
    if (progress.next_stage >= 0) {
        const auto i = static_cast<size_t>(progress.next_stage);
        const Case c = case_of(course, progress, i, titles);
        next.to_go = c.stage.consecutive - c.own.streak;
        if (c.stage.mode == StageMode::kExam) {
            take(i, NextKind::kExam);
            next.seed = c.own.next_seed;
            next.reason = why_exam(c);
        } else if (c.own.attempts == 0) {
            take(i, NextKind::kStart);
            next.reason = why_start(c);
        } else {
            take(i, NextKind::kContinue);
            next.reason = why_continue(c, next.to_go);
        }
        return;
    }
    next.kind = progress.mastered ? NextKind::kFinished : NextKind::kExhausted;
    next.reason =
        progress.mastered ? why_finished(progress) : why_exhausted(course, progress, titles);
}

}  // namespace

const char* next_kind_name(NextKind kind) {
    constexpr std::array<const char*, 7> kNames{"wait", "refresh",   "start",   "continue",
                                                "exam", "exhausted", "finished"};
    return kNames[static_cast<size_t>(kind)];
}

NextStep next_step(const Course& course, const CourseProgress& progress,
                   const std::map<std::string, LocalText>& titles, const CourseDates& dates,
                   const std::string& now_utc) {
    NextStep next;
    const auto now = utc_seconds(now_utc), starts = utc_seconds(dates.starts_utc);
    if (now && starts && *now < *starts) {
        next.kind = NextKind::kWait;
        next.reason = Bilingual::phrase("The course begins on %1.", {day_text(dates.starts_utc)});
        return next;
    }
    choose(course, progress, titles, next);
    set_dates(dates, now_utc, next);
    return next;
}

}  // namespace placode::curriculum
