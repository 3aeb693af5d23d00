// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the cards of the page of devices ask of it: to read and to change the station file.

#include <QString>
#include <functional>

#include "haptics/station.h"

namespace placode::ui {

/// The page outlives its cards.
struct StationWishes {
    /// Changes the station file; false: it could not be written, and the user was told.
    std::function<bool(const std::function<void(haptics::Station&)>&)> change;
    std::function<haptics::Station()> station;
    std::function<void(const QString&)> notice;
};

}  // namespace placode::ui
