// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The settings of this computer, from the station file.

#include <QFrame>
#include <functional>

#include "ui/shell/station_wishes.h"

namespace placode::ui {

class AppContext;

/// Arms and limits, and the keys of the device that is tried.
/// @param tried empty = none.
/// @param saved is called when the settings were saved.
[[nodiscard]] QFrame* make_station_card(AppContext& context, const QString& tried,
                                        const StationWishes& wishes,
                                        const std::function<void()>& saved);

}  // namespace placode::ui
