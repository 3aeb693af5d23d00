// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/analysis_table.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <algorithm>

#include "ui/shell/parts.h"

namespace placode::ui {

QTableWidget* make_analysis_table(const reports::Analysis& found) {
    QStringList head;
    for (const std::string& each : found.head)
        head << QCoreApplication::translate("Analysis", each.c_str());
    QTableWidget* table = make_table(head, qstr(found.title));
    table->setObjectName("analysis_table");
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(found.rows.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const auto& cells = found.rows[static_cast<size_t>(row)];
        for (size_t c = 0; c < cells.size(); ++c)
            table->setItem(row, static_cast<int>(c),
                           cells[c].value ? make_number_cell(qstr(cells[c].text), *cells[c].value)
                                          : make_cell(qstr(cells[c].text)));
    }
    fit_columns(table, 0);
    table->horizontalHeader()->setMinimumSectionSize(64);
    table->setColumnWidth(0, 240);
    table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);  // as computed
    table->setSortingEnabled(true);
    table->setMinimumHeight(std::min(10, table->rowCount() + 1) * kTouchTarget + 10);
    return table;
}

}  // namespace placode::ui
