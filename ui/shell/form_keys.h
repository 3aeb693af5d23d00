// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Enter in a field of a form does what its primary button does, where the form is complete; else
// the first field that is missing or wrong gets the focus and the form says why.

#include <QLineEdit>
#include <functional>
#include <initializer_list>

namespace placode::ui {

/// What stands in the way of a form; no text = nothing does.
struct FormProblem {
    QString text;
    QLineEdit* field = nullptr;  ///< Where it is mended.
    explicit operator bool() const { return !text.isEmpty(); }
};

/// @param act the slot of the primary button: it checks, says what is wrong and focuses the field.
inline void enter_submits(std::initializer_list<QLineEdit*> fields, QObject* receiver,
                          const std::function<void()>& act) {
    for (QLineEdit* field : fields)
        QObject::connect(field, &QLineEdit::returnPressed, receiver, act);
}

/// What was said of these fields goes when one of them is mended.
inline void hide_when_edited(QWidget* message, std::initializer_list<QLineEdit*> fields) {
    for (QLineEdit* field : fields)
        QObject::connect(field, &QLineEdit::textEdited, message, &QWidget::hide);
}

/// The first empty field of some, with what is said then: "Fill in: Name".
[[nodiscard]] FormProblem first_missing(std::initializer_list<QLineEdit*> fields);

/// Focus, and what is in it selected, so that typing replaces it.
inline void go_to_field(QLineEdit* field) {
    if (field == nullptr) return;
    field->setFocus(Qt::OtherFocusReason);
    field->selectAll();
}

}  // namespace placode::ui
