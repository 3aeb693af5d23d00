// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What an educator sees of everybody or a group: people by tasks, who needs help, who is due for a
// refresher, how the scores of a task are spread. Standings and sums are the store's and the rule
// is that of assessment/cohort.h, as in the shell.

#include <algorithm>
#include <set>

#include "curriculum/utc_time.h"
#include "reports/points_figure.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

using assessment::CohortCell;
using assessment::Standing;

constexpr int64_t kDayS = 86400;
/// After which a skill that is not used is worth a session: one month and five.
constexpr int64_t kFirstDays = 30, kSecondDays = 150;

struct Person {
    int64_t id = 0;
    std::string name, last_utc;
    std::map<std::string, CohortCell> tasks;
};

struct Cohort {
    std::vector<Person> people;  ///< By name.
    std::set<std::string> tasks;
};

/// Of whom is asked for. Who has left, whose account is closed, needs neither help nor a refresher.
std::vector<db::TaskStanding> standings_of(const Visit& visit, const std::string& task = {}) {
    std::vector<db::TaskStanding> found =
        visit.store.attempts().standings(visit.number("group"), task);
    std::erase_if(found, [](const db::TaskStanding& each) { return !each.active; });
    return found;
}

Cohort read_cohort(const Visit& visit) {
    Cohort cohort;
    for (const db::TaskStanding& each : standings_of(visit)) {
        if (cohort.people.empty() || cohort.people.back().id != each.user_id)
            cohort.people.push_back(
                {each.user_id, name_or_number(each.user_name, each.user_id), {}, {}});
        Person& person = cohort.people.back();
        person.last_utc = std::max(person.last_utc, each.last_utc);
        person.tasks[each.task_id] = assessment::judge_standing(each.trials);
        cohort.tasks.insert(each.task_id);
    }
    return cohort;
}

Html cell_of(const Person& person, const std::string& task) {
    const auto found = person.tasks.find(task);
    if (found == person.tasks.end()) return dash();
    const CohortCell& cell = found->second;
    Html out;
    out << points(cell.last) << " " << standing_badge(cell.standing) << " <span class=\"small\">"
        << text(cell.attempts) << "×</span>";
    return link("/people/" + std::to_string(person.id) + "/tasks/" + path_part(task), out);
}

/// The heading with the ways between the views of a cohort, and the choice of a group.
Html head(const Visit& visit, const Text& title, const std::string& path,
          const std::vector<Choice>& further) {
    std::vector<Choice> all{group_choice(visit)};
    all.insert(all.end(), further.begin(), further.end());
    const std::string same = query({{"group", visit.asked("group")}});
    Html out;
    out << "<h1>" << title << "</h1>\n"
        << views(Web::phrase("Cohort"), path + same,
                 {{"/cohort" + same, Web::phrase("People by tasks")},
                  {"/help" + same, Web::phrase("Who needs help")},
                  {"/refreshers" + same, Web::phrase("Due for a refresher")},
                  {"/scores" + same, Web::phrase("Scores of a task")}})
        << choices(path, all);
    return out;
}

std::vector<db::TaskStanding> part_of_list(const std::vector<db::TaskStanding>& list,
                                           const Part& part) {
    return {list.begin() + part.first, list.begin() + part.past};
}

/// Somebody passed it, and has not done it since for at least so many days.
struct Due {
    db::TaskStanding standing;
    int64_t days = 0;
};
std::vector<Due> due_people(const Visit& visit, int64_t least_days) {
    const int64_t now = curriculum::utc_seconds(visit.now_utc).value_or(0);
    std::vector<Due> due;
    for (db::TaskStanding& each : standings_of(visit)) {
        const auto last = curriculum::utc_seconds(each.last_utc);
        if (each.trials.passed == 0 || !last) continue;
        const int64_t days = (now - *last) / kDayS;
        if (days >= least_days) due.push_back({std::move(each), days});
    }
    std::stable_sort(due.begin(), due.end(),
                     [](const Due& a, const Due& b) { return a.days > b.days; });
    return due;
}

