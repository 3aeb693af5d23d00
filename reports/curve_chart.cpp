// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost, step or mesh: curves told apart by sign as well as by colour. Names like
// "light, wall" and "light, tissue" are one group: one colour, and a line for each of its kinds.

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "reports/palette.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

constexpr QCPScatterStyle::ScatterShape kSigns[]{
    QCPScatterStyle::ssDisc,    QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
    QCPScatterStyle::ssDiamond, QCPScatterStyle::ssCross,  QCPScatterStyle::ssPlus,
    QCPScatterStyle::ssCircle,  QCPScatterStyle::ssStar};

constexpr int kMostSigns = 60;  // more would run into each other

/// Less than a decade has ticks between its powers, as 1.5e4, which whole mantissas would call 2e4.
class LogTicker : public QCPAxisTickerLog {
 protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int) override {
        constexpr int most = 3;
        const double mantissa = tick / std::pow(10, std::floor(std::log10(tick)));
        int digits = 0;
        for (double m = mantissa; digits < most && std::abs(m - std::round(m)) > 1e-6; m *= 10)
            ++digits;
        return QCPAxisTickerLog::getTickLabel(tick, locale, format, digits);
    }
};

void set_axis(QCPAxis* axis, const std::string& label, bool logarithmic) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(13);
    axis->setLabel(QString::fromStdString(label));
    axis->setLabelFont(font);
    axis->setTickLabelFont(font);
    if (!logarithmic) return;
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTicker>(new LogTicker));
    axis->setNumberFormat(QStringLiteral("eb"));
}

/// Points that both axes can show, from left to right.
std::pair<QVector<double>, QVector<double>> visible(const Curve& curve, const CurveChart& chart) {
    std::vector<std::pair<double, double>> points;
    for (size_t i = 0; i < curve.x.size() && i < curve.y.size(); ++i) {
        const bool shown = std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]) &&
                           (!chart.log_x || curve.x[i] > 0) && (!chart.log_y || curve.y[i] > 0);
        if (shown) points.emplace_back(curve.x[i], curve.y[i]);
    }
    std::sort(points.begin(), points.end());
    QVector<double> x, y;
    for (const auto& [a, b] : points) {
        x << a;
        y << b;
    }
    return {x, y};
}

/// Below the picture, three names a row: nothing is hidden behind them.
void place_names(QCustomPlot& plot, const QFont& font) {
    plot.legend->setVisible(true);
    plot.legend->setFont(font);
    plot.plotLayout()->addElement(2, 0, plot.legend);
    plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    plot.legend->setWrap(3);
    plot.legend->setBorderPen(Qt::NoPen);
    plot.plotLayout()->setRowStretchFactor(2, 0.001);
}

/// How a curve is drawn.
struct Look {
    size_t colour = 0, line = 0;
};

/// Colours by the first part of the names and lines by the second, where all have two and parts
/// repeat; else a colour each.
std::vector<Look> looks_of(const std::vector<Curve>& curves) {
    std::vector<std::string> groups, kinds;
    std::vector<Look> looks;
    const auto place = [](std::vector<std::string>& seen, const std::string& part) {
        const auto at = std::find(seen.begin(), seen.end(), part);
        if (at == seen.end()) seen.push_back(part);
        return static_cast<size_t>(std::find(seen.begin(), seen.end(), part) - seen.begin());
    };
    bool two_parts = !curves.empty();
    for (const Curve& curve : curves) {
        const size_t comma = curve.name.find(", ");
        two_parts = two_parts && comma != std::string::npos;
        if (!two_parts) break;
        looks.push_back({place(groups, curve.name.substr(0, comma)),
                         place(kinds, curve.name.substr(comma + 2))});
    }
    constexpr size_t lines = 3;
    if (two_parts && groups.size() < curves.size() && kinds.size() <= lines) return looks;
    looks.assign(curves.size(), {});
    for (size_t i = 0; i < looks.size(); ++i) looks[i].colour = i;
    return looks;
}

void add_curve(QCustomPlot& plot, const Curve& curve, const CurveChart& chart, const Look& look) {
    const auto [x, y] = visible(curve, chart);
    if (x.isEmpty()) return;
    constexpr Qt::PenStyle lines[]{Qt::SolidLine, Qt::DashLine, Qt::DotLine};
    QCPGraph* graph = plot.addGraph();
    const QColor colour = QColor::fromRgba(kCurveColours[look.colour % std::size(kCurveColours)]);
    graph->setName(QString::fromStdString(curve.name));
    graph->setPen(QPen(colour, 2, lines[look.line % std::size(lines)]));
    if (x.size() <= kMostSigns) {
        // After a full turn of the colours the signs go on by one: no two curves look alike.
        const size_t sign = look.colour + look.colour / std::size(kCurveColours) + 3 * look.line;
        QCPScatterStyle style(kSigns[sign % std::size(kSigns)], colour, Qt::white, 9);
        style.setPen(QPen(colour, 2));
        graph->setScatterStyle(style);
    }
    graph->setData(x, y, true);
}

/// Everything is seen, levels too, with air around it.
void set_ranges(QCustomPlot& plot, const CurveChart& chart) {
    plot.rescaleAxes();
    for (const auto& [name, level] : chart.levels)
        if (!chart.log_y || level > 0) plot.yAxis->setRange(plot.yAxis->range().expanded(level));
    plot.xAxis->scaleRange(chart.log_x ? 1.3 : 1.06);
    plot.yAxis->scaleRange(chart.log_y ? 1.2 : 1.1);
}

void add_levels(QCustomPlot& plot, const CurveChart& chart) {
    Qt::PenStyle style = Qt::DashLine;
    for (const auto& [name, level] : chart.levels) {
        QCPGraph* graph = plot.addGraph();
        graph->setName(QString::fromStdString(name));
        graph->setPen(QPen(QColor(0x5f, 0x66, 0x6e), 1.5, style));
        style = style == Qt::DashLine ? Qt::DotLine : Qt::DashLine;
        graph->setData({plot.xAxis->range().lower, plot.xAxis->range().upper}, {level, level},
                       true);
    }
}

}  // namespace

void write_chart_png(const CurveChart& chart, const std::string& path) {
    QCustomPlot plot;
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(13);
    plot.plotLayout()->insertRow(0);
    QFont bold = font;
    bold.setBold(true);
    plot.plotLayout()->addElement(
        0, 0, new QCPTextElement(&plot, QString::fromStdString(chart.title), bold));
    set_axis(plot.xAxis, chart.x_label, chart.log_x);
    set_axis(plot.yAxis, chart.y_label, chart.log_y);
    place_names(plot, font);
    const std::vector<Look> looks = looks_of(chart.curves);
    for (size_t i = 0; i < chart.curves.size(); ++i)
        add_curve(plot, chart.curves[i], chart, looks[i]);
    set_ranges(plot, chart);
    add_levels(plot, chart);
    if (!plot.savePng(QString::fromStdString(path), 900, 560))
        throw ReportError("write the chart " + path + ": cannot be written; choose another place");
}

}  // namespace placode::reports
