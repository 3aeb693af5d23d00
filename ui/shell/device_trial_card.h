// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The card in which one device is tried: how to calibrate it, what it says now, a floor to press
// against, and which arm is in which hand. What was found is kept in the station file.

#include <QFrame>
#include <functional>

#include "haptics/station.h"
#include "ui/shell/device_tester.h"

namespace placode::ui {

class AppContext;

/// What the card asks of its page.
struct TrialWishes {
    /// Changes the station file; false: it could not be written, and the user was told.
    std::function<bool(const std::function<void(haptics::Station&)>&)> change;
    std::function<haptics::Station()> station;
    std::function<void(const QString&)> notice;
};

/// A card that tries `device` as long as it lives.
[[nodiscard]] QFrame* make_trial_card(AppContext& context, const QString& device,
                                      const TrialWishes& wishes);

/// What to do before a device may be used, one step a line.
[[nodiscard]] QStringList calibration_steps(const QString& device);

}  // namespace placode::ui
