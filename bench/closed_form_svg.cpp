// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Drawn here and not by reports/: text stays text, nothing depends on fonts or on a display, and a
// change of a number is one line of a diff.

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/closed_forms.h"
#include "sim/core/number_text.h"

namespace placode::bench {
namespace {

using sim::fixed_text;
using sim::Vec2;

constexpr std::array<const char*, 3> kColours{"#0b5fa5", "#b3261e", "#2f7d4f"};
constexpr double kPanelWidth = 380, kLeft = 62, kTop = 62, kPlotWidth = 300, kPlotHeight = 220;
constexpr double kLegendRow = 18;

std::string text_at(const Vec2& at, const std::string& anchor, const std::string& text,
                    const std::string& more = "") {
    std::string escaped;
    for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return "<text x=\"" + fixed_text(at.x(), 1) + "\" y=\"" + fixed_text(at.y(), 1) +
           "\" text-anchor=\"" + anchor + "\"" + more + ">" + escaped + "</text>\n";
}

std::string line(const Vec2& a, const Vec2& b, const char* colour) {
    return "<path d=\"M" + fixed_text(a.x(), 1) + " " + fixed_text(a.y(), 1) + " L" +
           fixed_text(b.x(), 1) + " " + fixed_text(b.y(), 1) + "\" stroke=\"" + colour + "\"/>\n";
}

/// Circle, square, triangle: told apart in grey, too.
std::string marker(const Vec2& at, size_t kind) {
    const std::string x = fixed_text(at.x(), 1), y = fixed_text(at.y(), 1);
    const std::string look = std::string("\" fill=\"#ffffff\" stroke=\"") + kColours.at(kind) +
                             "\" stroke-width=\"1.6\"/>\n";
    if (kind == 0) return "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3.6" + look;
    if (kind == 1)
        return "<rect x=\"" + fixed_text(at.x() - 3.3, 1) + "\" y=\"" +
               fixed_text(at.y() - 3.3, 1) + "\" width=\"6.6\" height=\"6.6" + look;
    return "<path d=\"M" + x + " " + fixed_text(at.y() - 4.4, 1) + " l4.2 7.4 h-8.4 z" + look;
}

/// Ends of an axis and the distance of its ticks, a 1, 2 or 5 with zeros.
struct Range {
    double low = 0, high = 1, tick = 1;
    int decimals = 0;
};

Range range_of(const ClosedFormPanel& panel, int axis) {
    double low = 0, high = 0;
    bool first = true;
    for (const ClosedFormSeries& series : panel.series)
        for (const auto* points : {&series.found, &series.exact})
            for (const Vec2& p : *points) {
                low = first ? p[axis] : std::min(low, p[axis]);
                high = first ? p[axis] : std::max(high, p[axis]);
                first = false;
            }
    const double rough = std::max(high - low, 1e-12) / 5;
    const double decade = std::pow(10, std::floor(std::log10(rough))), share = rough / decade;
    Range range;
    range.tick = decade * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    range.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(range.tick) + 1e-9)));
    range.low = range.tick * std::floor(low / range.tick + 1e-9);
    range.high = range.tick * std::ceil(high / range.tick - 1e-9);
    // What runs along the upper border would be drawn half outside.
    if (axis == 1 && high > 0 && range.high - high < 0.01 * range.tick) range.high += range.tick;
    return range;
}

/// From the units of the axes to the picture.
struct Plot {
    Range x, y;
    double left = 0;
    [[nodiscard]] Vec2 at(const Vec2& p) const {
        return {left + kPlotWidth * (p.x() - x.low) / (x.high - x.low),
                kTop + kPlotHeight * (y.high - p.y()) / (y.high - y.low)};
    }
};

