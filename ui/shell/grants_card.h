// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A card with which an educator grants somebody more attempts at a stage that limits them.

#include <functional>

#include "curriculum/course.h"
#include "ui/shell/app_context.h"

class QWidget;

namespace placode::ui {

/// Null where no stage of the course limits its attempts. `changed` is told what was done.
[[nodiscard]] QWidget* make_grants_card(AppContext& context, const curriculum::Course& course,
                                        std::function<void(const QString&)> changed);

}  // namespace placode::ui
