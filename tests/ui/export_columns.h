// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One item of a questionnaire read out of every export by means that are not ours where there are
// some: Qt's JSON and XML readers, the program readstat. Participant to answer.

#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QXmlStreamReader>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reports/csv_table.h"
#include "reports/export.h"

namespace placode::ui {

using Rows = std::vector<std::vector<std::string>>;
using Column = std::map<std::string, std::string>;

inline std::string cell(const Rows& rows, size_t row, const std::string& column) {
    for (size_t c = 0; c < rows.at(0).size(); ++c)
        if (rows[0][c] == column) return rows.at(row).at(c);
    return {};
}

inline Rows table_of(const QString& path) {
    return reports::parse_csv(reports::read_file(path.toStdString()));
}

inline QJsonDocument json_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll())
                                          : QJsonDocument();
}

inline Column csv_column(const QString& folder, const QString& study, const QString& form,
                         const std::string& item) {
    Column column;
    const Rows rows = table_of(folder + "/" + study + "_" + form + ".csv");
    for (size_t r = 1; r < rows.size(); ++r)
        column[cell(rows, r, "participant")] = cell(rows, r, item);
    return column;
}

inline Column fhir_column(const QString& folder, const QString& form, const QString& item) {
    Column column;
    QDirIterator files(folder, {"QuestionnaireResponse-" + form + "*"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QJsonObject resource = json_of(files.next()).object();
        const std::string who = resource["subject"]["identifier"]["value"].toString().toStdString();
        const std::function<void(const QJsonArray&)> search = [&](const QJsonArray& items) {
            for (const QJsonValue& each : items) {
                const QJsonValue answer = each["answer"][0];
                if (each["linkId"].toString() == item)
                    column[who] = answer["valueCoding"].isObject()
                                      ? answer["valueCoding"]["code"].toString().toStdString()
                                      : std::to_string(answer["valueInteger"].toInt());
                search(each["item"].toArray());
            }
        };
        search(resource["item"].toArray());
    }
    return column;
}

/// @param name of the variable in the dictionary.
inline Column redcap_column(const QString& folder, const std::string& name) {
    Column column;
    QDirIterator tables(folder, {"*.csv"}, QDir::Files, QDirIterator::Subdirectories);
    while (tables.hasNext()) {
        const Rows rows = table_of(tables.next());
        if (rows.at(0).at(0) != "record_id") continue;
        for (size_t r = 1; r < rows.size(); ++r)
            if (const std::string value = cell(rows, r, name); !value.empty())
                column[cell(rows, r, "record_id")] = value;
    }
    return column;
}

inline Column odm_column(const QString& folder, const std::string& item_oid) {
    Column column;
    QDirIterator files(folder, {"*.xml"}, QDir::Files, QDirIterator::Subdirectories);
    QFile file(files.hasNext() ? files.next() : QString());
    if (!file.open(QIODevice::ReadOnly)) return column;
    QXmlStreamReader xml(&file);
    std::string subject;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto attribute = [&](const char* name) {
            return xml.attributes().value(QLatin1String(name)).toString().toStdString();
        };
        if (xml.name() == QLatin1String("SubjectData")) subject = attribute("SubjectKey");
        if (xml.name() == QLatin1String("ItemData") && attribute("ItemOID") == item_oid)
            column[subject] = attribute("Value");
    }
    return column;
}

/// The responses of the statements whose activity ends in /FORM/ITEM.
inline Column xapi_column(const QString& folder, const QString& form, const QString& item) {
    Column column;
    QDirIterator files(folder, {"*.json"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext())
        for (const QJsonValue& each : json_of(files.next()).array()) {
            const QString activity = each["object"]["id"].toString();
            if (activity.endsWith("/" + item) && activity.contains(form))
                column[each["actor"]["account"]["name"].toString().toStdString()] =
                    each["result"]["response"].toString().toStdString();
        }
    return column;
}

/// Empty where the program readstat is not installed.
inline Column spss_column(const QString& file, const std::string& item) {
    Column column;
    const QString program = QStandardPaths::findExecutable("readstat");
    if (program.isEmpty()) return column;
    QProcess process;
    process.start(program, {file, "-"});
    process.waitForFinished(60000);
    const std::string text = process.readAllStandardOutput().toStdString();
    const size_t begin = text.find("\"participant");
    if (begin == std::string::npos) return column;
    const Rows rows = reports::parse_csv(text.substr(begin));
    for (size_t r = 1; r < rows.size(); ++r)
        if (const std::string value = cell(rows, r, item); !value.empty())
            column[cell(rows, r, "participant")] =
                std::to_string(static_cast<int>(std::lround(std::stod(value))));
    return column;
}

}  // namespace placode::ui
