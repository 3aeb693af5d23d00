// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/people_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <set>
#include <sstream>

#include "assessment/csv_reader.h"
#include "db/password.h"
#include "reports/csv_table.h"
#include "reports/export.h"

namespace placode::reports {
namespace {

constexpr std::array<std::pair<const char*, db::Role>, 4> kRoles{
    {{"trainee", db::Role::kTrainee},
     {"educator", db::Role::kEducator},
     {"coordinator", db::Role::kCoordinator},
     {"administrator", db::Role::kAdministrator}}};
constexpr std::array<const char*, 5> kColumns{"login", "name", "roles", "group", "password"};

using RowCells = std::vector<std::string>;

std::vector<assessment::CsvRow> rows_of(const std::string& csv, const std::string& origin) {
    try {
        auto rows = assessment::read_csv(csv);
        assessment::leave_out_empty_lines(rows);
        return rows;
    } catch (const assessment::CsvError& error) {
        throw PeopleFileError(origin + ": " + error.what());
    }
}

size_t column(const RowCells& head, const std::string& name) {
    return static_cast<size_t>(std::find(head.begin(), head.end(), name) - head.begin());
}

void check_head(const RowCells& head, const std::string& origin) {
    if (column(head, "login") == head.size() || column(head, "name") == head.size())
        throw PeopleFileError(origin +
                              ":1: expected the columns login,name[,roles][,group][,password]");
    for (const std::string& name : head)
        if (std::find(kColumns.begin(), kColumns.end(), name) == kColumns.end())
            throw PeopleFileError(origin + ":1: found the column \"" + name +
                                  "\"; expected login, name, roles, group or password");
}

int64_t group_of(db::Store& store, const std::string& name) {
    int64_t found = 0;
    for (const db::GroupRecord& group : store.groups().list()) {
        if (group.name != name && std::to_string(group.id) != name) continue;
        if (found != 0)
            throw PeopleFileError("\"" + name +
                                  "\" is the name of one group and the number of another; give the "
                                  "number of the one or the name of the other");
        found = group.id;
    }
    if (found == 0) throw PeopleFileError("there is no group \"" + name + "\" in " + store.url());
    return found;
}

/// What the store would refuse, said before anybody is added.
void check_rules(const db::NewUser& user, const std::string& place) {
    auto problem = db::login_problem(user.login);
    if (!problem) problem = db::name_problem(user.display_name);
    if (!problem && !user.password.empty())
        problem = db::password_problem(user.login, user.password);
    if (problem) throw PeopleFileError(place + problem->english());
}

PersonLine read_line(db::Store& store, const RowCells& head, const RowCells& row,
                     const std::string& place) {
    if (row.size() != head.size())
        throw PeopleFileError(place + "found " + std::to_string(row.size()) +
                              " columns; expected " + std::to_string(head.size()));
    const auto cell = [&](const char* name) {
        const size_t at = column(head, name);
        return at == head.size() ? std::string() : row[at];
    };
    PersonLine line;
    line.user.login = cell("login");
    line.user.display_name = cell("name");
    line.user.password = cell("password");
    try {
        if (!cell("roles").empty()) line.user.roles = roles_of_text(cell("roles"));
        if (!cell("group").empty()) line.group_id = group_of(store, cell("group"));
    } catch (const PeopleFileError& error) {
        throw PeopleFileError(place + error.what());
    }
    if (line.user.login.empty() || line.user.display_name.empty())
        throw PeopleFileError(place + "login and name must not be empty");
    check_rules(line.user, place);
    return line;
}

QString text(const std::string& value) { return QString::fromStdString(value); }

QJsonObject attempt_json(db::Store& store, const db::AttemptRecord& record) {
    const db::AttemptDetail detail = store.attempts().detail(record.id);
    QJsonObject metrics;
    for (const auto& metric : detail.metrics.values)
        metrics[text(std::string(metric.id))] = metric.value;
    QJsonArray reasons, further;
    for (const auto& reason : detail.score.reasons)
        reasons.append(QJsonObject{{"text", text(reason.text)}, {"points", reason.points}});
    for (const auto& each : store.attempts().rescores(record.id))
        further.append(QJsonObject{{"points", each.score.points},
                                   {"rubric", text(each.score.rubric_id)},
                                   {"rubric_version", each.score.rubric_version},
                                   {"scored_utc", text(each.scored_utc)}});
    QJsonArray remarks;
    for (const db::CommentRecord& each : store.reviews().comments(record.id))
        remarks.append(QJsonObject{{"time_s", each.time_s}, {"text", text(each.text)}});
    return {{"id", static_cast<qint64>(record.id)},
            {"task", text(record.task_id)},
            {"started_utc", text(record.started_utc)},
            {"duration_s", record.duration_s},
            {"device", text(record.device)},
            {"points", record.points},
            {"rubric", text(record.rubric_id)},
            {"rubric_version", record.rubric_version},
            {"exam_of_course", text(record.exam.course_id)},
            {"metrics", metrics},
            {"reasons", reasons},
            {"remarks", remarks},
            {"further_scores", further}};
}

QJsonObject person_json(db::Store& store, const db::UserRecord& user) {
    QJsonArray roles, groups, assignments, begins, certificates;
    for (const auto& [name, role] : kRoles)
        if (db::has_role(user.roles, role)) roles.append(name);
    for (const db::GroupRecord& group : store.groups().list())
        for (const auto* list : {&group.members, &group.educators})
            if (std::find(list->begin(), list->end(), user.id) != list->end())
                groups.append(text(group.name));
    for (const auto& each : store.courses().assignments(user.id))
        assignments.append(
            QJsonObject{{"course", text(each.course_id)}, {"due_utc", text(each.due_utc)}});
    for (const auto& each : store.courses().exam_begins(user.id))
        begins.append(QJsonObject{{"course", text(each.course_id)},
                                  {"stage", text(each.stage_id)},
                                  {"begun_utc", text(each.begun_utc)},
                                  {"attempt", static_cast<qint64>(each.attempt_id)}});
    for (const auto& each : store.courses().certificates(user.id))
        certificates.append(QJsonObject{{"course", text(each.course_id)},
                                        {"version", each.course_version},
                                        {"mastered_utc", text(each.mastered_utc)},
                                        {"code", text(each.code)}});
    return {{"id", static_cast<qint64>(user.id)},
            {"login", text(user.login)},
            {"name", text(user.display_name)},
            {"roles", roles},
            {"created_utc", text(user.created_utc)},
            {"has_pin", store.accounts().has_pin(user.id)},
            {"groups", groups},
            {"assignments", assignments},
            {"begun_exams", begins},
            {"certificates", certificates}};
}

}  // namespace

db::Roles roles_of_text(const std::string& text) {
    db::Roles roles = 0;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, ';');) {
        db::Roles found = 0;
        for (const auto& [known, role] : kRoles)
            if (word == known) found = static_cast<db::Roles>(role);
        if (found == 0)
            throw PeopleFileError("found the role \"" + word +
                                  "\"; expected trainee, educator, coordinator or administrator");
        roles |= found;
    }
    return roles;
}

