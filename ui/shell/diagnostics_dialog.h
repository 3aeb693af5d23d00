// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the programs wrote about themselves on this computer (ui/diagnostics): the log, and reports
// of crashes, to be read before anybody gets them.

class QWidget;

namespace placode::ui {

class AppContext;
class Notices;

/// Shows the newest crash report, or the log where there is none. Waits until it is closed.
void show_diagnostics(AppContext& context, QWidget* parent);

/// Says once that a program has crashed since this was last said, with a way to what it left.
void offer_crash_report(AppContext& context, Notices& notices, QWidget* window);

}  // namespace placode::ui
