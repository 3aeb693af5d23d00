// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Standards: a pass mark for a task from two groups of people (contrasting groups), with what it
// would have cost: who would pass or fail wrongly. Or from judges; and what each metric is worth.

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>
#include <map>

#include "assessment/standard_setting.h"
#include "db/norm_bands.h"
#include "db/standards.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/passphrase_dialog.h"
#include "ui/shell/standard_cards.h"
#include "ui/shell/training.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

constexpr int kLastAttempts = 3;

/// Whose score counts once: a person, or a scripted operator that a person had play.
struct Operator {
    QString key;  ///< In the page's state.
    QString name;
    db::RecentMean recent;
    [[nodiscard]] bool scripted() const { return !recent.script.empty(); }
};

class StandardsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StandardsPage)
 public:
    StandardsPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        known_ = context.store().attempts().tasks();
        groups_ = place.state.value("groups").toMap();
        marked_ = place.state.value("marked").toBool();
        angoff_ = place.state.value("angoff").toMap();
        QVBoxLayout* column = make_column(this);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Standards"), "display"), 1);
        tasks_ = new QComboBox;
        tasks_->setObjectName("standard_task");
        tasks_->setAccessibleName(tr("Task"));
        for (const std::string& task : known_)
            tasks_->addItem(task_title(context, task), qstr(task));
        shown_ = std::max(0, tasks_->findData(place.state.value("task")));
        tasks_->setCurrentIndex(shown_);
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
        connect(tasks_, &QComboBox::currentIndexChanged, this, [this] { chooseTask(); });
        showTask();
    }

    [[nodiscard]] QString title() const override { return tr("Standards"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"task", tasks_->itemData(shown_)},
                {"groups", groups_},
                {"marked", marked_},
                {"angoff", angoff_}};
    }
    [[nodiscard]] bool mayLeave() override {
        const bool judged = !angoff_.value("cells").toMap().isEmpty();
        if (!judged && !hasUnusedMarks()) return true;
        return confirm(this, tr("Leave without setting the standard?"),
                       judged ? tr("What the judges have estimated is lost.")
                              : tr("Who was marked as a novice or an expert is forgotten."),
                       tr("Leave"), tr("Stay here"));
    }

 private:
    [[nodiscard]] bool hasUnusedMarks() const {
        const auto marks = groups_.values();
        return marked_ && std::any_of(marks.begin(), marks.end(),
                                      [](const QVariant& group) { return group.toInt() != 0; });
    }

    /// One arrow key on the list is enough for another task: it asks as a page does.
    void chooseTask() {
        if (!mayLeave()) {
            const QSignalBlocker quiet(tasks_);
            return tasks_->setCurrentIndex(shown_);
        }
        shown_ = tasks_->currentIndex();
        groups_.clear();
        marked_ = false;
        angoff_.clear();
        showTaskOrSay();
    }

    /// For what is called when no page is being made: rights may have gone, or a server.
    void showTaskOrSay() {
        context_.guard(tr("Reading the attempts"), [this] { showTask(); });
    }

    void read() {
        operators_.clear();
        for (db::RecentMean& each :
             context_.store().attempts().recent_means(task(), kLastAttempts)) {
            Operator one;
            one.name =
                each.user_name.empty() ? tr("number %1").arg(each.user_id) : qstr(each.user_name);
            if (!each.script.empty()) one.name += " · " + device_name(each.script);
            one.key = QString::number(each.user_id) + "/" + qstr(each.script);
            one.recent = std::move(each);
            operators_.push_back(std::move(one));
        }
    }

    [[nodiscard]] std::string task() const {
        return tasks_->currentData().toString().toStdString();
    }

    void showTask() {
        read();
        while (QLayoutItem* item = body_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        body_->addWidget(make_present_standard_card(context_, task()));
        body_->addWidget(groupsCard());
        result_ = new QVBoxLayout;
        auto* holder = new QWidget;
        holder->setLayout(result_);
        result_->setContentsMargins(0, 0, 0, 0);
        body_->addWidget(holder);
        showResult();
        // A task that no longer ships has a history, but no rubric to estimate.
        (void)context_.problemOf([this] {
            std::function<void(const assessment::Angoff&, const QString&)> save;
            if (context_.may(db::Action::kSetStandards, db::Scope::kOther))
                save = [this](const assessment::Angoff& judges, const QString& reason) {
                    // What is set cannot be lost any more: the next table begins empty.
                    if (keep(db::standard_of_judges(task(), judges), reason)) angoff_.clear();
                };
            const auto told = [this](const QVariantMap& typed) { angoff_ = typed; };
            body_->addWidget(make_angoff_card(context_, task(), angoff_, told, save));
        });
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
        centre_ = new QLineEdit(context_.storeSetting("centre").toString());
        centre_->setObjectName("centre_name");
        keep_choice(centre_);
        norms->addLayout(make_field(tr("Name of this centre"), centre_), 1);
        QPushButton* make =
            make_button(context_, tr("Make a norm pack of these groups"), "secondary", "norms");
        make->setObjectName("make_norms");
        connect(make, &QPushButton::clicked, this, [this] { makeNorms(); });
        norms->addWidget(make, 0, Qt::AlignBottom);
        layout->addLayout(norms);
    }

    void save() {
        std::vector<int64_t> people;
        for (const Operator& one : operators_)
            if (groups_.value(one.key).toInt() != 0) people.push_back(one.recent.user_id);
        const bool proved = context_.guard(tr("Setting the standard"), [&] {
            db::need_fit_to_judge(context_.store(), task(), people, kLastAttempts);
        });
        if (!proved) return;
        if (keep(db::standard_of_groups(task(), values(1), values(2), kLastAttempts),
                 reason_->text()))
            marked_ = false;
    }

    /// False when it was refused.
    bool keep(const curriculum::PassStandard& standard, const QString& reason) {
        return context_.guard(tr("Setting the standard"), [&] {
            context_.require(db::Action::kSetStandards, db::Scope::kOther);
            const int version =
                db::set_standard(context_.store(), standard, reason.trimmed().toStdString());
            QMetaObject::invokeMethod(
                this, [this] { showTaskOrSay(); }, Qt::QueuedConnection);
            Q_EMIT notice(tr("The standard is set (version %1). Attempts from now on are judged by "
                             "it; earlier ones keep their verdict.")
                              .arg(version));
        });
    }

    void makeNorms() {
        context_.guard(tr("Making the norm pack"), [this] {
            context_.require(db::Action::kSetStandards, db::Scope::kOther);
            const std::map<std::string, std::vector<int64_t>> people{{"novice", persons(1)},
                                                                     {"expert", persons(2)}};
            db::Store& store = context_.store();
            const std::string centre = centre_->text().trimmed().toStdString();
            context_.setStoreSetting("centre", centre_->text().trimmed());
            const curriculum::NormPack pack =
                db::make_norms(db::level_attempts(store, task(), people), centre,
                               QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(),
                               curriculum::kLeastNormGroup);
            const bool kept =
                ask_centre_passphrase(context_, this, [&](std::string_view passphrase) {
                    db::keep_own_norms(context_.store(), pack, passphrase);
                });
            if (!kept) return;
            marked_ = false;
            Q_EMIT notice(tr("The norm pack is made and signed. It stands on the page Norms."));
        });
    }

    /// A hundred people are put into a group as quickly as one: marked in the list, one touch.
    QWidget* groupsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Groups"), "heading"));
        if (operators_.empty()) {
            QLabel* why = make_label(
                tr("No attempt at this task counts yet. Once some do, whoever made them stands "
                   "here; the list above has other tasks."),
                "muted");
            why->setObjectName("standard_nobody");
            layout->addWidget(why);
            return make_card(layout);
        }
        people_ = make_table(
            {tr("Person"), tr("Attempts"), tr("Mean of the last"), tr("Group"), tr("Remark")},
            tr("Groups"));
        people_->setObjectName("standard_people");
        people_->setSelectionMode(QAbstractItemView::ExtendedSelection);
        people_->setSortingEnabled(false);
        people_->setRowCount(static_cast<int>(operators_.size()));
        for (int row = 0; row < people_->rowCount(); ++row) {
            const Operator& one = operators_[static_cast<size_t>(row)];
            const int n = one.recent.attempts;
            people_->setItem(row, 0, make_cell(one.name));
            people_->item(row, 0)->setData(Qt::UserRole, one.key);
            people_->setItem(row, 1, make_number_cell(QString::number(n), n));
            people_->setItem(
                row, 2,
                make_number_cell(format_number(one.recent.mean_points, 1), one.recent.mean_points));
            people_->setItem(row, 3, make_cell(groupWord(one.key)));
            people_->setItem(row, 4,
                             make_cell(one.recent.demonstration ? tr("DEMONSTRATION") : QString()));
        }
        fit_columns(people_, 0);
        people_->setColumnWidth(3, 130);
        people_->setFixedHeight(std::clamp(people_->rowCount(), 1, 6) * kTouchTarget + 50);
        people_->setSortingEnabled(true);
        people_->sortByColumn(0, Qt::AscendingOrder);
        layout->addWidget(people_);
        layout->addLayout(groupButtons());
        return make_card(layout);
    }

    QHBoxLayout* groupButtons() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        QLabel* said = make_label(tr("Mark people (Ctrl or Shift for several), then:"), "small");
        row->addWidget(said, 1);
        const std::pair<QString, const char*> buttons[]{{tr("Novices"), "mark_novices"},
                                                        {tr("Experts"), "mark_experts"},
                                                        {tr("Neither"), "mark_neither"}};
        for (int i = 0; i < 3; ++i) {
            QPushButton* button = make_button(context_, buttons[i].first, "secondary");
            button->setObjectName(buttons[i].second);
            const int group = (i + 1) % 3;
            connect(button, &QPushButton::clicked, this, [this, group] { put(group); });
            row->addWidget(button);
        }
        return row;
    }

    [[nodiscard]] QString groupWord(const QString& key) const {
        const int group = groups_.value(key).toInt();
        return group == 1 ? tr("novice") : group == 2 ? tr("expert") : QStringLiteral("–");
    }

    void put(int group) {
        marked_ = true;
        const bool sorted = people_->isSortingEnabled();
        people_->setSortingEnabled(false);
        for (const QModelIndex& index : people_->selectionModel()->selectedRows()) {
            const QString key = people_->item(index.row(), 0)->data(Qt::UserRole).toString();
            groups_[key] = group;
            people_->item(index.row(), 3)->setText(groupWord(key));
        }
        people_->setSortingEnabled(sorted);
        showResult();
    }

    [[nodiscard]] std::vector<double> values(int group) const {
        std::vector<double> found;
        for (const Operator& one : operators_)
            if (groups_.value(one.key).toInt() == group) found.push_back(one.recent.mean_points);
        return found;
    }

    /// Those of a group who are people.
    [[nodiscard]] std::vector<int64_t> persons(int group) const {
        std::vector<int64_t> found;
        for (const Operator& one : operators_)
            if (groups_.value(one.key).toInt() == group && !one.scripted())
                found.push_back(one.recent.user_id);
        return found;
    }

    void showResult() {
        while (QLayoutItem* item = result_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        const std::vector<double> novices = values(1), experts = values(2);
        std::function<void(QVBoxLayout*)> saving;
        if (context_.may(db::Action::kSetStandards, db::Scope::kOther))
            saving = [this](QVBoxLayout* layout) { addSaving(layout); };
        result_->addWidget(make_contrasting_card(context_, novices, experts, saving));
        if (novices.size() < 2 || experts.size() < 2) return;
        result_->addWidget(make_quality_card(context_, task(), persons(1), persons(2)));
    }

    std::vector<std::string> known_;  ///< Tasks with attempts.
    std::vector<Operator> operators_;
    QVariantMap groups_;   ///< Key of the operator to 0 neither, 1 novice, 2 expert.
    bool marked_ = false;  ///< Since a standard or a norm pack was made of the groups.
    QVariantMap angoff_;   ///< What judges have typed and nobody has set, as the card tells it.
    int shown_ = 0;        ///< Row of the task whose standard is shown.
    QComboBox* tasks_ = nullptr;
    QTableWidget* people_ = nullptr;
    QVBoxLayout *body_ = nullptr, *result_ = nullptr;
    QLineEdit *reason_ = nullptr, *centre_ = nullptr;
};

}  // namespace

Page* make_standards_page(AppContext& context, const Place& place) {
    return new StandardsPage(context, place);
}

}  // namespace placode::ui
