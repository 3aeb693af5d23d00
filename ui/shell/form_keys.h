// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Enter in a field or on a box of a form does what its primary button does, where the form is
// complete; else the first field that is missing or wrong gets the focus and the form says why.

#include <QKeyEvent>
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

/// Enter on a box, which by itself knows the space bar only.
class EnterOnBox : public QObject {
 public:
    EnterOnBox(QWidget* box, std::function<void()> act) : QObject(box), act_(std::move(act)) {
        box->installEventFilter(this);
    }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::KeyPress) return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) return false;
        if (!key->isAutoRepeat()) act_();
        return true;
    }

 private:
    std::function<void()> act_;
};

/// @param fields line edits and boxes
/// @param act the slot of the primary button: it checks, says what is wrong and focuses the field.
inline void enter_submits(std::initializer_list<QWidget*> fields, QObject* receiver,
                          const std::function<void()>& act) {
    for (QWidget* field : fields) {
        if (auto* line = qobject_cast<QLineEdit*>(field))
            QObject::connect(line, &QLineEdit::returnPressed, receiver, act);
        else
            new EnterOnBox(field, act);
    }
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
