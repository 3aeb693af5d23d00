// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a field of a definition's form shows of its JSON, and what it reads back from what was
// typed.

#include <QString>

#include "ui/shell/definition_form.h"

namespace placode::ui::form_text {

/// Empty for what is no text.
[[nodiscard]] QString text_of(const OrderedJson& json);
/// Of {"en": .., "pl": ..}, and back; null where both are empty.
[[nodiscard]] QString local_of(const OrderedJson& json, const char* language);
[[nodiscard]] OrderedJson local(const QString& english, const QString& polish);

/// A line of a list of objects, and back. Keys that the line does not show stay as in `before`.
[[nodiscard]] QString line_of(const OrderedJson& element, FormFieldKind kind);
[[nodiscard]] OrderedJson element_of(const QString& line, FormFieldKind kind,
                                     const OrderedJson& before);

/// The text of a field of one line, and back; an empty one is null. A number that is none stays a
/// text, and the check says so.
[[nodiscard]] QString shown(const OrderedJson& value, FormFieldKind kind);
[[nodiscard]] OrderedJson read(const QString& text, FormFieldKind kind);

}  // namespace placode::ui::form_text
