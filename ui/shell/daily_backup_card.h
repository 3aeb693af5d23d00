// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Backup and health: the backup that systemd makes every day (packaging/placode-backup.timer),
// switched on and off, and what became of the newest one.

#include "ui/shell/pages.h"

namespace placode::ui {

[[nodiscard]] QWidget* make_daily_backup_card(AppContext& context);

}  // namespace placode::ui
