// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// People: an administrator creates accounts, closes and opens them, and gives a new password.

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>

#include "ui/shell/account_fields.h"
#include "ui/shell/new_person_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/table_width.h"

namespace placode::ui {
namespace {

constexpr int kUserIdRole = Qt::UserRole + 1;
constexpr int kBothBeside = 1060, kLeastTable = 300;  ///< [px]

class PeoplePage : public Page {
    Q_DECLARE_TR_FUNCTIONS(PeoplePage)
 public:
    explicit PeoplePage(AppContext& context) : Page(context) {
        context.require(db::Action::kManageUsers, db::Scope::kOther);
        QVBoxLayout* layout = make_column(this, 1600);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("People"), "display"), 1);
        int waiting = 0;
        for (const db::ErasureRecord& each : context.store().accounts().erasure_requests())
            waiting += each.done_utc.empty() ? 1 : 0;
        QPushButton* more =
            make_button(context,
                        waiting == 0 ? tr("Invitations, lists, requests")
                                     : tr("Invitations, lists, requests (%1 waiting)").arg(waiting),
                        "secondary", "people");
        more->setObjectName("open_admissions");
        connect(more, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kAdmissions, 0, {}, {}});
        });
        head->addWidget(more);
        layout->addLayout(head);
        row_ = new QHBoxLayout;
        row_->setSpacing(kSpace16);
        auto* left = new QVBoxLayout;
        left->setSpacing(kSpace16);
        table_ = make_table({tr("Name"), tr("Log-in name"), tr("Roles"), tr("State"), tr("Since")},
                            tr("People"));
        table_->setObjectName("people_table");
        table_->setMinimumHeight(kLeastTable);
        connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { showSelected(); });
        left->addWidget(table_, 1);
        left->addWidget(selectedCard());
        row_->addLayout(left, 1);
        new_card_ = new NewPersonCard(context, *this, [this] { fill(); });
        row_->addWidget(new_card_, 0, Qt::AlignTop);
        layout->addLayout(row_, 1);
        fill();
    }

    [[nodiscard]] QString title() const override { return tr("People"); }
    [[nodiscard]] bool keepsTyped() const override { return true; }

 private:
    /// Beside the list where there is room for both, below it elsewhere.
    void resizeEvent(QResizeEvent* event) override {
        Page::resizeEvent(event);
        const bool wide = width() >= kBothBeside;
        row_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        new_card_->layOut(wide);
        row_->setAlignment(new_card_, wide ? Qt::AlignTop : Qt::Alignment());
    }

    QWidget* selectedCard() {
        auto* layout = new QHBoxLayout;
        layout->setSpacing(kSpace12);
        selected_ = make_label(tr("Select a person to change the account."), "muted");
        layout->addWidget(selected_, 1);
        new_password_ = new QLineEdit;
        new_password_->setObjectName("reset_password_field");
        new_password_->setEchoMode(QLineEdit::Password);
        new_password_->setPlaceholderText(password_rule());
        new_password_->setAccessibleName(tr("New password"));
        new_password_->setFixedWidth(200);
        reset_ = make_button(context_, tr("Set password"), "secondary", "key");
        reset_->setObjectName("reset_password");
        active_ = make_button(context_, tr("Deactivate"), "danger");
        active_->setObjectName("toggle_active");
        layout->addWidget(new_password_);
        layout->addWidget(reset_);
        layout->addWidget(active_);
        connect(reset_, &QPushButton::clicked, this, [this] { resetPassword(); });
        enter_submits({new_password_}, this, [this] { resetPassword(); });
        connect(active_, &QPushButton::clicked, this, [this] { toggleActive(); });
        auto* both = new QVBoxLayout;
        both->setSpacing(kSpace12);
        both->addLayout(layout);
        both->addWidget(rolesRow());
        return make_card(both);
    }

    QWidget* rolesRow() {
        roles_row_ = new QWidget;
        auto* layout = new QHBoxLayout(roles_row_);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(kSpace12);
        for (const db::Role role : {db::Role::kTrainee, db::Role::kEducator, db::Role::kCoordinator,
                                    db::Role::kAdministrator}) {
            auto* box = new QCheckBox(role_names(static_cast<db::Roles>(role)));
            box->setObjectName(QString("selected_role_%1").arg(static_cast<int>(role)));
            connect(box, &QCheckBox::toggled, this, [this] { showRolesButton(); });
            selected_roles_.emplace_back(box, role);
            layout->addWidget(box);
        }
        layout->addStretch();
        change_roles_ = make_button(context_, tr("Change the roles"), "secondary");
        change_roles_->setObjectName("change_roles");
        connect(change_roles_, &QPushButton::clicked, this, [this] { changeRoles(); });
        layout->addWidget(change_roles_);
        return roles_row_;
    }

    [[nodiscard]] db::Roles tickedRoles() const {
        db::Roles roles = 0;
        for (const auto& [box, role] : selected_roles_)
            if (box->isChecked()) roles |= static_cast<db::Roles>(role);
        return roles;
    }

    /// Nobody changes the own roles: who takes away the last right cannot give it back.
    void showRolesButton() {
        const db::UserRecord* person = selected();
        change_roles_->setEnabled(person != nullptr && person->id != context_.user().id &&
                                  tickedRoles() != 0 && tickedRoles() != person->roles);
    }

    void changeRoles() {
        const db::UserRecord* person = selected();
        if (person == nullptr) return;
        const db::Roles roles = tickedRoles();
        const QString name = qstr(person->display_name);
        if (!confirm(this, tr("Change the roles of %1?").arg(name),
                     tr("From now on: %1. Whoever is signed in with this account has to sign in "
                        "again.")
                         .arg(role_names(roles)),
                     tr("Change")))
            return;
        context_.guard(tr("Changing the account"), [&] {
            context_.store().accounts().set_roles(person->id, roles);
            fill();
            Q_EMIT notice(tr("%1 is now: %2.").arg(name, role_names(roles)));
        });
    }

    void fill() {
        const int64_t kept = selectedId();
        people_ = context_.store().accounts().list();
        table_->setSortingEnabled(false);
        table_->setRowCount(static_cast<int>(people_.size()));
        int row = 0;
        for (const db::UserRecord& person : people_) {
            QTableWidgetItem* name = make_cell(qstr(person.display_name));
            name->setData(kUserIdRole, QVariant::fromValue<qint64>(person.id));
            table_->setItem(row, 0, name);
            table_->setItem(row, 1, make_cell(qstr(person.login)));
            table_->setItem(row, 2, make_cell(role_names(person.roles)));
            QTableWidgetItem* state = make_cell(!person.active         ? tr("Deactivated")
                                                : person.demonstration ? tr("DEMONSTRATION")
                                                                       : tr("Active"));
            state->setForeground(!person.active         ? context_.colors().muted
                                 : person.demonstration ? context_.colors().warn
                                                        : context_.colors().good);
            table_->setItem(row, 3, state);
            table_->setItem(row, 4, make_cell(format_when(person.created_utc)));
            ++row;
        }
        fit_columns(table_, 2);
        keep_within(table_, {.stretch = 2, .least_px = 130, .drop = {4}});
        table_->setSortingEnabled(true);
        table_->sortByColumn(0, Qt::AscendingOrder);
        for (int r = 0; r < table_->rowCount(); ++r) {
            if (kept != 0 && table_->item(r, 0)->data(kUserIdRole).toLongLong() == kept)
                table_->selectRow(r);
        }
        showSelected();
    }

    [[nodiscard]] int64_t selectedId() const {
        const auto rows = table_->selectionModel()->selectedRows();
        if (rows.isEmpty()) return 0;
        return table_->item(rows.front().row(), 0)->data(kUserIdRole).toLongLong();
    }

    [[nodiscard]] const db::UserRecord* selected() const {
        const int64_t id = selectedId();
        for (const db::UserRecord& person : people_) {
            if (person.id == id) return &person;
        }
        return nullptr;
    }

    void showSelected() {
        const db::UserRecord* person = selected();
        for (QWidget* part :
             std::initializer_list<QWidget*>{new_password_, reset_, active_, roles_row_})
            part->setVisible(person != nullptr);
        if (person == nullptr) {
            selected_->setText(tr("Select a person to change the account."));
            return;
        }
        selected_->setText(qstr(person->display_name));
        active_->setText(person->active ? tr("Deactivate") : tr("Activate"));
        // Nobody locks himself out.
        active_->setEnabled(person->id != context_.user().id);
        for (const auto& [box, role] : selected_roles_) {
            box->setChecked(db::has_role(person->roles, role));
            box->setEnabled(person->id != context_.user().id);
        }
        showRolesButton();
    }

    void resetPassword() {
        const db::UserRecord* person = selected();
        if (person == nullptr) return;
        context_.guard(tr("Setting the password"), [&] {
            if (const QString problem = password_problem(new_password_->text()); !problem.isEmpty())
                throw Refusal(problem);
            context_.store().accounts().set_password(person->id,
                                                     new_password_->text().toStdString(), true);
            new_password_->clear();
            Q_EMIT notice(tr("%1 has a new password.").arg(qstr(person->display_name)));
        });
    }

    void toggleActive() {
        const db::UserRecord* person = selected();
        if (person == nullptr) return;
        const bool active = !person->active;
        if (!active && !confirm(this, tr("Deactivate %1?").arg(qstr(person->display_name)),
                                tr("The person can no longer sign in. Attempts and answers stay."),
                                tr("Deactivate")))
            return;
        context_.guard(tr("Changing the account"), [&] {
            context_.store().accounts().set_active(person->id, active);
            fill();
        });
    }

    std::vector<db::UserRecord> people_;
    std::vector<std::pair<QCheckBox*, db::Role>> selected_roles_;
    QBoxLayout* row_ = nullptr;
    NewPersonCard* new_card_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel* selected_ = nullptr;
    QLineEdit* new_password_ = nullptr;
    QWidget* roles_row_ = nullptr;
    QPushButton *reset_ = nullptr, *active_ = nullptr, *change_roles_ = nullptr;
};

}  // namespace

Page* make_people_page(AppContext& context, const Place&) { return new PeoplePage(context); }

}  // namespace placode::ui
