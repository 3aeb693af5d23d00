// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the headline of the accuracy report says of rows that are made up here.
#include "bench/accuracy_report.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace placode::bench {
namespace THIS_TEST {

using sim::AccuracyRow;

AccuracyRow row(const char* method, const char* quantity, double error) {
    AccuracyRow out;
    out.study = "twisted bar";
    out.setting = "one end turned";
    out.method = method;
    out.quantity = quantity;
    out.h_s = 2.5e-4;
    out.error = error;
    return out;
}

std::string report(double xpbd_force, double xpbd_place) {
    return accuracy_report({row("vbd", "displacement against newton", 0.001),
                            row("vbd", "reaction at the end against newton", 0.002),
                            row("xpbd", "displacement against newton", xpbd_place),
                            row("xpbd", "reaction at the end against newton", xpbd_force)},
                           {}, AccuracyRun(), "");
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(AccuracyReport, NamesTheErrorOfReactionsBesideThatOfDisplacements) {
    const std::string text = report(0.02, 0.01);
    EXPECT_TRUE(has(text, "`vbd` 0.1 and 0.2 %, `xpbd` 1 and 2 %")) << text;
    EXPECT_FALSE(has(text, "Warning"));
}

TEST(AccuracyReport, WarnsWhereReactionsAreMuchWorseThanDisplacements) {
    const std::string text = report(0.075, 0.0003);
    EXPECT_TRUE(has(text, "Warning: these reactions are more than 3 times")) << text;
    EXPECT_TRUE(has(text,
                    "twisted bar, `xpbd` at 0.25 ms: 0.03 % of displacement, 7.5 % of "
                    "reaction"))
        << text;
    EXPECT_FALSE(has(text, "`vbd` at 0.25 ms"));
    // A force that is right to 0.5 % is right, however good the places are.
    EXPECT_FALSE(has(report(0.004, 1e-6), "Warning"));
}

TEST(AccuracyReport, SaysNothingOfReactionsThatWereNotMeasured) {
    const std::string text =
        accuracy_report({row("vbd", "displacement against newton", 0.001)}, {}, AccuracyRun(), "");
    EXPECT_FALSE(has(text, "Displacement and reaction"));
}

}  // namespace THIS_TEST
}  // namespace placode::bench
