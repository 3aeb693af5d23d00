// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts: what an educator sees of all trainees. Filter by person and task, sort, open.

#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/shell/attempts_table.h"
#include "ui/shell/pages.h"
#include "ui/shell/training.h"
#include "ui/shell/training_reports.h"

namespace placode::ui {
namespace {

constexpr int kRows = 100;          ///< Of one page of the list.
constexpr int kWidestFilter = 420;  ///< [px]

class AttemptsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AttemptsPage)
 public:
    AttemptsPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        offset_ = place.state.value("offset").toLongLong();
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace32, kSpace24, kSpace32, kSpace24);
        layout->setSpacing(kSpace16);
        layout->addWidget(make_label(tr("Attempts of all trainees"), "display"));
        addFilters(layout, place);
        count_ = make_label({}, "muted");
        count_->setObjectName("attempts_count");
        layout->addWidget(count_);
        list_ = new QVBoxLayout;
        layout->addLayout(list_, 1);
        auto* foot = new QHBoxLayout;
        foot->setSpacing(kSpace8);
        foot->addWidget(make_label(tr("Enter or double click opens the result."), "small"), 1);
        newer_ = make_button(context, tr("Newer"), "quiet", "back");
        newer_->setObjectName("attempts_newer");
        older_ = make_button(context, tr("Older"), "quiet", "next");
        older_->setObjectName("attempts_older");
        for (auto [button, step] : {std::pair{newer_, -kRows}, {older_, kRows}}) {
            foot->addWidget(button);
            connect(button, &QPushButton::clicked, this,
                    [this, step = step] { showFrom(std::max<int64_t>(0, offset_ + step)); });
        }
        layout->addLayout(foot);
        show();
    }

    [[nodiscard]] QString title() const override { return tr("Attempts"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"person", person_->currentData()},
                {"task", task_->currentData()},
                {"offset", QVariant::fromValue<qint64>(offset_)}};
    }

 private:
    void addFilters(QVBoxLayout* layout, const Place& place) {
        person_ = new QComboBox;
        person_->setObjectName("filter_person");
        person_->setMinimumWidth(240);
        person_->addItem(tr("Everybody"), 0);
        auto people = context_.store().accounts().list();
        std::sort(people.begin(), people.end(), [](const auto& a, const auto& b) {
            return QString::localeAwareCompare(qstr(a.display_name), qstr(b.display_name)) < 0;
        });
        for (const db::UserRecord& each : people)
            person_->addItem(qstr(each.display_name), QVariant::fromValue<qint64>(each.id));
        task_ = new QComboBox;
        task_->setObjectName("filter_task");
        task_->setMinimumWidth(240);
        task_->addItem(tr("All tasks"), QString());
        for (const std::string& id : curriculum::list_definitions("tasks"))
            task_->addItem(task_title(context_, id), qstr(id));
        person_->setCurrentIndex(std::max(0, person_->findData(place.state.value("person", 0))));
        task_->setCurrentIndex(std::max(0, task_->findData(place.state.value("task"))));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        for (QComboBox* box : {person_, task_}) {
            keep_narrow(box);
            box->setMaximumWidth(kWidestFilter);
        }
        row->addLayout(make_field(tr("Person"), person_), 1);
        row->addLayout(make_field(tr("Task"), task_), 1);
        row->addStretch();
        report_ = make_trainee_report_button(context_, *this, tr("Report of this person"), [this] {
            return person_->currentData().toLongLong();
        });
        row->addWidget(report_, 0, Qt::AlignBottom);
        layout->addLayout(row);
        for (QComboBox* box : {person_, task_})
            connect(box, &QComboBox::currentIndexChanged, this, [this] { showFrom(0); });
    }

    /// From a slot, which no exception may leave. What cannot be read is asked for again by the
    /// same touch.
    void showFrom(int64_t offset) {
        const int64_t before = std::exchange(offset_, offset);
        if (!context_.guard(tr("Reading the attempts"), [this] { show(); })) offset_ = before;
    }

    /// One page of the list, counted and cut by the store.
    void show() {
        clear();  // The attempts of one person must not stand under the name of another.
        db::AttemptFilter filter;
        filter.user_id = person_->currentData().toLongLong();
        filter.task_id = task_->currentData().toString().toStdString();
        filter.limit = kRows;
        filter.studies = context_.may(db::Action::kRunQuestionnaire);
        filter.offset = offset_;
        const db::AttemptPage page = context_.store().attempts().page(filter);
        table_ = make_attempts_table(context_, page.rows, AttemptColumns::kEverybody);
        table_->setObjectName("attempts_table");
        connect(table_, &QTableWidget::cellActivated, this, [this](int row, int) {
            Q_EMIT go({PageId::kResult, attempt_of_row(table_, row), {}, {}});
        });
        list_->addWidget(table_);
        const auto rows = static_cast<int64_t>(page.rows.size());
        const bool none = page.total == 0 && filter.user_id == 0 && filter.task_id.empty();
        count_->setText(
            none ? tr("Nobody has made an attempt yet. Once a trainee has, it shows up "
                      "here.")
            : page.total == 0
                ? tr("There is no such attempt.")
                : tr("Shown: %1 to %2 of %3").arg(offset_ + 1).arg(offset_ + rows).arg(page.total));
        report_->setEnabled(filter.user_id != 0);
        report_->setToolTip(filter.user_id != 0 ? QString() : tr("Choose a person first."));
        newer_->setEnabled(offset_ > 0);
        older_->setEnabled(offset_ + rows < page.total);
        for (QPushButton* button : {newer_, older_}) button->setVisible(page.total > kRows);
    }

    void clear() {
        while (QLayoutItem* item = list_->takeAt(0)) {
            item->widget()->hide();
            item->widget()->deleteLater();
            delete item;
        }
        count_->clear();
    }

    int64_t offset_ = 0;
    QComboBox *person_ = nullptr, *task_ = nullptr;
    QLabel* count_ = nullptr;
    QVBoxLayout* list_ = nullptr;
    QPushButton *newer_ = nullptr, *older_ = nullptr, *report_ = nullptr;
    QTableWidget* table_ = nullptr;
};

}  // namespace

Page* make_attempts_page(AppContext& context, const Place& place) {
    return new AttemptsPage(context, place);
}

}  // namespace placode::ui
