// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables that stay within their page.

#include <QTableWidget>

namespace placode::ui {

/// Narrows the widest columns, instead of letting the table scroll sideways, whenever it is smaller
/// than its content; what is cut off ends in dots and stands in the tool tip. `stretch` is the
/// column that takes the rest, as for fit_columns(), after which this is called.
void keep_within(QTableWidget* table, int stretch);

}  // namespace placode::ui
