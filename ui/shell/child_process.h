// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the shell's launchers of our other programs have in common.

namespace placode::ui {

/// How long a program of ours may take to start, or to close its recording after Stop [ms].
inline constexpr int kPatienceMs = 5000;

}  // namespace placode::ui
