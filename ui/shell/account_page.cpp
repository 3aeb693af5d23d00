// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// My account: who I am here, a new password, a PIN for a quick return, keys and buttons, my data,
// and erasure.

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>

#include "reports/people_file.h"
#include "ui/shell/account_fields.h"
#include "ui/shell/controls_card.h"
#include "ui/shell/export_folder.h"
#include "ui/shell/local_profile_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

class AccountPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(AccountPage)
 public:
    AccountPage(AppContext& context, const Place& place) : Page(context) {
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
        const auto profile = context.store().accounts().local_profile();
        if (profile && profile->id == context.user().id) {
            column->addWidget(make_local_profile_card(context, this));
        } else {
            column->addWidget(passwordCard());
            column->addWidget(pinCard());
        }
        QWidget* controls = make_controls_card(context);
        column->addWidget(controls);
        column->addWidget(dataCard());
        column->addWidget(erasureCard());
        column->addStretch();
        if (place.text == "controls") begin_at(controls);
    }

    [[nodiscard]] QString title() const override { return tr("My account"); }

 private:
    QWidget* passwordCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("New password"), "heading"));
        given_ = make_label(tr("Somebody else set your password and knows it. Choose one that only "
                               "you know; until then every sign-in begins here."),
                            "warn");
        given_->setObjectName("given_password");
        given_->setVisible(context_.user().password_given);
        layout->addWidget(given_);
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
        new_->setPlaceholderText(password_rule());
        message_ = make_label({}, "critical");
        message_->setObjectName("account_message");
        message_->hide();
        layout->addWidget(message_);
        QPushButton* change = make_button(context_, tr("Change the password"), "primary", "key");
        change->setObjectName("change_password");
        connect(change, &QPushButton::clicked, this, [this] { this->change(); });
        hide_when_edited(message_, {old_, new_, again_});
        enter_submits({old_, new_, again_}, this, [this] { this->change(); });
        layout->addWidget(change, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    void change() {
        message_->hide();
        if (const FormProblem missing = first_missing({old_, new_})) return say(missing);
        if (const QString problem = password_problem(new_->text()); !problem.isEmpty())
            return say({problem, new_});
        if (new_->text() != again_->text())
            return say({tr("The two passwords differ. Type them again."), again_});
        context_.guard(tr("Changing the password"), [this] {
            if (const FormProblem wrong = checkPresent(old_)) return say(wrong);
            context_.store().accounts().set_password(context_.user().id,
                                                     new_->text().toStdString());
            for (QLineEdit* field : {old_, new_, again_}) field->clear();
            context_.ownPasswordSet();
            given_->hide();
            Q_EMIT notice(tr("The password was changed."));
        });
    }

    /// Whoever finds the screen unlocked is not yet the person.
    FormProblem checkPresent(QLineEdit* field) {
        const db::SignIn check =
            context_.store().accounts().sign_in(context_.user().login, field->text().toStdString());
        if (check.outcome == db::SignInOutcome::kThrottled)
            return {tr("Too many wrong passwords. Try again in %1 s.").arg(check.wait_s), field};
        if (check.outcome != db::SignInOutcome::kOk)
            return {tr("The present password is wrong."), field};
        return {};
    }

    QWidget* pinCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("PIN for a quick return"), "heading"));
        layout->addWidget(make_label(
            tr("At a station where you signed in with your password within the last %1 hours, the "
               "PIN is enough to come back. Four to twelve digits; after three wrong ones the "
               "password is needed.")
                .arg(AppContext::kPinHours),
            "muted"));
        pin_password_ = new QLineEdit;
        pin_password_->setObjectName("pin_password");
        pin_password_->setEchoMode(QLineEdit::Password);
        layout->addLayout(make_field(tr("Present password"), pin_password_));
        pin_ = new QLineEdit;
        pin_->setObjectName("new_pin");
        pin_->setEchoMode(QLineEdit::Password);
        pin_->setInputMethodHints(Qt::ImhDigitsOnly);
        pin_->setMaxLength(12);
        layout->addLayout(make_field(tr("New PIN"), pin_));
        pin_message_ = make_label({}, "critical");
        pin_message_->setObjectName("pin_message");
        pin_message_->hide();
        hide_when_edited(pin_message_, {pin_password_, pin_});
        layout->addWidget(pin_message_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        QPushButton* set = make_button(context_, tr("Set the PIN"), "secondary", "key");
        set->setObjectName("set_pin");
        remove_pin_ = make_button(context_, tr("Remove the PIN"), "quiet");
        remove_pin_->setObjectName("remove_pin");
        remove_pin_->setVisible(context_.store().accounts().has_pin(context_.user().id));
        row->addWidget(set);
        row->addWidget(remove_pin_);
        row->addStretch();
        layout->addLayout(row);
        const auto give = [this] {
            if (const FormProblem missing = first_missing({pin_password_}))
                return sayOfPin(missing);
            if (!pin_->text().isEmpty()) return setPin(pin_->text());
            context_.report({tr("Type four to twelve digits."), {}, {}, false});
            go_to_field(pin_);
        };
        connect(set, &QPushButton::clicked, this, give);
        enter_submits({pin_password_, pin_}, this, give);
        connect(remove_pin_, &QPushButton::clicked, this, [this] { setPin({}); });
        return make_card(layout);
    }

    void setPin(const QString& pin) {
        context_.guard(tr("Setting the PIN"), [&] {
            // A PIN opens the account for hours; to take one away opens nothing.
            if (!pin.isEmpty())
                if (const FormProblem wrong = checkPresent(pin_password_)) return sayOfPin(wrong);
            context_.store().accounts().set_pin(context_.user().id, pin.toStdString());
            for (QLineEdit* field : {pin_password_, pin_}) field->clear();
            remove_pin_->setVisible(!pin.isEmpty());
            Q_EMIT notice(pin.isEmpty() ? tr("The PIN is gone.") : tr("The PIN is set."));
        });
    }

    QWidget* dataCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("My data"), "heading"));
        layout->addWidget(make_label(
            tr("Everything that is kept about you, as a file that any program can read: account, "
               "groups, courses, certificates, attempts with metrics, reasons and remarks."),
            "muted"));
        recordings_ = new QCheckBox(tr("With the recordings of all attempts"));
        recordings_->setObjectName("data_recordings");
        keep_choice(recordings_);
        layout->addWidget(recordings_);
        QPushButton* save = make_button(context_, tr("Save my data"), "secondary", "download");
        save->setObjectName("save_my_data");
        connect(save, &QPushButton::clicked, this, [this] { saveData(); });
        layout->addWidget(save, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    void saveData() {
        const QString parent = context_.askFolder(this, tr("Save my data"));
        if (parent.isEmpty()) return;
        const QString folder = export_folder(parent, qstr(context_.user().login));
        if (!context_.guard(tr("Saving my data"),
                            [this] { context_.require(db::Action::kExportPersonalData); }))
            return;
        const auto data = std::make_shared<reports::OwnData>();
        context_.background(
            this, tr("Saving my data"),
            [data, folder, id = context_.user().id,
             recordings = recordings_->isChecked()](db::Store& store) {
                *data = reports::write_own_data(store, id, folder.toStdString(), recordings);
            },
            [this, data, folder](bool done) {
                if (done)
                    Q_EMIT written(tr("Your data is in %1: attempts %2, recordings %3.")
                                       .arg(folder)
                                       .arg(data->attempts)
                                       .arg(data->recordings),
                                   folder);
            });
    }

    QWidget* erasureCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Erase me"), "heading"));
        erasure_ = make_label({}, "muted");
        erasure_->setObjectName("erasure_state");
        layout->addWidget(erasure_);
        erasure_fields_ = new QWidget;
        auto* inside = new QVBoxLayout(erasure_fields_);
        inside->setContentsMargins(0, 0, 0, 0);
        reason_ = new QLineEdit;
        reason_->setObjectName("erasure_reason");
        inside->addLayout(make_field(tr("Reason, if you like"), reason_));
        QPushButton* ask = make_button(context_, tr("Ask to be erased"), "danger");
        ask->setObjectName("ask_erasure");
        connect(ask, &QPushButton::clicked, this, [this] { askErasure(); });
        inside->addWidget(ask, 0, Qt::AlignLeft);
        layout->addWidget(erasure_fields_);
        showErasure();
        return make_card(layout);
    }

    void showErasure() {
        QString asked;
        for (const db::ErasureRecord& each : context_.store().accounts().erasure_requests())
            if (each.user_id == context_.user().id && each.done_utc.empty())
                asked = format_when(each.asked_utc);
        erasure_->setText(asked.isEmpty()
                              ? tr("An administrator then removes your name, log-in, groups and "
                                   "certificates. Save your data before.")
                              : tr("You asked on %1. An administrator carries it out.").arg(asked));
        erasure_fields_->setVisible(asked.isEmpty());
    }

    void askErasure() {
        if (!confirm(this, tr("Ask to be erased?"),
                     tr("Once an administrator has done it, it cannot be undone."),
                     tr("Ask to be erased")))
            return;
        context_.guard(tr("Asking to be erased"), [this] {
            context_.require(db::Action::kRequestErasure);
            context_.store().accounts().request_erasure(context_.user().id,
                                                        reason_->text().trimmed().toStdString());
            showErasure();
        });
    }

    void say(const FormProblem& problem) { say(problem, message_); }
    void sayOfPin(const FormProblem& problem) { say(problem, pin_message_); }
    static void say(const FormProblem& problem, QLabel* message) {
        message->setText(problem.text);
        message->show();
        go_to_field(problem.field);
    }

    QLineEdit *old_ = nullptr, *new_ = nullptr, *again_ = nullptr;
    QLabel *message_ = nullptr, *erasure_ = nullptr, *given_ = nullptr, *pin_message_ = nullptr;
    QLineEdit *pin_ = nullptr, *pin_password_ = nullptr, *reason_ = nullptr;
    QPushButton* remove_pin_ = nullptr;
    QCheckBox* recordings_ = nullptr;
    QWidget* erasure_fields_ = nullptr;
};

}  // namespace

Page* make_account_page(AppContext& context, const Place& place) {
    return new AccountPage(context, place);
}

}  // namespace placode::ui
