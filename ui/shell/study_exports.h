// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What goes out of a study: its pages of data and results, the export with or without names, and
// the report.

#include <string>

#include "ui/shell/pages.h"

namespace placode::ui {

/// A row of buttons for who may export; `page` speaks and leads on for it.
[[nodiscard]] QWidget* make_study_exports(AppContext& context, Page& page,
                                          const std::string& study);

}  // namespace placode::ui