std::string axes_of(const ClosedFormPanel& panel, const Plot& plot) {
    std::string out;
    for (int i = 0; i <= std::lround((plot.x.high - plot.x.low) / plot.x.tick); ++i) {
        const double value = plot.x.low + i * plot.x.tick;
        const Vec2 foot = plot.at({value, plot.y.low});
        out += line(foot, plot.at({value, plot.y.high}), "#e3e2dc");
        out += text_at(foot + Vec2(0, 17), "middle", fixed_text(value, plot.x.decimals));
    }
    for (int i = 0; i <= std::lround((plot.y.high - plot.y.low) / plot.y.tick); ++i) {
        const double value = plot.y.low + i * plot.y.tick;
        const Vec2 foot = plot.at({plot.x.low, value});
        out += line(foot, plot.at({plot.x.high, value}), "#e3e2dc");
        out += text_at(foot + Vec2(-6, 4), "end", fixed_text(value, plot.y.decimals));
    }
    const Vec2 corner = plot.at({plot.x.low, plot.y.low});
    out += line(corner, plot.at({plot.x.high, plot.y.low}), "#444444");
    out += line(corner, plot.at({plot.x.low, plot.y.high}), "#444444");
    const double middle = plot.left + kPlotWidth / 2;
    out += text_at({middle, kTop - 10}, "middle", panel.title, " font-weight=\"bold\"");
    out += text_at({middle, kTop + kPlotHeight + 36}, "middle", panel.x_label);
    const double x = plot.left - 46, y = kTop + kPlotHeight / 2;
    return out +
           text_at({x, y}, "middle", panel.y_label,
                   " transform=\"rotate(-90 " + fixed_text(x, 1) + " " + fixed_text(y, 1) + ")\"");
}

std::string series_of(const ClosedFormPanel& panel, const Plot& plot) {
    std::string out;
    for (size_t i = 0; i < panel.series.size(); ++i) {
        const ClosedFormSeries& series = panel.series[i];
        const std::string colour = kColours.at(i);
        out += "<path d=\"";
        for (size_t k = 0; k < series.exact.size(); ++k) {
            const Vec2 p = plot.at(series.exact[k]);
            out += (k == 0 ? "M" : " L") + fixed_text(p.x(), 1) + " " + fixed_text(p.y(), 1);
        }
        out += "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.6\"/>\n";
        for (const Vec2& p : series.found) out += marker(plot.at(p), i);
        const double row = kTop + kPlotHeight + 58 + kLegendRow * static_cast<double>(i);
        out += marker({plot.left + 8, row - 4}, i);
        out += text_at({plot.left + 20, row}, "start", series.name);
    }
    const double row = kTop + kPlotHeight + 58;
    out += line({plot.left + 168, row - 4}, {plot.left + 192, row - 4}, "#444444");
    return out + text_at({plot.left + 198, row}, "start", panel.exact_name);
}

}  // namespace

std::string closed_form_svg(const ClosedFormFigure& figure) {
    size_t rows = 1;
    for (const ClosedFormPanel& panel : figure.panels) rows = std::max(rows, panel.series.size());
    const std::string width =
                          fixed_text(kPanelWidth * static_cast<double>(figure.panels.size()), 0),
                      height = fixed_text(
                          kTop + kPlotHeight + 50 + kLegendRow * static_cast<double>(rows), 0);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " +
                      height + "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222222\">\n";
    out +=
        "<!-- Written by `placodectl bench closed-forms`; run it again instead of editing. -->\n";
    out += "<title>" + figure.title + "</title>\n";
    out += "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n";
    out += text_at({kPanelWidth * static_cast<double>(figure.panels.size()) / 2, 24}, "middle",
                   figure.title + ": markers are computed, lines are the closed form",
                   " font-size=\"14\"");
    for (size_t i = 0; i < figure.panels.size(); ++i) {
        const ClosedFormPanel& panel = figure.panels[i];
        const Plot plot{range_of(panel, 0), range_of(panel, 1),
                        kPanelWidth * static_cast<double>(i) + kLeft};
        out += axes_of(panel, plot) + series_of(panel, plot);
    }
    return out + "</svg>\n";
}

std::string closed_form_page(const std::vector<ClosedFormFigure>& figures, const Machine& machine,
                             const std::string& day) {
    std::string out =
        "<!-- Written by `placodectl bench closed-forms`; run it again instead of editing. -->\n"
        "# Contact, heat and thread against closed forms\n\n"
        "`placodectl bench closed-forms --out docs/measurements` on " +
        machine.processor + ", " + machine.compiler + ", kernels " + machine.kernel_target + ", " +
        day + ". Nothing here depends on time or load.\n";
    for (const ClosedFormFigure& figure : figures) {
        out += "\n## " + figure.title + "\n\n![" + figure.title + "](" + figure.name +
               ".svg)\n\n| case | against | difference | test accepts | which difference |\n"
               "|---|---|---|---|---|\n";
        for (const ClosedFormPanel& panel : figure.panels)
            for (const ClosedFormSeries& series : panel.series)
                out += "| " + panel.title + ", " + series.name + " | " + panel.exact_name + " | " +
                       fixed_text(100 * series.error, 3) + " % | " +
                       fixed_text(100 * panel.target, 1) + " % | " + panel.measure + " |\n";
    }
    return out;
}

}  // namespace placode::bench
