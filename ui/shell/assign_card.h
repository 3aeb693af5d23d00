// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A card with which an educator gives a course to a person or a group, with dates, and ends it.

#include <functional>

#include "ui/shell/app_context.h"

class QWidget;

namespace placode::ui {

/// `changed` is told what was done, in words, after each change.
[[nodiscard]] QWidget* make_assign_card(AppContext& context, const std::string& course_id,
                                        std::function<void(const QString&)> changed);

}  // namespace placode::ui
