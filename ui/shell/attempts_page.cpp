// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts: what an educator sees of all trainees. Filter by person and task, sort, open.

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <map>

#include "ui/shell/attempts_table.h"
#include "ui/shell/pages.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

class AttemptsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AttemptsPage)
 public:
    AttemptsPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        all_ = context.store().attempts(0);
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace32, kSpace24, kSpace32, kSpace24);
        layout->setSpacing(kSpace16);
        layout->addWidget(make_label(tr("Attempts of all trainees"), "display"));
        addFilters(layout, place);
        count_ = make_label({}, "muted");
        layout->addWidget(count_);
        table_ = make_attempts_table(context, all_, AttemptColumns::kEverybody);
        table_->setObjectName("attempts_table");
        connect(table_, &QTableWidget::cellActivated, this, [this](int row, int) {
            Q_EMIT go({PageId::kResult, attempt_of_row(table_, row), {}, {}});
        });
        layout->addWidget(table_, 1);
        layout->addWidget(make_label(tr("Enter or double click opens the result."), "small"));
        filter();
    }

    [[nodiscard]] QString title() const override { return tr("Attempts"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"person", person_->currentData()}, {"task", task_->currentData()}};
    }

 private:
    void addFilters(QVBoxLayout* layout, const Place& place) {
        person_ = new QComboBox;
        person_->setObjectName("filter_person");
        person_->setMinimumWidth(240);
        person_->addItem(tr("Everybody"), 0);
        task_ = new QComboBox;
        task_->setObjectName("filter_task");
        task_->setMinimumWidth(240);
        task_->addItem(tr("All tasks"), QString());
        std::map<QString, int64_t> people;
        for (const db::AttemptRecord& attempt : all_) {
            people[qstr(attempt.user_name)] = attempt.user_id;
            const QString id = qstr(attempt.task_id);
            if (task_->findData(id) < 0) task_->addItem(task_title(context_, attempt.task_id), id);
        }
        for (const auto& [name, id] : people)
            person_->addItem(name, QVariant::fromValue<qint64>(id));
        person_->setCurrentIndex(std::max(0, person_->findData(place.state.value("person", 0))));
        task_->setCurrentIndex(std::max(0, task_->findData(place.state.value("task"))));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        row->addLayout(make_field(tr("Person"), person_));
        row->addLayout(make_field(tr("Task"), task_));
        row->addStretch();
        layout->addLayout(row);
        for (QComboBox* box : {person_, task_})
            connect(box, &QComboBox::currentIndexChanged, this, [this] { filter(); });
    }

    void filter() {
        std::map<int64_t, const db::AttemptRecord*> by_id;
        for (const db::AttemptRecord& attempt : all_) by_id[attempt.id] = &attempt;
        const int64_t person = person_->currentData().toLongLong();
        const std::string task = task_->currentData().toString().toStdString();
        int shown = 0;
        for (int row = 0; row < table_->rowCount(); ++row) {
            const db::AttemptRecord& attempt = *by_id.at(attempt_of_row(table_, row));
            const bool fits = (person == 0 || attempt.user_id == person) &&
                              (task.empty() || attempt.task_id == task);
            table_->setRowHidden(row, !fits);
            shown += fits ? 1 : 0;
        }
        count_->setText(all_.empty()
                            ? tr("Nobody has made an attempt yet. Once a trainee has, it shows up "
                                 "here.")
                            : tr("Shown: %1 of %2").arg(shown).arg(all_.size()));
    }

    std::vector<db::AttemptRecord> all_;
    QComboBox *person_ = nullptr, *task_ = nullptr;
    QLabel* count_ = nullptr;
    QTableWidget* table_ = nullptr;
};

}  // namespace

Page* make_attempts_page(AppContext& context, const Place& place) {
    return new AttemptsPage(context, place);
}

}  // namespace placode::ui
