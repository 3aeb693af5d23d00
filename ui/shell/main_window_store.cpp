// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in place of any page while there is no store to open. One that was here before is
// gone: said, with the ways on, instead of a first start in which whoever comes first becomes
// administrator. One of an older program: brought up to date, which takes its time.
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/shell/details.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr int kCardPx = 620;  ///< Width of the questions.

QVBoxLayout* new_card() {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace16);
    return layout;
}

QString words_of(db::UpdatePart part) {
    switch (part) {
        case db::UpdatePart::kCheck:
            return MainWindow::tr("The store is being read from beginning to end.");
        case db::UpdatePart::kCopy:
            return MainWindow::tr("A copy of it is being made.");
        case db::UpdatePart::kTables:
            return MainWindow::tr("Its tables are being changed.");
        case db::UpdatePart::kSeals:
            return MainWindow::tr("What it holds is being sealed.");
    }
    return {};
}

}  // namespace

QPushButton* MainWindow::addWay(QVBoxLayout* layout, const Way& way,
                                const std::function<void()>& act) {
    QPushButton* button = make_button(context_, way.text, way.kind, way.icon);
    button->setObjectName(way.name);
    connect(button, &QPushButton::clicked, this, act, Qt::QueuedConnection);
    layout->addWidget(button);
    return button;
}

QWidget* MainWindow::showCard(QVBoxLayout* layout) {
    if (shown_) shown_->deleteLater();
    if (shown_) shown_->hide();
    QFrame* card = make_card(layout);
    layout->setContentsMargins(kSpace32, kSpace32, kSpace32, kSpace32);
    card->setFixedWidth(kCardPx);
    auto* blank = new QWidget;
    auto* column = new QVBoxLayout(blank);
    column->addStretch(1);
    // Between stretches, not aligned: a layout that aligns does not ask how high lines of text are.
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(card);
    row->addStretch();
    column->addLayout(row);
    column->addStretch(2);
    page_ = nullptr;
    shown_ = blank;
    content_->addWidget(blank);
    updateFrame();
    return blank;
}

void MainWindow::showMissingStore() {
    QVBoxLayout* layout = new_card();
    layout->addWidget(make_label(tr("The store is not where it was"), "display"));
    layout->addWidget(make_label(
        tr("Accounts and attempts were kept in a file that is gone or empty now. Perhaps a disk is "
           "not connected, or somebody moved the file. Nothing was changed."),
        "muted"));
    layout->addWidget(
        new Details(context_, qstr(context_.storeUrl()).section('?', 0, 0).remove("sqlite:")));
    const auto go_on = [this](bool done) {
        if (!done) return;
        notices_->closeAll();
        begin();
    };
    const QString filter = tr("Placode store (*.db)");
    QPushButton* first = addWay(layout, {tr("Try again"), "primary", "again", "try_again"},
                                [go_on] { go_on(true); });
    addWay(layout, {tr("Show where it is now"), "secondary", "", "choose_store"},
           [this, go_on, filter] {
               const QString file =
                   context_.askOpenFile(this, tr("Where the store is now"), filter);
               go_on(!file.isEmpty() && context_.chooseStore(file));
           });
    addWay(layout, {tr("Restore a backup"), "secondary", "", "restore_backup"}, [this, filter] {
        const QString file = context_.askOpenFile(this, tr("Restore a backup"), filter);
        if (!file.isEmpty()) restoreFrom(file);
    });
    addWay(layout, {tr("Begin anew, without any data"), "danger", "", "begin_anew"}, [this, go_on] {
        go_on(confirm(this, tr("Begin with an empty store?"),
                      tr("Whoever creates the first account becomes administrator. The old data "
                         "does not come back by this."),
                      tr("Begin anew")) &&
              context_.beginAnew());
    });
    showCard(layout)->setEnabled(!context_.restoring());
    first->setFocus();
}

void MainWindow::restoreFrom(const QString& file) {
    context_.restoreBackup(file, this, [this](bool done) {
        if (!done) return showMissingStore();
        notices_->closeAll();
        begin();
        // The store that knew who was erased is always gone here.
        notices_->showNotice(
            tr("The backup is in place. Whoever was erased since it was made is back, and so "
               "are the data of participants who withdrew since: look at your list of "
               "requests, and erase them again."));
    });
    shown_->setEnabled(false);
}

void MainWindow::updateStore() {
    context_.updateStore(this, [this](bool done, const QString& copy) {
        if (!done) return showUpdateFailed(copy);
        notices_->closeAll();
        begin();
    });
    showUpdating();
}

void MainWindow::showUpdating() {
    QVBoxLayout* layout = new_card();
    layout->addWidget(make_label(tr("The store is being brought up to date"), "display"));
    layout->addWidget(make_label(
        tr("An older version of Placode made it. With many attempts this takes minutes. Do not "
           "switch the computer off; Placode goes on by itself."),
        "muted"));
    QLabel* part = make_label({});
    part->setObjectName("update_part");
    const auto say = [this, part] {
        if (const auto& now = context_.updating()) part->setText(words_of(*now));
    };
    say();
    connect(&context_, &AppContext::updateReached, part, say);
    layout->addWidget(part);
    auto* bar = new QProgressBar;
    bar->setRange(0, 0);  // Nobody knows how long it takes.
    bar->setTextVisible(false);
    bar->setAccessibleName(tr("The store is being brought up to date"));
    layout->addWidget(bar);
    showCard(layout);
}

void MainWindow::showUpdateFailed(const QString& copy) {
    QVBoxLayout* layout = new_card();
    layout->addWidget(make_label(tr("The store could not be brought up to date"), "display"));
    layout->addWidget(make_label(
        copy.isEmpty()
            ? tr("No data is lost.")
            : tr("No data is lost. A copy of the store as it was before is kept: whoever "
                 "helps finds its place in the details."),
        "muted"));
    auto* details = new Details(context_, copy);
    details->setObjectName("update_copy");
    layout->addWidget(details);
    const auto again = [this] {
        notices_->closeAll();
        begin();
    };
    QPushButton* first = addWay(layout, {tr("Try again"), "primary", "again", "try_again"}, again);
    if (context_.storeWasChosen())
        addWay(layout, {tr("Use this computer's own store"), "quiet", "", "use_own_store"},
               [this, again] {
                   context_.useOwnStore();
                   again();
               });
    showCard(layout);
    first->setFocus();
}

}  // namespace placode::ui
