// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/assign_card.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QLineEdit>

#include "db/access.h"
#include "db/course_conduct.h"
#include "ui/shell/day_text.h"
#include "ui/shell/parts.h"
#include "ui/shell/trainee_chooser.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

class AssignCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(AssignCard)
 public:
    AssignCard(AppContext& context, std::string course_id,
               std::function<void(const QString&)> changed)
        : context_(context), course_id_(std::move(course_id)), changed_(std::move(changed)) {
        setProperty("role", "card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Assignments"), "heading"));
        layout->addLayout(fields());
        table_ = make_table({tr("To"), tr("Version"), tr("From"), tr("Due"), tr("State"), {}},
                            tr("Assignments"));
        table_->setObjectName("assignments_table");
        table_->setSortingEnabled(false);
        layout->addWidget(table_);
        empty_ = make_label(tr("Nobody has this course yet. Choose a person or a group above."),
                            "muted");
        layout->addWidget(empty_);
        fill();
    }

 private:
    QVBoxLayout* fields() {
        auto* both = new QVBoxLayout;
        both->setSpacing(kSpace12);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        target_ = make_search_list("assign_target");
        addTargets();
        target_->setCurrentIndex(-1);  // Nobody is given a course by being first in a list.
        target_->lineEdit()->setPlaceholderText(tr("Type a name, or choose from the list"));
        both->addLayout(make_field(tr("Person or group"), target_));
        const QDate today = QDate::currentDate();
        from_ = date(today, "assign_from");
        row->addLayout(make_field(tr("From"), from_));
        due_ = date(today.addDays(28), "assign_due");
        row->addLayout(make_field(tr("Due"), due_));
        has_due_ = new QCheckBox(tr("has an end"));
        has_due_->setObjectName("assign_has_due");
        has_due_->setChecked(true);
        connect(has_due_, &QCheckBox::toggled, due_, &QWidget::setEnabled);
        for (QWidget* field : {static_cast<QWidget*>(target_), static_cast<QWidget*>(from_),
                               static_cast<QWidget*>(due_), static_cast<QWidget*>(has_due_)})
            keep_choice(field);
        row->addWidget(has_due_, 0, Qt::AlignBottom);
        row->addStretch();
        QPushButton* assign = make_button(context_, tr("Assign"), "primary", "plus");
        assign->setObjectName("assign_course");
        connect(assign, &QPushButton::clicked, this, [this] { this->assign(); });
        row->addWidget(assign, 0, Qt::AlignBottom);
        both->addLayout(row);
        return both;
    }

    static QDateEdit* date(const QDate& day, const char* object) {
        auto* edit = new QDateEdit(day);
        edit->setCalendarPopup(true);
        edit->setDisplayFormat(kDayFormat);
        edit->setObjectName(object);
        edit->setMinimumHeight(kTouchTarget);
        edit->setMinimumWidth(150);
        return edit;
    }

    /// Only whom this educator may assign to; the store is asked again when it is done.
    void addTargets() {
        db::Store& store = context_.store();
        const int64_t self = context_.user().id;
        for (const db::GroupRecord& group : store.groups().list())
            if (context_.may(db::Action::kAssignCourses, db::scope_of_group(group, self)))
                target_->addItem(tr("Group %1").arg(qstr(group.name)),
                                 QVariant::fromValue<qint64>(-group.id));
        add_trainees(context_, target_);
    }

    void assign() {
        context_.guard(tr("Assigning the course"), [this] {
            const int row = chosen_row(target_);
            if (row < 0)
                throw Refusal(why_no_row(
                    target_, tr("There is nobody called \"%1\" whom you may assign a course; "
                                "choose one of the list.")));
            const int64_t target = target_->itemData(row).toLongLong();
            db::Store& store = context_.store();
            db::AssignmentRecord wanted;
            wanted.course_id = course_id_;
            (target < 0 ? wanted.group_id : wanted.user_id) = std::abs(target);
            require(wanted);
            wanted.starts_utc = from_->date().toString(Qt::ISODate).toStdString();
            if (has_due_->isChecked())
                wanted.due_utc = due_->date().toString(Qt::ISODate).toStdString();
            const curriculum::Course course = db::find_course(store, course_id_);
            wanted.course_version = course.version;
            db::publish_course_on_first_use(store, course);
            store.courses().assign(wanted);
            fill();
            changed_(tr("Assigned to %1.").arg(target_->itemText(row)));
        });
    }

    void require(const db::AssignmentRecord& assignment) {
        db::Store& store = context_.store();
        const int64_t self = context_.user().id;
        db::Scope scope = db::Scope::kOther;
        if (assignment.user_id != 0) {
            scope = db::scope_between(store, self, assignment.user_id);
        } else {
            for (const db::GroupRecord& group : store.groups().list())
                if (group.id == assignment.group_id) scope = db::scope_of_group(group, self);
        }
        context_.require(db::Action::kAssignCourses, scope);
    }

    [[nodiscard]] QString nameOf(const db::AssignmentRecord& each) const {
        if (each.user_id != 0) {
            const auto user = context_.store().accounts().find(each.user_id);
            return user ? qstr(user->display_name) : QString::number(each.user_id);
        }
        for (const db::GroupRecord& group : context_.store().groups().list())
            if (group.id == each.group_id) return tr("Group %1").arg(qstr(group.name));
        return QString::number(each.group_id);
    }

    void fill() {
        std::vector<db::AssignmentRecord> shown;
        for (const db::AssignmentRecord& each : context_.store().courses().assignments(0))
            if (each.course_id == course_id_) shown.push_back(each);
        table_->setRowCount(static_cast<int>(shown.size()));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const db::AssignmentRecord& each = shown[static_cast<size_t>(row)];
            table_->setItem(row, 0, make_cell(nameOf(each)));
            table_->setItem(
                row, 1,
                make_number_cell(QString::number(each.course_version), each.course_version));
            table_->setItem(row, 2, make_cell(day_text(each.starts_utc)));
            table_->setItem(row, 3, make_cell(day_text(each.due_utc)));
            table_->setItem(
                row, 4,
                make_cell(each.ended_utc.empty() ? tr("active")
                                                 : tr("ended %1").arg(day_text(each.ended_utc))));
            table_->setItem(row, 5, make_cell({}));
            if (!each.ended_utc.empty()) continue;
            QPushButton* end = make_button(context_, tr("End"), "quiet");
            end->setObjectName(QString("end_assignment_%1").arg(row));
            const QString name = nameOf(each);
            end->setAccessibleName(tr("End the assignment to %1").arg(name));
            connect(
                end, &QPushButton::clicked, this, [this, each, name] { this->end(each, name); },
                Qt::QueuedConnection);
            table_->setCellWidget(row, 5, end);
        }
        fit_columns(table_, 0);
        table_->setColumnWidth(5, 110);
        for (const int c : {2, 3, 4})
            table_->setColumnWidth(c, std::max(110, table_->columnWidth(c)));
        table_->setFixedHeight(std::min(6, std::max(1, table_->rowCount())) * kTouchTarget + 50);
        table_->setVisible(!shown.empty());
        empty_->setVisible(shown.empty());
    }

    void end(const db::AssignmentRecord& each, const QString& name) {
        if (!confirm(this, tr("End the assignment?"),
                     tr("%1 is no longer asked to do the course. Attempts and certificates stay.")
                         .arg(name),
                     tr("End")))
            return;
        context_.guard(tr("Ending the assignment"), [&] {
            require(each);
            context_.store().courses().end_assignment(each.id);
            fill();
            changed_(tr("The assignment has ended."));
        });
    }

    AppContext& context_;
    std::string course_id_;
    std::function<void(const QString&)> changed_;
    QComboBox* target_ = nullptr;
    QDateEdit *from_ = nullptr, *due_ = nullptr;
    QCheckBox* has_due_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel* empty_ = nullptr;
};

}  // namespace

QWidget* make_assign_card(AppContext& context, const std::string& course_id,
                          std::function<void(const QString&)> changed) {
    return new AssignCard(context, course_id, std::move(changed));
}

}  // namespace placode::ui