Html person_link(const db::TaskStanding& standing) {
    return link("/people/" + std::to_string(standing.user_id),
                text(name_or_number(standing.user_name, standing.user_id)));
}
Html curve_link(const Visit& visit, const db::TaskStanding& standing) {
    return link(
        "/people/" + std::to_string(standing.user_id) + "/tasks/" + path_part(standing.task_id),
        text(visit.tasks.of(standing.task_id).title));
}

}  // namespace

PageText cohort_page(const Visit& visit) {
    const Cohort cohort = read_cohort(visit);
    Html body = head(visit, Web::phrase("Cohort"), "/cohort", {});
    if (cohort.people.empty()) {
        body << "<p class=\"muted\">" << Web::phrase("Nobody here has an attempt that counts.")
             << "</p>";
        return {Web::phrase("Cohort"), body};
    }
    const Part part = part_of(visit, static_cast<int64_t>(cohort.people.size()));
    std::vector<Column> columns{{Web::phrase("Person")}, {Web::phrase("Last seen")}};
    for (const std::string& task : cohort.tasks)
        columns.push_back({text(visit.tasks.of(task).title)});
    Table table(Web::count_phrase("%n person(s) with attempts", cohort.people.size()), columns);
    for (int64_t i = part.first; i < part.past; ++i) {
        const Person& person = cohort.people[static_cast<size_t>(i)];
        std::vector<Html> cells{link("/people/" + std::to_string(person.id), text(person.name)),
                                day(person.last_utc)};
        for (const std::string& task : cohort.tasks) cells.push_back(cell_of(person, task));
        table.row(cells);
    }
    body << "<section class=\"card\">" << table.html()
         << pager(part, "/cohort", {{"group", visit.asked("group")}}) << "<p class=\"small\">"
         << Web::phrase("Last score, standing and number of attempts.") << "</p></section>\n";
    return {Web::phrase("Cohort"), body};
}

PageText help_page(const Visit& visit) {
    std::vector<db::TaskStanding> list;
    std::vector<db::TaskStanding> regressed;
    for (db::TaskStanding& each : standings_of(visit)) {
        const Standing standing = assessment::judge_standing(each.trials).standing;
        if (standing == Standing::kStuck)
            list.push_back(std::move(each));
        else if (standing == Standing::kRegressed)
            regressed.push_back(std::move(each));
    }
    const size_t stuck = list.size();
    list.insert(list.end(), regressed.begin(), regressed.end());
    Html body = head(visit, Web::phrase("Who needs help"), "/help", {});
    const Part part = part_of(visit, static_cast<int64_t>(list.size()));
    Table table(Web::phrase("%1 stuck, %2 regressed; who is stuck stands first", text(stuck),
                            text(regressed.size())),
                {{Web::phrase("Person")},
                 {Web::phrase("Task")},
                 {Web::phrase("Standing")},
                 {Web::phrase("Last"), true},
                 {Web::phrase("Best"), true},
                 {Web::phrase("Attempts"), true},
                 {Web::phrase("Last on")}});
    for (const db::TaskStanding& each : part_of_list(list, part))
        table.row({person_link(each), curve_link(visit, each),
                   standing_badge(assessment::judge_standing(each.trials).standing),
                   points(each.last_points), points(each.best_points), text(each.attempts),
                   day(each.last_utc)});
    body << "<section class=\"card\">";
    if (list.empty())
        body << "<p>" << Web::phrase("Nobody is stuck or regressed.") << "</p>";
    else
        body << table.html() << pager(part, "/help", {{"group", visit.asked("group")}});
    body << "<p class=\"small\">" << standings_explained() << " "
         << Web::phrase("It points at people to look at and does not judge them.")
         << "</p></section>\n";
    return {Web::phrase("Who needs help"), body};
}

