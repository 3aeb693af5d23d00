// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// For who teaches: the newest attempts of trainees, on the page Today.

#include "ui/shell/parts.h"

namespace placode::ui {

class Page;

/// Nothing where the user sees no attempts of others, or nobody has made one.
[[nodiscard]] QFrame* make_newest_attempts_card(AppContext& context, Page* page);

}  // namespace placode::ui
