// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Log-in: large, keyboard first. Name and password, the last people of this machine one touch away.

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QTimer>
#include <algorithm>
#include <optional>

#include "db/demonstration.h"
#include "ui/shell/form_keys.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr int kRememberedPeople = 4;

class LoginPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(LoginPage)
 public:
    LoginPage(AppContext& context, const Place& place) : Page(context) {
        // Scrolls where the screen is small or its scale is large.
        QVBoxLayout* outer = make_column(this, 520);
        (void)context_.problemOf([&] { alone_ = context_.store().accounts().local_profile(); });
        outer->addStretch(2);
        outer->addWidget(alone_ ? buildCardOfOne(place) : buildCard(place), 0, Qt::AlignHCenter);
        outer->addStretch(3);
        if (alone_) return;
        timer_.setInterval(1000);
        connect(&timer_, &QTimer::timeout, this, [this] { countDown(); });
        const QString last = context_.storeSetting("last_login").toString();
        login_->setText(place.state.value("login", isHere(last) ? last : QString()).toString());
        const QString said = place.state.value("message").toString();
        if (!said.isEmpty()) say(said);
        showPinHint();
        QTimer::singleShot(0, this, [this] {
            (login_->text().isEmpty() ? login_ : password_)->setFocus(Qt::OtherFocusReason);
        });
    }

    [[nodiscard]] QString title() const override { return tr("Sign in"); }
    [[nodiscard]] QVariantMap state() const override {
        if (alone_) return {{"note", note_->text()}};
        return {{"login", login_->text()},
                {"note", note_->text()},
                {"message", message_->isHidden() ? QString() : message_->text()}};
    }

 private:
    /// One person without a password: one button, and nobody else can sign in.
    QWidget* buildCardOfOne(const Place& place) {
        QVBoxLayout* layout = beginCard(place);
        button_ = make_button(context_, tr("Go on as %1").arg(qstr(alone_->display_name)),
                              "primary", "next");
        button_->setObjectName("enter");
        button_->setLayoutDirection(Qt::RightToLeft);
        button_->setProperty("scale", "large");
        layout->addWidget(button_);
        layout->addWidget(make_label(
            tr("This profile has no password. Under My account you can make an account of it."),
            "small"));
        connect(button_, &QPushButton::clicked, this, [this] {
            context_.guard(tr("Signing in"), [this] {
                const db::SignIn in = context_.store().accounts().enter();
                // Another program made an account of it meanwhile: then with its password.
                if (!in.user) return Q_EMIT go({PageId::kLogin, 0, {}, {}});
                context_.signIn(*in.user);
            });
        });
        QTimer::singleShot(0, this, [this] { button_->setFocus(Qt::OtherFocusReason); });
        return endCard(layout);
    }

    QVBoxLayout* beginCard(const Place& place) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace16);
        auto* head = new QHBoxLayout;
        auto* mark = new QLabel;
        mark->setPixmap(line_icon("placode", context_.colors().accent).pixmap(40, 40));
        head->addWidget(mark);
        head->addSpacing(kSpace8);
        head->addWidget(make_label("Placode", "display"), 1);
        layout->addLayout(head);
        layout->addWidget(
            make_label(tr("Fetoscopic spina bifida repair: practise, see, repeat."), "muted"));
        note_ = make_label({}, "warn");
        note_->setObjectName("login_note");
        note_->setText(place.state.value("note").toString());
        note_->setVisible(!note_->text().isEmpty());
        layout->addWidget(note_);
        return layout;
    }

    QWidget* endCard(QVBoxLayout* layout) {
        QFrame* card = make_card(layout);
        layout->setContentsMargins(kSpace32, kSpace32, kSpace32, kSpace32);
        card->setFixedWidth(460);
        return card;
    }

    QWidget* buildCard(const Place& place) {
        QVBoxLayout* layout = beginCard(place);
        (void)context_.problemOf(
            [&] { demonstrators_ = context_.store().accounts().demonstrators(); });
        addPeople(layout);
        addDemonstration(layout);
        login_ = new QLineEdit;
        login_->setObjectName("login");
        password_ = new QLineEdit;
        password_->setObjectName("password");
        password_->setEchoMode(QLineEdit::Password);
        layout->addLayout(make_field(tr("Log-in name"), login_));
        layout->addLayout(make_field(tr("Password"), password_));
        pin_hint_ = make_label(tr("Your PIN is enough here: you signed in not long ago."), "small");
        pin_hint_->setObjectName("pin_hint");
        pin_hint_->hide();
        layout->addWidget(pin_hint_);
        connect(login_, &QLineEdit::textChanged, this, [this] { showPinHint(); });
        message_ = make_hint("critical");
        message_->setObjectName("login_message");
        layout->addWidget(message_);
        button_ = make_button(context_, tr("Sign in"), "primary", "next");
        button_->setObjectName("sign_in");
        button_->setLayoutDirection(Qt::RightToLeft);
        button_->setProperty("scale", "large");
        layout->addWidget(button_);
        QPushButton* join = make_button(context_, tr("I have an invitation"), "quiet");
        join->setObjectName("open_join");
        layout->addWidget(join, 0, Qt::AlignHCenter);
        connect(join, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kJoin, 0, {}, {}});
        });
        connect(button_, &QPushButton::clicked, this, [this] { signIn(); });
        enter_submits({login_, password_}, this, [this] { signIn(); });
        return endCard(layout);
    }

    /// Whether somebody of this name may sign in to the store that is open.
    [[nodiscard]] bool isHere(const QString& login) {
        bool may = false;
        if (!login.isEmpty())
            (void)context_.problemOf(
                [&] { may = context_.store().accounts().may_sign_in(login.toStdString()); });
        return may;
    }

    /// The people who signed in here last, as long as they still may.
    void addPeople(QVBoxLayout* layout) {
        if (!demonstrators_.empty()) return;  // They all stand below.
        QStringList recent = context_.storeSetting("recent_logins").toStringList();
        recent.removeIf([this](const QString& login) { return !isHere(login); });
        if (recent.isEmpty()) return;
        auto* grid = new QGridLayout;
        grid->setSpacing(kSpace8);
        int count = 0;
        for (const QString& login : recent.mid(0, kRememberedPeople)) {
            QPushButton* person = make_button(context_, login, "secondary", "account");
            person->setObjectName("person_" + login);
            person->setAccessibleName(tr("Sign in as %1").arg(login));
            connect(person, &QPushButton::clicked, this, [this, login] {
                login_->setText(login);
                password_->clear();
                password_->setFocus();
            });
            grid->addWidget(person, count / 2, count % 2);
            ++count;
        }
        layout->addLayout(grid);
    }

    /// A store that was made to be looked at says who is in it, and lets everybody in.
    void addDemonstration(QVBoxLayout* layout) {
        if (demonstrators_.empty()) return;
        auto* inside = new QVBoxLayout;
        inside->setSpacing(kSpace8);
        inside->addWidget(make_label(
            tr("This is a demonstration: choose who you want to be. The password of all is "
               "\"%1\".")
                .arg(db::kDemonstrationPassword),
            "small"));
        auto* grid = new QGridLayout;
        grid->setSpacing(kSpace8);
        int count = 0;
        for (const db::UserRecord& user : demonstrators_) {
            if (!user.active) continue;
            const QString login = qstr(user.login);
            QPushButton* person = make_button(context_, login, "secondary");
            person->setProperty("scale", "small");
            person->setObjectName("demonstration_" + login);
            person->setAccessibleName(tr("Sign in as %1").arg(login));
            person->setToolTip(qstr(user.display_name) + ", " + role_names(user.roles));
            connect(person, &QPushButton::clicked, this, [this, login] {
                login_->setText(login);
                password_->setText(db::kDemonstrationPassword);
                button_->setFocus();
            });
            auto* cell = new QVBoxLayout;
            cell->setSpacing(0);
            cell->addWidget(person);
            cell->addWidget(make_label(role_names(user.roles), "small"));
            grid->addLayout(cell, count / 2, count % 2);
            ++count;
        }
        inside->addLayout(grid);
        QFrame* card = make_card(inside);
        card->setObjectName("demonstration_accounts");
        layout->addWidget(card);
    }

    void signIn() {
        if (!button_->isEnabled()) return;
        if (login_->text().trimmed().isEmpty() || password_->text().isEmpty()) {
            say(tr("Type your log-in name and your password."));
            return go_to_field(login_->text().trimmed().isEmpty() ? login_ : password_);
        }
        context_.guard(tr("Signing in"), [this] {
            const std::string typed = password_->text().toStdString();
            if (const int64_t id = pinUser(); id != 0 && looksLikePin(password_->text())) {
                const db::SignIn result = context_.store().accounts().unlock(id, typed);
                if (result.outcome == db::SignInOutcome::kWrong) {
                    password_->clear();
                    showPinHint();
                    return say(pinUser() != 0
                                   ? tr("The PIN is wrong. Try again, or type your password.")
                                   : tr("Three wrong PINs: type your password."));
                }
                return answer(result);
            }
            const db::SignIn result =
                context_.store().accounts().sign_in(login_->text().trimmed().toStdString(), typed);
            if (result.outcome == db::SignInOutcome::kOk) context_.notePassword(*result.user);
            answer(result);
        });
    }

    /// Who may come back with the PIN: has one, and gave the password here not long ago; else 0.
    [[nodiscard]] int64_t pinUser() const {
        const int64_t id = context_.knownHere(login_->text());
        return id != 0 && context_.store().accounts().has_pin(id) ? id : 0;
    }
    [[nodiscard]] static bool looksLikePin(const QString& typed) {
        return typed.size() >= 4 && typed.size() <= 12 &&
               std::all_of(typed.begin(), typed.end(), [](QChar c) { return c.isDigit(); });
    }
    void showPinHint() {
        bool may = false;
        (void)context_.problemOf([&] { may = pinUser() != 0; });
        pin_hint_->setVisible(may);
    }

    void answer(const db::SignIn& result) {
        password_->clear();
        switch (result.outcome) {
            case db::SignInOutcome::kOk:
                remember(qstr(result.user->login));
                context_.signIn(*result.user);
                return;
            case db::SignInOutcome::kThrottled:
                wait_s_ = std::max(1, result.wait_s);
                button_->setEnabled(false);
                timer_.start();
                countDown();
                break;
            case db::SignInOutcome::kDeactivated:
                say(tr("This account is deactivated. An administrator can open it again."));
                break;
            default:
                say(tr("Log-in name or password is wrong. Try again."));
        }
        password_->setFocus();
    }

    void remember(const QString& login) {
        QStringList recent = context_.storeSetting("recent_logins").toStringList();
        recent.removeAll(login);
        recent.prepend(login);
        context_.setStoreSetting("recent_logins", recent.mid(0, kRememberedPeople));
    }

    void countDown() {
        if (wait_s_ <= 0) {
            timer_.stop();
            button_->setEnabled(true);
            message_->hide();
            return;
        }
        say(tr("Too many wrong passwords. Try again in %1 s.").arg(wait_s_--));
    }

    void say(const QString& text) {
        message_->setText(text);
        message_->show();
    }

    QLineEdit* login_ = nullptr;
    QLineEdit* password_ = nullptr;
    QLabel *message_ = nullptr, *pin_hint_ = nullptr, *note_ = nullptr;
    QPushButton* button_ = nullptr;
    QTimer timer_;
    std::vector<db::UserRecord> demonstrators_;
    std::optional<db::UserRecord> alone_;
    int wait_s_ = 0;
};

}  // namespace

Page* make_login_page(AppContext& context, const Place& place) {
    return new LoginPage(context, place);
}

}  // namespace placode::ui
