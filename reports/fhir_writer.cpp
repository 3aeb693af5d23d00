// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// FHIR R4: one Questionnaire a form, one QuestionnaireResponse a row. R4, not R5: `choice`, and
// `questionnaire` with the version pinned.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <filesystem>

#include "reports/formats.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;
constexpr const char* kNullFlavor = "http://terminology.hl7.org/CodeSystem/v3-NullFlavor";
constexpr const char* kAbsent = "http://hl7.org/fhir/StructureDefinition/data-absent-reason";

QString text(const std::string& value) { return QString::fromStdString(value); }

/// A form of a data set, whose addresses hang on the store it came from.
struct Source {
    const Dataset& data;
    const Form& form;

    [[nodiscard]] QString address(const std::string& thing) const {
        return text(address_of(data, thing));
    }
    [[nodiscard]] QString url() const { return address("Questionnaire/" + form.id); }
    [[nodiscard]] QString canonical() const { return url() + "|" + QString::number(form.version); }
    [[nodiscard]] QString system_of(const Field& field) const {
        return address("CodeSystem/" + form.id + "-" + field.id);
    }
};

QJsonObject coding(const QString& system, const QString& code, const QString& display) {
    QJsonObject object{{"system", system}, {"code", code}};
    if (!display.isEmpty()) object["display"] = display;
    return object;
}

QJsonObject coding_of(const Source& source, const Field& field, const std::string& value) {
    if (value == curriculum::kNotApplicable)
        return coding(kNullFlavor, "NA", QStringLiteral("not applicable"));
    QString display;
    for (const Code& code : field.codes)
        if (std::to_string(code.value) == value) display = text(code.label);
    return coding(source.system_of(field), text(value), display);
}

const char* type_of(const Field& field) {
    switch (field.kind) {
        case FieldKind::kCode:
        case FieldKind::kMultiple:
            return "choice";
        case FieldKind::kDecimal:
            return "decimal";
        case FieldKind::kDate:
            return "date";
        case FieldKind::kText:
            break;
    }
    return "text";
}

QJsonArray extensions_of(const Field& field) {
    QJsonArray list;
    if (!field.unit.empty())
        list.append(
            QJsonObject{{"url", "http://hl7.org/fhir/StructureDefinition/questionnaire-unit"},
                        {"valueCoding", QJsonObject{{"display", text(field.unit)}}}});
    if (field.minimum)
        list.append(QJsonObject{{"url", "http://hl7.org/fhir/StructureDefinition/minValue"},
                                {"valueDecimal", *field.minimum}});
    if (field.maximum)
        list.append(QJsonObject{{"url", "http://hl7.org/fhir/StructureDefinition/maxValue"},
                                {"valueDecimal", *field.maximum}});
    if (field.analogue) {
        const QJsonObject slider =
            coding("http://hl7.org/fhir/questionnaire-item-control", "slider", "Slider");
        list.append(QJsonObject{
            {"url", "http://hl7.org/fhir/StructureDefinition/questionnaire-itemControl"},
            {"valueCodeableConcept", QJsonObject{{"coding", QJsonArray{slider}}}}});
    }
    return list;
}

QJsonObject item_of(const Source& source, const Field& field) {
    QString label = text(field.label);
    if (field.analogue)
        label += QString(" (%1: %2; %3: %4)")
                     .arg(*field.minimum)
                     .arg(text(field.anchor_low))
                     .arg(*field.maximum)
                     .arg(text(field.anchor_high));
    QJsonObject item{{"linkId", text(field.id)}, {"type", type_of(field)}, {"text", label}};
    if (field.required && !field.derived) item["required"] = true;
    if (field.derived) item["readOnly"] = true;
    if (field.kind == FieldKind::kMultiple) item["repeats"] = true;
    QJsonArray options;
    for (const Code& code : field.codes)
        options.append(
            QJsonObject{{"valueCoding", coding_of(source, field, std::to_string(code.value))}});
    if (!field.codes.empty() && field.not_applicable)
        options.append(
            QJsonObject{{"valueCoding", coding_of(source, field, curriculum::kNotApplicable)}});
    if (!options.isEmpty()) item["answerOption"] = options;
    const QJsonArray extensions = extensions_of(field);
    if (!extensions.isEmpty()) item["extension"] = extensions;
    const Field* asked = field.show_if ? source.form.field(field.show_if->item) : nullptr;
    if (asked != nullptr) {
        QJsonArray conditions;
        for (const std::string& answer : field.show_if->any_of)
            conditions.append(QJsonObject{{"question", text(asked->id)},
                                          {"operator", "="},
                                          {"answerCoding", coding_of(source, *asked, answer)}});
        item["enableWhen"] = conditions;
        if (conditions.size() > 1) item["enableBehavior"] = "any";
    }
    return item;
}

