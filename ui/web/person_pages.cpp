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
            return stage.refresh_due ? badge(say("refresher due"), Tone::kWarn)
                                     : badge(say("mastered"), Tone::kGood);
        case curriculum::StageStatus::kOpen:
            return badge(say("open@stage"), Tone::kPlain);
        case curriculum::StageStatus::kExhausted:
            return badge(say("attempts used up"), Tone::kCritical);
        case curriculum::StageStatus::kLocked:
            break;
    }
    return badge(say("locked@stage"), Tone::kPlain);
}

Html course_part(const Visit& visit, const db::CourseStanding& standing) {
    const curriculum::Course& course = standing.course;
    const Text title = text(in_words(course.title));
    Html out;
    out << "<h3>" << title << "</h3><p>" << with_days(in_words(standing.next.reason));
    if (standing.certificate)
        out << " "
            << say("Certificate %1 of %2.", text(standing.certificate->code),
                   day(standing.certificate->issued_utc));
    out << "</p>\n";
    Table table(say("Stages of %1", title), {{say("Stage")},
                                             {say("State")},
                                             {say("Met in a row"), true},
                                             {say("Benchmark"), true},
                                             {say("Attempts that count"), true},
                                             {say("Best"), true},
                                             {say("Mastered on")},
                                             {say("Refresh from")}});
    for (size_t i = 0; i < course.stages.size() && i < standing.progress.stages.size(); ++i) {
        const curriculum::CourseStage& stage = course.stages[i];
        const curriculum::StageProgress& own = standing.progress.stages[i];
        Html name = text(visit.tasks.of(stage.task_id).title);
        if (stage.mode == curriculum::StageMode::kExam) name << " " << say("(exam)");
        table.row({name, status_badge(own),
                   say("%1 of %2", text(own.streak), text(stage.consecutive)),
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
        body << "<p class=\"muted\">" << say("No course is assigned.") << "</p>";
    for (const db::CourseStanding& each : report.courses) body << course_part(visit, each);
    return card(say("Courses"), body);
}

Html tasks_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    if (report.tasks.empty()) {
        body << "<p class=\"muted\">" << say("No attempt counts yet.") << "</p>";
        return card(say("Tasks"), body);
    }
    Table table(say("Where this person stands in each task"), {{say("Task")},
                                                               {say("Attempts"), true},
                                                               {say("Last"), true},
                                                               {say("Mean of last 3"), true},
                                                               {say("Best"), true},
                                                               {say("Standing")},
                                                               {say("Last on")}});
    const std::string path = "/people/" + std::to_string(report.user.id) + "/tasks/";
    for (const reports::PersonInTask& one : report.tasks)
        table.row({link(path + path_part(one.standing.task_id),
                        text(visit.tasks.of(one.standing.task_id).title)),
                   text(one.standing.attempts), points(one.standing.last_points),
                   points(one.standing_now.recent), points(one.standing.best_points),
                   standing_badge(one.standing_now.standing), day(one.standing.last_utc)});
    body << table.html() << "<p class=\"small\">" << say("Open a task to see its learning curve.")
         << " " << standings_explained() << "</p>";
    return card(say("Tasks"), body);
}

Html newest_card(const Visit& visit, const reports::TraineeReport& report) {
    Html body;
    const std::vector<db::AttemptRecord> newest(
        report.attempts.rbegin(),
        report.attempts.rbegin() +
            static_cast<std::ptrdiff_t>(std::min<size_t>(kNewest, report.attempts.size())));
    if (newest.empty())
        body << "<p class=\"muted\">" << say("There are no attempts yet.") << "</p>";
    else
        body << attempts_table(visit, say("Newest attempts"), newest, false)
             << link("/people/" + std::to_string(report.user.id) + "/attempts",
                     say_count(report.attempts.size(), "All of them: %1 attempt",
                               "All of them: %1 attempts"));
    return card(say("Newest attempts"), body);
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
    if (!user) throw NotThere(words("There is no such person."));
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
    reports::Figure figure = reports::learning_figure(
        "learning", words("Learning curve: %1", {task}), {line}, pass_points, limits, style);
    const auto share = [](double value) {
        return reports::with_spoken_sign(reports::number(value, 2)).toStdString();
    };
    figure.caption = words(
        "Scores over attempts and, below, the CUSUM of attempts that were not passed (Bolsin & "
        "Colson 2000) with its limits; p0 %1, p1 %2, alpha %3, beta %4.",
        {share(limits.p0), share(limits.p1), share(limits.alpha), share(limits.beta)});
    return figure;
}

/// Where this person's roles lead.
Html ways(const Visit& visit) {
    Html list;
    if (visit.may(db::Action::kViewAttempts))
        list << "<li>"
             << say("%1: everybody by tasks, %2, %3", link("/cohort", say("Cohort")),
                    link("/help", say("who needs help")),
                    link("/refreshers", say("who is due for a refresher")))
             << "</li>";
    if (visit.may(db::Action::kRunQuestionnaire))
        list << "<li>"
             << say("%1: flow, completeness, double entry, deviations, locks",
                    link("/studies", say("Studies")))
             << "</li>";
    if (visit.may(db::Action::kManageUsers))
        list << "<li>" << say("%1: accounts, roles, groups", link("/people", say("People")))
             << "</li>";
    if (list.empty()) return list;
    Html all;
    all << "<ul>" << list << "</ul>";
    return card(say("Where to"), all);
}

}  // namespace

PageText own_page(const Visit& visit) {
    Html body;
    body << "<h1>" << text(visit.user.display_name) << "</h1><p class=\"muted\">"
         << text(role_words(visit.user.roles)) << mark_of(visit.user) << "</p>\n"
         << ways(visit) << all_cards(visit, visit.user);
    return {say("My page"), body};
}

PageText person_page(const Visit& visit) {
    const db::UserRecord user = person_of(visit);
    // Before anything of it is written: the store refuses here who may not see scores.
    const Html cards = all_cards(visit, user);
    Html body;
    body << "<h1>" << text(name_or_number(user.display_name, user.id)) << "</h1><p class=\"muted\">"
         << text(role_words(user.roles));
    if (!user.active) body << ", " << say("account closed");
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
        throw NotThere(words("This person has no attempt at that task that counts."));
    const std::string title = visit.tasks.of(task).title;
    const std::string name = name_or_number(user.display_name, user.id);
    const double pass = visit.tasks.pass_points(visit.store, task);
    Html body;
    body << "<h1>" << text(title) << "</h1><p>"
         << link("/people/" + std::to_string(user.id), text(name)) << " · "
         << standing_badge(found->standing_now.standing) << " · "
         << say_count(found->points.size(), "%1 attempt, last %2, best %3, pass mark %4",
                      "%1 attempts, last %2, best %3, pass mark %4",
                      points(found->standing.last_points), points(found->standing.best_points),
                      points(pass))
         << "</p>\n";
    body << card(
        say("Learning curve"), figure([&](const reports::ChartStyle& style) {
            return learning_curve(title, {name, found->points, found->failed}, pass, style);
        }));
    body << "<p>"
         << link("/people/" + std::to_string(user.id) + "/attempts" + query({{"task", task}}),
                 say("The attempts behind it"))
         << "</p>\n";
    return {text(title + ", " + name), body};
}

}  // namespace placode::web
