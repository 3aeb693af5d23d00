// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Closing the window: what would be lost by it, and what goes on.
#include <QCloseEvent>
#include <utility>

#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"

namespace placode::ui {

bool MainWindow::waitsForWork() {
    if (!context_.busy()) return false;
    const bool when_done =
        confirm(this, tr("Close Placode when its work is done?"),
                tr("%1: this is still running. Placode closes by itself when it is done; if it "
                   "fails, Placode stays open.")
                    .arg(context_.busyWith()),
                tr("Close when done"), tr("Stay here"));
    if (!context_.busy()) return !when_done;  // It ended while the question stood.
    if (when_done && !closes_when_done_) {
        closes_when_done_ = true;
        context_.whenIdle(this, [this] {
            if (std::exchange(closes_when_done_, false)) close();
        });
    }
    return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool stay =
        (page_ && !page_->mayLeave()) || !mayTakeBack() || waitsForWork() ||
        (context_.launcher().running() &&
         !confirm(this, tr("Close Placode while an attempt is running?"),
                  tr("The attempt ends. Its recording is kept and offered at the next start."),
                  tr("Close"), tr("Stay here")));
    if (stay) return event->ignore();
    context_.settings().setValue(kGeometrySetting, saveGeometry());
    event->accept();
}

}  // namespace placode::ui
