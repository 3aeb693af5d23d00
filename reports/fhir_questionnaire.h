// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A form as a FHIR R4 Questionnaire, and what its responses refer to: items in sections, addresses,
// codings. Private to reports: fhir_writer.cpp writes the files.

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <string>

#include "reports/dataset.h"

namespace placode::reports {

[[nodiscard]] inline QString fhir_text(const std::string& value) {
    return QString::fromStdString(value);
}

/// A form of a data set, whose addresses hang on the store it came from.
struct FhirForm {
    const Dataset& data;
    const Form& form;

    [[nodiscard]] QString address(const std::string& thing) const {
        return fhir_text(address_of(data, thing));
    }
    [[nodiscard]] QString url() const { return address("Questionnaire/" + form.id); }
    [[nodiscard]] QString canonical() const { return url() + "|" + QString::number(form.version); }
    [[nodiscard]] QString system_of(const Field& field) const {
        return address("CodeSystem/" + form.id + "-" + field.id);
    }
};

[[nodiscard]] QJsonObject fhir_coding(const QString& system, const QString& code,
                                      const QString& display);
/// Of an answer of a field with codes; "does not apply" is FHIR's own NA.
[[nodiscard]] QJsonObject fhir_coding_of(const FhirForm& source, const Field& field,
                                         const std::string& value);

/// Items in their sections; `make` gives the item of a field, or an empty object to leave it out.
template <class Make>
QJsonArray fhir_items(const Form& form, bool with_text, const Make& make) {
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
            group["text"] = fhir_text(section);
        }
        top.append(group);
    }
    return top;
}

[[nodiscard]] QJsonObject fhir_questionnaire(const FhirForm& source);

}  // namespace placode::reports
