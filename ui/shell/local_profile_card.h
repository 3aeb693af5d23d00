// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// My account for who came in without one: makes an account of the local profile.

#include "ui/shell/pages.h"

namespace placode::ui {

[[nodiscard]] QWidget* make_local_profile_card(AppContext& context, Page* page);

}  // namespace placode::ui
