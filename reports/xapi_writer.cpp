// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// xAPI 1.0.3 statements for a learning record store: one for every answer, one for every attempt.
// Stand-alone statements, not a cmi5 session: launched, abandoned, waived and satisfied belong to
// the learning system and are never sent.

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QUuid>

#include "reports/formats.h"
#include "reports/report.h"
#include "reports/xapi.h"

namespace placode::reports {
namespace {

QString text(const std::string& value) { return QString::fromStdString(value); }
/// Where a pseudonym is an account: the centre's address, else the store.
QString home_of(const Dataset& data) {
    return text(data.base_uri.empty() ? "urn:uuid:" + data.origin : data.base_uri);
}
/// Readable also without an address: a part of the store's URN (RFC 8141, f-component).
QString address(const Dataset& data, const std::string& thing) {
    return home_of(data) + (data.base_uri.empty() ? "#" : "/") + text(thing);
}

QJsonObject in_english(const QString& value) { return {{"en", value}}; }

/// The same data give the same id: a store that has the statement already says so.
/// @param key of the thing in the store, not its place in a form: that changes with what is added.
QString statement_id(const Dataset& data, const std::string& key) {
    static const QUuid space(QStringLiteral("{5f0b7b0e-8c0e-5d0a-9d53-2a7d52b0a1c4}"));
    return QUuid::createUuidV5(space, text(data.id + "|" + key)).toString(QUuid::WithoutBraces);
}

QString timestamp(const Dataset& data, const Row& row) {
    QString value = text(row.at_utc.empty() ? data.created_utc : row.at_utc);
    if (!value.endsWith('Z')) value += 'Z';
    return value;
}

QJsonObject statement(const Dataset& data, const Form& form, const Row& row,
                      const std::string& verb, const std::string& key) {
    const QJsonObject actor{
        {"objectType", "Agent"},
        {"account", QJsonObject{{"homePage", home_of(data)}, {"name", text(row.participant)}}}};
    const QJsonObject verb_object{{"id", text("http://adlnet.gov/expapi/verbs/" + verb)},
                                  {"display", in_english(text(verb))}};
    QJsonObject extensions{{address(data, "extension/form"), text(form.name)},
                           {address(data, "extension/instance"), row.instance},
                           {address(data, "extension/demonstration"), row.demonstration}};
    const QJsonObject parent{{"objectType", "Activity"}, {"id", address(data, "study/" + data.id)}};
    QJsonObject context{{"platform", text(data.software)},
                        {"extensions", extensions},
                        {"contextActivities", QJsonObject{{"parent", QJsonArray{parent}}}}};
    if (!row.language.empty()) context["language"] = text(row.language);
    return {{"id", statement_id(data, key)},
            {"timestamp", timestamp(data, row)},
            {"version", "1.0.3"},
            {"actor", actor},
            {"verb", verb_object},
            {"context", context}};
}

QJsonArray components(const Field& field) {
    QJsonArray list;
    for (const Code& code : field.codes)
        list.append(QJsonObject{
            {"id", QString::number(code.value)},
            {"description",
             in_english(code.label.empty() ? QString::number(code.value) : text(code.label))}});
    if (field.not_applicable)
        list.append(QJsonObject{{"id", curriculum::kNotApplicable},
                                {"description", in_english("does not apply")}});
    return list;
}

QJsonObject definition_of(const Field& field) {
    QJsonObject definition{{"type", "http://adlnet.gov/expapi/activities/cmi.interaction"},
                           {"name", in_english(text(field.id))},
                           {"description", in_english(text(field.label))}};
    switch (field.kind) {
        case FieldKind::kCode:
            definition["interactionType"] = field.ordinal ? "likert" : "choice";
            definition[field.ordinal ? "scale" : "choices"] = components(field);
            break;
        case FieldKind::kMultiple:
            definition["interactionType"] = "choice";
            definition["choices"] = components(field);
            break;
        case FieldKind::kDecimal:
            definition["interactionType"] = "numeric";
            break;
        case FieldKind::kDate:
            definition["interactionType"] = "other";
            break;
        case FieldKind::kText:
            definition["interactionType"] = "long-fill-in";
            break;
    }
    return definition;
}

/// xAPI separates several choices by [,].
QString response_of(const Field& field, const std::string& value) {
    QString response = text(value);
    return field.kind == FieldKind::kMultiple ? response.replace(";", "[,]") : response;
}

QJsonObject answered(const Dataset& data, const Form& form, const Row& row, const Field& field,
                     const std::string& value) {
    QJsonObject object = statement(data, form, row, "answered",
                                   "answer|" + std::to_string(row.answer_id) + "|" + field.id);
    object["object"] =
        QJsonObject{{"objectType", "Activity"},
                    {"id", address(data, "questionnaire/" + form.id + "/" +
                                             std::to_string(form.version) + "/" + field.id)},
                    {"definition", definition_of(field)}};
    object["result"] = QJsonObject{{"response", response_of(field, value)}};
    return object;
}

QString duration(const std::string& seconds) {
    return "PT" + QString::number(std::stod(seconds), 'f', 2) + "S";
}

/// Everything about the attempt stands in the result's extensions, so that nothing is lost.
QJsonObject attempted(const Dataset& data, const Form& form, const Row& row) {
    const auto value = [&](const char* id) {
        const auto found = row.values.find(id);
        return found == row.values.end() ? std::string() : found->second;
    };
    // What does not count is neither passed nor failed, and what is to be done again not completed.
    const bool passed = row.counts && value("verdict") == "Passed";
    QJsonObject object = statement(data, form, row,
                                   !row.counts ? "terminated"
                                   : passed    ? "passed"
                                               : "failed",
                                   "attempt|" + std::to_string(row.attempt_id));
    object["object"] = QJsonObject{
        {"objectType", "Activity"},
        {"id", address(data, "task/" + value("task_id") + "/" + value("task_version"))},
        {"definition", QJsonObject{{"type", "http://adlnet.gov/expapi/activities/simulation"},
                                   {"name", in_english(text(value("task_id")))}}}};
    QJsonObject extensions;
    for (const auto& [id, each] : row.values)
        extensions[address(data, "metric/" + id)] = text(each);
    const double points = value("points").empty() ? 0 : std::stod(value("points"));
    QJsonObject result{
        {"completion", value("end") == "finished" && value("not_done").empty()},
        {"duration", duration(value("duration_s").empty() ? "0" : value("duration_s"))},
        {"score", QJsonObject{{"scaled", points / 100}, {"raw", points}, {"min", 0}, {"max", 100}}},
        {"extensions", extensions}};
    if (row.counts) result["success"] = passed;
    object["result"] = result;
    return object;
}

/// What has no statement: who is enrolled, who a person is and what deviated from the protocol are
/// no learning experiences.
bool has_statements(const Form& form) {
    return form.id == "attempts" || (is_questionnaire(form) && form.id != "person");
}

std::string path_of(const std::string& folder, const Dataset& data) {
    return folder + "/" + file_name(data.id) + "_xapi.json";
}

Cells read_cells(const Dataset& data, const std::string& path) {
    Cells cells;
    const auto document = QJsonDocument::fromJson(QByteArray::fromStdString(read_file(path)));
    std::set<QString> ids;
    for (const QJsonValue& entry : document.array()) {
        const QJsonValue context = entry["context"]["extensions"];
        const Form* form =
            data.form(context[address(data, "extension/form")].toString().toStdString());
        if (form == nullptr || !ids.insert(entry["id"].toString()).second)
            throw ReportError("export xapi: read back, a statement names no form or repeats an id");
        Row row;
        row.participant = entry["actor"]["account"]["name"].toString().toStdString();
        row.instance = context[address(data, "extension/instance")].toInt();
        if (form->id == "attempts") {
            const QJsonObject metrics = entry["result"]["extensions"].toObject();
            for (const Field& field : form->fields)
                if (const auto found = metrics.find(address(data, "metric/" + field.id));
                    found != metrics.end())
                    cells[cell_key(*form, row, field)] = found->toString().toStdString();
            continue;
        }
        const Field* field =
            form->field(entry["object"]["definition"]["name"]["en"].toString().toStdString());
        if (field == nullptr)
            throw ReportError("export xapi: read back, a statement names no item");
        QString response = entry["result"]["response"].toString();
        if (field->kind == FieldKind::kMultiple) response.replace("[,]", ";");
        cells[cell_key(*form, row, *field)] = response.toStdString();
    }
    return cells;
}

/// `settled` = only what will be said in the same words whenever it is asked for.
QJsonArray statements_of(const Dataset& data, bool settled) {
    QJsonArray statements;
    for (const Form& form : data.forms) {
        if (!has_statements(form)) continue;
        for (const Row& row : form.rows) {
            if (settled && row.waits) continue;
            if (form.id == "attempts") {
                statements.append(attempted(data, form, row));
                continue;
            }
            for (const Field& field : form.fields)
                if (const auto found = row.values.find(field.id); found != row.values.end())
                    statements.append(answered(data, form, row, field, found->second));
        }
    }
    return statements;
}

}  // namespace

std::vector<XapiStatement> xapi_statements(const Dataset& data) {
    std::vector<XapiStatement> all;
    for (const QJsonValue& each : statements_of(data, true))
        all.push_back(
            {each["id"].toString().toStdString(), each["timestamp"].toString().toStdString(),
             QJsonDocument(each.toObject()).toJson(QJsonDocument::Compact).toStdString()});
    return all;
}

void write_xapi(const ExportSource& source, const std::string& folder) {
    save_file(path_of(folder, source.data),
              QJsonDocument(statements_of(source.data, false)).toJson().toStdString());
}

void verify_xapi(const ExportSource& source, const std::string& folder) {
    Dataset expected = source.data;
    std::erase_if(expected.forms, [](const Form& form) { return !has_statements(form); });
    compare_cells(cells_of(expected), read_cells(expected, path_of(folder, source.data)),
                  "export xapi");
}

}  // namespace placode::reports
