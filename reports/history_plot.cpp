// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Score over attempts: own line in the accent, verdicts by sign as well as colour, pass line named.

#include <qcustomplot.h>

#include <QPicture>

#include "reports/plot_parts.h"
#include "reports/report.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

void style_axis(QCPAxis* axis, const QString& label, const ChartStyle& style) {
    QFont font = axis->labelFont();
    font.setPixelSize(static_cast<int>(style.font_px));
    axis->setLabel(label);
    axis->setLabelFont(font);
    axis->setTickLabelFont(font);
    axis->setLabelColor(colour(style.muted));
    axis->setTickLabelColor(colour(style.muted));
    axis->setBasePen(QPen(colour(style.line)));
    axis->setTickPen(QPen(colour(style.line)));
    axis->setSubTickPen(Qt::NoPen);
    axis->grid()->setPen(QPen(colour(style.line), 1, Qt::SolidLine));
    axis->grid()->setZeroLinePen(Qt::NoPen);
}

/// Points of one verdict; the sign tells it without colour.
void add_points(QCustomPlot& plot, const std::vector<db::AttemptRecord>& attempts,
                assessment::Verdict verdict, QCPScatterStyle::ScatterShape shape,
                const ChartStyle& style) {
    QVector<double> x, y;
    for (size_t i = 0; i < attempts.size(); ++i) {
        if (attempts[i].verdict != verdict) continue;
        x << static_cast<double>(i + 1);
        y << attempts[i].points;
    }
    QCPGraph* graph = plot.addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    const QColor ink = verdict_colour(verdict, style);
    graph->setScatterStyle(QCPScatterStyle(shape, QPen(ink, 2), QBrush(colour(style.surface)), 9));
    graph->setData(x, y, true);
}

void add_pass_line(QCustomPlot& plot, double pass_points, double last, const ChartStyle& style) {
    QCPGraph* graph = plot.addGraph();
    graph->setPen(QPen(colour(style.good), 1, Qt::DashLine));
    graph->setData({0.5, last + 0.5}, {pass_points, pass_points}, true);
    auto* text = new QCPItemText(&plot);
    text->position->setCoords(last + 0.5, pass_points);
    text->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    text->setText(figure_word("pass mark of the task: %1").arg(points_text(pass_points)));
    text->setColor(colour(style.good));
    QFont font;
    font.setPixelSize(static_cast<int>(style.font_px));
    text->setFont(font);
}

}  // namespace

void draw_history(QPainter& painter, const QRectF& where,
                  const std::vector<db::AttemptRecord>& attempts, double pass_points,
                  const ChartStyle& style) {
    if (where.width() < 40 || where.height() < 40) return;
    QCustomPlot plot;
    plot.setBackground(QBrush(colour(style.surface)));
    style_axis(plot.xAxis, figure_word("attempt"), style);
    style_axis(plot.yAxis, figure_word("score [points of 100]"), style);
    const double last = std::max<double>(1, static_cast<double>(attempts.size()));
    plot.xAxis->setRange(0.5, last + 0.5);
    // Room below 0 for the sign of an attempt with 0 points, as above 100.
    plot.yAxis->setRange(-4, 104);
    QSharedPointer<QCPAxisTickerFixed> ticker(new QCPAxisTickerFixed);
    ticker->setTickStep(1);
    ticker->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    plot.xAxis->setTicker(ticker);
    plot.xAxis->grid()->setVisible(false);

    QVector<double> x, y;
    for (size_t i = 0; i < attempts.size(); ++i) {
        x << static_cast<double>(i + 1);
        y << attempts[i].points;
    }
    QCPGraph* line = plot.addGraph();
    line->setPen(QPen(colour(style.accent), 2));
    line->setData(x, y, true);
    add_pass_line(plot, pass_points, last, style);
    add_points(plot, attempts, assessment::Verdict::kPassed, QCPScatterStyle::ssDisc, style);
    add_points(plot, attempts, assessment::Verdict::kNotYet, QCPScatterStyle::ssCircle, style);
    add_points(plot, attempts, assessment::Verdict::kFailed, QCPScatterStyle::ssCross, style);
    add_points(plot, attempts, assessment::Verdict::kNotAttempted, QCPScatterStyle::ssDot, style);

    // By way of a picture: QCustomPlot draws with its own painter class, and vectors stay vectors.
    QPicture picture;
    QCPPainter recorder;
    recorder.begin(&picture);
    recorder.setMode(QCPPainter::pmVectorized);
    plot.toPainter(&recorder, static_cast<int>(where.width()), static_cast<int>(where.height()));
    recorder.end();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPicture(where.topLeft(), picture);
    painter.restore();
}

}  // namespace placode::reports
