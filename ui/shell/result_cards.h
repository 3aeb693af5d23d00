// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cards of the result page. Each is built from values; what needs the recording comes later.

#include <functional>
#include <memory>
#include <vector>

#include "db/store.h"
#include "reports/attempt_figures.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {

/// Shows a moment of the recording [s].
using ShowMoment = std::function<void(double time_s)>;

/// What the cards are about.
struct ResultData {
    db::AttemptDetail detail;
    std::vector<db::AttemptRecord> history;   ///< Of the person at this task, oldest first.
    std::vector<db::AttemptDetail> earlier;   ///< The last ones before this attempt, oldest first.
    std::vector<db::CommentRecord> comments;  ///< By time.
    std::optional<db::NormPackRecord> norms;  ///< In use for the task.
};
/// Reads all of it. Throws StoreError.
[[nodiscard]] ResultData read_result(db::Store& store, int64_t attempt_id);

/// The three reasons that cost most, each with "Show" where it has a moment.
[[nodiscard]] QWidget* make_reasons_card(AppContext& context, const ResultData& data,
                                         const ShowMoment& show);
/// Strengths and weaknesses by theme, against the own earlier attempts.
[[nodiscard]] QWidget* make_themes_card(AppContext& context, const ResultData& data);
/// Values with unit, own last, change, and the own band as a strip.
[[nodiscard]] QWidget* make_metrics_card(AppContext& context, const ResultData& data);
/// Damage ledger on a time line with the chosen entry in words.
[[nodiscard]] QWidget* make_ledger_card(AppContext& context, const ResultData& data,
                                        const sim::Recording& recording, const ShowMoment& show);
/// Where a sewn slit leaks, as a picture and in words; nullptr for a task that has none.
[[nodiscard]] QWidget* make_leak_card(AppContext& context,
                                      const std::shared_ptr<const sim::Recording>& recording);
/// Damage on the anatomy, beside energy and incision or what an exercise asked for.
[[nodiscard]] QWidget* make_map_card(AppContext& context,
                                     const std::shared_ptr<const sim::Recording>& recording);
/// The ways of the instruments from three sides.
[[nodiscard]] QWidget* make_ways_card(AppContext& context,
                                      const std::shared_ptr<const sim::Recording>& recording);

/// Remarks with their times; a field for a new one where the user may. `moment` gives the time of a
/// new remark, or a negative number for the whole attempt. `changed` is called with the new list.
[[nodiscard]] QWidget* make_comments_card(
    AppContext& context, int64_t attempt_id, int64_t owner_id,
    const std::function<double()>& moment, const ShowMoment& show,
    const std::function<void(const std::vector<db::CommentRecord>&)>& changed);

/// Flags of the remarks for a time line: 1, 2, 3 ..
[[nodiscard]] std::vector<reports::TimeMark> marks_of(
    const std::vector<db::CommentRecord>& comments);

/// True when the user may remark on the attempts of that person.
[[nodiscard]] bool may_remark(AppContext& context, int64_t owner_id);

}  // namespace placode::ui
