// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A store that was here before is gone: said, with the ways on, instead of a first start in which
// whoever comes first becomes administrator.
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/shell/details.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr int kCardPx = 620;  ///< Width of the questions.

}  // namespace

void MainWindow::showMissingStore() {
    if (shown_) shown_->deleteLater();
    if (shown_) shown_->hide();
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace16);
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
    const auto add = [&](const QString& text, const char* kind, const char* icon, const char* name,
                         const std::function<void()>& act) {
        QPushButton* button = make_button(context_, text, kind, icon);
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, act, Qt::QueuedConnection);
        layout->addWidget(button);
        return button;
    };
    const QString filter = tr("Placode store (*.db)");
    QPushButton* first =
        add(tr("Try again"), "primary", "again", "try_again", [go_on] { go_on(true); });
    add(tr("Show where it is now"), "secondary", "", "choose_store", [this, go_on, filter] {
        const QString file = context_.askOpenFile(this, tr("Where the store is now"), filter);
        go_on(!file.isEmpty() && context_.chooseStore(file));
    });
    add(tr("Restore a backup"), "secondary", "", "restore_backup", [this, go_on, filter] {
        const QString file = context_.askOpenFile(this, tr("Restore a backup"), filter);
        if (file.isEmpty()) return;
        context_.restoreBackup(file, this, [this, go_on](bool done) {
            if (!done) return showMissingStore();
            go_on(true);
            // The store that knew who was erased is always gone here.
            notices_->showNotice(
                tr("The backup is in place. Whoever was erased since it was made is back, and so "
                   "are the data of participants who withdrew since: look at your list of "
                   "requests, and erase them again."));
        });
        shown_->setEnabled(false);
    });
    add(tr("Begin anew, without any data"), "danger", "", "begin_anew", [this, go_on] {
        go_on(confirm(this, tr("Begin with an empty store?"),
                      tr("Whoever creates the first account becomes administrator. The old data "
                         "does not come back by this."),
                      tr("Begin anew")) &&
              context_.beginAnew());
    });
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
    blank->setEnabled(!context_.restoring());
    page_ = nullptr;
    shown_ = blank;
    content_->addWidget(blank);
    updateFrame();
    first->setFocus();
}

}  // namespace placode::ui
