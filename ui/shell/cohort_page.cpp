// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Cohort: people by tasks, who is stuck and who regressed first, and how scores of one task are
// spread.

#include <QCheckBox>
#include <QCollator>
#include <QComboBox>
#include <QFile>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <map>

#include "assessment/cohort.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/figure.h"
#include "ui/shell/attempts_table.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"
#include "ui/shell/training_reports.h"

namespace placode::ui {
namespace {

constexpr int kFewTasks = 170, kManyTasks = 116, kLeastTask = 48;  ///< Width of a column [px].

using assessment::CohortCell;
using assessment::Standing;

constexpr int kMostHelpLines = 8;

struct Person {
    int64_t id = 0;
    QString name;
    std::map<std::string, CohortCell> tasks;
    std::map<std::string, double> first_points;
    std::string last_utc;
};

/// The style sheet draws cells without their own background: this one does it.
class HeatDelegate : public QStyledItemDelegate {
 public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QVariant brush = index.data(Qt::BackgroundRole);
        if (brush.isValid())
            painter->fillRect(option.rect.adjusted(2, 2, -2, -2), brush.value<QBrush>());
        QStyledItemDelegate::paint(painter, option, index);
    }
};

class CohortPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(CohortPage)
 public:
    CohortPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        read();
        QVBoxLayout* column = make_column(this, 1400);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Cohort"), "display"), 1);
        help_ = new QCheckBox(tr("Only people who need help"));
        help_->setObjectName("only_help");
        help_->setChecked(place.state.value("help").toBool());
        help_->setEnabled(!people_.empty());  // Without people there is no table.
        connect(help_, &QCheckBox::toggled, this, [this] { filter(); });
        head->addWidget(help_);
        QPushButton* save = make_button(context, tr("Export"), "secondary", "download");
        save->setObjectName("cohort_export");
        save->setEnabled(!people_.empty());
        connect(save, &QPushButton::clicked, this, [this] { exportTable(); });
        QPushButton* report = make_cohort_report_button(context, *this);
        report->setEnabled(!people_.empty());
        head->addWidget(report);
        head->addWidget(save);
        column->addLayout(head);
        if (people_.empty()) {
            QLabel* why = make_label(whyEmpty(), "muted");
            why->setObjectName("cohort_empty");
            column->addWidget(why);
            column->addStretch();
            return;
        }
        column->addWidget(helpCard());
        column->addWidget(tableCard());
        column->addWidget(distributionCard(place));
        column->addStretch();
        filter();
    }

    [[nodiscard]] QString title() const override { return tr("Cohort"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"help", help_->isChecked()},
                {"task", chooser_ ? chooser_->currentData() : QVariant()}};
    }

 private:
    void read() {
        std::map<int64_t, Person> people;
        for (const db::TaskStanding& each : context_.store().attempts().standings(0)) {
            Person& person = people[each.user_id];
            person.id = each.user_id;
            if (person.name.isEmpty())
                person.name = each.user_name.empty() ? tr("number %1").arg(each.user_id)
                                                     : qstr(each.user_name);
            person.last_utc = std::max(person.last_utc, each.last_utc);
            person.tasks[each.task_id] = assessment::judge_standing(each.trials);
            person.first_points[each.task_id] = each.first_points;
            if (std::find(tasks_.begin(), tasks_.end(), each.task_id) == tasks_.end())
                tasks_.push_back(each.task_id);
        }
        std::sort(tasks_.begin(), tasks_.end());
        for (auto& [id, person] : people) people_.push_back(std::move(person));
        QCollator by_name;
        std::sort(people_.begin(), people_.end(), [&](const Person& a, const Person& b) {
            return by_name.compare(a.name, b.name) < 0;
        });
    }

    /// The page of attempts may list some that do not count.
    [[nodiscard]] QString whyEmpty() const {
        const auto made = context_.store().attempts().page({}).rows;
        if (made.empty())
            return tr("Nobody has made an attempt yet. Once a trainee has, it shows up here.");
        return why_nobody_counts(made);
    }

    [[nodiscard]] static QString wordOf(Standing standing) {
        switch (standing) {
            case Standing::kNotTried:
                return tr("not tried");
            case Standing::kLearning:
                return tr("learning");
            case Standing::kPassing:
                return tr("passing");
            case Standing::kRegressed:
                return tr("regressed");
            case Standing::kStuck:
                return tr("stuck");
        }
        return {};
    }
    [[nodiscard]] static bool needsHelp(Standing standing) {
        return standing == Standing::kStuck || standing == Standing::kRegressed;
    }

    QWidget* helpCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Who needs help"), "heading"));
        int shown = 0, waiting = 0;
        // Who is stuck first; the rest of a long list is in the table, behind its own switch.
        for (const Standing kind : {Standing::kStuck, Standing::kRegressed})
            for (const Person& person : people_)
                for (const auto& [task, cell] : person.tasks) {
                    if (cell.standing != kind) continue;
                    if (shown < kMostHelpLines)
                        layout->addLayout(helpLine(person, task, cell, shown++));
                    else
                        ++waiting;
                }
        if (waiting > 0) {
            QLabel* more = make_label(
                tr("And %1 more: choose \"Only people who need help\" to see them in the table.")
                    .arg(waiting));
            more->setObjectName("help_more");
            layout->addWidget(more);
        }
        if (shown == 0) layout->addWidget(make_label(tr("Nobody is stuck or regressed."), "good"));
        layout->addWidget(make_label(
            tr("Stuck: none of the last 5 attempts passed and no gain of 3 points. Regressed: "
               "passed before, but neither of the last two attempts."),
            "small"));
        return make_card(layout);
    }

    QHBoxLayout* helpLine(const Person& person, const std::string& task, const CohortCell& cell,
                          int number) {
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        line->addWidget(make_badge(wordOf(cell.standing),
                                   cell.standing == Standing::kStuck ? "critical" : "warn"));
        line->addWidget(make_label(tr("%1 · %2 · last %3, best %4, attempts %5")
                                       .arg(person.name, task_title(context_, task),
                                            format_points(cell.last), format_points(cell.best))
                                       .arg(cell.attempts)),
                        1);
        QPushButton* open = make_button(context_, tr("Open the attempts"), "quiet", "next");
        open->setObjectName(QString("help_%1").arg(number));
        open->setAccessibleName(tr("Open the attempts of %1").arg(person.name));
        connect(open, &QPushButton::clicked, this,
                [this, id = person.id, task] { openAttempts(id, task); });
        line->addWidget(open);
        return line;
    }

    void openAttempts(int64_t person, const std::string& task) {
        Q_EMIT go({PageId::kAttempts,
                   0,
                   {},
                   {{"person", QVariant::fromValue<qint64>(person)}, {"task", qstr(task)}}});
    }

    QWidget* tableCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("People by tasks"), "heading"));
        QStringList head{tr("Person"), tr("Last seen")};
        for (const std::string& task : tasks_) head << task_title(context_, task);
        table_ = make_table(head, tr("People by tasks"));
        use_title_header(table_, 2);
        table_->setObjectName("cohort_table");
        table_->setSortingEnabled(false);
        table_->setSelectionBehavior(QAbstractItemView::SelectItems);
        table_->setRowCount(static_cast<int>(people_.size()));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const Person& person = people_[static_cast<size_t>(row)];
            table_->setItem(row, 0, make_cell(person.name));
            table_->item(row, 0)->setData(Qt::UserRole, row);
            table_->setItem(row, 1, make_cell(format_when(person.last_utc)));
            for (size_t t = 0; t < tasks_.size(); ++t)
                table_->setItem(row, static_cast<int>(t) + 2, cellOf(person, tasks_[t]));
        }
        fit_columns(table_, 0);
        table_->setItemDelegate(new HeatDelegate(table_));
        for (int c = 2; c < table_->columnCount(); ++c)
            table_->setColumnWidth(c, manyTasks() ? kManyTasks : kFewTasks);
        table_->horizontalHeader()->setMinimumSectionSize(kLeastTask);
        wrap_titles(table_);
        // A name ends in dots before the scores of twelve tasks scroll sideways.
        keep_within(
            table_,
            {.stretch = 0, .least_px = 180, .keep_px = manyTasks() ? 150 : 180, .drop = {1}});
        table_->setMinimumHeight(std::min(10, table_->rowCount() + 3) * kTouchTarget + 20);
        connect(table_, &QTableWidget::cellActivated, this, [this](int row, int column) {
            const auto index =
                static_cast<size_t>(table_->item(row, 0)->data(Qt::UserRole).toInt());
            openAttempts(people_[index].id,
                         column < 2 ? std::string() : tasks_[static_cast<size_t>(column - 2)]);
        });
        layout->addWidget(table_);
        layout->addWidget(make_label(tr("Last score, verdict and number of attempts, or the last "
                                        "score alone where there are many "
                                        "tasks. Enter or double click opens them."),
                                     "small"));
        return make_card(layout);
    }

    /// Then a cell holds the score alone, and how many attempts stand behind it in its tool tip.
    [[nodiscard]] bool manyTasks() const { return tasks_.size() > 4; }

    QTableWidgetItem* cellOf(const Person& person, const std::string& task) {
        const auto found = person.tasks.find(task);
        if (found == person.tasks.end()) return make_number_cell("–", -1);
        const CohortCell& cell = found->second;
        const char* sign = cell.standing == Standing::kPassing ? "✓"
                           : needsHelp(cell.standing)          ? "▼"
                                                               : "·";
        QString words = QString("%1 %2").arg(sign, format_points(cell.last));
        if (!manyTasks()) words += QString("  %1×").arg(cell.attempts);
        QTableWidgetItem* item = make_number_cell(words, cell.last);
        item->setToolTip(
            wordOf(cell.standing) + " · " +
            tr("best %1, passed in a row: %2").arg(format_points(cell.best)).arg(cell.streak) +
            " · " + tr("attempts: %1").arg(cell.attempts));
        const Tokens& colors = context_.colors();
        switch (cell.standing) {
            case Standing::kPassing:
                item->setBackground(colors.good_soft);
                item->setForeground(colors.good);
                break;
            case Standing::kRegressed:
                item->setBackground(colors.warn_soft);
                item->setForeground(colors.warn);
                break;
            case Standing::kStuck:
                item->setBackground(colors.critical_soft);
                item->setForeground(colors.critical);
                break;
            default:
                break;
        }
        return item;
    }

    void filter() {
        for (int row = 0; row < table_->rowCount(); ++row) {
            const auto& tasks = people_[static_cast<size_t>(row)].tasks;
            const bool wanted = !help_->isChecked() ||
                                std::any_of(tasks.begin(), tasks.end(), [](const auto& each) {
                                    return needsHelp(each.second.standing);
                                });
            table_->setRowHidden(row, !wanted);
        }
    }

    QWidget* distributionCard(const Place& place) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Scores of a task"), "heading"), 1);
        chooser_ = new QComboBox;
        chooser_->setObjectName("distribution_task");
        chooser_->setAccessibleName(tr("Task"));
        for (const std::string& task : tasks_)
            chooser_->addItem(task_title(context_, task), qstr(task));
        chooser_->setCurrentIndex(std::max(0, chooser_->findData(place.state.value("task"))));
        head->addWidget(chooser_);
        layout->addLayout(head);
        pictures_ = new QVBoxLayout;
        layout->addLayout(pictures_);
        layout->addWidget(make_label(tr("Every point is a person; box: quartiles, line: median, "
                                        "diamond: mean."),
                                     "small"));
        connect(chooser_, &QComboBox::currentIndexChanged, this, [this] { showDistribution(); });
        showDistribution();
        return make_card(layout);
    }

    void showDistribution() {
        while (QLayoutItem* item = pictures_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        const std::string task = chooser_->currentData().toString().toStdString();
        reports::StripGroup first{tr("first attempt").toStdString(), {}},
            last{tr("last attempt").toStdString(), {}}, best{tr("best attempt").toStdString(), {}};
        for (const Person& person : people_) {
            const auto found = person.tasks.find(task);
            if (found == person.tasks.end()) continue;
            first.values.push_back(person.first_points.at(task));
            last.values.push_back(found->second.last);
            best.values.push_back(found->second.best);
        }
        const reports::Figure figure =
            reports::strip_figure("scores", {}, tr("score [points of 100]").toStdString(),
                                  {first, last, best}, chart_style(context_.theme()));
        QWidget* picture = make_picture(
            [figure](QPainter& painter, const QRectF& where) { figure.draw(painter, where); },
            QSize(480, static_cast<int>(figure.height)), tr("Scores of a task"),
            tr("First, last and best score of %n person(s).", nullptr,
               static_cast<int>(first.values.size())));
        picture->setObjectName("distribution");
        picture->setFixedHeight(static_cast<int>(figure.height));
        pictures_->addWidget(picture);
    }

    void exportTable() {
        const QString path = context_.askSaveFile(this, tr("Export the cohort"),
                                                  "placode-cohort.csv", tr("CSV (*.csv)"));
        if (path.isEmpty()) return;
        context_.guard(tr("Exporting the cohort"), [&] {
            context_.require(db::Action::kViewPersonalData, db::Scope::kOther);
            std::string csv = reports::csv_line({"person", "task", "standing", "attempts",
                                                 "last_points", "best_points", "passed_in_a_row"});
            static constexpr const char* kWords[]{"not_tried", "learning", "passing", "regressed",
                                                  "stuck"};
            for (const Person& person : people_)
                for (const auto& [task, cell] : person.tasks)
                    csv += reports::csv_line({reports::harmless(person.name.toStdString()), task,
                                              kWords[static_cast<size_t>(cell.standing)],
                                              std::to_string(cell.attempts),
                                              QString::number(cell.last, 'f', 1).toStdString(),
                                              QString::number(cell.best, 'f', 1).toStdString(),
                                              std::to_string(cell.streak)});
            reports::save_file(path.toStdString(), csv);
            context_.audit("export.cohort", "cohort", path);
            Q_EMIT written(tr("Cohort written: %1").arg(path), path);
        });
    }

    std::vector<Person> people_;
    std::vector<std::string> tasks_;
    QCheckBox* help_ = nullptr;
    QTableWidget* table_ = nullptr;
    QComboBox* chooser_ = nullptr;
    QVBoxLayout* pictures_ = nullptr;
};

}  // namespace

Page* make_cohort_page(AppContext& context, const Place& place) {
    return new CohortPage(context, place);
}

}  // namespace placode::ui
