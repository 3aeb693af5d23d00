// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study as participants will go through it, and the questionnaires it needs.

#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// Consent, and every step with its texts and questions, one below the other.
[[nodiscard]] QWidget* make_study_preview(AppContext& context,
                                          const curriculum::StudyProtocol& study);

/// What a participant does not see but who builds a questionnaire must: the condition, reverse
/// keying, scale scores, "names a person". Empty when there is nothing.
[[nodiscard]] QString item_notes(AppContext& context,
                                 const curriculum::Questionnaire& questionnaire,
                                 const curriculum::QuestionnaireItem& item);

/// The newest published version, else the shipped one. Throws DefinitionError.
[[nodiscard]] curriculum::Questionnaire newest_questionnaire(AppContext& context,
                                                             const std::string& id);
/// Throws DefinitionError naming the step whose questionnaire or task is not there.
void check_study_questionnaires(AppContext& context, const curriculum::StudyProtocol& study);
/// True when `json` (a study or questionnaire) does not call itself a draft, or who publishes it
/// knows and wants it so. Without a question in a text that is ready.
[[nodiscard]] bool confirm_draft(AppContext& context, QWidget* parent, const std::string& json);
/// Keeps the texts of the questionnaires a study asks for.
void publish_questionnaires(AppContext& context, const curriculum::StudyProtocol& study);

}  // namespace placode::ui
