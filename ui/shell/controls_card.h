// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which key and button does what in the simulator, for one account at this computer.

#include "haptics/control_layout.h"
#include "ui/shell/pages.h"

namespace placode::ui {

/// Of whoever is signed in; as delivered where nothing was chosen, or nothing that can be read.
[[nodiscard]] haptics::ControlLayout own_layout(const AppContext& context);

/// My account: shows it and changes it. Kept at once.
[[nodiscard]] QWidget* make_controls_card(AppContext& context);

}  // namespace placode::ui
