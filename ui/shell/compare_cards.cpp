// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/compare_cards.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <algorithm>

#include "db/attempt_counting.h"
#include "reports/words.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct CompareWords {
    Q_DECLARE_TR_FUNCTIONS(ComparePage)
};

void add_reasons(QVBoxLayout* layout, const std::vector<assessment::Reason>& reasons) {
    for (size_t i = 0; i < std::min<size_t>(3, reasons.size()); ++i)
        layout->addWidget(make_label("−" + format_points(reasons[i].points) + "  " +
                                     reports::reason_words(reasons[i])));
    if (reasons.empty())
        layout->addWidget(make_label(CompareWords::tr("No points were lost"), "good"));
}

}  // namespace

QFrame* make_compare_head(const db::AttemptDetail& attempt, const QString& name, size_t place) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    auto* line = new QHBoxLayout;
    const bool scored = db::counts(attempt.record);
    QLabel* points =
        make_label(scored ? points_words(attempt.record.points) : QStringLiteral("–"), "title");
    points->setObjectName(QString("compare_points_%1").arg(place));
    line->addWidget(points);
    line->addWidget(make_badge(verdict_word(attempt.record), verdict_tone(attempt.record)));
    line->addStretch();
    layout->addLayout(line);
    layout->addWidget(make_label(name, "muted"));
    if (scored)
        add_reasons(layout, attempt.score.reasons);
    else
        layout->addWidget(make_label(
            CompareWords::tr("Does not count: %1").arg(reports::not_counted_words(attempt.record)),
            "muted"));
    layout->addStretch();
    QFrame* card = make_card(layout);
    card->setObjectName(QString("compare_head_%1").arg(place));
    return card;
}

QFrame* make_compare_metrics(AppContext& context, const db::AttemptDetail& first,
                             const db::AttemptDetail& second) {
    auto* layout = new QVBoxLayout;
    layout->addWidget(make_label(CompareWords::tr("Measures"), "heading"));
    // What was left after a few seconds was short and gentle, and not better for that.
    const bool judged = db::counts(first.record) && db::counts(second.record);
    if (!judged)
        layout->addWidget(
            make_label(CompareWords::tr("One of the two does not count: its measures stand "
                                        "here without a verdict on which is better."),
                       "muted"));
    QTableWidget* table = make_table(
        {CompareWords::tr("Measure"), CompareWords::tr("Unit"), CompareWords::tr("This one"),
         CompareWords::tr("The other"), CompareWords::tr("Better")},
        CompareWords::tr("Measures"));
    table->setObjectName("compare_metrics");
    table->setSortingEnabled(false);
    const reports::TaskScope scope = task_scope(context, first.record.task_id);
    for (const assessment::MetricDefinition& each : assessment::metric_definitions()) {
        if (!reports::belongs(scope, each.id)) continue;
        const auto a = first.metrics.find(each.id);
        const auto b = second.metrics.find(each.id);
        if (!a || !b) continue;
        const int row = table->rowCount();
        table->insertRow(row);
        table->setItem(row, 0, make_cell(metric_name(each.name)));
        table->item(row, 0)->setData(Qt::UserRole, qstr(std::string(each.id)));
        table->item(row, 0)->setToolTip(metric_explanation(each, scope));
        table->setItem(row, 1, make_cell(each.unit.empty() ? "–" : unit_sign(each.unit)));
        table->setItem(row, 2, make_number_cell(metric_value(each, *a), *a));
        table->setItem(row, 3, make_number_cell(metric_value(each, *b), *b));
        const bool neutral = !judged || each.direction == assessment::Direction::kNeutral ||
                             format_value(*a) == format_value(*b);
        const bool first_better =
            (each.direction == assessment::Direction::kLowerIsBetter) == (*a < *b);
        table->setItem(row, 4,
                       make_cell(neutral        ? QStringLiteral("–")
                                 : first_better ? CompareWords::tr("◀ this one")
                                                : CompareWords::tr("the other ▶")));
    }
    fit_columns(table, 0);
    for (const int c : {2, 3, 4}) table->setColumnWidth(c, 140);
    table->setFixedHeight(std::clamp(table->rowCount(), 1, 8) * kTouchTarget + 50);
    layout->addWidget(table);
    return make_card(layout);
}

}  // namespace placode::ui
