// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which fields the editor asks for in a study, its steps, a questionnaire and its questions.

#include "ui/shell/definition_form.h"

namespace placode::ui {

class AppContext;

[[nodiscard]] std::vector<FormField> study_fields();
[[nodiscard]] std::vector<FormField> consent_fields();
[[nodiscard]] std::vector<FormField> arms_fields();
[[nodiscard]] std::vector<FormField> step_fields(AppContext& context);
[[nodiscard]] std::vector<FormField> questionnaire_fields();
[[nodiscard]] std::vector<FormField> item_fields();

/// What a list of steps or items calls an element: "procedure_1 (Procedure)".
/// Of a definition's text, in a language or in English; `id` when there is none.
[[nodiscard]] QString definition_title(const std::string& json, const std::string& id,
                                       const QString& language);
[[nodiscard]] QString element_name(const OrderedJson& element);

/// The least definition that is right.
[[nodiscard]] QString empty_definition(bool study);
/// A further step or question with an id of its own.
[[nodiscard]] OrderedJson new_element(bool study, size_t number);

}  // namespace placode::ui
