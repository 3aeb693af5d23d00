// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/new_person_card.h"

#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QStyle>

#include "ui/shell/account_fields.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

constexpr int kNewCard = 320;  ///< Width beside the list [px].

}  // namespace

NewPersonCard::NewPersonCard(AppContext& context, Page& page, std::function<void()> added)
    : context_(context), page_(page), whenAdded_(std::move(added)) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(tr("Add a person"), "heading"));
    name_ = new QLineEdit;
    name_->setObjectName("new_name");
    login_ = new QLineEdit;
    login_->setObjectName("new_login");
    password_ = new QLineEdit;
    password_->setObjectName("new_password");
    password_->setPlaceholderText(password_rule());
    password_->setEchoMode(QLineEdit::Password);
    fields_ = new QVBoxLayout;
    fields_->setSpacing(kSpace12);
    fields_->addLayout(make_field(tr("Name"), name_));
    fields_->addLayout(make_field(tr("Log-in name"), login_));
    fields_->addLayout(make_field(tr("First password"), password_));
    layout->addLayout(fields_);
    role_boxes_ = new QVBoxLayout;
    for (const db::Role role : {db::Role::kTrainee, db::Role::kEducator, db::Role::kCoordinator,
                                db::Role::kAdministrator}) {
        auto* box = new QCheckBox(role_names(static_cast<db::Roles>(role)));
        box->setObjectName(QString("role_%1").arg(static_cast<int>(role)));
        keep_choice(box);
        roles_.emplace_back(box, role);
        role_boxes_->addWidget(box);
    }
    role_boxes_->addStretch();
    layout->addLayout(role_boxes_);
    message_ = make_label({}, "critical");
    message_->setObjectName("add_message");
    message_->hide();
    layout->addWidget(message_);
    role_summary_ = make_label({}, "small");
    role_summary_->setObjectName("role_summary");
    layout->addWidget(role_summary_);
    QPushButton* add = make_button(context_, tr("Add the person"), "primary", "plus");
    add->setObjectName("add_person");
    connect(add, &QPushButton::clicked, this, [this] { this->add(); });
    enter_submits({name_, login_, password_}, this, [this] { this->add(); });
    hide_when_edited(message_, {name_, login_, password_});
    layout->addWidget(add);
    for (const auto& [box, role] : roles_) {
        connect(box, &QCheckBox::toggled, this, [this] { showRoles(); });
        enter_submits({box}, this, [this] { this->add(); });
    }
    resetRoles();
}

void NewPersonCard::layOut(bool wide) {
    fields_->setDirection(wide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    role_boxes_->setDirection(fields_->direction());
    role_boxes_->setSpacing(wide ? 0 : kSpace24);
    setMinimumWidth(wide ? kNewCard : 0);
    setMaximumWidth(wide ? kNewCard : QWIDGETSIZE_MAX);
}

/// Most people are trainees; what was ticked for the one before is not for the next.
void NewPersonCard::resetRoles() {
    for (const auto& [box, role] : roles_) box->setChecked(role == db::Role::kTrainee);
    showRoles();
}

db::Roles NewPersonCard::chosenRoles() const {
    db::Roles roles = 0;
    for (const auto& [box, role] : roles_)
        if (box->isChecked()) roles |= static_cast<db::Roles>(role);
    return roles;
}

/// Who is more than a trainee may see and change more: said before the button is pressed.
void NewPersonCard::showRoles() {
    const db::Roles roles = chosenRoles();
    const bool more = roles != static_cast<db::Roles>(db::Role::kTrainee);
    role_summary_->setText(roles == 0 ? tr("No role is ticked.")
                                      : tr("Will be: %1").arg(role_names(roles)));
    role_summary_->setProperty("role", more ? "warn" : "small");
    role_summary_->style()->unpolish(role_summary_);
    role_summary_->style()->polish(role_summary_);
}

void NewPersonCard::add() {
    // The second click of two that were meant as one.
    const bool empty = name_->text().isEmpty() && login_->text().isEmpty();
    if (empty && added_.isValid() && added_.elapsed() < QApplication::doubleClickInterval()) return;
    message_->hide();
    FormProblem problem = first_missing({name_, login_});
    if (!problem) problem = login_problem(login_);
    if (const auto other = !problem ? whoHas(login_->text()) : std::nullopt)
        problem = {tr("The log-in name %1 is taken: %2 has it. Choose another one.")
                       .arg(qstr(other->login), qstr(other->display_name)),
                   login_};
    if (const QString rule = password_problem(password_->text()); !problem && !rule.isEmpty())
        problem = {rule, password_};
    db::NewUser user;
    user.display_name = name_->text().trimmed().toStdString();
    user.login = login_->text().trimmed().toStdString();
    user.password = password_->text().toStdString();
    user.roles = chosenRoles();
    user.password_given = true;
    if (!problem && user.roles == 0) problem = {tr("A person needs at least one role."), nullptr};
    if (problem) {
        message_->setText(problem.text);
        message_->show();
        return go_to_field(problem.field);
    }
    context_.guard(tr("Adding the person"), [&] {
        context_.store().accounts().create(user);
        for (QLineEdit* field : {name_, login_, password_}) field->clear();
        resetRoles();
        name_->setFocus();
        whenAdded_();
        added_.start();
        Q_EMIT page_.notice(
            tr("%1 was added: %2.").arg(qstr(user.display_name), role_names(user.roles)));
    });
}

/// Whose log-in name it is; a store that does not answer says so when the person is added.
std::optional<db::UserRecord> NewPersonCard::whoHas(const QString& login) {
    std::optional<db::UserRecord> found;
    (void)context_.problemOf(
        [&] { found = context_.store().accounts().find_login(login.trimmed().toStdString()); });
    return found;
}

}  // namespace placode::ui
