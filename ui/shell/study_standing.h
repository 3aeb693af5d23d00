// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is to be known of one participant in the list of a study.

#include <QString>

#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// A sentence for each thing: what was skipped, what was idle, what is to be done again and why.
[[nodiscard]] QString standing_remark(const AppContext& context,
                                      const curriculum::StudyProtocol& protocol,
                                      const db::Progress& progress);

}  // namespace placode::ui