PageText refreshers_page(const Visit& visit) {
    const bool later = visit.asked("after") == "5";
    const std::vector<Due> due = due_people(visit, later ? kSecondDays : kFirstDays);
    Html body = head(
        visit, Web::phrase("Due for a refresher"), "/refreshers",
        {{"after",
          Web::phrase("Not practised for"),
          later ? "5" : "1",
          {{"1", Web::phrase("1 month or longer")}, {"5", Web::phrase("5 months or longer")}}}});
    const Part part = part_of(visit, static_cast<int64_t>(due.size()));
    Table table(
        Web::count_phrase(
            "%n person(s) and task(s) passed once and not practised since, the longest first",
            due.size()),
        {{Web::phrase("Person")},
         {Web::phrase("Task")},
         {Web::phrase("Due")},
         {Web::phrase("Last on")},
         {Web::phrase("Days ago"), true},
         {Web::phrase("Last"), true},
         {Web::phrase("Best"), true}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const Due& each = due[static_cast<size_t>(i)];
        table.row({person_link(each.standing), curve_link(visit, each.standing),
                   each.days >= kSecondDays ? badge(Web::phrase("since 5 months"), Tone::kCritical)
                                            : badge(Web::phrase("since 1 month"), Tone::kWarn),
                   day(each.standing.last_utc), text(each.days), points(each.standing.last_points),
                   points(each.standing.best_points)});
    }
    body << "<section class=\"card\">";
    if (due.empty())
        body << "<p>" << Web::phrase("Nobody is due.") << "</p>";
    else
        body << table.html()
             << pager(part, "/refreshers",
                      {{"group", visit.asked("group")}, {"after", visit.asked("after")}});
    body << "<p class=\"small\">"
         << Web::phrase(
                "A month is 30 days and counts from the last attempt that counts, of tasks with at "
                "least one pass. When a stage of a course is to be refreshed by the course's own "
                "rule stands on the person's page.")
         << "</p></section>\n";
    return {Web::phrase("Due for a refresher"), body};
}

PageText scores_page(const Visit& visit) {
    const std::vector<std::string> tasks = visit.store.attempts().tasks();
    Choice choice{"task", Web::phrase("Task"), visit.asked("task"), {}};
    for (const std::string& task : tasks)
        choice.values.emplace_back(task, text(visit.tasks.of(task).title));
    if (std::find(tasks.begin(), tasks.end(), choice.chosen) == tasks.end())
        choice.chosen = tasks.empty() ? "" : tasks.front();
    Html body = head(visit, Web::phrase("Scores of a task"), "/scores", {choice});
    if (tasks.empty()) {
        body << "<p class=\"muted\">" << Web::phrase("There are no attempts yet.") << "</p>";
        return {Web::phrase("Scores of a task"), body};
    }
    std::vector<reports::StripGroup> groups{{Web::plain_phrase("first attempt"), {}},
                                            {Web::plain_phrase("last attempt"), {}},
                                            {Web::plain_phrase("best attempt"), {}}};
    for (const db::TaskStanding& each : standings_of(visit, choice.chosen)) {
        groups[0].values.push_back(each.first_points);
        groups[1].values.push_back(each.last_points);
        groups[2].values.push_back(each.best_points);
    }
    const std::string title = visit.tasks.of(choice.chosen).title;
    Html drawing;
    if (groups[0].values.empty())
        drawing << "<p>" << Web::phrase("Nobody here has an attempt at it that counts.") << "</p>";
    else
        drawing << figure([&](const reports::ChartStyle& style) {
            reports::Figure strip =
                reports::points_figure("scores", Web::plain_phrase("Scores: %1", {title}),
                                       Web::plain_phrase("score [points of 100]"), groups, style);
            strip.caption = Web::plain_count_phrase(
                "%n person(s). Every point is a person; box: quartiles, line: median, diamond: "
                "mean.",
                groups[0].values.size());
            return strip;
        });
    body << card(text(title), drawing);
    return {Web::phrase("Scores of a task"), body};
}

}  // namespace placode::web
