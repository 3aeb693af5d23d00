// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a study's records are kept, and the button that erases those whose time is over.

#include <functional>
#include <string>

#include "ui/shell/pages.h"

namespace placode::ui {

/// nullptr where the protocol does not say how long, or nobody has records.
/// @param erased shows the page anew after the records of these codes were erased, and where they
/// may still be.
[[nodiscard]] QWidget* make_retention_card(AppContext& context, Page& page,
                                           const std::string& study,
                                           const std::function<void(const QString& codes)>& erased);

}  // namespace placode::ui
