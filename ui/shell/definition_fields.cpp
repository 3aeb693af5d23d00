// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/definition_fields.h"

#include <QCoreApplication>

#include "curriculum/conduct.h"
#include "curriculum/definitions.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct DefinitionFields {
    Q_DECLARE_TR_FUNCTIONS(DefinitionFields)
};
using Kind = FormFieldKind;

std::vector<FormOption> tasks(AppContext& context) {
    std::vector<FormOption> options{{QString(), DefinitionFields::tr("none")}};
    for (const std::string& id : curriculum::list_definitions("tasks"))
        options.push_back({qstr(id), task_title(context, id)});
    return options;
}

std::vector<FormOption> step_kinds() {
    return {{"consent", DefinitionFields::tr("Consent")},
            {"questionnaire", DefinitionFields::tr("Questionnaire")},
            {"briefing", DefinitionFields::tr("Briefing: text to read")},
            {"familiarisation", DefinitionFields::tr("Familiarisation: free practice")},
            {"procedure", DefinitionFields::tr("Procedure: a recorded task")}};
}

std::vector<FormOption> aids() {
    std::vector<FormOption> options;
    for (const std::string_view name : curriculum::kAidNames) {
        const QString id = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        options.push_back({id, id == "planned_line" ? DefinitionFields::tr("the planned line")
                               : id == "read_outs"  ? DefinitionFields::tr("read-outs")
                               : id == "warnings"   ? DefinitionFields::tr("warnings")
                                                    : DefinitionFields::tr("depth")});
    }
    return options;
}

std::vector<FormOption> item_kinds() {
    return {{"likert", DefinitionFields::tr("Likert scale")},
            {"number", DefinitionFields::tr("Number")},
            {"choice", DefinitionFields::tr("One choice")},
            {"multiple", DefinitionFields::tr("Several choices")},
            {"date", DefinitionFields::tr("Date")},
            {"visual_analogue", DefinitionFields::tr("Visual analogue scale")},
            {"text", DefinitionFields::tr("Text")}};
}

}  // namespace

std::vector<FormField> study_fields() {
    return {{"id", DefinitionFields::tr("Id: letters, digits, _")},
            {"version", DefinitionFields::tr("Version"), Kind::kInteger},
            {"title", DefinitionFields::tr("Title"), Kind::kLocal},
            {"description", DefinitionFields::tr("Description"), Kind::kLocal},
            {"source", DefinitionFields::tr("Source")},
            {"reason", DefinitionFields::tr("Why it differs from the version before")},
            {"visits", DefinitionFields::tr("Visits"), Kind::kInteger}};
}

std::vector<FormField> consent_fields() {
    return {
        {"version", DefinitionFields::tr("Version"), Kind::kInteger},
        {"information", DefinitionFields::tr("Information, a paragraph a line: English | Polish"),
         Kind::kLocalLines},
        {"statements",
         DefinitionFields::tr("Statements to agree to, one a line: id | English | Polish"),
         Kind::kStatements}};
}

std::vector<FormField> arms_fields() {
    return {
        {"names",
         DefinitionFields::tr("Names of the arms, one a line: English | Polish (empty = no arms)"),
         Kind::kLocalLines},
        {"block_size", DefinitionFields::tr("Size of a block: a multiple of the number of arms"),
         Kind::kInteger}};
}

std::vector<FormField> step_fields(AppContext& context) {
    return {{"id", DefinitionFields::tr("Id: letters, digits, _")},
            {"kind", DefinitionFields::tr("Kind"), Kind::kChoice, step_kinds()},
            {"title", DefinitionFields::tr("Title"), Kind::kLocal},
            {"text", DefinitionFields::tr("Text to read, a paragraph a line: English | Polish"),
             Kind::kLocalLines},
            {"questionnaire", DefinitionFields::tr("Questionnaire: its id")},
            {"task", DefinitionFields::tr("Task"), Kind::kChoice, tasks(context)},
            {"max_s", DefinitionFields::tr("At most [s] (familiarisation)"), Kind::kNumber},
            {"time_limit_s", DefinitionFields::tr("Time limit [s] (procedure; empty = none)"),
             Kind::kNumber},
            {"min_s",
             DefinitionFields::tr("Least duration [s]: a shorter attempt does not count as done"),
             Kind::kNumber},
            {"device",
             DefinitionFields::tr("Device, e.g. mouse (empty = the coordinator chooses once)")},
            {"aids", DefinitionFields::tr("What the picture may show"), Kind::kSeveral, aids()},
            {"arms", DefinitionFields::tr("Only for these arms, from 0 (empty = everybody)"),
             Kind::kIntegers}};
}

