// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/cohort_people.h"

#include <QCollator>
#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/points_figure.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// In the context of the page that shows them.
struct CohortWords {
    Q_DECLARE_TR_FUNCTIONS(CohortPage)
};

}  // namespace

CohortPeople read_cohort_people(db::Store& store) {
    CohortPeople cohort;
    std::map<int64_t, CohortPerson> people;
    for (const db::TaskStanding& each : store.attempts().standings(0)) {
        if (!each.active) continue;
        CohortPerson& person = people[each.user_id];
        person.id = each.user_id;
        if (person.name.isEmpty())
            person.name = each.user_name.empty() ? CohortWords::tr("number %1").arg(each.user_id)
                                                 : qstr(each.user_name);
        person.last_utc = std::max(person.last_utc, each.last_utc);
        person.tasks[each.task_id] = assessment::judge_standing(each.trials);
        person.first_points[each.task_id] = each.first_points;
        if (std::find(cohort.tasks.begin(), cohort.tasks.end(), each.task_id) == cohort.tasks.end())
            cohort.tasks.push_back(each.task_id);
    }
    std::sort(cohort.tasks.begin(), cohort.tasks.end());
    for (auto& [id, person] : people) cohort.people.push_back(std::move(person));
    QCollator by_name;
    std::sort(cohort.people.begin(), cohort.people.end(),
              [&](const CohortPerson& a, const CohortPerson& b) {
                  return by_name.compare(a.name, b.name) < 0;
              });
    return cohort;
}

QString standing_words(assessment::Standing standing) {
    using assessment::Standing;
    switch (standing) {
        case Standing::kNotTried:
            return CohortWords::tr("not tried");
        case Standing::kLearning:
            return CohortWords::tr("learning");
        case Standing::kPassing:
            return CohortWords::tr("passing");
        case Standing::kRegressed:
            return CohortWords::tr("regressed");
        case Standing::kStuck:
            return CohortWords::tr("stuck");
    }
    return {};
}

bool needs_help(assessment::Standing standing) {
    return standing == assessment::Standing::kStuck || standing == assessment::Standing::kRegressed;
}

QWidget* make_scores_picture(const AppContext& context, const std::vector<CohortPerson>& people,
                             const std::string& task) {
    reports::StripGroup first{CohortWords::tr("first attempt").toStdString(), {}},
        last{CohortWords::tr("last attempt").toStdString(), {}},
        best{CohortWords::tr("best attempt").toStdString(), {}};
    for (const CohortPerson& person : people) {
        const auto found = person.tasks.find(task);
        if (found == person.tasks.end()) continue;
        first.values.push_back(person.first_points.at(task));
        last.values.push_back(found->second.last);
        best.values.push_back(found->second.best);
    }
    const reports::Figure figure =
        reports::points_figure("scores", {}, CohortWords::tr("score [points of 100]").toStdString(),
                               {first, last, best}, chart_style(context.theme()));
    QWidget* picture = make_picture(
        [figure](QPainter& painter, const QRectF& where) { figure.draw(painter, where); },
        QSize(480, static_cast<int>(figure.height)), CohortWords::tr("Scores of a task"),
        CohortWords::tr("First, last and best score of %n person(s).", nullptr,
                        static_cast<int>(first.values.size())));
    picture->setObjectName("distribution");
    picture->setFixedHeight(static_cast<int>(figure.height));
    return picture;
}

std::string cohort_csv(const std::vector<CohortPerson>& people) {
    std::string csv = reports::csv_line({"person", "task", "standing", "attempts", "last_points",
                                         "best_points", "passed_in_a_row"});
    static constexpr const char* kWords[]{"not_tried", "learning", "passing", "regressed", "stuck"};
    for (const CohortPerson& person : people)
        for (const auto& [task, cell] : person.tasks)
            csv += reports::csv_line(
                {reports::harmless(person.name.toStdString()), task,
                 kWords[static_cast<size_t>(cell.standing)], std::to_string(cell.attempts),
                 QString::number(cell.last, 'f', 1).toStdString(),
                 QString::number(cell.best, 'f', 1).toStdString(), std::to_string(cell.streak)});
    return csv;
}

}  // namespace placode::ui
