// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables that stay within their page.

#include <QTableWidget>
#include <vector>

namespace placode::ui {

/// How a table gives way when its page is narrower than its content.
struct TableFit {
    int stretch = 0;             ///< Column that takes the rest, as for fit_columns().
    int least_px = 110;          ///< Width below which columns are left out.
    int keep_px = 110;           ///< Width that it keeps while the others are narrowed.
    std::vector<int> drop = {};  ///< Columns to leave out, the first one first: what a click
                                 ///< on the row shows anyway.
};

/// Leaves out columns, then narrows the widest ones, instead of letting the table scroll sideways;
/// what is cut off ends in dots and stands in the tool tip. Called after fit_columns().
void keep_within(QTableWidget* table, const TableFit& fit);

/// Titles from column `first` on in up to three lines, right-aligned, broken at words whenever the
/// width of a column changes; what has no room ends in dots and stands in the tool tip.
void wrap_titles(QTableWidget* table, int first);

}  // namespace placode::ui
