// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pdf_report_text.h"

#include <QDateTime>
#include <algorithm>
#include <utility>

#include "db/attempt_counting.h"
#include "reports/metric_groups.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

constexpr double kFullScore = 100;  ///< Points.

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

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

QString kind_words(const ReportSubject& subject) {
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

}  // namespace

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

QString head_html(const ReportSubject& subject, const ChartStyle& style) {
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

QString provenance_html(const ReportSubject& subject) {
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

QString signature_html(const ReportSubject& subject) {
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

}  // namespace placode::reports
