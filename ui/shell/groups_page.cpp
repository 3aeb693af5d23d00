// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Groups (cohorts): who is in them and who teaches them.

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStandardItemModel>
#include <algorithm>
#include <map>

#include "db/access.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/trainee_chooser.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

using db::GroupRole;

class GroupsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(GroupsPage)
 public:
    GroupsPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kManageGroups, db::Scope::kGroup);
        QVBoxLayout* column = make_column(this, 1000);
        column->addWidget(make_label(tr("Groups"), "display"));
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace16);
        name_ = new QLineEdit;
        name_->setObjectName("new_group");
        head->addLayout(make_field(tr("New group"), name_), 1);
        QPushButton* add = make_button(context, tr("Add the group"), "secondary", "plus");
        add->setObjectName("add_group");
        connect(add, &QPushButton::clicked, this, [this] { this->add(); });
        connect(name_, &QLineEdit::returnPressed, this, [this] { this->add(); });
        head->addWidget(add, 0, Qt::AlignBottom);
        chooser_ = new QComboBox;
        chooser_->setObjectName("group");
        chooser_->setMinimumWidth(200);
        keep_narrow(chooser_);
        head->addLayout(make_field(tr("Group"), chooser_), 2);
        column->addLayout(head);
        body_ = new QVBoxLayout;
        column->addLayout(body_);
        column->addStretch(1);
        for (const db::UserRecord& user : context.store().accounts().list())
            people_[user.id] = user;
        read();
        chooser_->setCurrentIndex(std::max(0, chooser_->findData(place.state.value("group"))));
        connect(chooser_, &QComboBox::currentIndexChanged, this, [this] { showGroup(); });
        showGroup();
    }

    [[nodiscard]] QString title() const override { return tr("Groups"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"group", chooser_->currentData()}};
    }

 private:
    void read() {
        const QSignalBlocker quiet(chooser_);
        const QVariant kept = chooser_->currentData();
        groups_ = context_.store().groups().list();
        chooser_->clear();
        for (const db::GroupRecord& group : groups_)
            chooser_->addItem(qstr(group.name), QVariant::fromValue<qint64>(group.id));
        chooser_->setCurrentIndex(std::max(0, chooser_->findData(kept)));
    }

    [[nodiscard]] const db::GroupRecord* current() const {
        for (const db::GroupRecord& group : groups_)
            if (group.id == chooser_->currentData().toLongLong()) return &group;
        return nullptr;
    }
    [[nodiscard]] bool mayChange(const db::GroupRecord& group) const {
        return context_.may(db::Action::kManageGroups,
                            db::scope_of_group(group, context_.user().id));
    }

    void add() {
        context_.guard(tr("Adding the group"), [this] {
            context_.require(db::Action::kManageGroups, db::Scope::kGroup);
            const int64_t id =
                context_.store().groups().create(name_->text().trimmed().toStdString());
            // Who makes a group teaches it; an administrator's own group waits for its educator.
            if (db::has_role(context_.user().roles, db::Role::kEducator))
                context_.store().groups().set_role(id, context_.user().id, GroupRole::kEducator);
            name_->clear();
            read();
            chooser_->setCurrentIndex(chooser_->findData(QVariant::fromValue<qint64>(id)));
            showGroup();
        });
    }

    void showGroup() {
        while (QLayoutItem* item = body_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        const db::GroupRecord* group = current();
        if (group == nullptr) {
            body_->addWidget(make_label(
                tr("There are no groups yet. Give one a name above; courses can then be assigned "
                   "to all of it at once, and its educators see who is stuck."),
                "muted"));
            return;
        }
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(qstr(group->name), "heading"));
        if (mayChange(*group)) {
            layout->addLayout(addRow());
        } else {
            layout->addWidget(make_label(
                tr("Only an educator of this group or an administrator may change it."), "muted"));
        }
        QTableWidget* people = table(*group);
        layout->addWidget(people);
        if (mayChange(*group)) layout->addWidget(outButton(people), 0, Qt::AlignLeft);
        body_->addWidget(make_card(layout));
    }

    QHBoxLayout* addRow() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        person_ = new QComboBox;
        person_->setObjectName("group_person");
        person_->setMinimumWidth(180);
        person_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        // Filled before the list knows it: a thousand single additions take a quarter of a second.
        auto* model = new QStandardItemModel(person_);
        for (const auto& [id, user] : people_) {
            if (!user.active) continue;
            auto* item = new QStandardItem(
                QString("%1 (%2)").arg(qstr(user.display_name), qstr(user.login)));
            item->setData(QVariant::fromValue<qint64>(id), Qt::UserRole);
            model->appendRow(item);
        }
        person_->setModel(model);
        person_->setEditable(true);
        person_->setInsertPolicy(QComboBox::NoInsert);
        person_->completer()->setCompletionMode(QCompleter::PopupCompletion);
        person_->completer()->setFilterMode(Qt::MatchContains);
        person_->setCurrentIndex(-1);  // Nobody comes into a group by being first in a list.
        person_->lineEdit()->setPlaceholderText(tr("Type a name, or choose from the list"));
        row->addLayout(make_field(tr("Person"), person_), 1);
        role_ = new QComboBox;
        role_->setObjectName("group_role");
        role_->addItem(tr("member"), static_cast<int>(GroupRole::kMember));
        role_->addItem(tr("educator"), static_cast<int>(GroupRole::kEducator));
        row->addLayout(make_field(tr("As"), role_));
        keep_choice(person_);
        keep_choice(role_);
        QPushButton* put = make_button(context_, tr("Put into the group"), "primary", "plus");
        put->setObjectName("group_add");
        connect(put, &QPushButton::clicked, this, [this] { this->put(); });
        row->addWidget(put, 0, Qt::AlignBottom);
        return row;
    }

    void put() {
        const int row = chosen_row(person_);
        if (row < 0) {
            context_.guard(tr("Changing the group"), [this] {
                throw Refusal(why_no_row(
                    person_, tr("There is nobody called \"%1\"; choose one of the list.")));
            });
            return;
        }
        set(person_->itemData(row).toLongLong(),
            static_cast<GroupRole>(role_->currentData().toInt()));
    }

    /// For the person that is marked in the table.
    QPushButton* outButton(QTableWidget* people) {
        QPushButton* out = make_button(context_, tr("Take out of the group"), "secondary");
        out->setObjectName("group_out");
        out->setEnabled(false);
        connect(people, &QTableWidget::itemSelectionChanged, out, [people, out] {
            out->setEnabled(!people->selectionModel()->selectedRows().isEmpty());
        });
        connect(
            out, &QPushButton::clicked, this,
            [this, people] {
                const auto rows = people->selectionModel()->selectedRows();
                if (rows.isEmpty()) return;
                const auto* name = people->item(rows.front().row(), 0);
                set(name->data(Qt::UserRole).toLongLong(), GroupRole::kNone);
            },
            Qt::QueuedConnection);
        return out;
    }

    QTableWidget* table(const db::GroupRecord& group) {
        QTableWidget* table =
            make_table({tr("Person"), tr("Log-in name"), tr("In the group")}, tr("Group"));
        table->setObjectName("group_table");
        table->setSortingEnabled(false);
        const auto add = [&](int64_t id, const QString& role) {
            const auto found = people_.find(id);
            if (found == people_.end()) return;
            const int row = table->rowCount();
            table->setRowCount(row + 1);
            table->setItem(row, 0, make_cell(qstr(found->second.display_name)));
            table->setItem(row, 1, make_cell(qstr(found->second.login)));
            table->setItem(row, 2, make_cell(role));
            table->item(row, 0)->setData(Qt::UserRole, QVariant::fromValue<qint64>(id));
        };
        for (const int64_t id : group.educators) add(id, tr("educator"));
        for (const int64_t id : group.members) add(id, tr("member"));
        fit_columns(table, 0);
        table->setColumnWidth(1, std::max(200, table->columnWidth(1)));
        table->setColumnWidth(2, 140);
        table->setFixedHeight(std::clamp(table->rowCount(), 1, 9) * kTouchTarget + 50);
        return table;
    }

    void set(int64_t person, GroupRole role) {
        context_.guard(tr("Changing the group"), [&] {
            const db::GroupRecord* group = current();
            context_.require(db::Action::kManageGroups,
                             db::scope_of_group(*group, context_.user().id));
            // Nobody draws people of other groups into the own one.
            context_.require(db::Action::kManageGroups,
                             db::scope_between(context_.store(), context_.user().id, person));
            if (role == GroupRole::kEducator &&
                !db::has_role(people_.at(person).roles, db::Role::kEducator))
                throw Refusal(tr("%1 has not the role educator; an administrator can give it.")
                                  .arg(qstr(people_.at(person).display_name)));
            context_.store().groups().set_role(group->id, person, role);
            read();
            showGroup();
            if (role != GroupRole::kNone)
                Q_EMIT notice(
                    tr("%1 is in the group now.").arg(qstr(people_.at(person).display_name)));
        });
    }

    std::vector<db::GroupRecord> groups_;
    std::map<int64_t, db::UserRecord> people_;
    QLineEdit* name_ = nullptr;
    QComboBox *chooser_ = nullptr, *person_ = nullptr, *role_ = nullptr;
    QVBoxLayout* body_ = nullptr;
};

}  // namespace

Page* make_groups_page(AppContext& context, const Place& place) {
    return new GroupsPage(context, place);
}

}  // namespace placode::ui
