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
    int least_column_px = 52;    ///< Nothing is narrowed below this.
    int give_way_px = 0;         ///< Down to this the others make room until the column that
                                 ///< takes the rest has least_px; 0: it has keep_px alone.
    std::vector<int> drop = {};  ///< Columns to leave out, the first one first: what a click
                                 ///< on the row shows anyway.
};

/// Leaves out columns, then narrows the widest ones, instead of letting the table scroll sideways;
/// what is cut has dots in its middle and stands in the tool tip. Columns of buttons are not
/// narrowed. fit_columns() sees to it without columns to leave out; called after it for another
/// fit.
void keep_within(QTableWidget* table, const TableFit& fit);
/// When the page is built, unless it has called keep_within() by then.
void keep_within_later(QTableWidget* table, int stretch);

/// Rows as high as their text needs on lines of the columns' widths: nothing is cut off. Called
/// after keep_within(). @param shown rows that the table has room for before it scrolls.
void wrap_rows(QTableWidget* table, int shown);

/// A header whose titles from column `first` on stand in up to three lines, broken at words, or
/// upright where columns are narrow; what has no room ends in dots and stands in the tool tip.
/// Called before fit_columns(), and wrap_titles() once the widths are set.
void use_title_header(QTableWidget* table, int first);
void wrap_titles(QTableWidget* table);

}  // namespace placode::ui
