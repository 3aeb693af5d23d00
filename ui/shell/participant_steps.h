// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a participant sees after answering: the answers once more before they are submitted, and the
// thanks; and what is said about an answer that cannot be taken.

#include <functional>

#include "curriculum/questionnaire.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// A number as people read it, with its unit in their language. Every other unit than "years" is a
/// symbol, the same everywhere.
[[nodiscard]] QString with_unit(const QString& number, const std::string& unit);

/// What would be right, in the words of the question; empty when `answer` is, or there is none.
[[nodiscard]] QString answer_problem(const AppContext& context,
                                     const curriculum::QuestionnaireItem& item,
                                     const QString& answer);

/// With the buttons "change_answers" and "submit_answers".
/// @param mark of a question that is shown: "A1".
[[nodiscard]] QWidget* make_review_step(
    AppContext& context, const curriculum::Questionnaire& questionnaire,
    const curriculum::Answers& answers,
    const std::function<QString(const curriculum::QuestionnaireItem&)>& mark);

/// With the button "participant_done".
[[nodiscard]] QWidget* make_thanks_step(AppContext& context, const QString& code);

}  // namespace placode::ui
