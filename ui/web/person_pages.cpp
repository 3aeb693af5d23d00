// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One person: courses stage by stage, where they stand in each task, learning curves. The own page
// is the same for oneself.

#include "assessment/standard_setting.h"
#include "reports/cohort_report.h"
#include "sim/core/counted.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

constexpr int kNewest = 10;

Html status_badge(const curriculum::StageProgress& stage) {
    switch (stage.status) {
        case curriculum::StageStatus::kMastered:
            return stage.refresh_due ? badge(Html("refresher due"), "warn")
                                     : badge(Html("mastered"), "good");
        case curriculum::StageStatus::kOpen:
            return badge(Html("open"), "");
        case curriculum::StageStatus::kExhausted:
            return badge(Html("attempts used up"), "critical");
        case curriculum::StageStatus::kLocked:
            break;
    }
    return badge(Html("locked"), "");
}

Html course_part(const Visit& visit, const db::CourseStanding& standing) {
    const curriculum::Course& course = standing.course;
    Html out;
    out << "<h3>" << text(course.title.en) << "</h3><p>" << text(standing.next.reason.en);
    if (standing.certificate)
        out << " Certificate " << text(standing.certificate->code) << " of "
            << day(standing.certificate->issued_utc) << ".";
    out << "</p>\n";
    Table table("Stages of " + course.title.en, {{"Stage"},
                                                 {"State"},
                                                 {"Met in a row", true},
                                                 {"Benchmark", true},
                                                 {"Attempts that count", true},
                                                 {"Best", true},
                                                 {"Mastered on"},
                                                 {"Refresh from"}});
    for (size_t i = 0; i < course.stages.size() && i < standing.progress.stages.size(); ++i) {
        const curriculum::CourseStage& stage = course.stages[i];
        const curriculum::StageProgress& own = standing.progress.stages[i];
        Html name = text(visit.tasks.of(stage.task_id).title);
        if (stage.mode == curriculum::StageMode::kExam) name << " (exam)";
        table.row({name, status_badge(own),
                   text(std::to_string(own.streak) + " of " + std::to_string(stage.consecutive)),
                   points(stage.benchmark_points), text(own.attempts),
                   own.attempts > 0 ? points(own.best_points) : text("–"), day(own.mastered_utc),
                   day(own.refresh_utc)});
    }
    out << table.html();
    return out;
}

Html courses_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    if (report.courses.empty()) body << "<p class=\"muted\">No course is assigned.</p>";
    for (const db::CourseStanding& each : report.courses) body << course_part(visit, each);
    return card(Html("Courses"), body);
}

Html tasks_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    if (report.tasks.empty()) {
        body << "<p class=\"muted\">No attempt counts yet.</p>";
        return card(Html("Tasks"), body);
    }
    Table table("Where this person stands in each task", {{"Task"},
                                                          {"Attempts", true},
                                                          {"Last", true},
                                                          {"Mean of last 3", true},
                                                          {"Best", true},
                                                          {"Standing"},
                                                          {"Last on"}});
    const std::string path = "/people/" + std::to_string(report.user.id) + "/tasks/";
    for (const reports::PersonInTask& one : report.tasks)
        table.row({link(path + path_part(one.standing.task_id),
                        text(visit.tasks.of(one.standing.task_id).title)),
                   text(one.standing.attempts), points(one.standing.last_points),
                   points(one.standing_now.recent), points(one.standing.best_points),
                   standing_badge(one.standing_now.standing), day(one.standing.last_utc)});
    body << table.html() << "<p class=\"small\">Open a task to see its learning curve. "
         << standings_explained() << "</p>";
    return card(Html("Tasks"), body);
}

Html newest_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    const std::vector<db::AttemptRecord> newest(
        report.attempts.rbegin(),
        report.attempts.rbegin() +
            static_cast<std::ptrdiff_t>(std::min<size_t>(kNewest, report.attempts.size())));
    if (newest.empty())
        body << "<p class=\"muted\">There are no attempts yet.</p>";
    else
        body << attempts_table(visit, "Newest attempts", newest, false)
             << link("/people/" + std::to_string(report.user.id) + "/attempts",
                     text("All of them: " + sim::counted(report.attempts.size(), "attempt")));
    return card(Html("Newest attempts"), body);
}

