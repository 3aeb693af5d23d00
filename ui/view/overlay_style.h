// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers as text, beside the colours, for everything drawn over the picture.

#include <cstdio>
#include <string>

#include "ui/view/overlay_colours.h"

namespace placode::view::style {

/// With a point, whatever the locale says.
inline std::string number(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    for (char* c = text; *c != 0; ++c) {
        if (*c == ',') *c = '.';
    }
    return text;
}

}  // namespace placode::view::style
