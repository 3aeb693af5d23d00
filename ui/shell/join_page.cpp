// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Join: somebody who was invited makes the own account with the code.

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTimer>

#include "ui/shell/account_fields.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

class JoinPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(JoinPage)
 public:
    JoinPage(AppContext& context, const Place& place) : Page(context) {
        QVBoxLayout* column = make_column(this, 620);
        column->addStretch(1);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Make your account"), "display"));
        layout->addWidget(make_label(
            tr("Type the code that you were given. Name and password are yours to choose."),
            "muted"));
        addFields(layout, place);
        message_ = make_label({}, "critical");
        message_->setObjectName("join_message");
        message_->hide();
        layout->addWidget(message_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        QPushButton* make = make_button(context, tr("Make the account"), "primary", "check");
        make->setObjectName("join");
        QPushButton* leave = make_button(context, tr("Back to sign in"), "quiet", "back");
        leave->setObjectName("join_back");
        row->addWidget(make);
        row->addWidget(leave);
        row->addStretch();
        layout->addLayout(row);
        connect(make, &QPushButton::clicked, this, [this] { join(); });
        hide_when_edited(message_,
                         {code_, fields_.name, fields_.login, fields_.password, fields_.again});
        enter_submits({code_, fields_.name, fields_.login, fields_.password, fields_.again}, this,
                      [this] { join(); });
        connect(leave, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kLogin, 0, {}, {}});
        });
        column->addWidget(make_card(layout));
        column->addStretch(2);
        QTimer::singleShot(0, this, [this] { code_->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("Make your account"); }
    [[nodiscard]] QVariantMap state() const override {
        QVariantMap state = fields_.state();
        state["code"] = code_->text();
        return state;
    }

 private:
    void addFields(QVBoxLayout* layout, const Place& place) {
        code_ = new QLineEdit(place.state.value("code").toString());
        code_->setObjectName("join_code");
        layout->addLayout(make_field(tr("Code of the invitation"), code_));
        fields_.addTo(layout, place.state,
                      {"join_name", "join_login", "join_password", "join_again"});
    }

    void join() {
        message_->hide();
        if (code_->text().trimmed().isEmpty())
            return say({tr("Type the code of the invitation."), code_});
        if (const FormProblem problem = fields_.problem()) return say(problem);
        const db::NewUser user = fields_.user();
        context_.guard(tr("Making the account"), [&] {
            context_.store().accounts().accept_invitation(code_->text().trimmed().toStdString(),
                                                          user);
            Q_EMIT notice(tr("Your account is made. Sign in with it."));
            Q_EMIT go({PageId::kLogin, 0, {}, {{"login", QString::fromStdString(user.login)}}});
        });
    }

    void say(const FormProblem& problem) {
        message_->setText(problem.text);
        message_->show();
        go_to_field(problem.field);
    }

    AccountFields fields_;
    QLineEdit* code_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

Page* make_join_page(AppContext& context, const Place& place) {
    return new JoinPage(context, place);
}

}  // namespace placode::ui
