// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of attempts, newest first: of one person, and of everybody or a group.

#include "ui/web/parts.h"

namespace placode::web {
namespace {

/// A larger number of a page is an address somebody made up; its rows would not fit 64 bits.
constexpr int64_t kLastPage = 1'000'000;

/// The page of the list that is asked for, and what leads to the others.
Html list(const Visit& visit, db::AttemptFilter filter, const std::string& path,
          std::vector<QueryPart> asked, bool with_person) {
    filter.limit = kRowsOfPage;
    filter.offset = (std::clamp<int64_t>(visit.number("page"), 1, kLastPage) - 1) * kRowsOfPage;
    db::AttemptPage page = visit.store.attempts().page(filter);
    const Part part = part_of(visit, page.total);
    if (part.first != filter.offset) {  // Beyond the end: the last one.
        filter.offset = part.first;
        page = visit.store.attempts().page(filter);
    }
    Html out;
    if (page.rows.empty())
        out << "<p class=\"muted\">" << Web::phrase("There are no attempts here.") << "</p>";
    else
        out << attempts_table(visit, Web::count_phrase("%n attempt(s), newest first", page.total),
                              page.rows, with_person)
            << pager(part, path, std::move(asked));
    return out;
}

Choice task_choice(const Visit& visit, const std::vector<std::string>& tasks) {
    Choice choice{
        "task", Web::phrase("Task"), visit.asked("task"), {{"", Web::phrase("All tasks")}}};
    for (const std::string& task : tasks)
        choice.values.emplace_back(task, text(visit.tasks.of(task).title));
    return choice;
}

}  // namespace

PageText attempts_page(const Visit& visit) {
    db::AttemptFilter filter;
    filter.group_id = visit.number("group");
    filter.task_id = visit.asked("task");
    const std::vector<std::string> tasks = visit.store.attempts().tasks();
    Html body;
    body << "<h1>" << Web::phrase("Attempts") << "</h1>\n"
         << choices("/attempts", {group_choice(visit), task_choice(visit, tasks)})
         << "<section class=\"card\">"
         << list(visit, filter, "/attempts",
                 {{"group", visit.asked("group")}, {"task", filter.task_id}}, true)
         << "</section>\n";
    return {Web::phrase("Attempts"), body};
}

PageText persons_attempts_page(const Visit& visit) {
    const auto user = visit.store.accounts().find(visit.id());
    if (!user) throw NotThere(Web::plain_phrase("There is no such person."));
    db::AttemptFilter filter;
    filter.user_id = user->id;
    filter.task_id = visit.asked("task");
    const std::string path = "/people/" + std::to_string(user->id);
    const std::string name = name_or_number(user->display_name, user->id);
    Html body;
    const Text title = Web::phrase("Attempts of %1", text(name));
    body << "<h1>" << title << "</h1><p>" << link(path, text(name));
    if (!filter.task_id.empty())
        body << " · " << Web::phrase("%1 only", text(visit.tasks.of(filter.task_id).title)) << " · "
             << link(path + "/attempts", Web::phrase("all tasks"));
    body << "</p>\n<section class=\"card\">"
         << list(visit, filter, path + "/attempts", {{"task", filter.task_id}}, false)
         << "</section>\n";
    return {title, body};
}

}  // namespace placode::web
