// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt without a window, with pictures when asked for.

#include <chrono>
#include <optional>
#include <thread>

#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"
#include "ui/view/fetoscope_view.h"

namespace placode::ui {

void run_headless(curriculum::AttemptRunner& runner, const Arguments& arguments,
                  StatusLine& status) {
    Screenshots shots(arguments);
    view::OverlayState overlay = attempt_overlay(runner.task(), arguments);
    std::optional<view::FetoscopeView> view;
    if (shots.wanted()) {
        view.emplace(view::view_field(*runner.scene(), arguments.seed),
                     view_settings(arguments, overlay.title));
    }
    runner.start();
    while (!runner.finished()) {
        if (finish_requested()) runner.request_finish(sim::EndReason::kClosed);
        if (stop_requested()) runner.request_finish(sim::EndReason::kInterrupted);
        status.print(runner.status());
        if (view) {
            const sim::Snapshot& snapshot = runner.snapshot();
            if (!snapshot.x.empty()) {
                view->observe(snapshot);
                if (view->lens().dirty()) view->wipe_lens();  // a script cannot press L
                if (shots.due(snapshot.time_s)) {
                    overlay.practice.goal = runner.practice();
                    view->draw(snapshot, overlay);
                    shots.save(*view, snapshot.time_s);
                }
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    runner.wait();
    if (!view) return;
    const sim::Snapshot& last = runner.snapshot();
    if (last.x.empty()) return;
    overlay.practice.goal = runner.practice();
    view->draw(last, overlay);
    shots.save(*view, last.time_s);
}

}  // namespace placode::ui
