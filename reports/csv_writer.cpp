// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// CSV for people and statistics programs: RFC 4180, UTF-8, '.' decimals, atomic on disk.

#include <QLocale>
#include <QSaveFile>
#include <QString>
#include <QStringList>

#include "assessment/metrics.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

/// Text that a person typed. A leading = + - @ tab or return would run as a formula in a
/// spreadsheet, so it gets an apostrophe in front.
QString text_cell(QString text) {
    static const QString dangerous = QStringLiteral("=+-@\t\r");
    if (!text.isEmpty() && dangerous.contains(text.front())) text.prepend(u'\'');
    const bool quote =
        text.contains(u',') || text.contains(u'"') || text.contains(u'\n') || text.contains(u'\r');
    if (!quote) return text;
    return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString text_cell(const std::string& text) { return text_cell(QString::fromStdString(text)); }

/// Shortest text that reads back to the same double.
QString number_cell(double value) {
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

void save(const QString& text, const std::string& path, const char* what) {
    QSaveFile file(QString::fromStdString(path));
    const QByteArray bytes = text.toUtf8();
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit())
        return;
    throw ReportError(std::string("write ") + what + " to " + path + ": " +
                      file.errorString().toStdString() + "; choose a folder that you may write to");
}

bool is_number_item(const curriculum::QuestionnaireItem& item) {
    return item.kind != curriculum::ItemKind::kText;
}

}  // namespace

void write_answers_csv(const curriculum::Questionnaire& questionnaire,
                       const std::vector<db::AnswerRecord>& answers, const std::string& path) {
    QStringList header{"study_id",     "participant",  "questionnaire_id", "questionnaire_version",
                       "answered_utc", "demonstration"};
    for (const auto& item : questionnaire.items) header << text_cell(item.id);
    QString text = header.join(u',') + u'\n';
    for (const db::AnswerRecord& record : answers) {
        QStringList row{text_cell(record.study_id),
                        text_cell(record.participant),
                        text_cell(record.questionnaire_id),
                        QString::number(record.questionnaire_version),
                        text_cell(record.answered_utc),
                        record.demonstration ? QStringLiteral("1") : QStringLiteral("0")};
        for (const auto& item : questionnaire.items) {
            const auto found = record.answers.find(item.id);
            if (found == record.answers.end()) {
                row << QString();  // missing stays empty: never a 0 that a mean would swallow
                continue;
            }
            const QString value = QString::fromStdString(found->second);
            bool numeric = false;
            value.toDouble(&numeric);
            row << (is_number_item(item) && numeric ? value : text_cell(value));
        }
        text += row.join(u',') + u'\n';
    }
    save(text, path, "answers");
}

void write_attempts_csv(const std::vector<db::AttemptDetail>& attempts, const std::string& path) {
    QStringList header{"attempt_id",     "user_id",
                       "task_id",        "task_version",
                       "started_utc",    "duration_s",
                       "device",         "end",
                       "demonstration",  "points",
                       "verdict",        "rubric_id",
                       "rubric_version", "metric_set_version"};
    const auto definitions = assessment::metric_definitions();
    for (const auto& definition : definitions) {
        header << QString::fromUtf8(definition.id.data(),
                                    static_cast<qsizetype>(definition.id.size()));
    }
    QString text = header.join(u',') + u'\n';
    for (const db::AttemptDetail& attempt : attempts) {
        const db::AttemptRecord& record = attempt.record;
        QStringList row{QString::number(record.id),
                        QString::number(record.user_id),
                        text_cell(record.task_id),
                        QString::number(record.task_version),
                        text_cell(record.started_utc),
                        number_cell(record.duration_s),
                        text_cell(record.device),
                        end_word(record.end),
                        record.demonstration ? QStringLiteral("1") : QStringLiteral("0"),
                        number_cell(record.points),
                        verdict_word(record.verdict),
                        text_cell(record.rubric_id),
                        QString::number(record.rubric_version),
                        QString::number(record.metric_set_version)};
        for (const auto& definition : definitions) {
            const auto value = attempt.metrics.find(definition.id);
            row << (value ? number_cell(*value) : QString());
        }
        text += row.join(u',') + u'\n';
    }
    save(text, path, "attempts");
}

}  // namespace placode::reports
