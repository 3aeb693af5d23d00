// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl course next: where a person stands in a course, what is next and why.

#include "curriculum/utc_time.h"
#include "db/course_conduct.h"
#include "ui/cli/course_options.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

const char* status_name(const curriculum::StageProgress& own) {
    if (own.refresh_due) return "refresh due";
    switch (own.status) {
        case curriculum::StageStatus::kLocked:
            return "locked";
        case curriculum::StageStatus::kOpen:
            return "open";
        case curriculum::StageStatus::kMastered:
            return "mastered";
        case curriculum::StageStatus::kExhausted:
            return "attempts used";
    }
    return "";
}

Json to_json(const db::CourseStanding& standing) {
    const auto& next = standing.next;
    Json json{{"course", standing.course.id},
              {"version", standing.course.version},
              {"assignment", standing.assignment.id},
              {"due_utc", standing.assignment.due_utc},
              {"mastered", standing.progress.mastered},
              {"next",
               {{"kind", curriculum::next_kind_name(next.kind)},
                {"stage", next.stage_id},
                {"task", next.task_id},
                {"to_go", next.to_go},
                {"attempts_left", next.attempts_left},
                {"overdue", next.overdue},
                {"reason", next.reason.en},
                {"reason_pl", next.reason.pl}}},
              {"stages", Json::array()}};
    if (next.kind == curriculum::NextKind::kExam || next.seed != 0)
        json["next"]["seed"] = next.seed;
    if (standing.certificate) json["certificate"] = standing.certificate->code;
    for (size_t i = 0; i < standing.course.stages.size(); ++i) {
        const auto& own = standing.progress.stages[i];
        json["stages"].push_back({{"id", standing.course.stages[i].id},
                                  {"task", standing.course.stages[i].task_id},
                                  {"status", status_name(own)},
                                  {"streak", own.streak},
                                  {"attempts", own.attempts},
                                  {"begun_not_finished", own.unfinished},
                                  {"best_points", own.best_points},
                                  {"mastered_utc", own.mastered_utc},
                                  {"refresh_utc", own.refresh_utc}});
    }
    return json;
}

std::string text_of(const db::CourseStanding& standing) {
    std::vector<std::vector<std::string>> rows{{"stage", "status", "streak", "best", "attempts"}};
    for (size_t i = 0; i < standing.course.stages.size(); ++i) {
        const auto& own = standing.progress.stages[i];
        rows.push_back({standing.course.stages[i].id, status_name(own), std::to_string(own.streak),
                        own.attempts == 0 ? "-" : fixed(own.best_points, 1),
                        std::to_string(own.attempts)});
    }
    std::string unfinished;
    for (size_t i = 0; i < standing.course.stages.size(); ++i)
        if (const int count = standing.progress.stages[i].unfinished; count > 0)
            unfinished += standing.course.stages[i].id +
                          ": begun, not finished: " + std::to_string(count) + "\n";
    return standing.course.title.en +
           "\nnext: " + (standing.next.task_id.empty() ? std::string("-") : standing.next.task_id) +
           " (" + curriculum::next_kind_name(standing.next.kind) + "). " + standing.next.reason.en +
           "\n" + table(rows) + unfinished;
}

}  // namespace

int course_next(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t whose = named_or_self(session, options.user);
    session.need_for(db::Action::kViewAttempts, whose);
    const std::string now = options.at.empty() ? now_utc() : options.at;
    if (!curriculum::utc_seconds(now))
        throw InputError("--at " + options.at + ": expected a day such as 2026-11-21");
    std::vector<db::CourseStanding> standings;
    if (options.id.empty())
        standings = db::course_standings(session.store(), whose, now);
    else
        standings.push_back(db::course_standing(session.store(), whose, options.id, now));
    Json json = Json::array();
    std::string text;
    for (const auto& standing : standings) {
        json.push_back(to_json(standing));
        text += (text.empty() ? "" : "\n") + text_of(standing);
    }
    print(context, json,
          text.empty() ? "no course is assigned; `placodectl course next --course ID` shows one "
                         "all the same"
                       : text);
    return 0;
}

}  // namespace placode::cli
