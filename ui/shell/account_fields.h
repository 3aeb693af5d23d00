// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a new account needs, wherever one is made: name, log-in name and a password typed twice.

#include <QLineEdit>
#include <QVBoxLayout>
#include <QVariantMap>

#include "db/store.h"
#include "ui/shell/form_keys.h"

namespace placode::ui {

/// "at least 10 characters": said before somebody types.
[[nodiscard]] QString password_rule();
/// Why a new password will not do, in the reader's language; empty when it may.
[[nodiscard]] QString password_problem(const QString& password);

/// What is wrong with a new log-in name: spaces, which nobody sees at the end of it.
[[nodiscard]] FormProblem login_problem(QLineEdit* login);

struct AccountFields {
    QLineEdit *name = nullptr, *login = nullptr, *password = nullptr, *again = nullptr;

    /// Adds two rows to `layout`. `state` is what was typed before a page was built again; objects
    /// are named NAME, LOGIN, PASSWORD, AGAIN for tests.
    void addTo(QVBoxLayout* layout, const QVariantMap& state,
               const std::array<const char*, 4>& objects);
    /// What is missing or wrong, and where; nothing when an account can be made.
    [[nodiscard]] FormProblem problem() const;
    /// Without roles.
    [[nodiscard]] db::NewUser user() const;
    /// Never the password.
    [[nodiscard]] QVariantMap state() const;
};

}  // namespace placode::ui
