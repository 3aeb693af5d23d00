// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/questionnaire.h"

#include <charconv>
#include <cmath>
#include <set>

#include "curriculum/json_reader.h"

namespace placode::curriculum {

namespace {

ItemKind kind_of(const std::string& name) {
    if (name == "number") return ItemKind::kNumber;
    if (name == "choice") return ItemKind::kChoice;
    if (name == "text") return ItemKind::kText;
    return ItemKind::kLikert;
}

QuestionnaireItem read_item(const Json& json, const std::string& origin,
                            const std::string& pointer) {
    QuestionnaireItem item;
    item.id = json["id"];
    item.kind = kind_of(json["kind"]);
    item.text = local_text(json["text"]);
    item.required = json.value("required", true);
    item.unit = json.value("unit", std::string());
    item.scale_min = json.value("scale_min", 1);
    item.scale_max = json.value("scale_max", 5);
    if (json.contains("anchor_low")) item.anchor_low = local_text(json["anchor_low"]);
    if (json.contains("anchor_high")) item.anchor_high = local_text(json["anchor_high"]);
    item.number_min = json.value("number_min", 0.0);
    item.number_max = json.value("number_max", 0.0);
    for (const Json& choice : json.value("choices", Json::array()))
        item.choices.push_back(local_text(choice));
    if (item.kind == ItemKind::kLikert && item.scale_min >= item.scale_max)
        throw DefinitionError(origin, pointer, "scale_max must be above scale_min");
    if (item.kind == ItemKind::kNumber && item.number_min >= item.number_max)
        throw DefinitionError(origin, pointer, "number_max must be above number_min");
    if (item.kind == ItemKind::kChoice && item.choices.size() < 2)
        throw DefinitionError(origin, pointer, "a choice needs two or more \"choices\"");
    return item;
}

/// The whole text as a number, '.' decimals in every locale.
std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string plain(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

std::optional<std::string> check_number(const QuestionnaireItem& item, const std::string& answer,
                                        double low, double high, bool whole) {
    const std::string name = "item " + item.id + ": ";
    const std::optional<double> value = number_in(answer);
    if (!value) return name + "\"" + answer + "\" is not a number";
    if (whole && *value != std::floor(*value)) return name + answer + " is not a whole number";
    if (*value < low) return name + answer + " is below " + plain(low);
    if (*value > high) return name + answer + " is above " + plain(high);
    return std::nullopt;
}

}  // namespace

Questionnaire load_questionnaire(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("questionnaires", id_or_file);
    const std::string origin = file.string();
    const Json json = parse_json(read_definition(file), origin);
    check_schema(json, "questionnaire", origin);
    Questionnaire questionnaire;
    questionnaire.id = json["id"];
    questionnaire.version = json["version"];
    questionnaire.title = local_text(json["title"]);
    if (json.contains("introduction"))
        questionnaire.introduction = local_text(json["introduction"]);
    std::set<std::string> seen;
    for (size_t i = 0; i < json["items"].size(); ++i) {
        const std::string pointer = "/items/" + std::to_string(i);
        questionnaire.items.push_back(read_item(json["items"][i], origin, pointer));
        if (!seen.insert(questionnaire.items.back().id).second) {
            throw DefinitionError(origin, pointer + "/id",
                                  "\"" + questionnaire.items.back().id +
                                      "\" is used twice; every item needs an id of its own");
        }
    }
    return questionnaire;
}

std::optional<std::string> check_answers(const Questionnaire& questionnaire,
                                         const Answers& answers) {
    std::set<std::string> known;
    for (const QuestionnaireItem& item : questionnaire.items) {
        known.insert(item.id);
        const auto found = answers.find(item.id);
        if (found == answers.end() || found->second.empty()) {
            if (item.required) return "item " + item.id + " needs an answer";
            continue;
        }
        std::optional<std::string> problem;
        switch (item.kind) {
            case ItemKind::kLikert:
                problem = check_number(item, found->second, item.scale_min, item.scale_max, true);
                break;
            case ItemKind::kNumber:
                problem =
                    check_number(item, found->second, item.number_min, item.number_max, false);
                break;
            case ItemKind::kChoice:
                problem = check_number(item, found->second, 0,
                                       static_cast<double>(item.choices.size()) - 1, true);
                break;
            case ItemKind::kText:
                break;
        }
        if (problem) return problem;
    }
    for (const auto& [id, unused] : answers) {
        if (!known.contains(id))
            return "item " + id + " is not part of questionnaire " + questionnaire.id;
    }
    return std::nullopt;
}

}  // namespace placode::curriculum
