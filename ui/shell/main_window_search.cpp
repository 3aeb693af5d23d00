// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Search over everything, and the page that a user left last.
#include <QToolButton>

#include "ui/shell/help_window.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"
#include "ui/shell/search_box.h"

namespace placode::ui {

void MainWindow::openSearch() {
    // While a participant is at the screen nothing else can be opened.
    if (!context_.signedIn() || handedOver()) return;
    if (search_ && search_->isVisible()) return;
    std::vector<Findable> pages;
    for (const auto& [button, page] : rail_buttons_)
        pages.push_back(
            {Findable::Kind::kPage, button->accessibleName(), {}, {page, 0, {}, {}}, {}, {}});
    pages.push_back(
        {Findable::Kind::kPage, tr("My account"), {}, {PageId::kAccount, 0, {}, {}}, {}, {}});
    pages.push_back({Findable::Kind::kPage,
                     tr("Unfinished attempts"),
                     {},
                     {PageId::kRecovery, 0, {}, {}},
                     {},
                     {}});
    auto* box = new SearchBox(context_, std::move(pages), this);
    search_ = box;
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &SearchBox::chosen, this, &MainWindow::open, Qt::QueuedConnection);
    connect(
        box, &SearchBox::manualChosen, this,
        [this](const QString& page) { open_help(context_, this, page); }, Qt::QueuedConnection);
    box->open();
}

void MainWindow::rememberPlace() {
    if (!context_.signedIn()) return;
    // Only what can be opened again without a context: the rail's pages.
    for (const auto& [button, page] : rail_buttons_)
        if (page == place_.page)
            context_.setStoreSetting(QString("last_page/%1").arg(context_.user().id),
                                     button->objectName());
}

Place MainWindow::lastPlace() const {
    const QString last =
        context_.storeSetting(QString("last_page/%1").arg(context_.user().id)).toString();
    for (const auto& [button, page] : rail_buttons_)
        if (button->objectName() == last) return {page, 0, {}, {}};
    return home();
}

}  // namespace placode::ui
