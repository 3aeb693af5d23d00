// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Admissions: an administrator invites people, takes in a list, and answers those who ask to be
// erased.

#include <QComboBox>
#include <QDateEdit>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <memory>

#include "reports/people_file.h"
#include "ui/shell/day_text.h"
#include "ui/shell/erasure_requests_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

constexpr int kInvitationDays = 14;

class AdmissionsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AdmissionsPage)
 public:
    explicit AdmissionsPage(AppContext& context) : Page(context) {
        context.require(db::Action::kManageUsers, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 1100);
        column->addWidget(make_label(tr("Invitations and requests"), "display"));
        column->addWidget(inviteCard());
        column->addWidget(importCard());
        column->addWidget(new ErasureRequestsCard(context, *this));
        column->addStretch();
        showInvitations();
    }

    [[nodiscard]] QString title() const override { return tr("Invitations and requests"); }
    [[nodiscard]] bool keepsTyped() const override { return true; }

 private:
    QWidget* inviteCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Invite somebody"), "heading"));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        note_ = new QLineEdit;
        note_->setObjectName("invite_note");
        note_->setMinimumWidth(160);
        row->addLayout(make_field(tr("For whom"), note_), 2);
        role_ = new QComboBox;
        role_->setObjectName("invite_role");
        for (const db::Role role : {db::Role::kTrainee, db::Role::kEducator, db::Role::kCoordinator,
                                    db::Role::kAdministrator})
            role_->addItem(role_names(static_cast<db::Roles>(role)), static_cast<int>(role));
        row->addLayout(make_field(tr("As"), role_), 1);
        group_ = new QComboBox;
        group_->setObjectName("invite_group");
        // The longest name of a group must not push the rest off a small screen.
        group_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        group_->setMinimumWidth(140);
        group_->addItem(tr("no group"), 0);
        for (const db::GroupRecord& group : context_.store().groups().list())
            group_->addItem(qstr(group.name), QVariant::fromValue<qint64>(group.id));
        row->addLayout(make_field(tr("Group"), group_), 1);
        until_ = new QDateEdit(QDate::currentDate().addDays(kInvitationDays));
        until_->setObjectName("invite_until");
        until_->setCalendarPopup(true);
        until_->setMinimumWidth(150);
        until_->setDisplayFormat(kDayFormat);
        row->addLayout(make_field(tr("Last day"), until_), 1);
        for (QWidget* field : {static_cast<QWidget*>(role_), static_cast<QWidget*>(group_),
                               static_cast<QWidget*>(until_)})
            keep_choice(field);
        QPushButton* invite = make_button(context_, tr("Make a code"), "primary", "plus");
        invite->setObjectName("invite");
        connect(invite, &QPushButton::clicked, this, [this] { this->invite(); });
        layout->addLayout(row);
        layout->addWidget(invite, 0, Qt::AlignLeft);
        code_ = new QLineEdit;
        code_->setObjectName("invitation_code");
        code_->setReadOnly(true);
        code_->setAccessibleName(tr("Code of the invitation"));
        code_->hide();
        layout->addWidget(code_);
        layout->addWidget(make_label(
            tr("The code is shown once: hand it over now. It works once, until its last day."),
            "small"));
        invitations_ =
            make_table({tr("For whom"), tr("As"), tr("Made by"), tr("Last day"), tr("Used")},
                       tr("Invitations"));
        invitations_->setObjectName("invitations_table");
        layout->addWidget(invitations_);
        return make_card(layout);
    }

    void invite() {
        context_.guard(tr("Inviting somebody"), [this] {
            context_.require(db::Action::kManageUsers, db::Scope::kOther);
            db::InvitationRecord invitation;
            invitation.roles = static_cast<db::Roles>(role_->currentData().toInt());
            invitation.group_id = group_->currentData().toLongLong();
            invitation.note = note_->text().trimmed().toStdString();
            invitation.expires_utc = until_->date().toString(Qt::ISODate).toStdString();
            code_->setText(qstr(context_.store().accounts().invite(invitation)));
            code_->show();
            code_->selectAll();
            code_->setFocus();
            note_->clear();
            showInvitations();
        });
    }

    void showInvitations() {
        const auto all = context_.store().accounts().invitations();
        invitations_->setSortingEnabled(false);
        invitations_->setRowCount(static_cast<int>(all.size()));
        for (int row = 0; row < invitations_->rowCount(); ++row) {
            const db::InvitationRecord& each = all[static_cast<size_t>(row)];
            invitations_->setItem(row, 0, make_cell(qstr(each.note)));
            invitations_->setItem(row, 1, make_cell(role_names(each.roles)));
            invitations_->setItem(row, 2, make_cell(qstr(each.invited_by)));
            invitations_->setItem(row, 3, make_cell(day_text(each.expires_utc)));
            invitations_->setItem(
                row, 4,
                make_cell(each.used_utc.empty() ? tr("not yet") : format_when(each.used_utc)));
        }
        fit_columns(invitations_, 0);
        for (const int c : {1, 2, 3, 4})
            invitations_->setColumnWidth(c, std::max(130, invitations_->columnWidth(c)));
        invitations_->setFixedHeight(
            std::clamp<int>(invitations_->rowCount(), 1, 5) * kTouchTarget + 50);
        invitations_->setVisible(!all.empty());
    }

    QWidget* importCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Take in a list"), "heading"));
        layout->addWidget(make_label(
            tr("A CSV file with the columns login, name and, if wanted, roles (separated by ;), "
               "group and password. The whole file is checked before the first account is made. "
               "Passwords that are missing are made and written into a file of your choice."),
            "muted"));
        load_ = make_button(context_, tr("Choose the file"), "secondary", "people");
        load_->setObjectName("import_people");
        connect(load_, &QPushButton::clicked, this, [this] { importList(); });
        layout->addWidget(load_, 0, Qt::AlignLeft);
        // It may be a list that this page was left with: the same people a second time would get
        // passwords that are nobody's.
        load_->setEnabled(!context_.busy());
        context_.whenIdle(load_, [this] { load_->setEnabled(true); });
        return make_card(layout);
    }

    void importList() {
        const QString path = context_.askOpenFile(this, tr("Take in a list"), "CSV (*.csv)");
        if (path.isEmpty()) return;
        context_.guard(tr("Taking in the list"), [&] {
            context_.require(db::Action::kManageUsers, db::Scope::kOther);
            QFile file(path);
            if (!file.open(QIODevice::ReadOnly))
                throw reports::PeopleFileError(path.toStdString() + ": " +
                                               file.errorString().toStdString());
            auto people = reports::read_people(context_.store(), file.readAll().toStdString(),
                                               path.toStdString());
            const std::string made = reports::make_passwords(people);
            if (!made.empty()) {
                // Written before the first account is made: a password that nobody knows helps
                // nobody.
                const QString out = context_.askSaveFile(this, tr("Passwords that were made"),
                                                         "passwords.csv", "CSV (*.csv)");
                if (out.isEmpty()) return;
                reports::save_passwords(out.toStdString(), made);
            }
            makeAccounts(std::move(people), path.toStdString());
        });
    }

    /// On a worker: each password is hashed, which takes its time on purpose.
    void makeAccounts(std::vector<reports::PersonLine> people, const std::string& origin) {
        load_->setEnabled(false);
        auto count = std::make_shared<size_t>(0);
        context_.background(
            this, tr("Taking in the list"),
            [count, people = std::move(people), origin](db::Store& store) {
                *count = reports::make_accounts(store, people, origin);
            },
            [this, count](bool done) {
                load_->setEnabled(true);
                if (done) Q_EMIT notice(tr("Added people: %1.").arg(*count));
            });
    }

    QLineEdit *note_ = nullptr, *code_ = nullptr;
    QComboBox *role_ = nullptr, *group_ = nullptr;
    QDateEdit* until_ = nullptr;
    QPushButton* load_ = nullptr;
    QTableWidget* invitations_ = nullptr;
};

}  // namespace

Page* make_admissions_page(AppContext& context, const Place&) {
    return new AdmissionsPage(context);
}

}  // namespace placode::ui