std::vector<FormField> questionnaire_fields() {
    return {{"id", DefinitionFields::tr("Id: letters, digits, _")},
            {"version", DefinitionFields::tr("Version"), Kind::kInteger},
            {"title", DefinitionFields::tr("Title"), Kind::kLocal},
            {"introduction", DefinitionFields::tr("Introduction"), Kind::kLocal},
            {"source", DefinitionFields::tr("Source")},
            {"licence", DefinitionFields::tr("Licence")},
            {"scales",
             DefinitionFields::tr(
                 "Scale scores, one a line: id | mean or sum, then the items | English | Polish"),
             Kind::kScales}};
}

std::vector<FormField> item_fields() {
    return {
        {"id", DefinitionFields::tr("Id: letters, digits, _")},
        {"kind", DefinitionFields::tr("Kind"), Kind::kChoice, item_kinds()},
        {"text", DefinitionFields::tr("Question"), Kind::kLocal},
        {"scale_min", DefinitionFields::tr("Scale from"), Kind::kInteger},
        {"scale_max", DefinitionFields::tr("Scale to"), Kind::kInteger},
        {"anchor_low", DefinitionFields::tr("Word at the low end"), Kind::kLocal},
        {"anchor_high", DefinitionFields::tr("Word at the high end"), Kind::kLocal},
        {"choices", DefinitionFields::tr("Choices, one a line: English | Polish"),
         Kind::kLocalLines},
        {"number_min", DefinitionFields::tr("Least number"), Kind::kNumber},
        {"number_max", DefinitionFields::tr("Greatest number"), Kind::kNumber},
        {"unit", DefinitionFields::tr("Unit")},
        {"show_if", DefinitionFields::tr("Shown only if: item = answers"), Kind::kShowIf},
        {"required", DefinitionFields::tr("An answer is required"), Kind::kFlag, {}, true},
        {"not_applicable", DefinitionFields::tr("\"Does not apply\" may be answered"), Kind::kFlag},
        {"reverse", DefinitionFields::tr("Turned round in scale scores"), Kind::kFlag},
        {"identifying", DefinitionFields::tr("Names a person: leaves only with permission"),
         Kind::kFlag}};
}

QString definition_title(const std::string& json, const std::string& id, const QString& language) {
    const OrderedJson read = OrderedJson::parse(json, nullptr, false);
    const auto title = read.is_object() ? read.find("title") : read.end();
    if (!read.is_object() || title == read.end()) return qstr(id);
    if (title->is_string()) return qstr(title->get<std::string>());
    for (const std::string& each : {language.toStdString(), std::string("en")}) {
        if (!title->is_object() || !title->contains(each) || !(*title)[each].is_string()) continue;
        const auto words = (*title)[each].get<std::string>();
        if (!words.empty()) return qstr(words);
    }
    return qstr(id);
}

QString element_name(const OrderedJson& element) {
    const auto text_at = [&](const char* key) {
        const auto found = element.find(key);
        return found != element.end() && found->is_string() ? qstr(found->get<std::string>())
                                                            : QString();
    };
    if (!element.is_object()) return "?";
    QString kind = text_at("kind");
    for (const auto& options : {step_kinds(), item_kinds()}) {
        for (const FormOption& option : options) {
            if (option.value == kind) kind = option.words.section(':', 0, 0);
        }
    }
    return kind.isEmpty() ? text_at("id") : kind + "  ·  " + text_at("id");
}

QString empty_definition(bool study) {
    return study ? QStringLiteral(R"({
  "id": "my_study",
  "version": 1,
  "title": {
    "en": "My study"
  },
  "consent": {
    "version": 1,
    "information": [
      {
        "en": "What the study is about."
      }
    ],
    "statements": [
      {
        "id": "voluntary",
        "text": {
          "en": "I take part voluntarily."
        }
      }
    ]
  },
  "steps": [
    {
      "id": "consent",
      "kind": "consent",
      "title": {
        "en": "Information and consent"
      }
    }
  ]
})")
                 : QStringLiteral(R"({
  "id": "my_questionnaire",
  "version": 1,
  "title": {
    "en": "My questionnaire"
  },
  "items": [
    {
      "id": "A",
      "kind": "likert",
      "text": {
        "en": "The first question"
      },
      "scale_min": 1,
      "scale_max": 5,
      "anchor_low": {
        "en": "not at all"
      },
      "anchor_high": {
        "en": "very much"
      }
    }
  ]
})");
}

OrderedJson new_element(bool study, size_t number) {
    const std::string tail = std::to_string(number);
    if (study)
        return {{"id", "step_" + tail},
                {"kind", "briefing"},
                {"title", {{"en", "Step " + tail}}},
                {"text", {{{"en", "Text to read"}}}}};
    return {{"id", "item_" + tail},
            {"kind", "likert"},
            {"text", {{"en", "Question " + tail}}},
            {"scale_min", 1},
            {"scale_max", 5},
            {"anchor_low", {{"en", "not at all"}}},
            {"anchor_high", {{"en", "very much"}}}};
}

}  // namespace placode::ui
