// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// FHIR R4: one Questionnaire a form, one QuestionnaireResponse a row. R4, not R5: `choice`, and
// `questionnaire` with the version pinned.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <filesystem>

#include "reports/fhir_questionnaire.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;
constexpr const char* kAbsent = "http://hl7.org/fhir/StructureDefinition/data-absent-reason";

QJsonObject answer_item(const FhirForm& source, const Row& row, const Field& field) {
    const auto found = row.values.find(field.id);
    if (found == row.values.end()) return {};
    QJsonObject item{{"linkId", fhir_text(field.id)}};
    const std::string& value = found->second;
    QJsonArray answers;
    if (field.kind == FieldKind::kCode ||
        (field.kind == FieldKind::kMultiple && value == curriculum::kNotApplicable)) {
        answers.append(QJsonObject{{"valueCoding", fhir_coding_of(source, field, value)}});
    } else if (field.kind == FieldKind::kMultiple) {
        for (const int index : curriculum::answer_indices(value).value_or(std::vector<int>{}))
            answers.append(
                QJsonObject{{"valueCoding", fhir_coding_of(source, field, std::to_string(index))}});
    } else if (field.not_applicable && value == curriculum::kNotApplicable) {
        item["extension"] =
            QJsonArray{QJsonObject{{"url", kAbsent}, {"valueCode", "not-applicable"}}};
        return item;
    } else if (field.kind == FieldKind::kDecimal) {
        answers.append(QJsonObject{{"valueDecimal", *curriculum::answer_number(value)}});
    } else if (field.kind == FieldKind::kDate) {
        answers.append(QJsonObject{{"valueDate", fhir_text(value)}});
    } else {
        answers.append(QJsonObject{{"valueString", fhir_text(value)}});
    }
    item["answer"] = answers;
    return item;
}

/// FHIR's dateTime has seconds and a zone.
QString date_time(const std::string& utc) {
    QString value = fhir_text(utc);
    if (!value.endsWith('Z') && !value.contains('+')) value += 'Z';
    return value;
}

QJsonObject response_of(const FhirForm& source, const Row& row) {
    const Form& form = source.form;
    QJsonObject resource{
        {"resourceType", "QuestionnaireResponse"},
        {"identifier",
         QJsonObject{{"system", source.address("response")},
                     {"value", QString("%1-%2-%3")
                                   .arg(fhir_text(form.name), fhir_text(row.participant))
                                   .arg(row.instance)}}},
        {"questionnaire", source.canonical()},
        {"status", "completed"},
        {"subject",
         QJsonObject{{"type", "Practitioner"},
                     {"identifier", QJsonObject{{"system", source.address("pseudonym")},
                                                {"value", fhir_text(row.participant)}}}}}};
    if (!row.at_utc.empty()) resource["authored"] = date_time(row.at_utc);
    if (!row.language.empty()) resource["language"] = fhir_text(row.language);
    if (row.demonstration)
        resource["meta"] =
            QJsonObject{{"tag", QJsonArray{fhir_coding(source.address("tag"), "demonstration",
                                                       "simulated data, not a person's answers")}}};
    const QJsonArray items = fhir_items(
        form, false, [&](const Field& field) { return answer_item(source, row, field); });
    if (!items.isEmpty()) resource["item"] = items;
    return resource;
}

void save_json(const std::string& path, const QJsonObject& resource) {
    save_file(path, QJsonDocument(resource).toJson(QJsonDocument::Indented).toStdString());
}

std::string root_of(const Dataset& data, const std::string& folder) {
    return folder + "/" + file_name(data.id) + "_fhir";
}

std::string response_path(const std::string& root, const Form& form, const Row& row) {
    return root + "/QuestionnaireResponse-" + file_name(form.name) + "-" +
           file_name(row.participant) + "-" + std::to_string(row.instance) + ".json";
}

// --- reading back ------------------------------------------------------------------------------

std::string answer_text(const Field& field, const QJsonObject& item) {
    const QJsonArray extensions = item["extension"].toArray();
    if (!extensions.isEmpty() && extensions[0].toObject()["url"] == kAbsent)
        return curriculum::kNotApplicable;
    std::string value;
    for (const QJsonValue& entry : item["answer"].toArray()) {
        const QJsonObject answer = entry.toObject();
        if (!value.empty()) value += ';';
        if (field.kind == FieldKind::kCode || field.kind == FieldKind::kMultiple)
            value += answer["valueCoding"].toObject()["code"].toString().toStdString();
        else if (field.kind == FieldKind::kDecimal)
            value += shortest_text(answer["valueDecimal"].toDouble());
        else if (field.kind == FieldKind::kDate)
            value += answer["valueDate"].toString().toStdString();
        else
            value += answer["valueString"].toString().toStdString();
    }
    return value;
}

void read_items(const Form& form, const Row& row, const QJsonArray& items, Cells& cells) {
    for (const QJsonValue& entry : items) {
        const QJsonObject item = entry.toObject();
        read_items(form, row, item["item"].toArray(), cells);
        const Field* field = form.field(item["linkId"].toString().toStdString());
        if (field != nullptr) cells[cell_key(form, row, *field)] = answer_text(*field, item);
    }
}

QJsonObject read_json(const std::string& path) {
    QJsonParseError error{};
    const auto document =
        QJsonDocument::fromJson(QByteArray::fromStdString(read_file(path)), &error);
    if (!document.isObject())
        throw ReportError("read " + path + ": " + error.errorString().toStdString());
    return document.object();
}

}  // namespace

void write_fhir(const ExportSource& source, const std::string& folder) {
    const std::string root = root_of(source.data, folder);
    fs::create_directories(root);
    for (const Form& form : source.data.forms) {
        save_json(root + "/Questionnaire-" + file_name(form.name) + ".json",
                  fhir_questionnaire({source.data, form}));
        for (const Row& row : form.rows)
            save_json(response_path(root, form, row), response_of({source.data, form}, row));
    }
}

void verify_fhir(const ExportSource& source, const std::string& folder) {
    Cells cells;
    const std::string root = root_of(source.data, folder);
    for (const Form& form : source.data.forms) {
        for (const Row& expected : form.rows) {
            const QJsonObject resource = read_json(response_path(root, form, expected));
            Row row;
            row.participant = resource["subject"]["identifier"]["value"].toString().toStdString();
            row.instance = resource["identifier"]["value"].toString().section('-', -1).toInt();
            if (resource["questionnaire"].toString() != FhirForm{source.data, form}.canonical())
                throw ReportError("export fhir: read back, " + response_path(root, form, expected) +
                                  " names another questionnaire");
            read_items(form, row, resource["item"].toArray(), cells);
        }
    }
    compare_cells(cells_of(source.data), cells, "export fhir");
}

}  // namespace placode::reports
