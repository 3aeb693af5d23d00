// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one attempt on A4: what happened, why it scored so, and where it can be checked.

#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>
#include <cmath>
#include <span>

#include "reports/attempt_figures.h"
#include "reports/report.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

constexpr double kMargin = 56, kWidth = 794, kHeight = 1123;  // A4 at 96 dpi
constexpr double kInner = kWidth - 2 * kMargin;

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

/// Draws HTML in a column and returns its height.
double draw_html(QPainter& painter, const QPointF& at, double width, const QString& html) {
    QTextDocument document;
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    // Letter spacing (at least 1/64 pixel) switches ligatures off: with them a search for
    // "finished" finds nothing.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    document.setDefaultFont(font);
    document.setDocumentMargin(0);
    document.setTextWidth(width);
    document.setHtml(html);
    painter.save();
    painter.translate(at);
    document.drawContents(&painter);
    painter.restore();
    return document.size().height();
}

QString head_html(const db::AttemptRecord& record, const assessment::Score& score,
                  const ChartStyle& style) {
    QString html;
    if (record.demonstration) {
        html += QStringLiteral(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> - simulated operator, "
            "not a person's attempt.</p>");
    }
    html += QStringLiteral("<p style='color:#5f666e'>Placode - attempt %1</p>").arg(record.id);
    html += QStringLiteral(
                "<p style='font-size:22px'><b><span style='color:%1'>%2</span> - %3 of 100 "
                "points</b></p>")
                .arg(verdict_colour(score.verdict, style).name(), verdict_word(score.verdict),
                     number(score.points, 1));
    if (!record.void_reason.empty())
        html += QStringLiteral(
                    "<p style='background-color:#fff1d6'><b>&nbsp;Does not count.</b> %1. The "
                    "attempt is kept; the machine failed, not the person.</p>")
                    .arg(escaped(record.void_reason));
    html += QStringLiteral(
                "<p>%1 &middot; task %2 (version %3) &middot; %4 UTC &middot; %5 s &middot; %6 "
                "&middot; %7</p>")
                .arg(escaped(record.user_name), escaped(record.task_id),
                     QString::number(record.task_version), escaped(record.started_utc),
                     number(record.duration_s, 1), escaped(record.device), end_word(record.end));
    return html;
}

QString reasons_html(const assessment::Score& score) {
    if (score.reasons.empty()) return QStringLiteral("<h3>Reasons</h3><p>No points were lost.</p>");
    QString html =
        QStringLiteral("<h3>Reasons</h3><table cellspacing='0' cellpadding='3' width='100%'>");
    for (const assessment::Reason& reason : score.reasons) {
        const QString when =
            reason.time_s < 0 ? QString() : QStringLiteral("at %1 s").arg(number(reason.time_s, 1));
        html += QStringLiteral(
                    "<tr><td align='right'>-%1</td><td>%2%3</td><td align='right' "
                    "style='color:#5f666e'>%4</td></tr>")
                    .arg(number(reason.points, 1),
                         reason.critical ? QStringLiteral("<b>critical:</b> ") : QString(),
                         reason_words(reason.text).toHtmlEscaped(), when);
    }
    return html + QStringLiteral("</table>");
}

constexpr size_t kMetricsAPage = 46;

/// Definitions of those that this attempt has.
std::vector<assessment::MetricDefinition> known_metrics(const assessment::MetricSet& metrics) {
    std::vector<assessment::MetricDefinition> known;
    for (const assessment::MetricDefinition& definition : assessment::metric_definitions())
        if (metrics.find(definition.id)) known.push_back(definition);
    return known;
}

QString metrics_html(const assessment::MetricSet& metrics,
                     std::span<const assessment::MetricDefinition> shown) {
    QString html = QStringLiteral(
        "<h3>Metrics</h3><table cellspacing='0' cellpadding='1' width='100%'>"
        "<tr style='color:#5f666e'><td>metric</td><td "
        "align='right'>value</td><td>unit</td><td>better</td></tr>");
    for (const assessment::MetricDefinition& definition : shown) {
        const auto value = metrics.find(definition.id);
        const char* better = definition.direction == assessment::Direction::kLowerIsBetter ? "lower"
                             : definition.direction == assessment::Direction::kHigherIsBetter
                                 ? "higher"
                                 : "";
        html += QStringLiteral(
                    "<tr><td>%1</td><td align='right'>%2</td><td>&nbsp;%3</td><td "
                    "style='color:#5f666e'>%4</td></tr>")
                    .arg(escaped(std::string(definition.name)),
                         is_count(definition, *value) ? number(*value, 0) : metric_number(*value),
                         unit_sign(definition.unit).toHtmlEscaped(), QString::fromLatin1(better));
    }
    return html + QStringLiteral("</table>");
}

