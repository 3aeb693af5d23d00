// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The damage ledger of a recording as a time line to click on, and the same entries as a list.

#include <functional>

#include "sim/step/recording.h"
#include "ui/shell/app_context.h"

class QFrame;

namespace placode::ui {

class LedgerView;

struct TimeLine {
    QFrame* card = nullptr;
    LedgerView* ledger = nullptr;  ///< In the card.
};

/// @param jump goes to a moment: a little before the entry that was chosen.
[[nodiscard]] TimeLine make_time_line(AppContext& context, const sim::Recording& recording,
                                      const std::function<void(double time_s)>& jump);

}  // namespace placode::ui
