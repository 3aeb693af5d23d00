// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The ways from the first start: alone, a shared station, a centre's server. Place::state says
// under "way" which one was chosen; nothing is the choice itself.

#include <QPushButton>

#include "ui/shell/pages.h"

namespace placode::ui {

inline constexpr const char* kStationWay = "station";
inline constexpr const char* kServerWay = "server";

[[nodiscard]] inline Place setup_place(const char* way) {
    return {PageId::kSetup, 0, {}, {{"way", QString(way)}}};
}

[[nodiscard]] Page* make_station_setup_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_server_setup_page(AppContext& context, const Place& place);
/// Back to the choice.
[[nodiscard]] QPushButton* make_way_back(AppContext& context, Page* page);

}  // namespace placode::ui
