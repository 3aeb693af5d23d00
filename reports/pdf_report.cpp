// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one attempt on A4: what happened, why it scored so, and where it can be checked.

#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include "curriculum/task.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/private_file.h"
#include "reports/leak_figure.h"
#include "reports/metric_groups.h"
#include "reports/pdf_report_text.h"
#include "reports/report.h"
#include "reports/sheets.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

constexpr double kSheetMargin = Sheets::kMargin, kSheetInner = Sheets::kInner;

/// Title of the task and what belongs to it, as the recording kept them; else the id.
void read_task(ReportSubject& subject) {
    subject.title = subject.attempt.record.task_id;
    subject.scope = scope_of(subject.recording.header);
    try {
        const curriculum::Task task = curriculum::load_task_text(subject.recording.header.task_json,
                                                                 subject.attempt.record.task_id);
        subject.title = task.title.in("en");
    } catch (const curriculum::DefinitionError&) {
        // An old recording whose task this build cannot read any more: the id says enough.
    }
}

void add_metrics(Sheets& sheets, const ReportSubject& subject) {
    sheets.html(
        QStringLiteral("<h2>Metrics</h2><p style='color:#5f666e'>In bold: what the score looks at. "
                       "Left out: what this task does not have.</p>"));
    for (const GroupedMetrics& group : grouped_metrics(subject.attempt.metrics, subject.scope)) {
        std::vector<QString> rows;
        for (const assessment::MetricDefinition& each : group.metrics)
            rows.push_back(metric_row(each, *subject.attempt.metrics.find(each.id), subject.scope));
        sheets.table(
            QString::fromLatin1(group_title(group.group)),
            QStringLiteral("<tr style='color:#5f666e'><td>measure</td><td align='right'>value</td>"
                           "<td>&nbsp;unit</td><td>direction</td></tr>"),
            rows);
    }
    if (nothing_moved_fast(subject.attempt.metrics))
        sheets.html(
            QStringLiteral("<p style='color:#5f666e'>No movements are counted: no tip was "
                           "faster than 20 mm/s.</p>"));
}

/// Where a sewn slit leaks; of a task that looks at it at least why there is no map.
void add_leak(Sheets& sheets, const ReportSubject& subject, const ChartStyle& style) {
    const std::optional<assessment::LeakMap> map = assessment::leak_map(subject.recording);
    if (!map && !looks_at_leak(subject.scope.scored)) return;
    const double height = map ? leak_height(style) : 0;
    sheets.need(height + 60);
    sheets.html(QStringLiteral("<h3>%1</h3>").arg(figure_word("Where it leaks")));
    sheets.space(4);
    if (map)
        sheets.picture(height + 6, [&](QPainter& painter, double y) {
            draw_leak(painter, QRectF(kSheetMargin, y, kSheetInner, height), *map, style);
        });
    sheets.html(QStringLiteral("<p>%1</p>")
                    .arg((map ? leak_words(*map) : no_leak_map_words()).toHtmlEscaped()));
    sheets.space(10);
}

/// What was harmed when and where, and the paths of the instruments.
void add_pictures(Sheets& sheets, const ReportSubject& subject, const ChartStyle& style) {
    const sim::Recording& recording = subject.recording;
    const auto picture = ledger_picture(recording, subject.scope);
    const auto heading = [&](const char* text, double height) {
        sheets.need(height + 30);
        sheets.html(QStringLiteral("<h3>%1</h3>").arg(figure_word(text)));
        sheets.space(4);
    };
    heading("Damage over time", ledger_height(style));
    sheets.picture(ledger_height(style) + 6, [&](QPainter& painter, double y) {
        draw_ledger(painter, QRectF(kSheetMargin, y, kSheetInner, ledger_height(style)), picture,
                    style);
    });
    add_leak(sheets, subject, style);
    const double half = (kSheetInner - 16) / 2, map = 330;
    const bool energy = subject.scope.energy;
    heading(energy ? "Damage and energy on the anatomy" : "Damage on the anatomy", map);
    sheets.picture(map + 6, [&](QPainter& painter, double y) {
        draw_field_map(painter, QRectF(kSheetMargin, y, half, map), recording, picture.entries,
                       FieldLayer::kDamage, style);
        if (energy)
            draw_field_map(painter, QRectF(kSheetMargin + half + 16, y, half, map), recording,
                           picture.entries, FieldLayer::kEnergy, style);
    });
    const double third = (kSheetInner - 24) / 3;
    heading("Paths of the instruments", 250);
    sheets.picture(256, [&](QPainter& painter, double y) {
        for (int i = 0; i < 3; ++i)
            draw_trajectory(painter, QRectF(kSheetMargin + i * (third + 12), y, third, 250),
                            recording, static_cast<Side>(i), style);
    });
}

