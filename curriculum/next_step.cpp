// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/next_step.h"

#include <algorithm>
#include <array>

#include "curriculum/utc_time.h"
#include "sim/core/number_text.h"

namespace placode::curriculum {
namespace {

constexpr int64_t kDayS = 86400;

std::string day_of(const std::string& utc) {
    const auto seconds = utc_seconds(utc);
    return seconds ? utc_day(*seconds) : utc;
}

std::string points(double value) { return sim::rounded_text(value, 4); }
/// With the decimal sign of Polish.
std::string points_pl(double value) {
    std::string text = points(value);
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

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

std::string attempts_pl(int n) {
    const int ones = n % 10, tens = n % 100;
    if (n == 1) return "próba";
    return ones >= 2 && ones <= 4 && (tens < 12 || tens > 14) ? "próby" : "prób";
}

void add(LocalText& text, const std::string& en, const std::string& pl) {
    text.en += (text.en.empty() ? "" : " ") + en;
    text.pl += (text.pl.empty() ? "" : " ") + pl;
}

void add_limit(const Case& c, LocalText& text) {
    const int left = c.own.attempts_left;
    if (left < 0) return;
    const std::string n = std::to_string(left);
    add(text, n + (left == 1 ? " attempt is left." : " attempts are left."),
        "Pozostało: " + n + " " + attempts_pl(left) + ".");
}

LocalText why_refresh(const Case& c) {
    const std::string day = day_of(c.own.refresh_utc), b = points(c.stage.benchmark_points);
    return {"\"" + c.title.en + "\" was mastered, but not repeated since; from " + day +
                " the skill fades. Reach " + b + " points once more.",
            "„" + c.title.pl + "” zaliczono, ale od tego czasu nie powtarzano; od " + day +
                " umiejętność słabnie. Osiągnij jeszcze raz " +
                points_pl(c.stage.benchmark_points) + " pkt."};
}

LocalText why_start(const Case& c) {
    if (c.stage.mode == StageMode::kFamiliarisation)
        return {"Get to know instruments and field with \"" + c.title.en +
                    "\"; any finished attempt counts.",
                "Poznaj narzędzia i pole w zadaniu „" + c.title.pl +
                    "”; liczy się każda ukończona próba."};
    // Attempts that do not count may have been made: nothing is said of trying.
    const int times = c.stage.consecutive;
    const std::string n = std::to_string(times);
    LocalText text{"\"" + c.title.en +
                       "\" is your next stage: no attempt of yours counts there yet. "
                       "To master it, reach at least " +
                       points(c.stage.benchmark_points) + " points" +
                       (times == 1 ? ", once." : ", " + n + " times in a row."),
                   "„" + c.title.pl +
                       "” to Twój następny etap: nie liczy się w nim jeszcze żadna Twoja próba. "
                       "Aby go zaliczyć, zdobądź co najmniej " +
                       points_pl(c.stage.benchmark_points) + " pkt" +
                       (times == 1 ? ", jeden raz." : ", " + n + " razy z rzędu.")};
    add_limit(c, text);
    return text;
}

LocalText why_continue(const Case& c, int to_go) {
    const std::string b = points(c.stage.benchmark_points), n = std::to_string(to_go);
    LocalText text;
    if (c.own.last_critical)
        add(text, "The last attempt had a critical error, so the count begins again.",
            "W ostatniej próbie był błąd krytyczny, więc liczenie zaczyna się od nowa.");
    else if (c.own.streak == 0)
        add(text, "Best so far: " + points(c.own.best_points) + " of the " + b + " points needed.",
            "Najlepszy wynik: " + points_pl(c.own.best_points) + " z potrzebnych " +
                points_pl(c.stage.benchmark_points) + " pkt.");
    add(text,
        "\"" + c.title.en + "\" needs " + n + (to_go == 1 ? " more attempt" : " more in a row") +
            " at " + b + " points or above.",
        "Do zaliczenia „" + c.title.pl + "” brakuje jeszcze: " + n + " " + attempts_pl(to_go) +
            (to_go == 1 ? "" : " z rzędu") + " na " + points_pl(c.stage.benchmark_points) +
            " pkt lub wyżej.");
    add_limit(c, text);
    return text;
}

LocalText why_exam(const Case& c) {
    const std::string number = std::to_string(c.own.attempts + 1);
    LocalText text{
        "Exam, attempt " + number + ": \"" + c.title.en + "\" without aids, case " +
            std::to_string(c.own.next_seed) + ", " + points(c.stage.benchmark_points) + " points.",
        "Egzamin, próba " + number + ": „" + c.title.pl + "” bez pomocy, przypadek " +
            std::to_string(c.own.next_seed) + ", " + points_pl(c.stage.benchmark_points) + " pkt."};
    if (c.stage.exam.proctor)
        add(text, "A proctor has to be present.", "Musi być obecna osoba nadzorująca.");
    add_limit(c, text);
    return text;
}

LocalText why_finished(const CourseProgress& progress) {
    std::string earliest;
    for (const StageProgress& own : progress.stages)
        if (!own.refresh_utc.empty() && (earliest.empty() || own.refresh_utc < earliest))
            earliest = own.refresh_utc;
    LocalText text{"All stages are mastered.", "Wszystkie etapy są zaliczone."};
    if (!earliest.empty())
        add(text, "The next repetition is due on " + day_of(earliest) + ".",
            "Najbliższe powtórzenie: " + day_of(earliest) + ".");
    return text;
}

/// The stage whose attempts are used up, for the words.
LocalText why_exhausted(const Course& course, const CourseProgress& progress,
                        const std::map<std::string, LocalText>& titles) {
    for (size_t i = 0; i < course.stages.size(); ++i) {
        if (progress.stages[i].status != StageStatus::kExhausted) continue;
        const Case c = case_of(course, progress, i, titles);
        const int used = c.own.attempts;
        return {"All " + std::to_string(used) + " attempts at \"" + c.title.en +
                    "\" are used; ask an educator for more.",
                "Wykorzystano wszystkie próby (" + std::to_string(used) + ") w zadaniu „" +
                    c.title.pl + "”; poproś osobę prowadzącą o następne."};
    }
    return {"Nothing is open.", "Nic nie jest otwarte."};
}

void set_dates(const CourseDates& dates, const std::string& now_utc, NextStep& next) {
    const auto now = utc_seconds(now_utc), due = utc_seconds(dates.due_utc);
    if (!now || !due || next.kind == NextKind::kFinished) return;
    // A day is due to its end.
    next.overdue = *now >= *due + (dates.due_utc.size() == 10 ? kDayS : 0);
    if (next.overdue) {
        add(next.reason, "The course was due on " + day_of(dates.due_utc) + ".",
            "Termin kursu minął " + day_of(dates.due_utc) + ".");
        return;
    }
    next.days_left = static_cast<int>(std::max<int64_t>(0, *due - *now) / kDayS);
    add(next.reason, "The course is due on " + day_of(dates.due_utc) + ".",
        "Termin kursu: " + day_of(dates.due_utc) + ".");
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
        next.reason = {"The course begins on " + day_of(dates.starts_utc) + ".",
                       "Kurs zaczyna się " + day_of(dates.starts_utc) + "."};
        return next;
    }
    choose(course, progress, titles, next);
    set_dates(dates, now_utc, next);
    return next;
}

}  // namespace placode::curriculum
