// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of docs/: what is computed lies on the closed form, and the pictures show all of it.
#include "bench/closed_forms.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

namespace placode::bench {
namespace THIS_TEST {

int markers_in(const pugi::xml_node& node) {
    int found = 0;
    for (const pugi::xml_node& child : node)
        found += std::string(child.attribute("fill").value()) == "#ffffff" &&
                 child.attribute("stroke-width");
    return found;
}

/// Every series has points and a line, and meets its target; the picture is well formed, shows a
/// marker for each point and one in each legend, and nothing outside of it.
void expect_sound(const ClosedFormFigure& figure, size_t panels) {
    ASSERT_EQ(figure.panels.size(), panels);
    int markers = 0;
    for (const ClosedFormPanel& panel : figure.panels) {
        ASSERT_FALSE(panel.series.empty()) << panel.title;
        for (const ClosedFormSeries& series : panel.series) {
            EXPECT_GE(series.found.size(), 8U) << panel.title << ", " << series.name;
            EXPECT_GE(series.exact.size(), 2U) << panel.title << ", " << series.name;
            EXPECT_LT(series.error, panel.target) << panel.title << ", " << series.name;
            EXPECT_GT(series.error, 0) << panel.title << ", " << series.name;
            markers += static_cast<int>(series.found.size()) + 1;
        }
    }
    const std::string svg = closed_form_svg(figure);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(svg.c_str())) << svg;
    EXPECT_EQ(markers_in(document.child("svg")), markers);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("\"-"), std::string::npos) << "a coordinate left of the picture";
    const std::string page = closed_form_page({figure}, Machine{}, "2026-11-29");
    EXPECT_NE(page.find("](" + figure.name + ".svg)"), std::string::npos);
    for (const ClosedFormPanel& panel : figure.panels)
        for (const ClosedFormSeries& series : panel.series)
            EXPECT_NE(page.find("| " + panel.title + ", " + series.name + " |"), std::string::npos);
}

TEST(ClosedForms, ContactMeetsHertzAndCoulomb) { expect_sound(contact_closed_forms(0.02), 2); }
TEST(ClosedForms, HeatMeetsTheErrorFunctionAndGreensFunction) {
    expect_sound(heat_closed_forms(), 2);
}
TEST(ClosedForms, ThreadMeetsTheElastica) { expect_sound(thread_closed_forms(), 2); }

}  // namespace THIS_TEST
}  // namespace placode::bench
