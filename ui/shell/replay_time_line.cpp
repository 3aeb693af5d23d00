// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_time_line.h"

#include <QCoreApplication>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "reports/attempt_figures.h"
#include "reports/task_scope.h"
#include "reports/words.h"
#include "ui/shell/ledger_view.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// In the context of the page that the card is on.
struct TimeLineWords {
    Q_DECLARE_TR_FUNCTIONS(WatchPage)
};

/// The same entries as a list, for keyboards and screen readers.
QTableWidget* event_table(LedgerView* ledger, const std::function<void(double)>& jump) {
    QTableWidget* table = make_table(
        {TimeLineWords::tr("Time"), TimeLineWords::tr("What"), TimeLineWords::tr("Where")},
        TimeLineWords::tr("Entries of the damage ledger"));
    table->setObjectName("ledger_table");
    table->setSortingEnabled(false);
    const auto& entries = ledger->picture().entries;
    table->setRowCount(static_cast<int>(entries.size()));
    for (size_t i = 0; i < entries.size(); ++i) {
        const int row = static_cast<int>(i);
        table->setItem(
            row, 0, make_number_cell(reports::minute_second(entries[i].from_s), entries[i].from_s));
        QString words = reports::ledger_words(entries[i]);
        if (entries[i].critical) words += " · " + TimeLineWords::tr("critical");
        table->setItem(row, 1, make_cell(words));
        table->setItem(row, 2, make_cell(reports::place_words(entries[i])));
    }
    fit_columns(table, 1);
    table->setFixedHeight(std::min(5, std::max(1, table->rowCount())) * kTouchTarget + 48);
    table->setVisible(!entries.empty());
    QObject::connect(table, &QTableWidget::cellActivated, ledger, [ledger, jump](int row, int) {
        jump(std::max(0.0, ledger->picture().entries[static_cast<size_t>(row)].from_s - kLeadS));
    });
    QObject::connect(table, &QTableWidget::currentCellChanged, ledger,
                     [ledger](int row) { ledger->select(row); });
    ledger->selected = [table](int entry) {
        const QSignalBlocker quiet(table);
        table->selectRow(entry);
    };
    return table;
}

}  // namespace

TimeLine make_time_line(AppContext& context, const sim::Recording& recording,
                        const std::function<void(double time_s)>& jump) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(make_label(TimeLineWords::tr("Click the time line to go there"), "heading"));
    reports::LedgerPicture picture =
        reports::ledger_picture(recording, reports::scope_of(recording.header));
    auto* ledger = new LedgerView(context, std::move(picture));
    ledger->setObjectName("ledger");
    layout->addWidget(ledger);
    ledger->chosen = [jump](double time_s, int entry) {
        jump(entry < 0 ? time_s : std::max(0.0, time_s - kLeadS));
    };
    layout->addWidget(event_table(ledger, jump));
    return {make_card(layout), ledger};
}

}  // namespace placode::ui
