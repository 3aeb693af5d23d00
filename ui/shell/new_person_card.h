// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The card with which an administrator adds a person: name, log-in name, first password, roles.

#include <QElapsedTimer>
#include <QFrame>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ui/shell/pages.h"

class QBoxLayout;
class QCheckBox;
class QLabel;
class QLineEdit;

namespace placode::ui {

class NewPersonCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(PeoplePage)
 public:
    /// @param page speaks for the card.
    /// @param added is called when somebody was added.
    NewPersonCard(AppContext& context, Page& page, std::function<void()> added);

    /// Beside a list, or below it with the fields side by side.
    void layOut(bool wide);

 private:
    void resetRoles();
    void showRoles();
    [[nodiscard]] db::Roles chosenRoles() const;
    void add();
    [[nodiscard]] std::optional<db::UserRecord> whoHas(const QString& login);

    AppContext& context_;
    Page& page_;
    std::function<void()> whenAdded_;
    QElapsedTimer added_;  ///< Since somebody was added.
    std::vector<std::pair<QCheckBox*, db::Role>> roles_;
    QBoxLayout *fields_ = nullptr, *role_boxes_ = nullptr;
    QLabel *role_summary_ = nullptr, *message_ = nullptr;
    QLineEdit *name_ = nullptr, *login_ = nullptr, *password_ = nullptr;
};

}  // namespace placode::ui
