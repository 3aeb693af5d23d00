// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reading questionnaires. What is done with answers stands in answers.cpp.

#include "curriculum/questionnaire.h"

#include <array>
#include <set>
#include <utility>

#include "curriculum/json_reader.h"

namespace placode::curriculum {

namespace {

constexpr std::array<std::pair<const char*, ItemKind>, 7> kItemKinds{
    {{"likert", ItemKind::kLikert},
     {"number", ItemKind::kNumber},
     {"choice", ItemKind::kChoice},
     {"text", ItemKind::kText},
     {"multiple", ItemKind::kMultiple},
     {"date", ItemKind::kDate},
     {"visual_analogue", ItemKind::kVisualAnalogue}}};

ItemKind kind_of(const std::string& name) {
    for (const auto& [known, kind] : kItemKinds)
        if (name == known) return kind;
    return ItemKind::kLikert;  // The schema has refused everything else.
}

std::vector<LocalText> texts(const Json& json, const char* key) {
    std::vector<LocalText> list;
    for (const Json& text : json.value(key, Json::array())) list.push_back(local_text(text));
    return list;
}

void check_item(const QuestionnaireItem& item, const std::string& origin,
                const std::string& pointer) {
    const auto refuse = [&](const char* problem) {
        throw DefinitionError(origin, pointer, problem);
    };
    const bool likert = item.kind == ItemKind::kLikert;
    if (likert && item.scale_min >= item.scale_max) refuse("scale_max must be above scale_min");
    if (likert && !item.point_labels.empty() &&
        item.point_labels.size() != static_cast<size_t>(item.scale_max - item.scale_min + 1))
        refuse("point_labels must name every value from scale_min to scale_max, or be left out");
    const bool ranged = item.kind == ItemKind::kNumber || item.kind == ItemKind::kVisualAnalogue;
    if (ranged && item.number_min >= item.number_max) refuse("number_max must be above number_min");
    const bool chosen = item.kind == ItemKind::kChoice || item.kind == ItemKind::kMultiple;
    if (chosen && item.choices.size() < 2) refuse("a choice needs two or more \"choices\"");
    if (item.reverse && !likert && item.kind != ItemKind::kVisualAnalogue)
        refuse("reverse is for likert and visual_analogue items");
}

QuestionnaireItem read_item(const Json& json, const std::string& origin,
                            const std::string& pointer) {
    QuestionnaireItem item;
    item.id = json["id"];
    item.kind = kind_of(json["kind"]);
    item.text = local_text(json["text"]);
    item.required = json.value("required", true);
    item.not_applicable = json.value("not_applicable", false);
    item.reverse = json.value("reverse", false);
    item.identifying = json.value("identifying", false);
    item.section = json.value("section", std::string());
    item.unit = json.value("unit", std::string());
    item.scale_min = json.value("scale_min", 1);
    item.scale_max = json.value("scale_max", 5);
    if (json.contains("anchor_low")) item.anchor_low = local_text(json["anchor_low"]);
    if (json.contains("anchor_high")) item.anchor_high = local_text(json["anchor_high"]);
    item.point_labels = texts(json, "point_labels");
    item.choices = texts(json, "choices");
    const bool analogue = item.kind == ItemKind::kVisualAnalogue;
    item.number_min = json.value("number_min", 0.0);
    item.number_max = json.value("number_max", analogue ? 100.0 : 0.0);
    if (json.contains("show_if")) {
        ShowIf condition{json["show_if"]["item"], {}};
        for (const Json& answer : json["show_if"]["any_of"])
            condition.any_of.push_back(answer.get<std::string>());
        item.show_if = condition;
    }
    check_item(item, origin, pointer);
    return item;
}

ScaleScore read_scale(const Json& json) {
    ScaleScore scale;
    scale.id = json["id"];
    scale.title = local_text(json["title"]);
    for (const Json& item : json["items"]) scale.items.push_back(item);
    scale.mean = json.value("method", std::string("mean")) == "mean";
    scale.factor = json.value("factor", 1.0);
    scale.offset = json.value("offset", 0.0);
    scale.minimum_answered = json.value("minimum_answered", 0);
    return scale;
}

/// Sections, conditions and scales name things that are there; conditions look back, so that no
/// item waits for one that comes later.
void check_references(const Questionnaire& questionnaire, const std::string& origin) {
    std::set<std::string> sections, items, scales;
    for (const Section& section : questionnaire.sections) sections.insert(section.id);
    for (size_t i = 0; i < questionnaire.items.size(); ++i) {
        const QuestionnaireItem& item = questionnaire.items[i];
        const std::string pointer = "/items/" + std::to_string(i);
        if (!item.section.empty() && !sections.contains(item.section))
            throw DefinitionError(origin, pointer + "/section",
                                  "there is no section \"" + item.section + "\"");
        if (item.show_if && !items.contains(item.show_if->item))
            throw DefinitionError(origin, pointer + "/show_if/item",
                                  "there is no earlier item \"" + item.show_if->item + "\"");
        if (!items.insert(item.id).second)
            throw DefinitionError(
                origin, pointer + "/id",
                "\"" + item.id + "\" is used twice; every item needs an id of its own");
    }
    for (size_t i = 0; i < questionnaire.scales.size(); ++i) {
        const std::string pointer = "/scales/" + std::to_string(i);
        for (const std::string& name : questionnaire.scales[i].items) {
            const QuestionnaireItem* item = questionnaire.item(name);
            if (item == nullptr || item->kind == ItemKind::kText ||
                item->kind == ItemKind::kMultiple || item->kind == ItemKind::kDate)
                throw DefinitionError(origin, pointer + "/items",
                                      "there is no item \"" + name + "\" with a number as answer");
        }
        if (items.contains(questionnaire.scales[i].id) ||
            !scales.insert(questionnaire.scales[i].id).second)
            throw DefinitionError(origin, pointer + "/id",
                                  "\"" + questionnaire.scales[i].id + "\" is used twice");
    }
}

}  // namespace

const QuestionnaireItem* Questionnaire::item(const std::string& item_id) const {
    for (const QuestionnaireItem& candidate : items)
        if (candidate.id == item_id) return &candidate;
    return nullptr;
}

Questionnaire load_questionnaire_text(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    check_schema(json, "questionnaire", origin);
    Questionnaire questionnaire;
    questionnaire.json = text;
    questionnaire.id = json["id"];
    questionnaire.version = json["version"];
    questionnaire.title = local_text(json["title"]);
    if (json.contains("introduction"))
        questionnaire.introduction = local_text(json["introduction"]);
    questionnaire.source = json.value("source", std::string());
    questionnaire.licence = json.value("licence", std::string());
    for (const Json& section : json.value("sections", Json::array())) {
        questionnaire.sections.push_back({section["id"], local_text(section["title"]), {}});
        if (section.contains("introduction"))
            questionnaire.sections.back().introduction = local_text(section["introduction"]);
    }
    for (size_t i = 0; i < json["items"].size(); ++i)
        questionnaire.items.push_back(
            read_item(json["items"][i], origin, "/items/" + std::to_string(i)));
    for (const Json& scale : json.value("scales", Json::array()))
        questionnaire.scales.push_back(read_scale(scale));
    check_references(questionnaire, origin);
    return questionnaire;
}

Questionnaire load_questionnaire(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("questionnaires", id_or_file);
    return load_questionnaire_text(read_definition(file), file.string());
}

}  // namespace placode::curriculum
