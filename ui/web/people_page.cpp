// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts with roles and groups, without scores.

#include <QString>
#include <map>

#include "ui/web/parts.h"

namespace placode::web {
namespace {

std::map<int64_t, std::string> groups_by_person(const Visit& visit) {
    std::map<int64_t, std::string> lines;
    for (const db::GroupRecord& group : visit.store.groups().list()) {
        const auto add = [&](int64_t person, const std::string& how) {
            std::string& line = lines[person];
            line += (line.empty() ? "" : ", ") + how;
        };
        for (const int64_t person : group.members) add(person, group.name);
        for (const int64_t person : group.educators)
            add(person, Web::plain_phrase("%1 (teaches)", {group.name}));
    }
    return lines;
}

bool fits(const db::UserRecord& user, const QString& words) {
    return words.isEmpty() ||
           QString::fromStdString(user.display_name).contains(words, Qt::CaseInsensitive) ||
           QString::fromStdString(user.login).contains(words, Qt::CaseInsensitive);
}

Html search_form(const std::string& words) {
    Html out;
    out << "<form class=\"choices\" method=\"get\" action=\"/people\"><div><label for=\"find\">"
        << Web::phrase("Name or log-in")
        << "</label><input id=\"find\" name=\"find\" type=\"search\" maxlength=\"100\" value=\""
        << text(words) << "\"></div><button type=\"submit\">" << Web::phrase("Find")
        << "</button></form>\n";
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
    Table table(Web::count_phrase("%n account(s)", people.size()), {{Web::phrase("Person")},
                                                                    {Web::phrase("Log-in")},
                                                                    {Web::phrase("Roles")},
                                                                    {Web::phrase("Groups")},
                                                                    {Web::phrase("State")},
                                                                    {Web::phrase("Since")}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::UserRecord& each = people[static_cast<size_t>(i)];
        const Html name = text(name_or_number(each.display_name, each.id));
        const auto of = groups.find(each.id);
        Html state = each.active ? badge(Web::phrase("open@account"), Tone::kGood)
                                 : badge(Web::phrase("closed@account"), Tone::kPlain);
        if (each.demonstration) state << " " << demonstration_badge();
        table.row({sees_scores ? link("/people/" + std::to_string(each.id), name) : name,
                   text(each.login), text(role_words(each.roles)),
                   of == groups.end() ? dash() : text(of->second), state, day(each.created_utc)});
    }
    Html body;
    body << "<h1>" << Web::phrase("People") << "</h1>\n"
         << search_form(wanted) << "<section class=\"card\">";
    if (people.empty())
        body << "<p class=\"muted\">" << Web::phrase("Nobody has that name.") << "</p>";
    else
        body << table.html() << pager(part, "/people", {{"find", wanted}});
    body << "</section>\n";
    return {Web::phrase("People"), body};
}

}  // namespace placode::web
