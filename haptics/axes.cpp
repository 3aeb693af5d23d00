// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/axes.h"

#include <cmath>
#include <string>

namespace placode::haptics {

Mat3 device_axes(std::string_view text, std::string_view key) {
    Mat3 axes = Mat3::Zero();
    int row = 0;
    double sign = 1;
    for (const char c : text) {
        if (c == ' ' || c == '+' || c == ',') continue;
        if (c == '-') {
            sign = -1;
            continue;
        }
        if (c < 'x' || c > 'z' || row > 2) {
            row = 9;
            break;
        }
        axes(row++, c - 'x') = sign;
        sign = 1;
    }
    if (row != 3 || std::abs(axes.determinant() - 1) > 1e-9)
        throw DeviceError(std::string(key) + ": found \"" + std::string(text) +
                          "\", expected three different axes that stay right-handed, e.g. x z -y");
    return axes;
}

}  // namespace placode::haptics
