// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/fhir_questionnaire.h"

#include "reports/text.h"

namespace placode::reports {
namespace {

constexpr const char* kNullFlavor = "http://terminology.hl7.org/CodeSystem/v3-NullFlavor";

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
                        {"valueCoding", QJsonObject{{"display", fhir_text(field.unit)}}}});
    if (field.minimum)
        list.append(QJsonObject{{"url", "http://hl7.org/fhir/StructureDefinition/minValue"},
                                {"valueDecimal", *field.minimum}});
    if (field.maximum)
        list.append(QJsonObject{{"url", "http://hl7.org/fhir/StructureDefinition/maxValue"},
                                {"valueDecimal", *field.maximum}});
    if (field.analogue) {
        const QJsonObject slider =
            fhir_coding("http://hl7.org/fhir/questionnaire-item-control", "slider", "Slider");
        list.append(QJsonObject{
            {"url", "http://hl7.org/fhir/StructureDefinition/questionnaire-itemControl"},
            {"valueCodeableConcept", QJsonObject{{"coding", QJsonArray{slider}}}}});
    }
    return list;
}

QJsonObject item_of(const FhirForm& source, const Field& field) {
    QString label = fhir_text(field.label);
    if (field.analogue)
        label += QString(" (%1: %2; %3: %4)")
                     .arg(*field.minimum)
                     .arg(fhir_text(field.anchor_low))
                     .arg(*field.maximum)
                     .arg(fhir_text(field.anchor_high));
    QJsonObject item{{"linkId", fhir_text(field.id)}, {"type", type_of(field)}, {"text", label}};
    if (field.required && !field.derived) item["required"] = true;
    if (field.derived) item["readOnly"] = true;
    if (field.kind == FieldKind::kMultiple) item["repeats"] = true;
    QJsonArray options;
    for (const Code& code : field.codes)
        options.append(QJsonObject{
            {"valueCoding", fhir_coding_of(source, field, std::to_string(code.value))}});
    if (!field.codes.empty() && field.not_applicable)
        options.append(QJsonObject{
            {"valueCoding", fhir_coding_of(source, field, curriculum::kNotApplicable)}});
    if (!options.isEmpty()) item["answerOption"] = options;
    const QJsonArray extensions = extensions_of(field);
    if (!extensions.isEmpty()) item["extension"] = extensions;
    const Field* asked = field.show_if ? source.form.field(field.show_if->item) : nullptr;
    if (asked != nullptr) {
        QJsonArray conditions;
        for (const std::string& answer : field.show_if->any_of)
            conditions.append(
                QJsonObject{{"question", fhir_text(asked->id)},
                            {"operator", "="},
                            {"answerCoding", fhir_coding_of(source, *asked, answer)}});
        item["enableWhen"] = conditions;
        if (conditions.size() > 1) item["enableBehavior"] = "any";
    }
    return item;
}

}  // namespace

QJsonObject fhir_coding(const QString& system, const QString& code, const QString& display) {
    QJsonObject object{{"system", system}, {"code", code}};
    if (!display.isEmpty()) object["display"] = display;
    return object;
}

QJsonObject fhir_coding_of(const FhirForm& source, const Field& field, const std::string& value) {
    if (value == curriculum::kNotApplicable)
        return fhir_coding(kNullFlavor, "NA", QStringLiteral("not applicable"));
    QString display;
    for (const Code& code : field.codes)
        if (std::to_string(code.value) == value) display = fhir_text(code.label);
    return fhir_coding(source.system_of(field), fhir_text(value), display);
}

QJsonObject fhir_questionnaire(const FhirForm& source) {
    const Dataset& data = source.data;
    const Form& form = source.form;
    QJsonObject resource{{"resourceType", "Questionnaire"},
                         {"id", fhir_text(plain_name(form.name)).replace('_', '-')},
                         {"url", source.url()},
                         {"version", QString::number(form.version)},
                         {"name", fhir_text(plain_name(form.name))},
                         {"title", fhir_text(form.title)},
                         {"status", "active"},
                         {"date", fhir_text(data.created_utc)},
                         {"subjectType", QJsonArray{"Practitioner"}}};
    if (!form.introduction.empty()) resource["description"] = fhir_text(form.introduction);
    if (!form.source.empty()) resource["purpose"] = fhir_text("FhirForm: " + form.source);
    if (!form.licence.empty()) resource["copyright"] = fhir_text(form.licence);
    resource["item"] =
        fhir_items(form, true, [&](const Field& field) { return item_of(source, field); });
    return resource;
}

}  // namespace placode::reports
