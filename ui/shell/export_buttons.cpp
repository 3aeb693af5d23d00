// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/export_buttons.h"

#include <QBoxLayout>
#include <utility>

#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {

void ExportRun::run(const std::function<void()>& work) {
    try {
        work();
    } catch (const reports::ExportStopped&) {
        stopped = true;
    }
}

ExportButtons::ExportButtons(AppContext& context, Page& page, QBoxLayout* row)
    : context_(context),
      page_(page),
      cancel_(make_button(context, tr("Cancel"), "secondary", "close")) {
    cancel_->setObjectName("cancel_export");
    QObject::connect(cancel_, &QPushButton::clicked, cancel_, [this] {
        run_->stop = true;
        cancel_->setEnabled(false);
    });
    cancel_->hide();
    row->addWidget(cancel_);
}

std::shared_ptr<ExportRun> ExportButtons::begin() {
    run_ = std::make_shared<ExportRun>();
    show(true);
    return run_;
}

bool ExportButtons::ended(const ExportRun& run) {
    show(false);
    if (run.stopped) Q_EMIT page_.notice(tr("Cancelled; nothing was written."));
    return !run.stopped;
}

reports::ExportPace ExportButtons::paceOf(
    const std::shared_ptr<ExportRun>& run,
    std::function<QString(const reports::ExportPart&)> words) const {
    return {[run] { return run->stop.load(); },
            [context = &context_, words = std::move(words)](const reports::ExportPart& part) {
                Q_EMIT context->busyChanged(words(part));
            }};
}

void ExportButtons::show(bool running) {
    for (QPushButton* each : begin_) each->setVisible(!running);
    cancel_->setEnabled(true);
    cancel_->setVisible(running);
}

}  // namespace placode::ui
