// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/handover.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "ui/shell/dialog_frame.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

class TakeBackDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(TakeBackDialog)
 public:
    TakeBackDialog(AppContext& context, QWidget* parent) : QDialog(parent), context_(context) {
        setObjectName("take_back");
        setWindowTitle(tr("For the coordinator"));
        setMinimumWidth(440);
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace24, kSpace24, kSpace24);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("For the coordinator"), "title"));
        layout->addWidget(make_label(
            (mayUsePin() ? tr("The screen belongs to a participant. %1 takes it back with the "
                              "password or the PIN.")
                         : tr("The screen belongs to a participant. %1 takes it back with the "
                              "password."))
                .arg(qstr(context.user().display_name)),
            "muted"));
        password_ = new QLineEdit;
        password_->setObjectName("take_back_password");
        password_->setEchoMode(QLineEdit::Password);
        layout->addLayout(
            make_field(tr("Password of %1").arg(qstr(context.user().login)), password_));
        message_ = make_label({}, "critical");
        message_->setObjectName("take_back_message");
        message_->hide();
        layout->addWidget(message_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        QPushButton* stay = make_button(context, tr("Stay here"), "secondary");
        stay->setObjectName("take_back_stay");
        stay->setAutoDefault(false);
        QPushButton* back = make_button(context, tr("Take the screen back"), "primary", "next");
        back->setObjectName("take_back_yes");
        back->setDefault(true);
        row->addStretch();
        row->addWidget(stay);
        row->addWidget(back);
        layout->addLayout(row);
        connect(stay, &QPushButton::clicked, this, &QDialog::reject);
        connect(back, &QPushButton::clicked, this, [this] { check(); });
        frame_dialog(this);
        password_->setFocus();
    }

 private:
    [[nodiscard]] bool mayUsePin() {
        bool may = false;
        const int64_t id = context_.user().id;
        (void)context_.problemOf(
            [&] { may = context_.knowsPassword(id) && context_.store().accounts().has_pin(id); });
        return may;
    }

    [[nodiscard]] bool looksLikePin() const {
        const QString typed = password_->text();
        return typed.size() >= 4 && typed.size() <= 12 &&
               std::all_of(typed.begin(), typed.end(), [](QChar c) { return c.isDigit(); });
    }

    void check() {
        if (password_->text().isEmpty()) return say(tr("Type your password."));
        db::SignIn result;
        const auto problem = context_.problemOf([&] {
            const std::string typed = password_->text().toStdString();
            const db::UserRecord user = context_.user();
            result = looksLikePin() && mayUsePin()
                         ? context_.store().accounts().unlock(user.id, typed)
                         : context_.store().accounts().sign_in(user.login, typed);
        });
        password_->clear();
        password_->setFocus();
        if (problem) return say(problem->title + " " + problem->way_out);
        switch (result.outcome) {
            case db::SignInOutcome::kOk:
                return accept();
            case db::SignInOutcome::kThrottled:
                return say(tr("Too many wrong passwords. Try again in %1 s.")
                               .arg(std::max(1, result.wait_s)));
            case db::SignInOutcome::kDeactivated:
                return say(tr("This account is deactivated."));
            case db::SignInOutcome::kWrong:
                return say(tr("That is wrong. The screen stays with the participant."));
        }
    }

    void say(const QString& text) {
        message_->setText(text);
        message_->show();
        make_room(this);
    }

    AppContext& context_;
    QLineEdit* password_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

bool is_participants(AppContext& context, const Place& place) {
    if (place.page == PageId::kStudyRun) return true;
    if (place.page == PageId::kRunning) return !context.launcher().order().study.isEmpty();
    if (place.page != PageId::kParticipant) return false;
    const QVariantMap& state = place.state;
    return state.value("rating_of").toLongLong() == 0 &&
           state.value("second_of").toLongLong() == 0 && !state.value("paper").toBool() &&
           state.value("preview").toString().isEmpty();
}

bool take_back(AppContext& context, QWidget* parent) {
    TakeBackDialog dialog(context, parent);
    if (dialog.exec() != QDialog::Accepted) return false;
    return context.guard(TakeBackDialog::tr("Writing the audit"), [&] {
        context.audit("session.take_back", QString("user %1").arg(context.user().id));
    });
}

}  // namespace placode::ui
