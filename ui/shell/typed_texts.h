// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What somebody has typed into the fields of a page or chosen there and not yet saved, kept while
// the page is built anew: in the other language, in the other theme, after a lock.

#include <QVariantMap>

class QWidget;

namespace placode::ui {

/// What is chosen there is kept with what is typed: for a box, list, number, day or row of a form
/// that does nothing before its button is pressed, and for a line that begins with a text of its
/// own.
/// @param field has a name.
void keep_choice(QWidget* field);

/// By the names of the fields. Without what a field hides: passwords are typed again.
[[nodiscard]] QVariantMap typed_texts(const QWidget& page);

/// Those of them for which the page has no field, yet.
[[nodiscard]] QVariantMap without_field(const QWidget& page, const QVariantMap& texts);

/// Into the fields of the same names that the page itself left empty or that keep_choice() named.
void type_again(const QWidget& page, const QVariantMap& texts);

}  // namespace placode::ui
