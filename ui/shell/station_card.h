// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The settings of this computer, from the station file.

#include <QFrame>
#include <functional>
#include <map>
#include <string>

#include "ui/shell/station_wishes.h"

namespace placode::ui {

class AppContext;

/// A setting that was changed on the page and not saved.
struct UnsavedSetting {
    QString of_station;  ///< What the station file says, when it was read.
    QString typed;
};
using UnsavedSettings = std::map<std::string, UnsavedSetting>;  ///< By the station's key.

/// What stands changed and not saved in such a card, for the one that takes its place.
[[nodiscard]] UnsavedSettings unsaved_settings(const QWidget& card);

/// Arms and limits, and the keys of the device that is tried.
/// @param tried empty = none.
/// @param unsaved is shown as it was typed, unless the station file says something new since then.
/// @param saved is called when the settings were saved.
[[nodiscard]] QFrame* make_station_card(AppContext& context, const QString& tried,
                                        const UnsavedSettings& unsaved, const StationWishes& wishes,
                                        const std::function<void()>& saved);

}  // namespace placode::ui
