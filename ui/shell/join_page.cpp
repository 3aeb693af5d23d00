// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Join: somebody who was invited makes the own account with the code.

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTimer>

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
        connect(again_, &QLineEdit::returnPressed, this, [this] { join(); });
        connect(leave, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kLogin, 0, {}, {}});
        });
        column->addWidget(make_card(layout));
        column->addStretch(2);
        QTimer::singleShot(0, this, [this] { code_->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("Make your account"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"code", code_->text()}, {"name", name_->text()}, {"login", login_->text()}};
    }

 private:
    void addFields(QVBoxLayout* layout, const Place& place) {
        const auto field = [&](const char* object, const QVariant& text) {
            auto* line = new QLineEdit(text.toString());
            line->setObjectName(object);
            return line;
        };
        code_ = field("join_code", place.state.value("code"));
        name_ = field("join_name", place.state.value("name"));
        login_ = field("join_login", place.state.value("login"));
        password_ = field("join_password", {});
        again_ = field("join_again", {});
        password_->setEchoMode(QLineEdit::Password);
        again_->setEchoMode(QLineEdit::Password);
        layout->addLayout(make_field(tr("Code of the invitation"), code_));
        auto* first = new QHBoxLayout;
        first->setSpacing(kSpace16);
        first->addLayout(make_field(tr("Your name"), name_));
        first->addLayout(make_field(tr("Log-in name"), login_));
        auto* second = new QHBoxLayout;
        second->setSpacing(kSpace16);
        second->addLayout(make_field(tr("Password"), password_));
        second->addLayout(make_field(tr("Password again"), again_));
        layout->addLayout(first);
        layout->addLayout(second);
    }

    void join() {
        message_->hide();
        if (code_->text().trimmed().isEmpty() || login_->text().trimmed().isEmpty() ||
            name_->text().trimmed().isEmpty())
            return say(tr("Give the code, your name and a log-in name."));
        if (password_->text() != again_->text())
            return say(tr("The two passwords differ. Type them again."));
        db::NewUser user;
        user.login = login_->text().trimmed().toStdString();
        user.display_name = name_->text().trimmed().toStdString();
        user.password = password_->text().toStdString();
        context_.guard(tr("Making the account"), [&] {
            context_.store().accept_invitation(code_->text().trimmed().toStdString(), user);
            Q_EMIT notice(tr("Your account is made. Sign in with it."));
            Q_EMIT go({PageId::kLogin, 0, {}, {{"login", login_->text().trimmed()}}});
        });
    }

    void say(const QString& text) {
        message_->setText(text);
        message_->show();
    }

    QLineEdit *code_ = nullptr, *name_ = nullptr, *login_ = nullptr, *password_ = nullptr,
              *again_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

Page* make_join_page(AppContext& context, const Place& place) {
    return new JoinPage(context, place);
}

}  // namespace placode::ui
