// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/account_fields.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <algorithm>

#include "db/password.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct Account {
    Q_DECLARE_TR_FUNCTIONS(AccountFields)
};

}  // namespace

QString password_rule() {
    return Account::tr("at least %1 characters").arg(db::kLeastPasswordLength);
}

QString password_problem(const QString& password) {
    const auto length = password.toUcs4().size();
    if (length >= db::kLeastPasswordLength) return {};
    return Account::tr("The password is too short: %1 of at least %2 characters.")
        .arg(length)
        .arg(db::kLeastPasswordLength);
}

FormProblem login_problem(QLineEdit* login) {
    const QString typed = login->text().trimmed();
    const bool spaces = std::any_of(typed.begin(), typed.end(), [](QChar c) {
        return c.isSpace() || c.category() == QChar::Other_Control;
    });
    if (spaces)
        return {Account::tr("A log-in name has no spaces: write it in one, as in anna.nowak."),
                login};
    return {};
}

void AccountFields::addTo(QVBoxLayout* layout, const QVariantMap& state,
                          const std::array<const char*, 4>& objects) {
    name = new QLineEdit(state.value("name").toString());
    name->setPlaceholderText(Account::tr("for example Anna Nowak"));
    login = new QLineEdit(state.value("login").toString());
    login->setPlaceholderText(Account::tr("short, for signing in"));
    password = new QLineEdit;
    password->setPlaceholderText(password_rule());
    again = new QLineEdit;
    size_t next = 0;
    for (QLineEdit* field : {name, login, password, again}) field->setObjectName(objects[next++]);
    for (QLineEdit* field : {password, again}) field->setEchoMode(QLineEdit::Password);
    auto* first = new QHBoxLayout;
    first->setSpacing(kSpace16);
    first->addLayout(make_field(Account::tr("Your name"), name));
    first->addLayout(make_field(Account::tr("Log-in name"), login));
    auto* second = new QHBoxLayout;
    second->setSpacing(kSpace16);
    second->addLayout(make_field(Account::tr("Password"), password));
    second->addLayout(make_field(Account::tr("Password again"), again));
    layout->addLayout(first);
    layout->addLayout(second);
}

FormProblem AccountFields::problem() const {
    for (QLineEdit* field : {name, login})
        if (field->text().trimmed().isEmpty())
            return {Account::tr("Give your name and a log-in name."), field};
    if (const FormProblem spaces = login_problem(login)) return spaces;
    if (const QString short_one = password_problem(password->text()); !short_one.isEmpty())
        return {short_one, password};
    if (password->text() != again->text())
        return {again->text().isEmpty() ? Account::tr("Type the password once more.")
                                        : Account::tr("The two passwords differ. Type them again."),
                again};
    return {};
}

FormProblem first_missing(std::initializer_list<QLineEdit*> fields) {
    for (QLineEdit* field : fields)
        if (field->text().trimmed().isEmpty())
            return {Account::tr("Fill in: %1.").arg(field->accessibleName()), field};
    return {};
}

db::NewUser AccountFields::user() const {
    db::NewUser user;
    user.login = login->text().trimmed().toStdString();
    user.display_name = name->text().trimmed().toStdString();
    user.password = password->text().toStdString();
    user.roles = 0;
    return user;
}

QVariantMap AccountFields::state() const {
    return {{"name", name->text()}, {"login", login->text()}};
}

}  // namespace placode::ui
