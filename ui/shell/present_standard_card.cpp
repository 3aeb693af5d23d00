// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The standard of a task that holds today.
#include <QCoreApplication>

#include "curriculum/task.h"
#include "db/standards.h"
#include "ui/shell/parts.h"
#include "ui/shell/standard_cards.h"

namespace placode::ui {
namespace {

/// In the context of the page that the card is on.
struct StandardWords {
    Q_DECLARE_TR_FUNCTIONS(StandardsPage)
};

QString origin_of(const db::StandardRecord& set) {
    const curriculum::PassStandard& standard = set.standard;
    if (standard.method == "angoff")
        return StandardWords::tr("From the estimates of %n judge(s), standard error %1 points. %2",
                                 nullptr, standard.angoff.judges)
            .arg(format_number(standard.angoff.se_points, 1), qstr(set.reason));
    return StandardWords::tr(
               "Novices: %1, experts: %2; novices who pass: %3 by the curves, %4 "
               "observed. %5")
        .arg(standard.novice.n)
        .arg(standard.expert.n)
        .arg(percent_text(standard.novice.theoretical_wrong),
             percent_text(standard.novice.observed_wrong), qstr(set.reason));
}

}  // namespace

QWidget* make_present_standard_card(AppContext& context, const std::string& task) {
    const auto set = db::standard_at(context.store(), task);
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace4);
    layout->addWidget(make_label(StandardWords::tr("The standard that holds"), "heading"));
    QLabel* mark = make_label({});
    mark->setObjectName("standard_now");
    layout->addWidget(mark);
    if (set) {
        mark->setText(StandardWords::tr("Pass mark %1 points, version %2, set by %3 on %4")
                          .arg(format_number(set->standard.pass_points, 1))
                          .arg(set->standard.version)
                          .arg(qstr(set->set_by), format_when(set->set_utc)));
        layout->addWidget(make_label(origin_of(*set), "small"));
    } else {
        double pass = 0;
        const auto problem =
            context.problemOf([&] { pass = curriculum::load_task(task).rubric.pass_points; });
        mark->setText(problem ? problem->title
                              : StandardWords::tr(
                                    "None was set: the task's own pass mark of %1 points holds.")
                                    .arg(format_points(pass)));
    }
    return make_card(layout);
}

}  // namespace placode::ui
