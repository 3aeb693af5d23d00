// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The dark theme's tokens, for everything drawn over the picture.

#include "ui/view/text.h"

namespace placode::view {

inline constexpr Colour kText{0.925F, 0.929F, 0.933F, 1}, kMuted{0.604F, 0.639F, 0.678F, 1};
inline constexpr Colour kLine{0.200F, 0.216F, 0.239F, 1}, kRaised{0.122F, 0.133F, 0.149F, 0.94F};
inline constexpr Colour kAccent{0.310F, 0.722F, 0.761F, 1}, kGood{0.424F, 0.773F, 0.561F, 1};
inline constexpr Colour kWarn{0.878F, 0.643F, 0.290F, 1}, kCritical{0.949F, 0.522F, 0.486F, 1};
inline constexpr Colour kYellow{0.965F, 0.796F, 0.227F, 1}, kBlue{0.357F, 0.588F, 0.976F, 1};
inline constexpr Colour kInk{0.086F, 0.094F, 0.106F, 1};

}  // namespace placode::view
