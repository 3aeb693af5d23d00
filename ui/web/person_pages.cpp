// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One person: courses stage by stage, where they stand in each task, learning curves. The own page
// is the same for oneself.

#include "assessment/standard_setting.h"
#include "reports/cohort_report.h"
#include "reports/text.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

constexpr int kNewest = 10;

Html status_badge(const curriculum::StageProgress& stage) {
    switch (stage.status) {
        case curriculum::StageStatus::kMastered:
            return stage.refresh_due ? badge(Web::phrase("refresher due"), Tone::kWarn)
                                     : badge(Web::phrase("mastered"), Tone::kGood);
        case curriculum::StageStatus::kOpen:
            return badge(Web::phrase("open@stage"), Tone::kPlain);
        case curriculum::StageStatus::kExhausted:
            return badge(Web::phrase("attempts used up"), Tone::kCritical);
        case curriculum::StageStatus::kLocked:
            break;
    }
    return badge(Web::phrase("locked@stage"), Tone::kPlain);
}

Html course_part(const Visit& visit, const db::CourseStanding& standing) {
    const curriculum::Course& course = standing.course;
    const Text title = text(in_words(course.title));
    Html out;
    out << "<h3>" << title << "</h3><p>" << with_days(in_words(standing.next.reason));
    if (standing.certificate)
        out << " "
            << Web::phrase("Certificate %1 of %2.", text(standing.certificate->code),
                           day(standing.certificate->issued_utc));
    out << "</p>\n";
    Table table(Web::phrase("Stages of %1", title), {{Web::phrase("Stage")},
                                                     {Web::phrase("State")},
                                                     {Web::phrase("Met in a row"), true},
                                                     {Web::phrase("Benchmark"), true},
                                                     {Web::phrase("Attempts that count"), true},
                                                     {Web::phrase("Best"), true},
                                                     {Web::phrase("Mastered on")},
                                                     {Web::phrase("Refresh from")}});
    for (size_t i = 0; i < course.stages.size() && i < standing.progress.stages.size(); ++i) {
        const curriculum::CourseStage& stage = course.stages[i];
        const curriculum::StageProgress& own = standing.progress.stages[i];
        Html name = text(visit.tasks.of(stage.task_id).title);
        if (stage.mode == curriculum::StageMode::kExam) name << " " << Web::phrase("(exam)");
        table.row({name, status_badge(own),
                   Web::phrase("%1 of %2", text(own.streak), text(stage.consecutive)),
                   points(stage.benchmark_points), text(own.attempts),
                   own.attempts > 0 ? points(own.best_points) : dash(), day(own.mastered_utc),
                   day(own.refresh_utc)});
    }
    out << table.html();
    return out;
}

Html courses_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    if (report.courses.empty())
        body << "<p class=\"muted\">" << Web::phrase("No course is assigned.") << "</p>";
    for (const db::CourseStanding& each : report.courses) body << course_part(visit, each);
    return card(Web::phrase("Courses"), body);
}

Html tasks_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    if (report.tasks.empty()) {
        body << "<p class=\"muted\">" << Web::phrase("No attempt counts yet.") << "</p>";
        return card(Web::phrase("Tasks"), body);
    }
    Table table(Web::phrase("Where this person stands in each task"),
                {{Web::phrase("Task")},
                 {Web::phrase("Attempts"), true},
                 {Web::phrase("Last"), true},
                 {Web::phrase("Mean of last 3"), true},
                 {Web::phrase("Best"), true},
                 {Web::phrase("Standing")},
                 {Web::phrase("Last on")}});
    const std::string path = "/people/" + std::to_string(report.user.id) + "/tasks/";
    for (const reports::PersonInTask& one : report.tasks)
        table.row({link(path + path_part(one.standing.task_id),
                        text(visit.tasks.of(one.standing.task_id).title)),
                   text(one.standing.attempts), points(one.standing.last_points),
                   points(one.standing_now.recent), points(one.standing.best_points),
                   standing_badge(one.standing_now.standing), day(one.standing.last_utc)});
    body << table.html() << "<p class=\"small\">"
         << Web::phrase("Open a task to see its learning curve.") << " " << standings_explained()
         << "</p>";
    return card(Web::phrase("Tasks"), body);
}

Html newest_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    const std::vector<db::AttemptRecord> newest(
        report.attempts.rbegin(),
        report.attempts.rbegin() +
            static_cast<std::ptrdiff_t>(std::min<size_t>(kNewest, report.attempts.size())));
    if (newest.empty())
        body << "<p class=\"muted\">" << Web::phrase("There are no attempts yet.") << "</p>";
    else
        body << attempts_table(visit, Web::phrase("Newest attempts"), newest, false)
             << link("/people/" + std::to_string(report.user.id) + "/attempts",
                     Web::count_phrase("All of them: %n attempt(s)", report.attempts.size()));
    return card(Web::phrase("Newest attempts"), body);
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
    if (!user) throw NotThere(Web::plain_phrase("There is no such person."));
    return *user;
}

