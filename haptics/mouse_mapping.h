// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a mouse's motion is at the tip.

namespace placode::haptics {

/// 0.25 mm at the tip for 1 mm on the desk, for a mouse of 800 counts per inch (31.5 per mm).
inline constexpr double kMouseCountM = 0.25e-3 / 31.5;
/// One notch of the wheel: half of what the zone is thick; with Shift for the way to the tissue
/// and out through the port.
inline constexpr double kMouseNotchM = 0.0005, kMouseQuickNotchM = 0.002;
inline constexpr double kMousePrecision = 0.2;  ///< Share of the motion with Ctrl.
inline constexpr double kMouseRollRad = 0.004;  ///< A count with Shift.

}  // namespace placode::haptics