Html all_cards(const Visit& visit, const db::UserRecord& user) {
    const reports::TraineeReport report =
        reports::read_trainee_report(visit.store, user, visit.now_utc);
    Html body;
    body << courses_card(visit, report) << tasks_card(visit, report) << newest_card(visit, report);
    return body;
}

/// The own account may always be read; of others, what the store says.
db::UserRecord person_of(const Visit& visit) {
    const auto user = visit.store.accounts().find(visit.id());
    if (!user) throw NotThere("There is no such person.");
    return *user;
}

Html mark_of(const db::UserRecord& user) {
    Html out;
    if (user.demonstration) out << " " << badge(Html("DEMONSTRATION"), "warn");
    return out;
}

/// Where this person's roles lead.
Html ways(const Visit& visit) {
    Html list;
    if (visit.may(db::Action::kViewAttempts))
        list << "<li>" << link("/cohort", Html("Cohort"))
             << ": everybody by tasks, <a href=\"/help\">who needs help</a>, <a "
                "href=\"/refreshers\">who is due for a refresher</a></li>";
    if (visit.may(db::Action::kRunQuestionnaire))
        list << "<li>" << link("/studies", Html("Studies"))
             << ": flow, completeness, double entry, deviations, locks</li>";
    if (visit.may(db::Action::kManageUsers))
        list << "<li>" << link("/people", Html("People")) << ": accounts, roles, groups</li>";
    if (list.empty()) return list;
    Html out;
    out << "<section class=\"card\"><h2>Where to</h2><ul>" << list << "</ul></section>\n";
    return out;
}

}  // namespace

PageText own_page(const Visit& visit) {
    Html body;
    body << "<h1>" << text(visit.user.display_name) << "</h1><p class=\"muted\">"
         << text(role_words(visit.user.roles)) << mark_of(visit.user) << "</p>\n"
         << ways(visit) << all_cards(visit, visit.user);
    return {"My page", body};
}

PageText person_page(const Visit& visit) {
    const db::UserRecord user = person_of(visit);
    // Before anything of it is written: the store refuses here who may not see scores.
    const Html cards = all_cards(visit, user);
    Html body;
    body << "<h1>" << text(name_or_number(user.display_name, user.id)) << "</h1><p class=\"muted\">"
         << text(role_words(user.roles));
    if (!user.active) body << ", account closed";
    body << mark_of(user) << "</p>\n" << cards;
    return {name_or_number(user.display_name, user.id), body};
}

PageText curve_page(const Visit& visit) {
    const db::UserRecord user = person_of(visit);
    const std::string task = visit.parts.at(1);
    const reports::TraineeReport report =
        reports::read_trainee_report(visit.store, user, visit.now_utc);
    const reports::PersonInTask* found = nullptr;
    for (const reports::PersonInTask& one : report.tasks)
        if (one.standing.task_id == task) found = &one;
    if (found == nullptr) throw NotThere("This person has no attempt at that task that counts.");
    const std::string title = visit.tasks.of(task).title;
    const std::string name = name_or_number(user.display_name, user.id);
    const double pass = visit.tasks.pass_points(visit.store, task);
    Html body;
    body << "<h1>" << text(title) << "</h1><p>"
         << link("/people/" + std::to_string(user.id), text(name)) << " · "
         << standing_badge(found->standing_now.standing) << " · "
         << text(sim::counted(found->points.size(), "attempt")) << ", last "
         << points(found->standing.last_points) << ", best " << points(found->standing.best_points)
         << ", pass mark " << points(pass) << "</p>\n";
    const auto make = [&](const reports::ChartStyle& style) {
        return reports::learning_figure("learning", "Learning curve: " + title,
                                        {{name, found->points, found->failed}}, pass,
                                        assessment::cusum_limits(0.05, 0.10, 0.05, 0.20), style);
    };
    body << card(Html("Learning curve"), figure(make));
    body << "<p>"
         << link("/people/" + std::to_string(user.id) + "/attempts" + query({{"task", task}}),
                 Html("The attempts behind it"))
         << "</p>\n";
    return {title + ", " + name, body};
}

}  // namespace placode::web
