// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Standards: a pass mark for a task from two groups of people (contrasting groups), with what it
// would have cost: who would pass or fail wrongly.

#include <QComboBox>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <algorithm>
#include <map>

#include "assessment/standard_setting.h"
#include "assessment/statistics.h"
#include "db/norms.h"
#include "db/standards.h"
#include "reports/attempt_figures.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// Fewer in a group carry no standard.
constexpr int kFewInGroup = 10;
constexpr size_t kLastAttempts = 3;
/// Of one task that are looked at, oldest first: more than any centre has.
constexpr int kMostAttempts = 100000;

/// Whose score counts once: a person, or a scripted operator that a person had play.
struct Operator {
    QString name;
    std::vector<double> points;  ///< Oldest first.
    int64_t user_id = 0;         ///< 0 = a scripted operator: nobody's skill.
    bool demonstration = false;
    /// Mean of the last attempts.
    [[nodiscard]] double value() const {
        const size_t n = std::min(kLastAttempts, points.size());
        return assessment::mean_of(std::span(points).last(n)).value_or(0);
    }
};

class StandardsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StandardsPage)
 public:
    StandardsPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        for (const db::TaskStanding& each : context.store().task_standings(0))
            if (std::find(known_.begin(), known_.end(), each.task_id) == known_.end())
                known_.push_back(each.task_id);
        groups_ = place.state.value("groups").toMap();
        QVBoxLayout* column = make_column(this);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Standards"), "display"), 1);
        tasks_ = new QComboBox;
        tasks_->setObjectName("standard_task");
        tasks_->setAccessibleName(tr("Task"));
        for (const std::string& task : known_)
            tasks_->addItem(task_title(context, task), qstr(task));
        tasks_->setCurrentIndex(std::max(0, tasks_->findData(place.state.value("task"))));
        head->addWidget(tasks_);
        column->addLayout(head);
        column->addWidget(make_label(
            tr("A pass mark from two groups: choose who is a novice and who is an expert at this "
               "task. Each person counts once, with the mean of the last %1 attempts.")
                .arg(kLastAttempts),
            "muted"));
        if (known_.empty()) {
            column->addWidget(make_label(tr("There are no attempts yet."), "muted"));
            column->addStretch();
            return;
        }
        body_ = new QVBoxLayout;
        body_->setSpacing(kSpace16);
        column->addLayout(body_);
        column->addStretch();
        connect(tasks_, &QComboBox::currentIndexChanged, this, [this] {
            groups_.clear();
            showTask();
        });
        showTask();
    }

    [[nodiscard]] QString title() const override { return tr("Standards"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"task", tasks_->currentData()}, {"groups", groups_}};
    }

 private:
    void read() {
        operators_.clear();
        std::map<QString, Operator> found;
        const std::string task = tasks_->currentData().toString().toStdString();
        db::AttemptFilter filter;
        filter.task_id = task;
        filter.newest_first = false;
        filter.limit = kMostAttempts;
        for (const db::AttemptRecord& each : context_.store().attempt_page(filter).rows) {
            if (each.end == sim::EndReason::kInterrupted || !each.void_reason.empty()) continue;
            QString name = qstr(each.user_name);
            const bool script = each.device.rfind("script:", 0) == 0;
            if (script) name += " · " + device_name(each.device);
            Operator& one = found[name];
            one.name = name;
            one.user_id = script ? 0 : each.user_id;
            one.points.push_back(each.points);
            one.demonstration = one.demonstration || each.demonstration;
        }
        for (auto& [name, one] : found) operators_.push_back(std::move(one));
    }

    void showTask() {
        read();
        while (QLayoutItem* item = body_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        body_->addWidget(presentCard());
        body_->addWidget(groupsCard());
        result_ = new QVBoxLayout;
        auto* holder = new QWidget;
        holder->setLayout(result_);
        result_->setContentsMargins(0, 0, 0, 0);
        body_->addWidget(holder);
        showResult();
    }

    /// What holds today, and since when.
    QWidget* presentCard() {
        const std::string task = tasks_->currentData().toString().toStdString();
        const auto set = db::standard_at(context_.store(), task);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace4);
        layout->addWidget(make_label(tr("The standard that holds"), "heading"));
        QLabel* mark = make_label({});
        mark->setObjectName("standard_now");
        layout->addWidget(mark);
        if (set) {
            mark->setText(tr("Pass mark %1 points, version %2, set by %3 on %4")
                              .arg(format_number(set->standard.pass_points, 1))
                              .arg(set->standard.version)
                              .arg(qstr(set->set_by), format_when(set->set_utc)));
            layout->addWidget(make_label(
                tr("From %1 novices and %2 experts; novices who pass: %3 by the curves, %4 "
                   "observed. %5")
                    .arg(set->standard.novice.n)
                    .arg(set->standard.expert.n)
                    .arg(percent(set->standard.novice.theoretical_wrong),
                         percent(set->standard.novice.observed_wrong), qstr(set->reason)),
                "small"));
        } else {
            double pass = 0;
            const auto problem =
                context_.problemOf([&] { pass = curriculum::load_task(task).rubric.pass_points; });
            mark->setText(problem ? problem->title
                                  : tr("None was set: the task's own pass mark of %1 points holds.")
                                        .arg(format_points(pass)));
        }
        return make_card(layout);
    }

    [[nodiscard]] static QString percent(double share) {
        return format_number(100 * share, 0) + " %";
    }

    /// The mark becomes the task's standard: attempts from now on are judged by it.
    void addSaving(QVBoxLayout* layout) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        reason_ = new QLineEdit;
        reason_->setObjectName("standard_reason");
        row->addLayout(make_field(tr("Reason (needed from the second one on)"), reason_), 1);
        QPushButton* save = make_button(context_, tr("Set as the standard"), "primary", "check");
        save->setObjectName("set_standard");
        connect(save, &QPushButton::clicked, this, [this] { this->save(); });
        row->addWidget(save, 0, Qt::AlignBottom);
        layout->addLayout(row);
        auto* norms = new QHBoxLayout;
        norms->setSpacing(kSpace16);
        centre_ = new QLineEdit(context_.settings().value("centre").toString());
        centre_->setObjectName("centre_name");
        norms->addLayout(make_field(tr("Name of this centre"), centre_), 1);
        QPushButton* make =
            make_button(context_, tr("Make a norm pack of these groups"), "secondary", "norms");
        make->setObjectName("make_norms");
        connect(make, &QPushButton::clicked, this, [this] { makeNorms(); });
        norms->addWidget(make, 0, Qt::AlignBottom);
        layout->addLayout(norms);
    }

    void save() {
        context_.guard(tr("Setting the standard"), [this] {
            context_.require(db::Action::kSetStandards, db::Scope::kOther);
            const int version = db::set_standard(
                context_.store(),
                db::standard_of_groups(tasks_->currentData().toString().toStdString(), values(1),
                                       values(2), static_cast<int>(kLastAttempts)),
                reason_->text().trimmed().toStdString());
            showTask();
            Q_EMIT notice(tr("The standard is set (version %1). Attempts from now on are judged by "
                             "it; earlier ones keep their verdict.")
                              .arg(version));
        });
    }

    void makeNorms() {
        context_.guard(tr("Making the norm pack"), [this] {
            context_.require(db::Action::kSetStandards, db::Scope::kOther);
            std::map<std::string, std::vector<int64_t>> people;
            for (const Operator& one : operators_) {
                const int group = groups_.value(one.name).toInt();
                if (one.user_id != 0 && group > 0)
                    people[group == 1 ? "novice" : "expert"].push_back(one.user_id);
            }
            db::Store& store = context_.store();
            const std::string task = tasks_->currentData().toString().toStdString();
            const std::string centre = centre_->text().trimmed().toStdString();
            context_.settings().setValue("centre", centre_->text().trimmed());
            db::keep_own_norms(
                store,
                db::make_norms(db::level_attempts(store, task, people), centre,
                               QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(),
                               curriculum::kLeastNormGroup));
            Q_EMIT notice(tr("The norm pack is made and signed. It stands on the page Norms."));
        });
    }

    QWidget* groupsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Groups"), "heading"));
        QTableWidget* table = make_table(
            {tr("Person"), tr("Attempts"), tr("Mean of the last"), tr("Group"), tr("Remark")},
            tr("Groups"));
        table->setObjectName("standard_people");
        table->setSortingEnabled(false);
        table->setRowCount(static_cast<int>(operators_.size()));
        for (int row = 0; row < table->rowCount(); ++row) {
            const Operator& one = operators_[static_cast<size_t>(row)];
            const int n = static_cast<int>(one.points.size());
            table->setItem(row, 0, make_cell(one.name));
            table->setItem(row, 1, make_number_cell(QString::number(n), n));
            table->setItem(row, 2, make_number_cell(format_number(one.value(), 1), one.value()));
            table->setItem(row, 4, make_cell(one.demonstration ? tr("DEMONSTRATION") : QString()));
            auto* group = new QComboBox;
            group->setObjectName(QString("group_%1").arg(row));
            group->setAccessibleName(tr("Group of %1").arg(one.name));
            group->addItem(tr("neither"), 0);
            group->addItem(tr("novice"), 1);
            group->addItem(tr("expert"), 2);
            group->setCurrentIndex(groups_.value(one.name).toInt());
            connect(group, &QComboBox::currentIndexChanged, this, [this, name = one.name](int i) {
                groups_[name] = i;
                showResult();
            });
            table->setCellWidget(row, 3, group);
        }
        fit_columns(table, 0);
        table->setColumnWidth(3, 150);
        table->setFixedHeight(std::min(6, std::max(1, table->rowCount())) * kTouchTarget + 50);
        layout->addWidget(table);
        return make_card(layout);
    }

    [[nodiscard]] std::vector<double> values(int group) const {
        std::vector<double> found;
        for (const Operator& one : operators_)
            if (groups_.value(one.name).toInt() == group) found.push_back(one.value());
        return found;
    }

    void showResult() {
        while (QLayoutItem* item = result_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Contrasting groups"), "heading"));
        const std::vector<double> novices = values(1), experts = values(2);
        if (novices.size() < 2 || experts.size() < 2) {
            layout->addWidget(
                make_label(tr("Choose at least two novices and two experts."), "muted"));
            result_->addWidget(make_card(layout));
            return;
        }
        try {
            addResult(layout, assessment::contrasting_groups(novices, experts), novices, experts);
        } catch (const std::invalid_argument& error) {
            QLabel* why =
                make_label(tr("These groups give no pass mark: their scores do not vary, or "
                              "do not differ in the right direction."),
                           "warn");
            why->setObjectName("standard_problem");
            layout->addWidget(why);
            layout->addWidget(make_label(QString::fromUtf8(error.what()), "small"));
        }
        result_->addWidget(make_card(layout));
    }

    void addResult(QVBoxLayout* layout, const assessment::ContrastingGroups& result,
                   const std::vector<double>& novices, const std::vector<double>& experts) {
        QLabel* cut =
            make_label(tr("Pass mark: %1 points").arg(format_number(result.cut_score, 1)), "title");
        cut->setObjectName("cut_score");
        layout->addWidget(cut);
        const reports::ChartStyle style = chart_style(context_.theme());
        QWidget* picture = make_picture(
            [result, novices, experts, style](QPainter& painter, const QRectF& where) {
                reports::draw_groups(painter, where, result, novices, experts, style);
            },
            QSize(480, 280), tr("Contrasting groups"), cut->text());
        picture->setObjectName("groups_picture");
        picture->setFixedHeight(290);
        layout->addWidget(picture);
        QTableWidget* table = make_table({tr("What"), tr("From the curves"), tr("Observed")},
                                         tr("What the pass mark costs"));
        table->setSortingEnabled(false);
        table->setRowCount(2);
        table->setItem(0, 0, make_cell(tr("Novices who would pass")));
        table->setItem(0, 1, make_cell(percent(result.theoretical_false_positive)));
        table->setItem(0, 2, make_cell(percent(result.observed_false_positive)));
        table->setItem(1, 0, make_cell(tr("Experts who would fail")));
        table->setItem(1, 1, make_cell(percent(result.theoretical_false_negative)));
        table->setItem(1, 2, make_cell(percent(result.observed_false_negative)));
        fit_columns(table, 0);
        table->setColumnWidth(1, 160);
        table->setColumnWidth(2, 160);
        table->setFixedHeight(2 * kTouchTarget + 48);
        layout->addWidget(table);
        layout->addWidget(make_label(
            tr("AUC %1, Cohen's d %2, Mann-Whitney p %3. Method: Jorgensen, Konge and Subhi 2018.")
                .arg(format_number(result.auc, 2), format_number(result.cohens_d, 2),
                     format_number(result.mannwhitney_p_cc, 3)),
            "small"));
        if (result.n_novice < kFewInGroup || result.n_expert < kFewInGroup)
            layout->addWidget(make_label(
                tr("Fewer than %1 people in a group: a first orientation, not a standard.")
                    .arg(kFewInGroup),
                "warn"));
        if (context_.may(db::Action::kSetStandards, db::Scope::kOther)) addSaving(layout);
    }

    std::vector<std::string> known_;  ///< Tasks with attempts.
    std::vector<Operator> operators_;
    QVariantMap groups_;  ///< Name of the operator to 0 neither, 1 novice, 2 expert.
    QComboBox* tasks_ = nullptr;
    QVBoxLayout *body_ = nullptr, *result_ = nullptr;
    QLineEdit *reason_ = nullptr, *centre_ = nullptr;
};

}  // namespace

Page* make_standards_page(AppContext& context, const Place& place) {
    return new StandardsPage(context, place);
}

}  // namespace placode::ui