Html mark_of(const db::UserRecord& user) {
    Html out;
    if (user.demonstration) out << " " << demonstration_badge();
    return out;
}

reports::Figure learning_curve(const std::string& task, const reports::LearningLine& line,
                               double pass_points, const reports::ChartStyle& style) {
    const assessment::CusumLimits limits = assessment::cusum_limits(0.05, 0.10, 0.05, 0.20);
    reports::Figure figure =
        reports::learning_figure("learning", Web::plain_phrase("Learning curve: %1", {task}),
                                 {line}, pass_points, limits, style);
    const auto share = [](double value) {
        return reports::with_spoken_sign(reports::number(value, 2)).toStdString();
    };
    figure.caption = Web::plain_phrase(
        "Scores over attempts and, below, the CUSUM of attempts that were not passed (Bolsin & "
        "Colson 2000) with its limits; p0 %1, p1 %2, alpha %3, beta %4.",
        {share(limits.p0), share(limits.p1), share(limits.alpha), share(limits.beta)});
    return figure;
}

/// Where this person's roles lead.
Html links(const Visit& visit) {
    Html list;
    if (visit.may(db::Action::kViewAttempts))
        list << "<li>"
             << Web::phrase("%1: everybody by tasks, %2, %3",
                            link("/cohort", Web::phrase("Cohort")),
                            link("/help", Web::phrase("who needs help")),
                            link("/refreshers", Web::phrase("who is due for a refresher")))
             << "</li>";
    if (visit.may(db::Action::kRunQuestionnaire))
        list << "<li>"
             << Web::phrase("%1: flow, completeness, double entry, deviations, locks",
                            link("/studies", Web::phrase("Studies")))
             << "</li>";
    if (visit.may(db::Action::kManageUsers))
        list << "<li>"
             << Web::phrase("%1: accounts, roles, groups", link("/people", Web::phrase("People")))
             << "</li>";
    if (list.empty()) return list;
    Html all;
    all << "<ul>" << list << "</ul>";
    return card(Web::phrase("Where to"), all);
}

}  // namespace

PageText own_page(const Visit& visit) {
    Html body;
    body << "<h1>" << text(visit.user.display_name) << "</h1><p class=\"muted\">"
         << text(role_words(visit.user.roles)) << mark_of(visit.user) << "</p>\n"
         << links(visit) << all_cards(visit, visit.user);
    return {Web::phrase("My page"), body};
}

PageText person_page(const Visit& visit) {
    const db::UserRecord user = person_of(visit);
    // Before anything of it is written: the store refuses here who may not see scores.
    const Html cards = all_cards(visit, user);
    Html body;
    body << "<h1>" << text(name_or_number(user.display_name, user.id)) << "</h1><p class=\"muted\">"
         << text(role_words(user.roles));
    if (!user.active) body << ", " << Web::phrase("account closed");
    body << mark_of(user) << "</p>\n" << cards;
    return {text(name_or_number(user.display_name, user.id)), body};
}

PageText curve_page(const Visit& visit) {
    const db::UserRecord user = person_of(visit);
    const std::string task = visit.parts.at(1);
    const reports::TraineeReport report =
        reports::read_trainee_report(visit.store, user, visit.now_utc);
    const reports::PersonInTask* found = nullptr;
    for (const reports::PersonInTask& one : report.tasks)
        if (one.standing.task_id == task) found = &one;
    if (found == nullptr)
        throw NotThere(Web::plain_phrase("This person has no attempt at that task that counts."));
    const std::string title = visit.tasks.of(task).title;
    const std::string name = name_or_number(user.display_name, user.id);
    const double pass = visit.tasks.pass_points(visit.store, task);
    Html body;
    body << "<h1>" << text(title) << "</h1><p>"
         << link("/people/" + std::to_string(user.id), text(name)) << " · "
         << standing_badge(found->standing_now.standing) << " · "
         << Web::count_phrase("%n attempt(s), last %1, best %2, pass mark %3", found->points.size(),
                              points(found->standing.last_points),
                              points(found->standing.best_points), points(pass))
         << "</p>\n";
    body << card(
        Web::phrase("Learning curve"), figure([&](const reports::ChartStyle& style) {
            return learning_curve(title, {name, found->points, found->failed}, pass, style);
        }));
    body << "<p>"
         << link("/people/" + std::to_string(user.id) + "/attempts" + query({{"task", task}}),
                 Web::phrase("The attempts behind it"))
         << "</p>\n";
    return {text(title + ", " + name), body};
}

}  // namespace placode::web
