// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the fetoscope shows when an attempt begins: the work, and not the lesion beside it.

#include "curriculum/task.h"

namespace placode::curriculum {

/// Points the scopes of `task.scene` (`ToolSpec::look_at_m`) at the middle of its slit, else of the
/// marks that its steps have in the field's plane, else of the lesion.
void aim_scopes(Task& task);

}  // namespace placode::curriculum