QString provenance_html(const db::AttemptRecord& record, const sim::Recording& recording) {
    return QStringLiteral(
               "<h3>Can be checked</h3><p style='color:#5f666e'>Rubric %1 version %2, metric set "
               "version %3, "
               "build %4, seed %5, recording with %6 frames and final state hash %7. The same "
               "recording "
               "and rubric give the same score.</p>")
        .arg(escaped(record.rubric_id), QString::number(record.rubric_version),
             QString::number(record.metric_set_version), escaped(record.build),
             QString::number(record.seed), QString::number(recording.inputs.size()),
             QString::number(recording.end.final_hash, 16));
}

void draw_footer(QPainter& painter, int page, int pages, const db::AttemptRecord& record) {
    draw_html(
        painter, {kMargin, kHeight - kMargin + 10}, kInner,
        QStringLiteral(
            "<p style='color:#5f666e;font-size:10px'>Placode attempt %1%2 - page %3 of %4</p>")
            .arg(QString::number(record.id),
                 record.demonstration ? QStringLiteral(" - DEMONSTRATION") : QString(),
                 QString::number(page), QString::number(pages)));
}

/// What was harmed when and where, and the ways of the instruments.
void draw_pictures(QPainter& painter, const sim::Recording& recording, const ChartStyle& style) {
    const auto picture =
        ledger_picture(recording.events, recording.header.geometry, recording.end.duration_s);
    double y = kMargin;
    const auto heading = [&](const char* text) {
        y += draw_html(painter, {kMargin, y}, kInner,
                       QStringLiteral("<h3>%1</h3>").arg(figure_word(text))) +
             4;
    };
    heading("Damage over time");
    draw_ledger(painter, QRectF(kMargin, y, kInner, ledger_height(style)), picture, style);
    y += ledger_height(style) + 6;
    heading("Damage and energy on the anatomy");
    const double half = (kInner - 16) / 2, map = 330;
    draw_field_map(painter, QRectF(kMargin, y, half, map), recording, picture.entries,
                   FieldLayer::kDamage, style);
    draw_field_map(painter, QRectF(kMargin + half + 16, y, half, map), recording, picture.entries,
                   FieldLayer::kEnergy, style);
    y += map + 6;
    heading("Ways of the instruments");
    const double third = (kInner - 24) / 3;
    for (int i = 0; i < 3; ++i)
        draw_trajectory(painter, QRectF(kMargin + i * (third + 12), y, third, 250), recording,
                        static_cast<Side>(i), style);
}

}  // namespace

void write_attempt_pdf(const db::AttemptDetail& attempt, const sim::Recording& recording,
                       const std::vector<db::AttemptRecord>& history, const std::string& path) {
    QSaveFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::WriteOnly)) {
        throw ReportError("write report to " + path + ": " + file.errorString().toStdString() +
                          "; choose a folder that you may write to");
    }
    const ChartStyle style;
    {
        QPdfWriter writer(&file);
        writer.setResolution(96);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        writer.setTitle(QStringLiteral("Placode attempt %1").arg(attempt.record.id));
        writer.setCreator(QString::fromStdString("Placode " + attempt.record.build));
        QPainter painter(&writer);
        double y = kMargin;
        y += draw_html(painter, {kMargin, y}, kInner,
                       head_html(attempt.record, attempt.score, style)) +
             8;
        draw_incision(painter, QRectF(kMargin, y, kInner * 0.52, 330), recording, style);
        draw_html(painter, {kMargin + kInner * 0.56, y}, kInner * 0.44,
                  QStringLiteral("<b>Own history of this task</b>"));
        draw_history(painter, QRectF(kMargin + kInner * 0.56, y + 22, kInner * 0.44, 240), history,
                     70, style);
        y += 346;
        draw_html(painter, {kMargin, y}, kInner, reasons_html(attempt.score));
        const auto known = known_metrics(attempt.metrics);
        const size_t tables =
            std::max<size_t>(1, (known.size() + kMetricsAPage - 1) / kMetricsAPage);
        const int pages = 2 + static_cast<int>(tables);
        draw_footer(painter, 1, pages, attempt.record);
        writer.newPage();
        draw_pictures(painter, recording, style);
        draw_footer(painter, 2, pages, attempt.record);
        for (size_t i = 0; i < tables; ++i) {
            writer.newPage();
            const size_t from = i * kMetricsAPage;
            const auto shown =
                std::span(known).subspan(from, std::min(kMetricsAPage, known.size() - from));
            y = kMargin + 12 +
                draw_html(painter, {kMargin, kMargin}, kInner,
                          metrics_html(attempt.metrics, shown));
            if (i + 1 == tables)
                draw_html(painter, {kMargin, y}, kInner,
                          provenance_html(attempt.record, recording));
            draw_footer(painter, static_cast<int>(i) + 3, pages, attempt.record);
        }
    }
    if (!file.commit()) {
        throw ReportError("write report to " + path + ": " + file.errorString().toStdString() +
                          "; free space or choose another folder");
    }
}

}  // namespace placode::reports
