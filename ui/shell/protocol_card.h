// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study with a protocol on the studies page.

#include "ui/shell/pages.h"

namespace placode::ui {

/// @param study its id; empty = the first. Emits `go` and `notice` of `page`.
/// @param participant the code that is selected in the list; empty = the first.
[[nodiscard]] QWidget* make_protocol_card(AppContext& context, Page& page, const QString& study,
                                          const QString& participant);

}  // namespace placode::ui
