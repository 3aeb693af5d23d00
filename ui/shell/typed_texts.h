// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What somebody has typed into the fields of a page and not yet saved, kept while the page is built
// anew: in the other language, in the other theme, after a lock.

#include <QVariantMap>

class QWidget;

namespace placode::ui {

/// By the names of the fields. Without what a field hides: passwords are typed again.
[[nodiscard]] QVariantMap typed_texts(const QWidget& page);

/// Into the fields of the same names that the page itself left empty.
void type_again(const QWidget& page, const QVariantMap& texts);

}  // namespace placode::ui
