// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The card in which one device is tried: how to calibrate it, what it says now, a floor to press
// against, and which arm is in which hand. What was found is kept in the station file.

#include <QFrame>

#include "ui/shell/device_tester.h"
#include "ui/shell/station_wishes.h"

namespace placode::ui {

class AppContext;

/// A card that tries `device` as long as it lives.
[[nodiscard]] QFrame* make_trial_card(AppContext& context, const QString& device,
                                      const StationWishes& wishes);

/// What to do before a device may be used, one step a line.
[[nodiscard]] QStringList calibration_steps(const QString& device);

}  // namespace placode::ui
