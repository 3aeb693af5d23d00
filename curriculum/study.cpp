// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/study.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "curriculum/bilingual.h"
#include "curriculum/json_reader.h"
#include "sim/core/random.h"

namespace placode::curriculum {

namespace {

constexpr std::array<std::pair<const char*, StepKind>, 5> kKinds{
    {{"consent", StepKind::kConsent},
     {"questionnaire", StepKind::kQuestionnaire},
     {"briefing", StepKind::kBriefing},
     {"familiarisation", StepKind::kFamiliarisation},
     {"procedure", StepKind::kProcedure}}};

StepKind kind_of(const std::string& name) {
    for (const auto& [known, kind] : kKinds)
        if (name == known) return kind;
    return StepKind::kBriefing;  // The schema has refused everything else.
}

void check_step(const StudyStep& step, const std::string& origin, const std::string& pointer) {
    const auto need = [&](bool there, const char* key, const char* what) {
        if (!there)
            throw DefinitionError(origin, pointer,
                                  "the step \"" + step.id + "\" is of kind \"" +
                                      step_kind_name(step.kind) + "\" and needs \"" + key +
                                      "\": " + what);
    };
    constexpr const char* kTask = "the id of a task, such as \"diathermy_ring\"";
    need(step.kind != StepKind::kQuestionnaire || !step.questionnaire.empty(), "questionnaire",
         "the id of a questionnaire, such as \"face_validity\"");
    need(step.kind != StepKind::kBriefing || !step.text.empty(), "text", "what is to be read");
    need(step.kind != StepKind::kFamiliarisation || !step.task.empty(), "task", kTask);
    need(step.kind != StepKind::kFamiliarisation || step.max_s > 0, "max_s",
         "how long it may take at most [s]");
    need(step.kind != StepKind::kProcedure || !step.task.empty(), "task", kTask);
}

/// Rules of an attempt stand in a step that is one, and leave time enough.
void check_conduct(const StudyStep& step, const Json& json, const std::string& origin,
                   const std::string& pointer) {
    for (const char* key : {"device", "aids", "min_s"})
        if (json.contains(key) && !step.is_attempt())
            throw DefinitionError(origin, pointer + "/" + key,
                                  std::string("a step of kind \"") + step_kind_name(step.kind) +
                                      "\" has no attempt; expected kind \"procedure\" or "
                                      "\"familiarisation\"");
    const double most = step.max_s > 0 ? step.max_s : step.time_limit_s.value_or(step.min_s);
    if (step.min_s > most)
        throw DefinitionError(origin, pointer + "/min_s",
                              "found a least duration above the longest one of the step");
}

Aids read_aids(const Json& json, const std::string& origin, const std::string& pointer) {
    std::string names;
    for (const Json& name : json) {
        if (!names.empty()) names += ',';
        names += name.get<std::string>();
    }
    const auto aids = aids_named(names);
    if (!aids) throw DefinitionError(origin, pointer, "found an unknown aid in \"" + names + "\"");
    return *aids;
}

StudyStep read_study_step(const Json& json, const std::string& origin, const std::string& pointer) {
    StudyStep step;
    step.id = json["id"];
    step.kind = kind_of(json["kind"]);
    if (json.contains("title")) step.title = local_text(json["title"]);
    for (const Json& text : json.value("text", Json::array()))
        step.text.push_back(local_text(text));
    step.questionnaire = json.value("questionnaire", std::string());
    step.task = json.value("task", std::string());
    step.max_s = json.value("max_s", 0.0);
    if (json.contains("time_limit_s")) step.time_limit_s = json["time_limit_s"].get<double>();
    step.min_s = json.value("min_s", 0.0);
    step.device = json.value("device", std::string());
    if (json.contains("aids")) step.aids = read_aids(json["aids"], origin, pointer + "/aids");
    step.required = json.value("required", true);
    step.arms = json.value("arms", std::vector<int>());
    check_step(step, origin, pointer);
    check_conduct(step, json, origin, pointer);
    return step;
}

Consent read_consent(const Json& json) {
    Consent consent;
    consent.version = json["version"];
    for (const Json& text : json["information"]) consent.information.push_back(local_text(text));
    for (const Json& statement : json["statements"])
        consent.statements.push_back(
            {statement["id"], local_text(statement["text"]), statement.value("required", true)});
    return consent;
}

Arms read_arms(const Json& json, const std::string& origin) {
    Arms arms;
    for (const Json& name : json["names"]) arms.names.push_back(local_text(name));
    arms.block_size = json["block_size"];
    if (arms.block_size % static_cast<int>(arms.names.size()) != 0)
        throw DefinitionError(origin, "/arms/block_size",
                              std::to_string(arms.block_size) +
                                  " is not a multiple of the number of arms, " +
                                  std::to_string(arms.names.size()));
    return arms;
}

void check_arms(const StudyProtocol& study, const std::string& origin) {
    const int count = study.arms ? static_cast<int>(study.arms->names.size()) : 0;
    for (size_t i = 0; i < study.steps.size(); ++i)
        for (const int arm : study.steps[i].arms)
            if (arm >= count)
                throw DefinitionError(origin, "/steps/" + std::to_string(i) + "/arms",
                                      "found arm " + std::to_string(arm) + "; the study has " +
                                          std::to_string(count) + " arms, counted from 0");
}

/// What a step names must be there when the study is read from a file, not on the first day.
void check_references(const StudyProtocol& study, const std::string& origin) {
    for (size_t i = 0; i < study.steps.size(); ++i) {
        const StudyStep& step = study.steps[i];
        const std::string pointer = "/steps/" + std::to_string(i);
        try {
            if (!step.questionnaire.empty())
                (void)find_definition("questionnaires", step.questionnaire);
            if (!step.task.empty()) (void)find_definition("tasks", step.task);
        } catch (const DefinitionError& error) {
            throw DefinitionError(
                origin, pointer + (step.questionnaire.empty() ? "/task" : "/questionnaire"),
                error.what());
        }
    }
}

/// What participants are told.
LocalText kept_for(int years) {
    return Bilingual::count_phrase(
        "What is recorded of you in this study is kept for %n year(s) after your last step, and "
        "then erased.",
        years);
}

}  // namespace

const char* step_kind_name(StepKind kind) {
    for (const auto& [name, known] : kKinds)
        if (kind == known) return name;
    return "";
}

bool StudyStep::for_arm(int arm) const {
    return arms.empty() || std::find(arms.begin(), arms.end(), arm) != arms.end();
}

Aids StudyStep::allowed_aids() const { return aids.value_or(conduct_of(AttemptMode::kStudy).aids); }

const StudyStep* StudyProtocol::step(const std::string& step_id) const {
    for (const StudyStep& candidate : steps)
        if (candidate.id == step_id) return &candidate;
    return nullptr;
}

bool StudyProtocol::needs_consent() const {
    return std::any_of(steps.begin(), steps.end(),
                       [](const StudyStep& step) { return step.kind == StepKind::kConsent; });
}

StudyProtocol load_study_text(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    check_schema(json, "study", origin);
    StudyProtocol study;
    study.json = text;
    study.id = json["id"];
    study.version = json["version"];
    study.title = local_text(json["title"]);
    if (json.contains("description")) study.description = local_text(json["description"]);
    study.source = json.value("source", std::string());
    study.reason = json.value("reason", std::string());
    study.visits = json.value("visits", 1);
    study.keep_years = json.value("keep_years", 0);
    if (json.contains("consent")) study.consent = read_consent(json["consent"]);
    if (json.contains("arms")) study.arms = read_arms(json["arms"], origin);
    std::set<std::string> seen;
    for (size_t i = 0; i < json["steps"].size(); ++i) {
        const std::string pointer = "/steps/" + std::to_string(i);
        study.steps.push_back(read_study_step(json["steps"][i], origin, pointer));
        if (!seen.insert(study.steps.back().id).second)
            throw DefinitionError(origin, pointer + "/id",
                                  "\"" + study.steps.back().id +
                                      "\" is used twice; every step needs an id of its own");
    }
    check_arms(study, origin);
    if (study.needs_consent() && study.consent.statements.empty())
        throw DefinitionError(origin, "/consent",
                              "a step asks for consent, but there is nothing to consent to");
    // Whoever consents has read it, whatever the authors wrote.
    if (study.keep_years > 0 && study.needs_consent())
        study.consent.information.push_back(kept_for(study.keep_years));
    return study;
}

StudyProtocol load_study(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("studies", id_or_file);
    StudyProtocol study = load_study_text(read_definition(file), file.string());
    check_references(study, file.string());
    return study;
}

int allocated_arm(const Arms& arms, uint64_t seed, int participant_number) {
    const int index = participant_number - 1;
    const int block = index / arms.block_size;
    std::vector<int> order;
    for (int i = 0; i < arms.block_size; ++i)
        order.push_back(i % static_cast<int>(arms.names.size()));
    sim::SplitMix64 random(seed ^ (0xd1342543de82ef95ULL * static_cast<uint64_t>(block + 1)));
    for (size_t i = order.size(); i > 1; --i)  // Fisher-Yates
        std::swap(order[i - 1], order[random.next() % i]);
    return order[static_cast<size_t>(index % arms.block_size)];
}

}  // namespace placode::curriculum
