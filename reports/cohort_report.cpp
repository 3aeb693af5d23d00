// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper about a cohort and about one trainee. What it says is read in cohort_data.cpp.
#include "reports/cohort_report.h"

#include <algorithm>
#include <map>
#include <set>

#include "db/attempt_counting.h"
#include "reports/paper.h"
#include "reports/points_figure.h"
#include "reports/report.h"
#include "reports/text.h"
#include "reports/words.h"
#include "sim/core/counted.h"

namespace placode::reports {
namespace {

/// "2 attempts".
template <typename Count>
QString many(Count count, const char* noun, const char* plural = "") {
    return QString::fromStdString(sim::counted(count, noun, plural));
}

using assessment::Standing;

constexpr size_t kRowsAPiece = 36;  // Of a table: one page holds about that many.
constexpr size_t kMostCurves = 40;  // More of them only make a picture black.

QString day(const std::string& utc) { return safe(utc.substr(0, 10)); }

std::string name_of(const PersonInTask& one) {
    return one.standing.user_name.empty() ? "number " + std::to_string(one.standing.user_id)
                                          : one.standing.user_name;
}

QString table(const QStringList& head, const std::vector<QStringList>& rows, size_t from,
              size_t to) {
    QString html = "<table cellspacing='0' cellpadding='2' width='100%'><tr>";
    for (const QString& cell : head)
        html += "<th align='left' style='font-size:11px'>" + cell + "</th>";
    html += "</tr>";
    for (size_t i = from; i < to; ++i) {
        html += "<tr>";
        for (const QString& cell : rows[i]) html += "<td style='font-size:11px'>" + cell + "</td>";
        html += "</tr>";
    }
    return html + "</table>";
}

/// In pieces of a page: laying out one long table again for every row would
/// take minutes.
void write_rows(Paper& paper, const QStringList& head, const std::vector<QStringList>& rows) {
    for (size_t at = 0; at < rows.size(); at += kRowsAPiece)
        paper.html(table(head, rows, at, std::min(rows.size(), at + kRowsAPiece)));
}

QStringList row_of(const PersonInTask& one) {
    const auto& s = one.standing;
    return {safe(name_of(one)),
            safe(s.task_id),
            QString::number(s.attempts),
            number(s.last_points, 1),
            number(one.standing_now.recent, 1),
            number(s.best_points, 1),
            QString::number(s.failed),
            QString::fromLatin1(assessment::standing_name(one.standing_now.standing)),
            day(s.last_utc)};
}

const QStringList& row_head() {
    static const QStringList head{"person", "task",   "attempts", "last", "last 3",
                                  "best",   "failed", "standing", "on"};
    return head;
}

void write_list(Paper& paper, const CohortReport& report, Standing kind, const char* title,
                const char* none) {
    paper.heading(QString::fromLatin1(title));
    std::vector<QStringList> rows;
    for (const PersonInTask& one : report.people)
        if (one.standing.active && one.standing_now.standing == kind) rows.push_back(row_of(one));
    if (rows.empty())
        paper.html(QString("<p>%1</p>").arg(QString::fromLatin1(none)));
    else
        write_rows(paper, row_head(), rows);
}

std::map<std::string, std::vector<const PersonInTask*>> by_task(
    const std::vector<PersonInTask>& people) {
    std::map<std::string, std::vector<const PersonInTask*>> tasks;
    for (const PersonInTask& one : people) tasks[one.standing.task_id].push_back(&one);
    return tasks;
}

Figure curves(const std::string& task, const std::vector<const PersonInTask*>& people,
              std::optional<double> pass_points) {
    // Evenly over the list where there are more than a picture can show.
    std::vector<LearningLine> lines;
    const size_t shown = std::min(kMostCurves, people.size());
    for (size_t i = 0; i < shown; ++i) {
        const PersonInTask& one = *people[i * people.size() / shown];
        lines.push_back({name_of(one), one.points, one.failed});
    }
    Figure figure =
        learning_figure("learning_" + task, "Learning curves, " + task, lines, pass_points,
                        assessment::cusum_limits(0.05, 0.10, 0.05, 0.20), ChartStyle{});
    if (people.size() > shown)
        figure.caption += " " + std::to_string(shown) + " of " + std::to_string(people.size()) +
                          " people are drawn, evenly over the list.";
    return figure;
}

Figure spread(const std::vector<PersonInTask>& people) {
    std::vector<StripGroup> groups;
    for (const auto& [task, in_task] : by_task(people)) {
        StripGroup group{task, {}};
        for (const PersonInTask* one : in_task) group.values.push_back(one->standing_now.recent);
        groups.push_back(std::move(group));
    }
    return points_figure("spread", "Mean of the last three attempts of each person",
                         "points of 100", groups, ChartStyle{});
}

}  // namespace

void write_cohort_pdf(const CohortReport& report, const std::string& path) {
    const QString mark = report.demonstration ? " - DEMONSTRATION" : "";
    Paper paper(path, "Placode cohort " + QString::fromStdString(report.group), "Placode",
                "Placode cohort " + QString::fromStdString(report.group) + mark);
    std::set<int64_t> persons;
    int attempts = 0;
    for (const PersonInTask& one : report.people) {
        persons.insert(one.standing.user_id);
        attempts += one.standing.attempts;
    }
    if (report.demonstration)
        paper.html(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> "
            "- attempts of "
            "simulated operators are among these.</p>");
    paper.html("<p style='font-size:22px'><b>" + safe(report.group) + "</b></p><p>" +
               many(persons.size(), "person with attempts", "people with attempts") + ", " +
               many(attempts, "finished attempt") + ", " + safe(report.made_utc) +
               " UTC. Stuck: none of the last " + QString::number(assessment::kStuckTrials) +
               " attempts passed and no gain of " + number(assessment::kProgressPoints, 0) +
               " points. Regressed: passed before, but neither of the last two attempts.</p>");
    write_list(paper, report, Standing::kRegressed, "Regressed", "Nobody.");
    write_list(paper, report, Standing::kStuck, "Stuck", "Nobody.");
    if (!report.people.empty()) {
        paper.heading("Distribution");
        paper.figure(spread(report.people));
        for (const auto& [task, people] : by_task(report.people))
            paper.figure(curves(task, people, report.pass_marks.of(task)));
        paper.heading("Everybody");
        std::vector<QStringList> rows;
        for (const PersonInTask& one : report.people) rows.push_back(row_of(one));
        write_rows(paper, row_head(), rows);
    }
    paper.finish();
}

namespace {

/// Which attempts do not count, and why.
void write_not_counted(Paper& paper, const std::vector<db::AttemptRecord>& attempts) {
    QString list;
    for (const db::AttemptRecord& each : attempts)
        if (!db::counts(each))
            list += "<li>Attempt " + QString::number(each.id) + " does not count: " +
                    not_counted_words(each, Language::kEnglish).toHtmlEscaped() + ".</li>";
    if (!list.isEmpty()) paper.html("<ul>" + list + "</ul>");
}

}  // namespace

void write_trainee_pdf(const TraineeReport& report, const std::string& path) {
    const QString name = QString::fromStdString(report.user.display_name);
    const QString mark = report.user.demonstration ? " - DEMONSTRATION" : "";
    Paper paper(path, "Placode trainee " + name, "Placode", "Placode trainee " + name + mark);
    if (report.user.demonstration)
        paper.html(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> "
            "- a demonstration "
            "account.</p>");
    paper.html("<p style='font-size:22px'><b>" + name.toHtmlEscaped() + "</b></p><p>" +
               many(report.attempts.size(), "attempt") + ", " + safe(report.made_utc) +
               " UTC.</p>");
    paper.heading("Courses");
    if (report.courses.empty()) paper.html("<p>No course is assigned.</p>");
    for (const db::CourseStanding& course : report.courses) {
        int mastered = 0;
        for (const auto& stage : course.progress.stages)
            mastered += stage.status == curriculum::StageStatus::kMastered ? 1 : 0;
        paper.html(
            "<p><b>" + safe(course.course.title.en) + "</b> - " + QString::number(mastered) +
            " of " + many(course.course.stages.size(), "stage") + " mastered" +
            (course.certificate ? ", certificate " + safe(course.certificate->code) : QString()) +
            ".<br/>Next: " + safe(course.next.reason.en) + "</p>");
    }
    if (!report.tasks.empty()) {
        paper.heading("Tasks");
        std::vector<QStringList> rows;
        for (const PersonInTask& one : report.tasks) rows.push_back(row_of(one));
        write_rows(paper, row_head(), rows);
        for (const PersonInTask& one : report.tasks)
            paper.figure(
                curves(one.standing.task_id, {&one}, report.pass_marks.of(one.standing.task_id)));
        paper.heading("History");
        std::vector<QStringList> attempts;
        for (const db::AttemptRecord& each : report.attempts)
            attempts.push_back(
                {QString::number(each.id), safe(each.started_utc), safe(each.task_id),
                 number(each.points, 1),
                 db::counts(each) ? verdict_word(each.verdict) : QStringLiteral("does not count"),
                 end_word(each.end), safe(each.device), safe(each.exam.stage_id)});
        write_rows(
            paper,
            {"attempt", "started (UTC)", "task", "points", "verdict", "end", "device", "exam"},
            attempts);
        write_not_counted(paper, report.attempts);
    }
    paper.finish();
}

}  // namespace placode::reports
