// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost, step or mesh: curves told apart by sign as well as by colour.

#include <qcustomplot.h>

#include <cmath>

#include "reports/report.h"

namespace placode::reports {
namespace {

// Colours of Okabe and Ito: safe for colour-blind readers.
constexpr unsigned kColours[]{0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7,
                              0xff56b4e9, 0xffe69f00, 0xff000000, 0xff8c6d31};
constexpr QCPScatterStyle::ScatterShape kSigns[]{
    QCPScatterStyle::ssDisc,    QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
    QCPScatterStyle::ssDiamond, QCPScatterStyle::ssCross,  QCPScatterStyle::ssPlus,
    QCPScatterStyle::ssCircle,  QCPScatterStyle::ssStar};

void set_axis(QCPAxis* axis, const std::string& label, bool logarithmic) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(13);
    axis->setLabel(QString::fromStdString(label));
    axis->setLabelFont(font);
    axis->setTickLabelFont(font);
    if (!logarithmic) return;
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
    axis->setNumberFormat(QStringLiteral("eb"));
    axis->setNumberPrecision(0);
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
    plot.legend->setVisible(true);
    plot.legend->setFont(font);
    int number = 0;
    for (const Curve& curve : chart.curves) {
        const auto [x, y] = visible(curve, chart);
        if (x.isEmpty()) continue;
        QCPGraph* graph = plot.addGraph();
        const QColor colour = QColor::fromRgba(kColours[number % std::size(kColours)]);
        graph->setName(QString::fromStdString(curve.name));
        graph->setPen(QPen(colour, 2));
        graph->setScatterStyle(
            QCPScatterStyle(kSigns[number % std::size(kSigns)], colour, Qt::white, 9));
        graph->setData(x, y, true);
        ++number;
    }
    plot.rescaleAxes();
    if (chart.log_x) plot.xAxis->scaleRange(1.3);
    if (chart.log_y) plot.yAxis->scaleRange(1.2);
    for (const auto& [name, level] : chart.levels) {
        QCPGraph* graph = plot.addGraph();
        graph->setName(QString::fromStdString(name));
        graph->setPen(QPen(QColor(0x5f, 0x66, 0x6e), 1, Qt::DashLine));
        graph->setData({plot.xAxis->range().lower, plot.xAxis->range().upper}, {level, level},
                       true);
    }
    if (!plot.savePng(QString::fromStdString(path), 900, 560))
        throw ReportError("write the chart " + path + ": cannot be written; choose another place");
}

}  // namespace placode::reports
