// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What sets a question apart from the page that it is asked over: a frame around it, and the page
// behind it dimmed. Window managers without title bars draw neither. And what has to wait until it
// is answered: a page must not go away under its own question.

#include <functional>

class QDialog;
class QObject;

namespace placode::ui {

/// Before the dialog is shown; frame and dimming live as long as it does. Main thread.
void frame_dialog(QDialog* dialog);

/// After something appeared in a dialog that is shown: it keeps its height by itself, and the words
/// would lie over the fields. Never makes it smaller.
void make_room(QDialog* dialog);

/// A dialog or an open list or menu waits for whoever sits here. Main thread.
[[nodiscard]] bool question_stands();

/// Does it now, or when no question stands any more; not when `receiver` has gone by then.
void when_no_question(QObject* receiver, const std::function<void()>& act);

}  // namespace placode::ui
