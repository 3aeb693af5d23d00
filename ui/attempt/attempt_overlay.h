// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Overlay texts of one attempt: task, controls of the device at hand.

#include "curriculum/task.h"
#include "ui/attempt/arguments.h"
#include "ui/view/fetoscope_view.h"

namespace placode::ui {

[[nodiscard]] view::OverlayState attempt_overlay(const curriculum::Task& task,
                                                 const Arguments& arguments);
/// Of a recording that is shown again: what was done (practice, exam, study) and the keys of a
/// replay. Where it stands in the recording is for the caller.
[[nodiscard]] view::OverlayState replay_overlay(const curriculum::Task& task,
                                                const sim::Recording& recording,
                                                const Arguments& arguments);
[[nodiscard]] view::ViewSettings view_settings(const Arguments& arguments,
                                               const std::string& title);

}  // namespace placode::ui
