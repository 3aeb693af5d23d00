// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a study's records are kept, and the button that erases those whose time is over.

#include <functional>
#include <string>

#include "ui/shell/pages.h"

namespace placode::ui {

/// nullptr where the protocol does not say how long, or nobody has records.
/// @param again shows the page anew after something was erased.
[[nodiscard]] QWidget* make_retention_card(AppContext& context, Page& page,
                                           const std::string& study,
                                           const std::function<void()>& again);

}  // namespace placode::ui
