// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of figures are told apart by everybody.

#include "reports/palette.h"

#include <gtest/gtest.h>

#include "tests/colour_vision.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;

std::vector<QColor> scale_of(size_t width) {
    std::vector<QColor> colours;
    for (size_t i = 0; i < width; ++i) colours.push_back(reports::scale_colour(i, width));
    return colours;
}

// White is 100 from black. A rust red and an olive green that all others see 62 apart look nearly
// alike to who lacks the middle cones.
TEST(Palette, TheSimulationSeesWhatIsKnown) {
    EXPECT_NEAR(closest({Qt::black, Qt::white}, kVisions[0].seen), 100, 0.1);
    const std::vector<QColor> red_green{QColor(0xb0, 0x40, 0x20), QColor(0x60, 0x70, 0x20)};
    EXPECT_GT(closest(red_green, kVisions[0].seen), 5 * closest(red_green, kVisions[2].seen));
    EXPECT_LT(closest(red_green, kVisions[2].seen), kToldApart + 5);
}

TEST(Palette, CurvesAreToldApart) {
    std::vector<QColor> curves;
    for (const unsigned argb : reports::kCurveColours) curves.push_back(QColor::fromRgba(argb));
    for (const Vision& vision : kVisions)
        EXPECT_GE(closest(curves, vision.seen), kToldApart) << vision.name;
}

TEST(Palette, AnswersOfAScaleAreToldApart) {
    for (const size_t width : {2u, 3u, 4u, 5u, 6u, 7u, 9u, 10u})
        for (const Vision& vision : kVisions)
            EXPECT_GE(closest(scale_of(width), vision.seen), kToldApart)
                << width << ", " << vision.name;
}

}  // namespace THIS_TEST
