// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/local_profile_card.h"

#include "ui/shell/account_fields.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

class LocalProfileCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(LocalProfileCard)
 public:
    LocalProfileCard(AppContext& context, Page* page) : context_(context), page_(page) {
        setProperty("role", "card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace24);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Make an account of this profile"), "heading"));
        layout->addWidget(make_label(
            tr("The profile has no password: whoever uses this computer can open it. With a name "
               "and a password it is an account. Your attempts and scores stay yours, and other "
               "people can be added."),
            "muted"));
        fields_.addTo(layout, {}, {"own_name", "own_login", "own_password", "own_password_again"});
        message_ = make_hint("critical");
        message_->setObjectName("account_message");
        layout->addWidget(message_);
        QPushButton* make = make_button(context_, tr("Make the account"), "primary", "key");
        make->setObjectName("make_account");
        connect(make, &QPushButton::clicked, this, [this] { makeAccount(); });
        hide_when_edited(message_, {fields_.name, fields_.login, fields_.password, fields_.again});
        enter_submits({fields_.name, fields_.login, fields_.password, fields_.again}, this,
                      [this] { makeAccount(); });
        layout->addWidget(make, 0, Qt::AlignLeft);
    }

 private:
    void makeAccount() {
        message_->hide();
        if (const FormProblem problem = fields_.problem()) {
            message_->setText(problem.text);
            message_->show();
            return go_to_field(problem.field);
        }
        context_.guard(tr("Making the account"), [this] {
            context_.store().accounts().name_local_profile(fields_.user());
            const auto self = context_.store().accounts().find(context_.user().id);
            context_.notePassword(*self);
            context_.signIn(*self);  // Under the new name, everywhere.
            Q_EMIT page_->notice(
                tr("The account was made. From now on you sign in with your password."));
        });
    }

    AppContext& context_;
    Page* page_;
    AccountFields fields_;
    QLabel* message_ = nullptr;
};

}  // namespace

QWidget* make_local_profile_card(AppContext& context, Page* page) {
    return new LocalProfileCard(context, page);
}

}  // namespace placode::ui
