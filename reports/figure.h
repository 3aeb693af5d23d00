// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Figures of a study: one drawing for window, PDF, SVG and PNG, and the data behind it. Readable in
// grey and for the colour-blind: position, sign and numbers say what colour says.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/standard_setting.h"
#include "reports/report.h"

namespace placode::reports {

struct Figure {
    std::string group;  ///< Name of the form it belongs to; may be empty.
    std::string id;     ///< File name: "likert_face_validity".
    std::string title, caption;
    double width = 680, height = 300;  ///< At 96 dpi.
    std::function<void(QPainter&, const QRectF&)> draw;
    std::string csv;  ///< The numbers that are drawn.
};

/// ID.svg, ID.png (288 dpi) and ID.csv. Throws ReportError.
/// @param demonstration writes so into the picture.
void save_figure(const Figure& figure, const std::string& folder, bool demonstration);

struct LikertBar {
    std::string id, label;
    int scale_min = 1;
    std::vector<int> counts;  ///< From scale_min on.
    std::string low, high;    ///< Words at the ends.
    int missing = 0;
    std::optional<double> mean, sd;
};
/// Diverging stacked bars: the middle of the scale in the middle, shares in per cent, counts
/// inside, n and mean (SD) at the right. @pre bars not empty, all of the same width of scale.
[[nodiscard]] Figure likert_figure(const std::string& id, const std::string& title,
                                   const std::vector<LikertBar>& bars, const ChartStyle& style);

struct StripGroup {
    std::string label;
    std::vector<double> values;
};
/// Every value as a point, a box of the quartiles (type 7), median and mean.
[[nodiscard]] Figure strip_figure(const std::string& id, const std::string& title,
                                  const std::string& axis, const std::vector<StripGroup>& groups,
                                  const ChartStyle& style);

struct ForestRow {
    std::string label;
    double estimate = 0, low = 0, high = 0;
    std::string note;          ///< "p 0.12"
    bool no_interval = false;  ///< The interval cannot be computed.
};
/// An axis from low to high. What lies beyond it is an arrow at its end; text and CSV have all
/// numbers as they are.
[[nodiscard]] Figure forest_figure(const std::string& id, const std::string& title,
                                   const std::string& axis, const std::vector<ForestRow>& rows,
                                   double low, double high, const ChartStyle& style);

struct LearningLine {
    std::string label;
    std::vector<double> points;  ///< Score of each attempt, in order.
    std::vector<bool> failed;
};
/// Above: scores over attempts, everybody thin, the mean thick. Below: CUSUM of everybody with the
/// limits h0 and h1.
/// @param pass_points no line where it is empty: several marks judged these attempts.
[[nodiscard]] Figure learning_figure(const std::string& id, const std::string& title,
                                     const std::vector<LearningLine>& lines,
                                     std::optional<double> pass_points,
                                     const assessment::CusumLimits& limits,
                                     const ChartStyle& style);

struct FlowNumbers {
    int enrolled = 0, consented = 0, stopped = 0, erased = 0, kept = 0;
    std::vector<std::pair<std::string, int>> reached;  ///< Step of the protocol, participants.
    int analysed = 0;
};
/// What the boxes say, for a page in another language than English.
struct FlowWords {
    std::string enrolled = "enrolled", left = "withdrew, data not used or erased",
                kept = "withdrew, data to date are used", consented = "consented",
                analysed = "answers or attempts analysed";
};
/// Who took part, who left, who is analysed.
[[nodiscard]] Figure flow_figure(const std::string& id, const std::string& title,
                                 const FlowNumbers& numbers, const ChartStyle& style,
                                 const FlowWords& words = {});

}  // namespace placode::reports
