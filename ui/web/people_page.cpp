// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts with roles and groups, without scores.

#include <QString>
#include <map>

#include "sim/core/counted.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

std::map<int64_t, std::string> groups_by_person(const Visit& visit) {
    std::map<int64_t, std::string> words;
    for (const db::GroupRecord& group : visit.store.groups().list()) {
        const auto add = [&](int64_t person, const char* role) {
            std::string& line = words[person];
            line += (line.empty() ? "" : ", ") + group.name + role;
        };
        for (const int64_t person : group.members) add(person, "");
        for (const int64_t person : group.educators) add(person, " (teaches)");
    }
    return words;
}

bool fits(const db::UserRecord& user, const QString& words) {
    return words.isEmpty() ||
           QString::fromStdString(user.display_name).contains(words, Qt::CaseInsensitive) ||
           QString::fromStdString(user.login).contains(words, Qt::CaseInsensitive);
}

Html search_form(const std::string& words) {
    Html out;
    out << "<form class=\"choices\" method=\"get\" action=\"/people\"><div><label "
           "for=\"find\">Name or log-in</label><input id=\"find\" name=\"find\" type=\"search\" "
           "maxlength=\"100\" value=\""
        << text(words) << "\"></div><button type=\"submit\">Find</button></form>\n";
    return out;
}

}  // namespace

PageText people_page(const Visit& visit) {
    const std::string wanted = visit.asked("find");
    std::vector<db::UserRecord> people;
    for (db::UserRecord& each : visit.store.accounts().list())
        if (fits(each, QString::fromStdString(wanted).trimmed())) people.push_back(std::move(each));
    const auto groups = groups_by_person(visit);
    const bool sees_scores = visit.may(db::Action::kViewAttempts);
    const Part part = part_of(visit, static_cast<int64_t>(people.size()));
    Table table(sim::counted(people.size(), "account"),
                {{"Person"}, {"Log-in"}, {"Roles"}, {"Groups"}, {"State"}, {"Since"}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::UserRecord& each = people[static_cast<size_t>(i)];
        const Html name = text(name_or_number(each.display_name, each.id));
        const auto of = groups.find(each.id);
        Html state = each.active ? badge(Html("open"), "good") : badge(Html("closed"), "");
        if (each.demonstration) state << " " << badge(Html("DEMONSTRATION"), "warn");
        table.row({sees_scores ? link("/people/" + std::to_string(each.id), name) : name,
                   text(each.login), text(role_words(each.roles)),
                   of == groups.end() ? text("–") : text(of->second), state,
                   day(each.created_utc)});
    }
    Html body;
    body << "<h1>People</h1>\n" << search_form(wanted) << "<section class=\"card\">";
    if (people.empty())
        body << "<p class=\"muted\">Nobody has that name.</p>";
    else
        body << table.html() << pager(part, "/people", {{"find", wanted}});
    body << "</section>\n";
    return {"People", body};
}

}  // namespace placode::web
