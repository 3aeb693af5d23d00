// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A pass mark from contrasting groups, what it would have cost, and how far the groups carry it.

#include <QCoreApplication>
#include <stdexcept>

#include "reports/attempt_figures.h"
#include "ui/shell/parts.h"
#include "ui/shell/standard_cards.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// Fewer in a group carry no standard.
constexpr int kFewInGroup = 10;

struct StandardsWords {
    Q_DECLARE_TR_FUNCTIONS(StandardsPage)
};

/// "0.012", "< 0.001"
QString p_text(double p) {
    return p < 0.001 ? "< " + format_number(0.001, 3) : format_number(p, 3);
}

void add_result(QVBoxLayout* layout, const AppContext& context,
                const assessment::ContrastingGroups& result, const std::vector<double>& novices,
                const std::vector<double>& experts) {
    QLabel* cut = make_label(
        StandardsWords::tr("Pass mark: %1 points").arg(format_number(result.cut_score, 1)),
        "title");
    cut->setObjectName("cut_score");
    layout->addWidget(cut);
    const reports::ChartStyle style = chart_style(context.theme());
    QWidget* picture = make_picture(
        [result, novices, experts, style](QPainter& painter, const QRectF& where) {
            reports::draw_groups(painter, where, result, novices, experts, style);
        },
        QSize(480, 280), StandardsWords::tr("Contrasting groups"), cut->text());
    picture->setObjectName("groups_picture");
    picture->setFixedHeight(290);
    layout->addWidget(picture);
    QTableWidget* table =
        make_table({StandardsWords::tr("What"), StandardsWords::tr("From the curves"),
                    StandardsWords::tr("Observed")},
                   StandardsWords::tr("What the pass mark costs"));
    table->setSortingEnabled(false);
    table->setRowCount(2);
    table->setItem(0, 0, make_cell(StandardsWords::tr("Novices who would pass")));
    table->setItem(0, 1, make_cell(percent_text(result.theoretical_false_positive)));
    table->setItem(0, 2, make_cell(percent_text(result.observed_false_positive)));
    table->setItem(1, 0, make_cell(StandardsWords::tr("Experts who would fail")));
    table->setItem(1, 1, make_cell(percent_text(result.theoretical_false_negative)));
    table->setItem(1, 2, make_cell(percent_text(result.observed_false_negative)));
    fit_columns(table, 0);
    table->setColumnWidth(1, 160);
    table->setColumnWidth(2, 160);
    table->setFixedHeight(2 * kTouchTarget + 48);
    layout->addWidget(table);
    layout->addWidget(make_label(
        StandardsWords::tr(
            "AUC %1, Cohen's d %2, Mann-Whitney p %3. Method: Jorgensen, Konge and Subhi 2018.")
            .arg(format_number(result.auc, 2), format_number(result.cohens_d, 2),
                 p_text(result.mannwhitney_p_cc)),
        "small"));
    if (result.n_novice < kFewInGroup || result.n_expert < kFewInGroup)
        layout->addWidget(
            make_label(StandardsWords::tr(
                           "Fewer than %1 people in a group: a first orientation, not a standard.")
                           .arg(kFewInGroup),
                       "warn"));
}

}  // namespace

QString percent_text(double share) { return format_number(100 * share, 0) + " %"; }

QFrame* make_contrasting_card(AppContext& context, const std::vector<double>& novices,
                              const std::vector<double>& experts,
                              const std::function<void(QVBoxLayout*)>& saving) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(StandardsWords::tr("Contrasting groups"), "heading"));
    if (novices.size() < 2 || experts.size() < 2) {
        layout->addWidget(make_label(
            StandardsWords::tr("Choose at least two novices and two experts."), "muted"));
        return make_card(layout);
    }
    try {
        add_result(layout, context, assessment::contrasting_groups(novices, experts), novices,
                   experts);
        if (saving) saving(layout);
    } catch (const std::invalid_argument& error) {
        QLabel* why = make_label(
            StandardsWords::tr("These groups give no pass mark: their scores do not vary, or "
                               "do not differ in the right direction."),
            "warn");
        why->setObjectName("standard_problem");
        layout->addWidget(why);
        layout->addWidget(make_label(QString::fromUtf8(error.what()), "small"));
    }
    return make_card(layout);
}

}  // namespace placode::ui
