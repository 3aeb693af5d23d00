// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Cohort: people by tasks, who is stuck and who regressed first, and how scores of one task are
// spread.

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <algorithm>
#include <map>

#include "assessment/cohort.h"
#include "db/attempt_counting.h"
#include "reports/export.h"
#include "ui/shell/attempts_table.h"
#include "ui/shell/cohort_people.h"
#include "ui/shell/heat_delegate.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"
#include "ui/shell/training_reports.h"

namespace placode::ui {
namespace {

constexpr int kFewTasks = 170, kManyTasks = 116, kLeastTask = 36;  ///< Width of a column [px].
constexpr int kRoomForScore = 44;  ///< Of a column that holds a sign and a score [px].

using assessment::CohortCell;
using assessment::Standing;

constexpr int kMostHelpLines = 8;

class CohortPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(CohortPage)
 public:
    CohortPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        CohortPeople read = read_cohort_people(context.store());
        people_ = std::move(read.people);
        tasks_ = std::move(read.tasks);
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
    /// The page of attempts may list some that do not count.
    [[nodiscard]] QString whyEmpty() const {
        const auto made = context_.store().attempts().page({}).rows;
        if (made.empty())
            return tr("Nobody has made an attempt yet. Once a trainee has, it shows up here.");
        if (std::any_of(made.begin(), made.end(),
                        [](const db::AttemptRecord& each) { return db::counts(each); }))
            return tr("Whoever made attempts has left: the accounts are deactivated.");
        return why_nobody_counts(made);
    }

    QWidget* helpCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Who needs help"), "heading"));
        int shown = 0, waiting = 0;
        // Who is stuck first; the rest of a long list is in the table, behind its own switch.
        for (const Standing kind : {Standing::kStuck, Standing::kRegressed})
            for (const CohortPerson& person : people_)
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

    QHBoxLayout* helpLine(const CohortPerson& person, const std::string& task,
                          const CohortCell& cell, int number) {
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        line->addWidget(make_badge(standing_words(cell.standing),
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
            const CohortPerson& person = people_[static_cast<size_t>(row)];
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
        // A name ends in dots before the scores of eighteen tasks scroll sideways, and not before
        // they have given way to it.
        keep_within(table_, {.stretch = 0,
                             .least_px = 180,
                             .keep_px = manyTasks() ? 104 : 180,
                             .least_column_px = kLeastTask,
                             .give_way_px = manyTasks() ? kRoomForScore : 0,
                             .drop = {1}});
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

    QTableWidgetItem* cellOf(const CohortPerson& person, const std::string& task) {
        const auto found = person.tasks.find(task);
        if (found == person.tasks.end()) return make_number_cell("–", -1);
        const CohortCell& cell = found->second;
        const char* sign = cell.standing == Standing::kPassing ? "✓"
                           : needs_help(cell.standing)         ? "▼"
                                                               : "·";
        const QString words =
            manyTasks()
                ? sign + QString::number(whole_points(cell.last))
                : QString("%1 %2  %3×").arg(sign, format_points(cell.last)).arg(cell.attempts);
        QTableWidgetItem* item = make_number_cell(words, cell.last);
        item->setToolTip(standing_words(cell.standing) + " · " + format_points(cell.last) + " · " +
                         tr("best %1, finished attempts passed in a row: %2")
                             .arg(format_points(cell.best))
                             .arg(cell.streak) +
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
                                    return needs_help(each.second.standing);
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
        QWidget* picture = make_scores_picture(context_, people_, task);
        pictures_->addWidget(picture);
    }

    void exportTable() {
        const QString path = context_.askSaveFile(this, tr("Export the cohort"),
                                                  "placode-cohort.csv", tr("CSV (*.csv)"));
        if (path.isEmpty()) return;
        context_.guard(tr("Exporting the cohort"), [&] {
            context_.require(db::Action::kViewPersonalData, db::Scope::kOther);
            const std::string csv = cohort_csv(people_);
            // Before the file: nothing leaves without its entry.
            context_.audit("export.cohort", "cohort", path);
            reports::save_private_file(path.toStdString(), csv);
            Q_EMIT written(tr("Cohort written: %1").arg(path), path);
        });
    }

    std::vector<CohortPerson> people_;
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
