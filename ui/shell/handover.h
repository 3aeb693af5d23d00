// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The screen in a participant's hands: which places are the participant's, and how the coordinator
// takes the screen back.

#include "ui/shell/pages.h"

namespace placode::ui {

/// True for what somebody without an account sees: a study's run, its questionnaires and attempts.
[[nodiscard]] bool is_participants(AppContext& context, const Place& place);

/// Asks who is signed in for the password, or for the PIN where that is enough to come back.
/// True when it was right; false when the screen stays with the participant.
[[nodiscard]] bool take_back(AppContext& context, QWidget* parent);

}  // namespace placode::ui
