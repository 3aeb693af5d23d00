// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of the page of standards: a pass mark from two groups or from the estimates of judges, and
// how much each metric is worth.

#include <QVariantMap>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/standard_setting.h"
#include "ui/shell/app_context.h"

class QFrame;
class QVBoxLayout;

namespace placode::ui {

/// A share as percent, without places.
[[nodiscard]] QString percent_text(double share);

/// The standard of a task that holds today: its mark, since when, and where it comes from.
[[nodiscard]] QWidget* make_present_standard_card(AppContext& context, const std::string& task_id);

/// The mark between two groups with its picture and its cost; or why there is none.
/// @param novices, experts mean points of each person. @param saving adds what keeps the mark;
/// absent for who may not.
[[nodiscard]] QFrame* make_contrasting_card(AppContext& context, const std::vector<double>& novices,
                                            const std::vector<double>& experts,
                                            const std::function<void(QVBoxLayout*)>& saving);

/// Reads the metrics of these people's attempts when asked to, on a worker, and shows the panel.
[[nodiscard]] QWidget* make_quality_card(AppContext& context, const std::string& task_id,
                                         const std::vector<int64_t>& novices,
                                         const std::vector<int64_t>& experts);

/// A table of rubric items by judges.
/// @param typed what `told` was given before the page was made anew. @param told gets it after
/// every change: "judges", and in "cells" for each line of the rubric, by its id, a text of every
/// judge; lines without any are left out. @param save keeps the mark; absent for who may not.
[[nodiscard]] QWidget* make_angoff_card(
    AppContext& context, const std::string& task_id, const QVariantMap& typed,
    const std::function<void(const QVariantMap&)>& told,
    const std::function<void(const assessment::Angoff&, const QString& reason)>& save);

}  // namespace placode::ui
