// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// History: the own scores as a chart and a table; a row opens its result.

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>

#include "assessment/learning_curve.h"
#include "assessment/standard_setting.h"
#include "db/attempt_counting.h"
#include "db/standards.h"
#include "reports/figure.h"
#include "ui/shell/attempts_table.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"
#include "ui/shell/training_reports.h"

namespace placode::ui {
namespace {

/// Of attempts that are not passed: fine up to here, and not acceptable from here on.
constexpr double kAcceptableRate = 0.05, kTooOftenRate = 0.10;

class HistoryPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(HistoryPage)
 public:
    HistoryPage(AppContext& context, const Place& place)
        : Page(context), all_(context.store().attempts().list(context.user().id)) {
        column_ = make_column(this);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("History"), "display"), 1);
        column_->addLayout(head);
        if (all_.empty()) {
            showEmpty();
            return;
        }
        tasks_ = new QComboBox;
        tasks_->setObjectName("history_task");
        tasks_->setAccessibleName(tr("Task"));
        for (const db::AttemptRecord& attempt : all_) {
            const QString id = qstr(attempt.task_id);
            if (tasks_->findData(id) < 0) tasks_->addItem(task_title(context, attempt.task_id), id);
        }
        // A task without an attempt of this person is none to show: then the last one done.
        const int asked = tasks_->findData(place.state.value("task"));
        tasks_->setCurrentIndex(asked >= 0 ? asked : tasks_->findData(qstr(all_.back().task_id)));
        head->addWidget(tasks_);
        head->addWidget(make_trainee_report_button(context, *this, tr("Report"),
                                                   [&context] { return context.user().id; }));
        connect(tasks_, &QComboBox::currentIndexChanged, this, [this] { showTask(); });
        body_ = new QVBoxLayout;
        body_->setSpacing(kSpace16);
        column_->addLayout(body_, 1);
        showTask();
    }

    [[nodiscard]] QString title() const override { return tr("History"); }
    [[nodiscard]] QVariantMap state() const override {
        return tasks_ ? QVariantMap{{"task", tasks_->currentData()}} : QVariantMap{};
    }

 private:
    void showEmpty() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("No attempts yet"), "heading"));
        layout->addWidget(make_label(
            tr("After your first attempt this page shows how your score develops."), "muted"));
        QPushButton* open = make_button(context_, tr("Open the course"), "primary", "course");
        connect(open, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kCourse, 0, {}, {}});
        });
        layout->addWidget(open, 0, Qt::AlignLeft);
        column_->addWidget(make_card(layout));
        column_->addStretch();
    }

    void showTask() {
        while (QLayoutItem* item = body_->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        const std::string id = tasks_->currentData().toString().toStdString();
        std::vector<db::AttemptRecord> shown, counted;
        for (const db::AttemptRecord& attempt : all_) {
            if (attempt.task_id != id) continue;
            shown.push_back(attempt);
            if (db::counts(attempt)) counted.push_back(attempt);
        }
        double pass = 70;
        (void)context_.problemOf(
            [&] { pass = db::rubric_at(context_.store(), curriculum::load_task(id)).pass_points; });
        auto* layout = new QVBoxLayout;
        layout->addWidget(make_label(tr("Score over attempts"), "heading"));
        if (counted.empty()) {
            addNothingCounts(layout, shown, qstr(id));
        } else {
            addChart(layout, counted, pass);
        }
        body_->addWidget(make_card(layout));
        if (counted.size() >= assessment::kCurveFrom) body_->addWidget(curveCard(counted, pass));
        QTableWidget* table = make_attempts_table(context_, shown, AttemptColumns::kOwn);
        table->setObjectName("history_table");
        table->setMinimumHeight(260);
        connect(table, &QTableWidget::cellActivated, this, [this, table](int row, int) {
            Q_EMIT go({PageId::kResult, attempt_of_row(table, row), {}, {}});
        });
        body_->addWidget(table, 1);
        body_->addWidget(make_label(tr("Enter or double click opens the result."), "small"));
    }

    void addNothingCounts(QVBoxLayout* layout, const std::vector<db::AttemptRecord>& shown,
                          const QString& task) {
        layout->setSpacing(kSpace12);
        QLabel* why = make_label(why_nothing_counts(shown), "muted");
        why->setObjectName("history_empty");
        layout->addWidget(why);
        QPushButton* open = make_button(context_, tr("Open the task"), "primary", "play");
        open->setObjectName("history_open_task");
        connect(open, &QPushButton::clicked, this, [this, task] {
            Q_EMIT go({PageId::kTask, 0, task, {}});
        });
        layout->addWidget(open, 0, Qt::AlignLeft);
    }

    void addChart(QVBoxLayout* layout, const std::vector<db::AttemptRecord>& counted, double pass) {
        const reports::ChartStyle style = chart_style(context_.theme());
        QWidget* chart = make_picture(
            [counted, pass, style](QPainter& painter, const QRectF& where) {
                reports::draw_history(painter, where, counted, pass, style);
            },
            QSize(320, 260), tr("Score over attempts"),
            tr("The same numbers stand in the table below."));
        chart->setObjectName("history_chart");
        layout->addWidget(chart);
    }

    static QString curveWords(const assessment::LearningCurve& curve) {
        if (curve.constant) return tr("All scores are equal: there is no curve to fit.");
        if (!curve.exponential || !curve.exponential->converged)
            return tr("No curve fits yet: the scores go up and down without a trend.");
        if (curve.exponential->gain <= 0)
            return tr("No learning curve: what fits the scores does not rise.");
        return tr("The curve approaches %1 points; 95 % of the gain is reached after about %2 "
                  "attempts. %3")
            .arg(
                format_points(curve.exponential->asymptote),
                format_number(curve.exponential->trial_to_95pct_of_gain, 0),
                curve.plateau ? tr("You are on the plateau.") : tr("There is still gain to come."));
    }

    /// What the fitted curve says in words, and the CUSUM with its limits.
    QWidget* curveCard(const std::vector<db::AttemptRecord>& counted, double pass) {
        reports::LearningLine line{context_.user().display_name, {}, {}};
        for (const db::AttemptRecord& attempt : counted) {
            line.points.push_back(attempt.points);
            line.failed.push_back(attempt.verdict != assessment::Verdict::kPassed);
        }
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Learning curve"), "heading"));
        const assessment::LearningCurve curve = assessment::learning_curve(line.points);
        QLabel* words = make_label(curveWords(curve), "muted");
        words->setObjectName("learning_words");
        layout->addWidget(words);
        const reports::Figure figure = reports::learning_figure(
            "learning", {}, {line}, pass,
            assessment::cusum_limits(kAcceptableRate, kTooOftenRate, 0.05, 0.20),
            chart_style(context_.theme()));
        QWidget* picture = make_picture(
            [figure](QPainter& painter, const QRectF& where) { figure.draw(painter, where); },
            QSize(320, static_cast<int>(figure.height)), tr("Learning curve and CUSUM"),
            words->text());
        picture->setFixedHeight(static_cast<int>(figure.height));
        layout->addWidget(picture);
        layout->addWidget(cusumWords(line.failed));
        layout->addWidget(make_label(
            tr("Below: CUSUM of attempts that were not passed. Above the upper limit performance "
               "is not acceptable, below the lower one it is (Bolsin and Colson 2000)."),
            "small"));
        return make_card(layout);
    }

    /// Where the sum stands today.
    static QLabel* cusumWords(const std::vector<bool>& failed) {
        const auto limits = assessment::cusum_limits(kAcceptableRate, kTooOftenRate, 0.05, 0.20);
        const assessment::Cusum sum = assessment::cusum(failed, limits);
        const double now = sum.path.empty() ? 0 : sum.path.back();
        const bool bad = now > limits.h1_upper, good = now < limits.h0_lower;
        QLabel* words = make_label(
            bad ? tr("CUSUM: since attempt %1 too many attempts are not passed. Practise the stage "
                     "before with your educator.")
                      .arg(sum.first_above_h1)
            : good ? tr("CUSUM: since attempt %1 the share of attempts that are not passed is "
                        "acceptable.")
                         .arg(sum.first_below_h0)
                   : tr("CUSUM: between the limits, more attempts will decide."),
            bad    ? "warn"
            : good ? "good"
                   : "muted");
        words->setObjectName("cusum_words");
        return words;
    }

    std::vector<db::AttemptRecord> all_;
    QVBoxLayout *column_ = nullptr, *body_ = nullptr;
    QComboBox* tasks_ = nullptr;
};

}  // namespace

Page* make_history_page(AppContext& context, const Place& place) {
    return new HistoryPage(context, place);
}

}  // namespace placode::ui