std::vector<PersonLine> read_people(db::Store& store, const std::string& csv,
                                    const std::string& origin) {
    const auto rows = rows_of(csv, origin);
    const RowCells head = rows.empty() ? RowCells{} : rows[0].cells;
    check_head(head, origin);
    std::set<std::string> logins;
    std::vector<PersonLine> people;
    for (size_t i = 1; i < rows.size(); ++i) {
        const std::string place = origin + ":" + std::to_string(rows[i].line) + ": ";
        PersonLine line = read_line(store, head, rows[i].cells, place);
        line.line = rows[i].line;
        if (!logins.insert(db::login_key(line.user.login)).second ||
            store.accounts().find_login(line.user.login))
            throw PeopleFileError(place + "the login \"" + line.user.login + "\" is taken");
        people.push_back(std::move(line));
    }
    return people;
}

std::string make_passwords(std::vector<PersonLine>& people) {
    std::string csv;
    for (PersonLine& person : people) {
        if (!person.user.password.empty()) continue;
        if (csv.empty()) csv = csv_line({"login", "password"});
        person.user.password = db::new_password();
        csv += csv_line({harmless(person.user.login), person.user.password});
    }
    return csv;
}

void save_passwords(const std::string& path, const std::string& csv) {
    using Kind = db::StoreError::Kind;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                            S_IRUSR | S_IWUSR);
    if (file < 0 && errno == EEXIST)
        throw db::StoreError(
            Kind::kRefused, "write the passwords: ",
            db::Said::that("%1 exists and is not overwritten; give another name").with(path));
    size_t done = 0;
    bool kept = file >= 0;
    while (kept && done < csv.size()) {
        const ssize_t wrote = ::write(file, csv.data() + done, csv.size() - done);
        kept = wrote > 0;
        done += kept ? static_cast<size_t>(wrote) : 0;
    }
    kept = kept && ::fsync(file) == 0;
    const std::string why = std::strerror(errno);
    if (file >= 0) ::close(file);
    if (kept) return;
    if (file >= 0) ::unlink(path.c_str());
    throw db::StoreError(Kind::kOther, "write the passwords: " + path + ": " + why +
                                           "; choose a folder that you may write to");
}

size_t make_accounts(db::Store& store, const std::vector<PersonLine>& people,
                     const std::string& origin) {
    std::vector<db::ListedUser> list;
    for (const PersonLine& person : people) {
        list.push_back({person.user, person.group_id});
        list.back().user.password_given = true;
    }
    size_t at = 0;
    try {
        store.accounts().create_all(list, at);
    } catch (const db::StoreError& error) {
        const std::string line = at < people.size() ? std::to_string(people[at].line) + ": " : " ";
        throw PeopleFileError(origin + ":" + line + error.what() + " (nobody was added)");
    }
    return people.size();
}

OwnData write_own_data(db::Store& store, int64_t user_id, const std::string& folder,
                       bool with_recordings) {
    const auto user = store.accounts().find(user_id);
    if (!user)
        throw db::StoreError(db::StoreError::Kind::kNotFound,
                             "there is no person with the number " + std::to_string(user_id));
    OwnData written;
    QJsonObject json = person_json(store, *user);
    QJsonArray list;
    const auto attempts = store.attempts().list(user_id);
    for (const db::AttemptRecord& record : attempts) list.append(attempt_json(store, record));
    json["attempts"] = list;
    written.attempts = static_cast<int>(attempts.size());
    // Before the first file: nothing leaves without its entry.
    store.audit().write(user->login, "user.data", "user " + std::to_string(user_id), folder);
    make_private_folder(folder);
    save_private_file(folder + "/my_data.json", QJsonDocument(json).toJson().toStdString());
    for (const db::AttemptRecord& record : attempts) {
        if (!with_recordings) break;
        try {
            const std::string file = folder + "/attempt_" + std::to_string(record.id) + ".placode";
            store.attempts().extract_recording(record.id, file);
            ::chmod(file.c_str(), S_IRUSR | S_IWUSR);
            ++written.recordings;
        } catch (const db::StoreError& problem) {
            // A score from elsewhere has no recording; everything else is told.
            if (problem.kind() != db::StoreError::Kind::kNotFound) throw;
        }
    }
    return written;
}

}  // namespace placode::reports
