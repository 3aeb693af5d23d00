// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every page once, with something to show: for what has to look at all of them (time, pictures,
// names for screen readers).

#include <vector>

#include "ui/shell/pages.h"

namespace placode::ui {

/// A page and where it can be seen.
struct TourStop {
    const char* name;  ///< Of the page, never translated: "standards".
    Place place;
};

/// The pages that the person who is signed in may open, in the order of PageId; those that show an
/// attempt or a participant only where the store has one, and none that needs a running attempt.
/// Main thread.
[[nodiscard]] std::vector<TourStop> page_tour(AppContext& context);

/// How long each stop took.
struct PageTime {
    const char* name = "";
    double first_ms = 0, median_ms = 0, worst_ms = 0;  ///< From the click to the painted page.
    double processor_ms = 0;  ///< Median, of the processor: the same on a machine that is busy.
    double complete_ms = 0;   ///< Worst, until what workers bring stands there, too.
};

class MainWindow;
/// Opens every page of the tour `runs` times, tells on standard error how far it is. Main thread;
/// processes events.
[[nodiscard]] std::vector<PageTime> time_pages(AppContext& context, MainWindow& window, int runs);

}  // namespace placode::ui
