// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a replay's window goes, so that it does not lie on the controls that steer it.

#include <QRect>
#include <vector>

class QWidget;

namespace placode::ui {

/// The best free place on `screens` (their usable parts) for a picture beside `window` (with its
/// frame), else over it without touching `controls`. Of the size a picture of 16:10 has there; null
/// where nothing of a useful size is left. All on the desktop [px].
[[nodiscard]] QRect replay_place(const std::vector<QRect>& screens, const QRect& window,
                                 const QRect& controls);
/// The same for a page on its screens now; `controls` are what has to stay in sight, and `also`
/// stays in sight as far as it is seen now where that leaves room for a picture.
[[nodiscard]] QRect replay_place(const QWidget& controls, const QWidget* also = nullptr);
/// Two windows side by side in a place for one.
[[nodiscard]] std::vector<QRect> two_of(const QRect& place);

}  // namespace placode::ui
