// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pages of studies share: which study, and how it is called.

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <functional>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// Title of the published protocol, else the id.
[[nodiscard]] QString study_title(AppContext& context, const std::string& study);

/// Of many with one question, in their order.
[[nodiscard]] QStringList study_titles(AppContext& context, const std::vector<std::string>& ids);

/// `wanted` if it is among `ids`, else the one chosen last, else the first; empty = there is none.
/// Remembered for the other pages.
[[nodiscard]] std::string chosen_study(AppContext& context, const std::vector<std::string>& ids,
                                       const QString& wanted);

/// nullptr when there is nothing to choose. Data of an entry: the id.
[[nodiscard]] QComboBox* make_study_chooser(AppContext& context,
                                            const std::vector<std::string>& ids,
                                            const std::string& chosen);

/// When a step's attempt ends by itself [s], as the simulator is told: the step's limit and the
/// task's own, whichever is less; 0 = neither has one. Throws DefinitionError for an unknown task.
[[nodiscard]] double step_limit_s(const curriculum::StudyStep& step);

/// A line without a label beside it: `words` stand in it and are its name for screen readers.
[[nodiscard]] QLineEdit* make_line(const char* object_name, const QString& words,
                                   bool secret = false);

/// A button of `page` that does `work`.
[[nodiscard]] QPushButton* make_action(AppContext& context, const QObject* page,
                                       const QString& text, const char* role, const QString& icon,
                                       const char* object_name, const std::function<void()>& work);

}  // namespace placode::ui
