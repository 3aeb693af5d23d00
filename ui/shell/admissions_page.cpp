// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Admissions: an administrator invites people, takes in a list, and answers those who ask to be
// erased.

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>

#include "db/erasure.h"
#include "reports/export.h"
#include "reports/people_file.h"
#include "ui/shell/day_text.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

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
        column->addWidget(erasureCard());
        column->addStretch();
        showInvitations();
        showRequests();
    }

    [[nodiscard]] QString title() const override { return tr("Invitations and requests"); }

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
        QPushButton* load = make_button(context_, tr("Choose the file"), "secondary", "people");
        load->setObjectName("import_people");
        connect(load, &QPushButton::clicked, this, [this] { importList(); });
        layout->addWidget(load, 0, Qt::AlignLeft);
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
                reports::save_file(out.toStdString(), made);
                QFile::setPermissions(out, QFileDevice::ReadOwner | QFileDevice::WriteOwner);
            }
            const size_t count =
                reports::make_accounts(context_.store(), people, path.toStdString());
            Q_EMIT notice(tr("Added people: %1.").arg(count));
        });
    }

    QWidget* erasureCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Who asks to be erased"), "heading"));
        requests_ = make_table({tr("Person"), tr("Asked"), tr("Reason"), tr("State"), {}},
                               tr("Who asks to be erased"));
        requests_->setObjectName("erasure_table");
        requests_->setSortingEnabled(false);
        layout->addWidget(requests_);
        with_attempts_ = new QCheckBox(tr("The attempts go as well (else they stay, nameless)"));
        with_attempts_->setObjectName("erase_attempts");
        layout->addWidget(with_attempts_);
        none_ = make_label(tr("Nobody has asked."), "muted");
        layout->addWidget(none_);
        left_ = make_label({}, "warn");
        left_->setObjectName("erasure_left");
        left_->hide();
        layout->addWidget(left_);
        certificate_ =
            make_button(context_, tr("Save the certificate of erasure"), "secondary", "download");
        certificate_->setObjectName("erasure_certificate");
        certificate_->hide();
        connect(certificate_, &QPushButton::clicked, this, [this] { saveCertificate(); });
        layout->addWidget(certificate_, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    void showRequests() {
        const auto all = context_.store().accounts().erasure_requests();
        requests_->setRowCount(static_cast<int>(all.size()));
        bool waits = false;
        for (int row = 0; row < requests_->rowCount(); ++row) {
            const db::ErasureRecord& each = all[static_cast<size_t>(row)];
            const auto user = context_.store().accounts().find(each.user_id);
            const bool open = each.done_utc.empty();
            waits = waits || open;
            const QString name =
                open && user ? qstr(user->display_name) : tr("number %1").arg(each.user_id);
            requests_->setItem(row, 0, make_cell(name));
            requests_->setItem(row, 1, make_cell(format_when(each.asked_utc)));
            requests_->setItem(row, 2, make_cell(qstr(each.reason)));
            requests_->setItem(
                row, 3,
                make_cell(open ? tr("waits") : tr("erased %1").arg(format_when(each.done_utc))));
            requests_->setItem(row, 4, make_cell({}));
            requests_->removeCellWidget(row, 4);
            if (!open) continue;
            QPushButton* erase = make_button(context_, tr("Erase"), "danger");
            erase->setObjectName(QString("erase_%1").arg(row));
            erase->setAccessibleName(tr("Erase %1").arg(name));
            connect(
                erase, &QPushButton::clicked, this,
                [this, id = each.user_id, name] { this->erase(id, name); }, Qt::QueuedConnection);
            requests_->setCellWidget(row, 4, erase);
        }
        fit_columns(requests_, 2);
        requests_->setColumnWidth(0, 200);
        requests_->setColumnWidth(3, std::max(170, requests_->columnWidth(3)));
        requests_->setColumnWidth(4, 120);
        requests_->setFixedHeight(std::clamp<int>(requests_->rowCount(), 1, 5) * kTouchTarget + 50);
        requests_->setVisible(!all.empty());
        with_attempts_->setVisible(waits);
        none_->setVisible(all.empty());
    }

    void erase(int64_t id, const QString& name) {
        const bool attempts = with_attempts_->isChecked();
        if (!confirm(this, tr("Erase %1 for good?").arg(name),
                     attempts ? tr("Name, log-in, groups, certificates and all attempts go. This "
                                   "cannot be undone.")
                              : tr("Name, log-in, groups and certificates go; attempts stay "
                                   "without a name. This cannot be undone."),
                     tr("Erase")))
            return;
        const bool may = context_.guard(tr("Erasing the person"), [&] {
            context_.require(db::Action::kErase,
                             db::scope_between(context_.store(), context_.user().id, id));
        });
        if (!may) return;
        const auto erasure = std::make_shared<db::Erasure>();
        context_.background(
            this, tr("Erasing the person"),
            [erasure, id, attempts, url = context_.storeUrl()](db::Store& store) {
                *erasure = db::erase_person(store, url, id, attempts);
            },
            [this, erasure, name](bool done) {
                showRequests();
                if (done) erased(*erasure, name);
            });
    }

    void erased(const db::Erasure& erasure, const QString& name) {
        erasure_ = erasure;
        QString said = tr("%1 was erased.").arg(name);
        if (!erasure.cleaned.empty())
            said += ' ' +
                    tr("Backups and other copies cleaned as well: %1.").arg(erasure.cleaned.size());
        QStringList left;
        for (const db::LeftCopy& each : erasure.left) left << qstr(each.path);
        left_->setText(tr("These copies may still hold the person; delete them:") + '\n' +
                       left.join('\n'));
        left_->setVisible(!left.isEmpty());
        certificate_->show();
        Q_EMIT notice(said);
    }

    void saveCertificate() {
        const QString path = context_.askSaveFile(
            this, tr("Save the certificate of erasure"),
            QString("placode-erasure-%1.txt").arg(erasure_.user_id), tr("Text (*.txt)"));
        if (path.isEmpty()) return;
        context_.guard(tr("Writing the certificate"), [&] {
            reports::save_file(path.toStdString(), db::erasure_certificate(erasure_));
            Q_EMIT written(tr("Certificate written: %1").arg(path), path);
        });
    }

    QLineEdit *note_ = nullptr, *code_ = nullptr;
    QComboBox *role_ = nullptr, *group_ = nullptr;
    QDateEdit* until_ = nullptr;
    QTableWidget *invitations_ = nullptr, *requests_ = nullptr;
    QCheckBox* with_attempts_ = nullptr;
    db::Erasure erasure_;  ///< The last one.
    QLabel* left_ = nullptr;
    QPushButton* certificate_ = nullptr;
    QLabel* none_ = nullptr;
};

}  // namespace

Page* make_admissions_page(AppContext& context, const Place&) {
    return new AdmissionsPage(context);
}

}  // namespace placode::ui
