// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// My account: who I am here, and a new password.

#include <QHBoxLayout>
#include <QLineEdit>

#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

class AccountPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AccountPage)
 public:
    explicit AccountPage(AppContext& context) : Page(context) {
        QVBoxLayout* column = make_column(this, 620);
        column->addWidget(make_label(tr("My account"), "display"));
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace12);
        QLabel* name = make_label(qstr(context.user().display_name), "title");
        name->setWordWrap(false);
        head->addWidget(name);
        if (context.user().demonstration) head->addWidget(make_demonstration_badge());
        head->addStretch();
        layout->addLayout(head);
        layout->addWidget(make_label(tr("Log-in name: %1").arg(qstr(context.user().login))));
        layout->addWidget(make_label(tr("Roles: %1").arg(role_names(context.user().roles))));
        layout->addWidget(
            make_label(tr("Since: %1").arg(format_when(context.user().created_utc)), "muted"));
        column->addWidget(make_card(layout));
        column->addWidget(passwordCard());
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("My account"); }

 private:
    QWidget* passwordCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("New password"), "heading"));
        const std::tuple<QLineEdit**, QString, const char*> fields[] = {
            {&old_, tr("Present password"), "old_password"},
            {&new_, tr("New password"), "new_password"},
            {&again_, tr("New password again"), "again_password"}};
        for (const auto& [field, name, object] : fields) {
            *field = new QLineEdit;
            (*field)->setEchoMode(QLineEdit::Password);
            (*field)->setObjectName(object);
            layout->addLayout(make_field(name, *field));
        }
        message_ = make_label({}, "critical");
        message_->hide();
        layout->addWidget(message_);
        QPushButton* change = make_button(context_, tr("Change the password"), "primary", "key");
        change->setObjectName("change_password");
        connect(change, &QPushButton::clicked, this, [this] { this->change(); });
        layout->addWidget(change, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    void change() {
        message_->hide();
        if (new_->text() != again_->text())
            return say(tr("The two passwords differ. Type them again."));
        context_.guard(tr("Changing the password"), [this] {
            const db::SignIn check =
                context_.store().sign_in(context_.user().login, old_->text().toStdString());
            if (check.outcome == db::SignInOutcome::kThrottled)
                return say(tr("Too many wrong passwords. Try again in %1 s.").arg(check.wait_s));
            if (check.outcome != db::SignInOutcome::kOk)
                return say(tr("The present password is wrong."));
            context_.store().set_password(context_.user().id, new_->text().toStdString());
            for (QLineEdit* field : {old_, new_, again_}) field->clear();
            Q_EMIT notice(tr("The password was changed."));
        });
    }

    void say(const QString& text) {
        message_->setText(text);
        message_->show();
    }

    QLineEdit *old_ = nullptr, *new_ = nullptr, *again_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

Page* make_account_page(AppContext& context, const Place&) { return new AccountPage(context); }

}  // namespace placode::ui