/// Items in their sections; `make` gives the item of a field, or an empty object to leave it out.
template <class Make>
QJsonArray items_of(const Form& form, bool with_text, const Make& make) {
    QJsonArray top;
    for (size_t i = 0; i < form.fields.size();) {
        const std::string& section = form.fields[i].section;
        QJsonArray inside;
        const size_t first = i;
        for (; i < form.fields.size() && form.fields[i].section == section; ++i) {
            const QJsonObject item = make(form.fields[i]);
            if (!item.isEmpty()) inside.append(item);
        }
        if (section.empty()) {
            for (const QJsonValue& item : inside) top.append(item);
            continue;
        }
        if (inside.isEmpty()) continue;
        QJsonObject group{{"linkId", QString("section.%1").arg(first + 1)}, {"item", inside}};
        if (with_text) {
            group["type"] = "group";
            group["text"] = text(section);
        }
        top.append(group);
    }
    return top;
}

QJsonObject questionnaire_of_form(const Source& source) {
    const Dataset& data = source.data;
    const Form& form = source.form;
    QJsonObject resource{{"resourceType", "Questionnaire"},
                         {"id", text(plain_name(form.name)).replace('_', '-')},
                         {"url", source.url()},
                         {"version", QString::number(form.version)},
                         {"name", text(plain_name(form.name))},
                         {"title", text(form.title)},
                         {"status", "active"},
                         {"date", text(data.created_utc)},
                         {"subjectType", QJsonArray{"Practitioner"}}};
    if (!form.introduction.empty()) resource["description"] = text(form.introduction);
    if (!form.source.empty()) resource["purpose"] = text("Source: " + form.source);
    if (!form.licence.empty()) resource["copyright"] = text(form.licence);
    resource["item"] =
        items_of(form, true, [&](const Field& field) { return item_of(source, field); });
    return resource;
}

QJsonObject answer_item(const Source& source, const Row& row, const Field& field) {
    const auto found = row.values.find(field.id);
    if (found == row.values.end()) return {};
    QJsonObject item{{"linkId", text(field.id)}};
    const std::string& value = found->second;
    QJsonArray answers;
    if (field.kind == FieldKind::kCode ||
        (field.kind == FieldKind::kMultiple && value == curriculum::kNotApplicable)) {
        answers.append(QJsonObject{{"valueCoding", coding_of(source, field, value)}});
    } else if (field.kind == FieldKind::kMultiple) {
        for (const int index : curriculum::answer_indices(value).value_or(std::vector<int>{}))
            answers.append(
                QJsonObject{{"valueCoding", coding_of(source, field, std::to_string(index))}});
    } else if (field.not_applicable && value == curriculum::kNotApplicable) {
        item["extension"] =
            QJsonArray{QJsonObject{{"url", kAbsent}, {"valueCode", "not-applicable"}}};
        return item;
    } else if (field.kind == FieldKind::kDecimal) {
        answers.append(QJsonObject{{"valueDecimal", *curriculum::answer_number(value)}});
    } else if (field.kind == FieldKind::kDate) {
        answers.append(QJsonObject{{"valueDate", text(value)}});
    } else {
        answers.append(QJsonObject{{"valueString", text(value)}});
    }
    item["answer"] = answers;
    return item;
}

/// FHIR's dateTime has seconds and a zone.
QString date_time(const std::string& utc) {
    QString value = text(utc);
    if (!value.endsWith('Z') && !value.contains('+')) value += 'Z';
    return value;
}

QJsonObject response_of(const Source& source, const Row& row) {
    const Form& form = source.form;
    QJsonObject resource{
        {"resourceType", "QuestionnaireResponse"},
        {"identifier",
         QJsonObject{
             {"system", source.address("response")},
             {"value",
              QString("%1-%2-%3").arg(text(form.name), text(row.participant)).arg(row.instance)}}},
        {"questionnaire", source.canonical()},
        {"status", "completed"},
        {"subject", QJsonObject{{"type", "Practitioner"},
                                {"identifier", QJsonObject{{"system", source.address("pseudonym")},
                                                           {"value", text(row.participant)}}}}}};
    if (!row.at_utc.empty()) resource["authored"] = date_time(row.at_utc);
    if (!row.language.empty()) resource["language"] = text(row.language);
    if (row.demonstration)
        resource["meta"] =
            QJsonObject{{"tag", QJsonArray{coding(source.address("tag"), "demonstration",
                                                  "simulated data, not a person's answers")}}};
    const QJsonArray items =
        items_of(form, false, [&](const Field& field) { return answer_item(source, row, field); });
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
                  questionnaire_of_form({source.data, form}));
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
            if (resource["questionnaire"].toString() != Source{source.data, form}.canonical())
                throw ReportError("export fhir: read back, " + response_path(root, form, expected) +
                                  " names another questionnaire");
            read_items(form, row, resource["item"].toArray(), cells);
        }
    }
    compare_cells(cells_of(source.data), cells, "export fhir");
}

}  // namespace placode::reports
