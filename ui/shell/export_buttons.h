// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports that take a while: what begins one, and the Cancel that stands in its place meanwhile.

#include <QCoreApplication>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "reports/export_pace.h"

class QBoxLayout;
class QPushButton;

namespace placode::ui {

class AppContext;
class Page;

/// One export. Shared by the page and the thread that exports.
struct ExportRun {
    std::atomic<bool> stop{false};  ///< Somebody wants it to end.
    bool stopped = false;           ///< It has ended by that; nothing was handed out.
    size_t files = 0;               ///< That were written.

    /// Does `work`, which asks a pace of paceOf(). Throws what it throws, but for ExportStopped.
    void run(const std::function<void()>& work);
};

/// One export at a time. The page that holds this lives at least as long as the buttons; one that
/// is left ends nothing: the export goes on.
class ExportButtons {
    Q_DECLARE_TR_FUNCTIONS(ExportButtons)
 public:
    /// Adds the Cancel to `row`.
    ExportButtons(AppContext& context, Page& page, QBoxLayout* row);
    void add(QPushButton* begins) { begin_.push_back(begins); }

    [[nodiscard]] std::shared_ptr<ExportRun> begin();
    /// Main thread, once it is over. False: it was cancelled, which is said here.
    [[nodiscard]] bool ended(const ExportRun& run);
    /// @param words what the window says meanwhile; called in the thread that exports.
    [[nodiscard]] reports::ExportPace paceOf(
        const std::shared_ptr<ExportRun>& run,
        std::function<QString(const reports::ExportPart&)> words) const;

 private:
    void show(bool running);

    AppContext& context_;
    Page& page_;
    std::vector<QPushButton*> begin_;
    QPushButton* cancel_;
    std::shared_ptr<ExportRun> run_;
};

}  // namespace placode::ui
