// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one attempt on A4: what happened, why it scored so, and where it can be checked.

#include <QDateTime>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <algorithm>

#include "curriculum/task.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "reports/attempt_figures.h"
#include "reports/metric_groups.h"
#include "reports/report.h"
#include "reports/sheets.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

constexpr double kFullScore = 100;  ///< Points.
constexpr double kSheetMargin = Sheets::kMargin, kSheetInner = Sheets::kInner;

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

/// What is printed.
struct Subject {
    const db::AttemptDetail& attempt;
    const sim::Recording& recording;
    const std::vector<db::AttemptRecord>& history;
    const ReportHead& head;
    std::string title;
    TaskScope scope;  ///< What of it is shown.
};

/// Title of the task and what belongs to it, as the recording kept them; else the id.
void read_task(Subject& subject) {
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

QString facts_html(const std::vector<std::pair<QString, QString>>& facts) {
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='2' width='100%'>");
    for (size_t i = 0; i < facts.size(); i += 2) {
        html += QStringLiteral("<tr>");
        for (size_t k = i; k < i + 2; ++k)
            html += k < facts.size() ? QStringLiteral(
                                           "<td style='color:#5f666e'>%1&nbsp;&nbsp;</td><td "
                                           "width='38%'>%2</td>")
                                           .arg(facts[k].first, facts[k].second)
                                     : QStringLiteral("<td></td><td></td>");
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

/// A title with what a store calls it, small, where that is another word.
QString titled(const std::string& title, const QString& id) {
    if (title.empty()) return id;
    return QStringLiteral("%1 <span style='color:#5f666e;font-size:10px'>(%2)</span>")
        .arg(escaped(title), id);
}

QString kind_words(const Subject& subject) {
    const db::ExamContext& exam = subject.attempt.record.exam;
    if (exam.course_id.empty())
        return subject.recording.header.mode == "study" ? QStringLiteral("study")
                                                        : QStringLiteral("practice");
    const QString course = QStringLiteral("%1, version %2")
                               .arg(escaped(exam.course_id), QString::number(exam.course_version));
    return QStringLiteral("exam of %1, stage %2")
        .arg(titled(subject.head.course_title, course),
             titled(subject.title, escaped(exam.stage_id)));
}

/// In the zone of this computer, which the screen shows too, and says so: a paper travels.
QString local_time(const std::string& utc) {
    const QDateTime when =
        QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
    if (!when.isValid()) return escaped(utc);
    const QString offset = when.toOffsetFromUtc(when.offsetFromUtc()).timeZoneAbbreviation();
    const QString zone = when.timeZoneAbbreviation();
    return when.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss ")) +
           (zone == offset || zone.isEmpty() ? offset : QStringLiteral("%1 (%2)").arg(zone, offset))
               .toHtmlEscaped();
}

/// Instead of verdict and points, which such an attempt has none of.
QString not_counted_html(const db::AttemptRecord& record) {
    QString html = QStringLiteral("<p style='font-size:22px'><b>Does not count: %1</b></p>")
                       .arg(not_counted_words(record, Language::kEnglish).toHtmlEscaped());
    QString more = QStringLiteral("The attempt is kept without a score.");
    if (!record.void_reason.empty()) more = escaped(record.void_reason) + ". " + more;
    if (db::machine_at_fault(record))
        more += QStringLiteral(" The machine failed, not the person.");
    return html + QStringLiteral("<p style='background-color:#fff1d6'>&nbsp;%1</p>").arg(more);
}

QString head_html(const Subject& subject, const ChartStyle& style) {
    const db::AttemptRecord& record = subject.attempt.record;
    const assessment::Score& score = subject.attempt.score;
    QString html =
        QStringLiteral(
            "<table width='100%' cellspacing='0'><tr><td><b>%1</b></td><td align='right' "
            "style='color:#5f666e'>Placode &middot; report of attempt %2</td></tr></table>")
            .arg(escaped(subject.head.centre), QString::number(record.id));
    if (record.demonstration)
        html += QStringLiteral(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> - made by a script or "
            "with a demonstration account; proves nothing about a person.</p>");
    html += db::counts(record)
                ? QStringLiteral(
                      "<p style='font-size:22px'><b><span style='color:%1'>%2</span> - %3 of 100 "
                      "points</b></p>")
                      .arg(verdict_colour(score.verdict, style).name(), verdict_word(score.verdict),
                           number(score.points, 1))
                : not_counted_html(record);
    std::vector<std::pair<QString, QString>> facts{
        {QStringLiteral("Person"), escaped(record.user_name)},
        {QStringLiteral("Task"),
         QStringLiteral("%1 (version %2)").arg(escaped(subject.title)).arg(record.task_version)},
        {QStringLiteral("Date"), local_time(record.started_utc)},
        {QStringLiteral("Duration"),
         QStringLiteral("%1, %2").arg(duration_words(record.duration_s), end_word(record.end))},
        {QStringLiteral("Kind"), kind_words(subject)},
        {QStringLiteral("Device"), escaped(record.device)}};
    if (!record.exam.proctor.empty())
        facts.emplace_back(QStringLiteral("Proctor"), escaped(record.exam.proctor));
    if (!record.haptic_grade.empty() && record.haptic_grade != "not_applicable")
        facts.emplace_back(QStringLiteral("Haptic certificate"), escaped(record.haptic_grade));
    return html + facts_html(facts);
}

/// Of an attempt that does not count: what happened, and no points.
std::vector<QString> reason_rows(const assessment::Score& score, bool scored) {
    std::vector<QString> rows;
    double lost = 0;
    for (const assessment::Reason& reason : score.reasons) {
        if (reason.item == assessment::kNotAttemptedItem) continue;
        if (!scored && reason.meaning.pattern == assessment::kNotMeasuredPattern) continue;
        const QString when = reason.time_s < 0
                                 ? QString()
                                 : QStringLiteral("at %1").arg(duration_words(reason.time_s));
        lost += reason.points;
        rows.push_back(QStringLiteral("<tr><td align='right' width='46'>%1</td><td>&nbsp;%2%3</td>"
                                      "<td align='right' width='90' style='color:#5f666e'>%4</td>"
                                      "</tr>")
                           .arg(!scored             ? QString()
                                : reason.points > 0 ? "-" + number(reason.points, 1)
                                                    : QStringLiteral("!"),
                                reason.critical ? QStringLiteral("<b>critical:</b> ") : QString(),
                                reason_words(reason).toHtmlEscaped(), when));
    }
    if (scored && lost > kFullScore)
        rows.push_back(QStringLiteral("<tr><td></td><td style='color:#5f666e'>&nbsp;The losses add "
                                      "up to %1 points; a score does not go below 0.</td><td></td>"
                                      "</tr>")
                           .arg(number(lost, 1)));
    return rows;
}

QString better_word(assessment::Direction direction) {
    switch (direction) {
        case assessment::Direction::kLowerIsBetter:
            return QStringLiteral("lower is better");
        case assessment::Direction::kHigherIsBetter:
            return QStringLiteral("higher is better");
        case assessment::Direction::kNeutral:
            break;
    }
    return QStringLiteral("for information");
}

QString metric_row(const assessment::MetricDefinition& definition, double value,
                   const TaskScope& scope) {
    const bool counts =
        std::find(scope.scored.begin(), scope.scored.end(), definition.id) != scope.scored.end();
    QString name = escaped(std::string(definition.name));
    if (about_force_limit(definition.id) && scope.force_limit_n > 0)
        name += QStringLiteral(" (%1 mN)").arg(number(1000 * scope.force_limit_n, 0));
    return QStringLiteral(
               "<tr><td width='46%'>%1</td><td align='right' width='14%'>%2</td><td "
               "width='14%'>&nbsp;%3</td><td style='color:#5f666e'>%4</td></tr>")
        .arg(counts ? QStringLiteral("<b>%1</b>").arg(name) : name, metric_text(definition, value),
             in_minutes(definition, value) ? QStringLiteral("min")
                                           : unit_sign(definition.unit).toHtmlEscaped(),
             better_word(definition.direction));
}

void add_metrics(Sheets& sheets, const Subject& subject) {
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

QString provenance_html(const Subject& subject) {
    const db::AttemptRecord& record = subject.attempt.record;
    return QStringLiteral(
               "<h3>Can be checked</h3><p style='color:#5f666e'>Rubric %1 version %2, metric set "
               "version %3, build %4, seed %5, recording with %6 frames and final state hash %7. "
               "The same recording and rubric give the same score.</p>")
        .arg(escaped(record.rubric_id), QString::number(record.rubric_version),
             QString::number(record.metric_set_version), escaped(record.build),
             QString::number(record.seed), QString::number(subject.recording.inputs.size()),
             QString::number(subject.recording.end.final_hash, 16));
}

/// Lines to sign on: the person, and who was there or taught.
QString signature_html(const Subject& subject) {
    const db::AttemptRecord& record = subject.attempt.record;
    const auto line = [](const QString& who, const QString& name) {
        return QStringLiteral(
                   "<tr><td colspan='2'><br><br></td></tr><tr><td>____________________________</td>"
                   "<td>________________</td></tr><tr><td style='color:#5f666e'>%1%2</td><td "
                   "style='color:#5f666e'>date</td></tr>")
            .arg(who, name.isEmpty() ? QString() : QStringLiteral(": ") + name);
    };
    const QString second =
        record.exam.proctor.empty() ? QStringLiteral("educator") : QStringLiteral("proctor");
    return QStringLiteral("<h3>Signatures</h3><table width='100%' cellspacing='0'>") +
           line(QStringLiteral("person"), escaped(record.user_name)) +
           line(second, escaped(record.exam.proctor)) + QStringLiteral("</table>");
}

/// What was harmed when and where, and the paths of the instruments.
void add_pictures(Sheets& sheets, const Subject& subject, const ChartStyle& style) {
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
void draw_main_picture(QPainter& painter, const QRectF& where, const Subject& subject,
                       const ChartStyle& style) {
    const AskedPlaces asked = asked_places(subject.recording);
    if (subject.scope.ring)
        draw_incision(painter, where, subject.recording, style);
    else if (asked.any())
        draw_asked(painter, where, subject.recording.header.geometry, asked, style);
    else
        draw_trajectory(painter, where, subject.recording, Side::kAbove, style);
}

void add_first_page(Sheets& sheets, const Subject& subject, const ChartStyle& style) {
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
int lay_out(QPdfWriter* writer, QPainter* painter, const Subject& subject, int pages) {
    ChartStyle style;
    style.plan = subject.scope.line;
    const db::AttemptRecord& record = subject.attempt.record;
    const QString mark = record.demonstration ? QStringLiteral(" - DEMONSTRATION") : QString();
    const QString head =
        QStringLiteral("<p style='color:#5f666e;font-size:10px'>%1 - %2 - %3%4</p>")
            .arg(escaped(record.user_name), escaped(subject.title),
                 local_time(record.started_utc).left(10), mark);
    const QString foot =
        QStringLiteral(
            "<table width='100%' cellspacing='0' style='color:#5f666e;font-size:10px'>"
            "<tr><td>Placode attempt %1%2 - %3</td><td align='right'>page %4 of "
            "%5</td></tr></table>")
            .arg(QString::number(record.id), mark, escaped(record.build), QStringLiteral("%1"),
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
    QSaveFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::WriteOnly)) {
        throw ReportError("write report to " + path + ": " + file.errorString().toStdString() +
                          "; choose a folder that you may write to");
    }
    Subject subject{attempt, recording, history, head, {}, {}};
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
