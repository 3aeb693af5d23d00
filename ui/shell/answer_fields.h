// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The field in which a participant answers one question: points of a scale, choices, a line, a
// date. Comfortable on a touch screen; every one is named "answer_ITEM" or "answer_ITEM_VALUE".

#include <QString>
#include <functional>

#include "curriculum/questionnaire.h"
#include "ui/shell/app_context.h"

class QVBoxLayout;

namespace placode::ui {

struct AnswerField {
    const curriculum::QuestionnaireItem& item;  ///< Outlives the widgets.
    QString question;                           ///< For who hears the page instead of seeing it.
    QString given;                              ///< Answer so far; empty = none.
    QObject* owner = nullptr;                   ///< The fields speak as long as it lives.
    std::function<void(const QString&)> keep;   ///< Takes every new answer; empty = none any more.
    std::function<void()> left;                 ///< A typed answer is done: the field was left.
};

void add_answer_field(QVBoxLayout* layout, AppContext& context, const AnswerField& field);

}  // namespace placode::ui
