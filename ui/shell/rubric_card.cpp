// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/rubric_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLocale>

#include "db/standards.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct RubricWords {
    Q_DECLARE_TR_FUNCTIONS(TaskPage)
};

QLabel* item_badge(const assessment::RubricItem& item, double start_points, double weights) {
    if (item.critical) return make_badge(RubricWords::tr("critical error"), "critical");
    if (item.earns > 0)
        return make_badge(
            RubricWords::tr("up to +%1").arg(format_points(start_points * item.earns / weights)),
            "good");
    return make_badge(RubricWords::tr("up to −%1").arg(format_points(item.max_points)));
}

QString item_rule(const assessment::RubricItem& item) {
    QString name = qstr(item.metric), unit;
    if (const auto* metric = assessment::metric_definition(item.metric)) {
        name = metric_name(metric->name);
        unit = unit_sign(metric->unit);
    }
    // As the time limit beside it is written.
    const QString limit =
        unit == "s" && item.threshold >= 60
            ? format_duration(item.threshold)
            : QString(QLocale().toString(item.threshold, 'g', 4) + " " + unit).trimmed();
    if (item.earns > 0)
        return RubricWords::tr("%1: %2 earn all these points, less in proportion").arg(name, limit);
    if (item.critical)
        return item.below ? RubricWords::tr("%1: less than %2 fails the attempt").arg(name, limit)
               : item.threshold == 0
                   ? RubricWords::tr("%1: any fails the attempt").arg(name)
                   : RubricWords::tr("%1: more than %2 fails the attempt").arg(name, limit);
    return item.below            ? RubricWords::tr("%1: at least %2").arg(name, limit)
           : item.threshold == 0 ? RubricWords::tr("%1: none").arg(name)
                                 : RubricWords::tr("%1: at most %2").arg(name, limit);
}

}  // namespace

QFrame* make_rubric_card(AppContext& context, const curriculum::Task& task,
                         const curriculum::CourseStage* exam) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(make_label(RubricWords::tr("What is scored"), "heading"));
    double weights = 0;
    for (const assessment::RubricItem& item : task.rubric.items) weights += item.earns;
    const QString start = format_points(task.rubric.start_points);
    const double mark = db::rubric_at(context.store(), task).pass_points;
    const QString pass = format_points(mark);
    layout->addWidget(make_label(
        weights > 0
            ? RubricWords::tr("What you do earns up to %1 points, harm takes points off. You pass "
                              "with %2.")
                  .arg(start, pass)
            : RubricWords::tr("You start with %1 points and pass with %2.").arg(start, pass),
        "muted"));
    // Else three pages name three numbers, and nobody knows which is which.
    const QString own = format_points(task.rubric.pass_points);
    if (own != pass) {
        QLabel* set = make_label(
            RubricWords::tr("An educator has set this pass mark; the task's own is %1 points. The "
                            "benchmark of a course is the course's own.")
                .arg(own),
            "small");
        set->setObjectName("pass_mark_set");
        layout->addWidget(set);
    }
    if (exam) {
        QLabel* asked = make_label(RubricWords::tr("This exam asks for %1 points.")
                                       .arg(format_points(exam->benchmark_points)));
        asked->setObjectName("exam_points");
        layout->addWidget(asked);
    }
    for (const assessment::RubricItem& item : task.rubric.items) {
        layout->addWidget(make_rule());
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        line->addWidget(make_label(item_rule(item)), 1);
        line->addWidget(item_badge(item, task.rubric.start_points, weights), 0, Qt::AlignTop);
        layout->addLayout(line);
    }
    return make_card(layout);
}

}  // namespace placode::ui