/// The incision; of a task without one what was asked for; else the paths of the instruments.
void draw_main_picture(QPainter& painter, const QRectF& where, const ReportSubject& subject,
                       const ChartStyle& style) {
    const AskedPlaces asked = asked_places(subject.recording);
    if (subject.scope.ring)
        draw_incision(painter, where, subject.recording, style);
    else if (asked.any())
        draw_asked(painter, where, subject.recording.header.geometry, asked, style);
    else
        draw_trajectory(painter, where, subject.recording, Side::kAbove, style);
}

void add_first_page(Sheets& sheets, const ReportSubject& subject, const ChartStyle& style) {
    sheets.html(head_html(subject, style));
    sheets.space(10);
    sheets.picture(340, [&](QPainter& painter, double y) {
        draw_main_picture(painter, QRectF(kSheetMargin, y, kSheetInner * 0.52, 330), subject,
                          style);
        sheets.draw(QStringLiteral("<b>Own history of this task</b>"),
                    {kSheetMargin + kSheetInner * 0.56, y}, kSheetInner * 0.44, true);
        std::vector<db::AttemptRecord> counted;
        for (const db::AttemptRecord& each : subject.history)
            if (db::counts(each)) counted.push_back(each);
        const QRectF place(kSheetMargin + kSheetInner * 0.56, y + 22, kSheetInner * 0.44, 240);
        if (counted.empty())
            sheets.draw(QStringLiteral("No attempt at this task counts yet."), place.topLeft(),
                        place.width(), true);
        else
            draw_history(painter, place, counted, 70, style);
    });
    const bool scored = db::counts(subject.attempt.record);
    const auto rows = reason_rows(subject.attempt.score, scored);
    if (!rows.empty())
        sheets.table(
            scored ? QStringLiteral("Reasons") : QStringLiteral("What was noticed (not scored)"),
            {}, rows);
    else if (scored)
        sheets.html(QStringLiteral("<h3>Reasons</h3><p>No points were lost.</p>"));
}

/// Everything, on paper or only counted; how many pages it takes.
int lay_out(QPdfWriter* writer, QPainter* painter, const ReportSubject& subject, int pages) {
    ChartStyle style;
    style.plan = subject.scope.line;
    const db::AttemptRecord& record = subject.attempt.record;
    const QString mark = record.demonstration ? QStringLiteral(" - DEMONSTRATION") : QString();
    const QString head =
        QStringLiteral("<p style='color:#5f666e;font-size:10px'>%1 - %2 - %3%4</p>")
            .arg(QString::fromStdString(record.user_name).toHtmlEscaped(),
                 QString::fromStdString(subject.title).toHtmlEscaped(),
                 local_time(record.started_utc).left(10), mark);
    const QString foot =
        QStringLiteral(
            "<table width='100%' cellspacing='0' style='color:#5f666e;font-size:10px'>"
            "<tr><td>Placode attempt %1%2 - %3</td><td align='right'>page %4 of "
            "%5</td></tr></table>")
            .arg(QString::number(record.id), mark,
                 QString::fromStdString(record.build).toHtmlEscaped(), QStringLiteral("%1"),
                 QStringLiteral("%2"));
    Sheets sheets(writer, painter, head, foot, pages);
    add_first_page(sheets, subject, style);
    sheets.newPage();
    add_pictures(sheets, subject, style);
    sheets.newPage();
    add_metrics(sheets, subject);
    sheets.space(8);
    sheets.html(provenance_html(subject));
    sheets.space(12);
    sheets.html(signature_html(subject));
    sheets.finishPage();
    return sheets.pages();
}

}  // namespace

ReportHead report_head(db::Store& store, const db::AttemptRecord& attempt) {
    ReportHead head;
    head.centre = store.norms().centre_name();
    if (attempt.exam.course_id.empty()) return head;
    try {
        head.course_title =
            db::find_course(store, attempt.exam.course_id, attempt.exam.course_version)
                .title.in("en");
    } catch (const curriculum::DefinitionError&) {
        // Neither published nor shipped any more: its id is title enough.
    }
    return head;
}

void write_attempt_pdf(const db::AttemptDetail& attempt, const sim::Recording& recording,
                       const std::vector<db::AttemptRecord>& history, const std::string& path,
                       const ReportHead& head) {
    db::PrivateFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        throw ReportError("write report to " + path + ": " + file.errorString().toStdString() +
                          "; choose a folder that you may write to");
    }
    ReportSubject subject{attempt, recording, history, head, {}, {}};
    read_task(subject);
    {
        QPdfWriter writer(&file);
        writer.setResolution(96);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        writer.setTitle(QStringLiteral("Placode attempt %1").arg(attempt.record.id));
        writer.setCreator(QString::fromStdString("Placode " + attempt.record.build));
        QPainter painter(&writer);
        const int pages = lay_out(nullptr, nullptr, subject, 0);
        lay_out(&writer, &painter, subject, pages);
    }
    if (!file.commit()) {
        throw ReportError("write report to " + path + ": " + file.errorString().toStdString() +
                          "; free space or choose another folder");
    }
}

}  // namespace placode::reports
