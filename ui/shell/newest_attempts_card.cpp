// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/newest_attempts_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <algorithm>

#include "ui/shell/attempts_table.h"
#include "ui/shell/pages.h"

namespace placode::ui {
namespace {

constexpr int kNewest = 5;  ///< Today is no list; the page Attempts has them all.

struct TodayWords {
    Q_DECLARE_TR_FUNCTIONS(TodayPage)
};

std::vector<db::AttemptRecord> newest_of_others(AppContext& context) {
    db::AttemptFilter filter;
    filter.limit = 4 * kNewest;  // the user's own are among them
    std::vector<db::AttemptRecord> found = context.store().attempts().page(filter).rows;
    std::erase_if(found,
                  [&](const db::AttemptRecord& each) { return each.user_id == context.user().id; });
    if (found.size() > kNewest) found.resize(kNewest);
    return found;
}

}  // namespace

QFrame* make_newest_attempts_card(AppContext& context, Page* page) {
    if (!context.may(db::Action::kViewAttempts, db::Scope::kOther)) return nullptr;
    const std::vector<db::AttemptRecord> newest = newest_of_others(context);
    if (newest.empty()) return nullptr;
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    auto* head = new QHBoxLayout;
    head->addWidget(make_label(TodayWords::tr("Newest attempts of trainees"), "heading"), 1);
    QPushButton* all = make_button(context, TodayWords::tr("All attempts"), "quiet", "next");
    all->setObjectName("today_all_attempts");
    QObject::connect(all, &QPushButton::clicked, page, [page] {
        Q_EMIT page->go({PageId::kAttempts, 0, {}, {}});
    });
    head->addWidget(all);
    layout->addLayout(head);
    QTableWidget* table = make_attempts_table(context, newest, AttemptColumns::kEverybody);
    table->setObjectName("today_newest");
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    int height = table->horizontalHeader()->sizeHint().height() + 2 * table->frameWidth();
    for (int row = 0; row < table->rowCount(); ++row) height += table->rowHeight(row);
    table->setFixedHeight(height + kSpace4);
    QObject::connect(table, &QTableWidget::cellActivated, page, [page, table](int row, int) {
        Q_EMIT page->go({PageId::kResult, attempt_of_row(table, row), {}, {}});
    });
    layout->addWidget(table);
    layout->addWidget(
        make_label(TodayWords::tr("Enter or double click opens the result."), "small"));
    return make_card(layout);
}

}  // namespace placode::ui
