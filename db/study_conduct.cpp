// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/study_conduct.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "db/attempt_counting.h"
#include "db/consent.h"
#include "db/packing.h"
#include "db/said.h"
#include "db/study_records.h"

namespace placode::db {
namespace {

constexpr size_t kLongestConsent = 4000;  // std::regex goes one call deeper with every letter

/// What was read on screen, as one text.
std::string consent_text(const curriculum::Consent& consent, const std::string& language) {
    std::string text;
    for (const auto& paragraph : consent.information) text += paragraph.in(language) + "\n";
    for (const auto& statement : consent.statements) text += statement.text.in(language) + "\n";
    return text;
}

/// The first step of the arm that asks for this questionnaire and is not done yet; else the last
/// that asks; "" where none does.
std::string step_of(Store& store, const curriculum::StudyProtocol& protocol, int arm,
                    const AnswerRecord& answers) {
    std::set<std::string> done;
    for (const StepRecord& step : store.studies().steps(answers.study_id))
        if (step.participant == answers.participant && step.visit == answers.visit &&
            step.state != StepState::kStarted && !step.superseded())
            done.insert(step.step);
    std::string last;
    for (const auto& step : protocol.steps) {
        if (step.kind != curriculum::StepKind::kQuestionnaire ||
            step.questionnaire != answers.questionnaire_id || !step.for_arm(arm))
            continue;
        last = step.id;
        if (!done.contains(step.id)) break;
    }
    return last;
}

/// As enrolled; without a protocol and an arm for a code that is not there.
ParticipantRecord participant_of(Store& store, const std::string& study_id,
                                 const std::string& code) {
    for (ParticipantRecord& each : store.studies().participants(study_id))
        if (each.code == code) return std::move(each);
    return {};
}

/// The step as the participant's version of the protocol has it; nullopt when none is known.
std::optional<curriculum::StudyStep> asked_step(Store& store, const StepRecord& step) {
    const int version = participant_of(store, step.study_id, step.participant).protocol_version;
    if (version == 0) return std::nullopt;
    const auto protocol = published_study(store, step.study_id, version);
    const auto* asked = protocol ? protocol->step(step.step) : nullptr;
    return asked == nullptr ? std::nullopt : std::optional(*asked);
}

bool demonstrates(Store& store, const StepRecord& step) {
    return participant_of(store, step.study_id, step.participant).demonstration;
}

/// Why an attempt does not do the step; nothing = it does.
NotDone why_not_done(const AttemptRecord& attempt,
                     const std::optional<curriculum::StudyStep>& asked) {
    NotDone why;
    why.interrupted =
        attempt.end == sim::EndReason::kInterrupted || attempt.end == sim::EndReason::kRunning;
    if (!why.interrupted && asked && attempt.duration_s < asked->min_s) {
        why.ended_s = static_cast<int>(attempt.duration_s);
        why.least_s = static_cast<int>(asked->min_s);
    }
    why.voids = why_void(attempt);
    return why;
}

void open_because(Progress& progress, const StepRecord& step) {
    progress.open_because = step.superseded() ? step.superseded_reason : step.detail;
    progress.open_meaning = step.superseded() ? std::string() : step.detail_meaning;
}

/// Consent and demographics are not asked again at a second visit.
bool first_visit_only(const curriculum::StudyStep& step) {
    return step.kind == curriculum::StepKind::kConsent || step.questionnaire == "demographics";
}

/// What record_consent() wrote: "consent version 2, en, text 1f..., agreed: read data; signed on
/// paper". Nothing for every other detail.
std::optional<GivenConsent> consent_of(const std::string& detail) {
    static const std::regex kForm(
        R"(consent version (\d{1,9}), ([^,]*), text ([0-9a-f]*), agreed: ([^;]*); signed on (paper|screen).*)");
    std::smatch part;
    if (detail.size() > kLongestConsent || !std::regex_match(detail, part, kForm))
        return std::nullopt;
    GivenConsent consent;
    consent.version = std::stoi(part[1]);
    consent.language = part[2];
    consent.text_checksum = part[3];
    std::istringstream words(part[4].str());
    for (std::string word; words >> word;) consent.agreed.push_back(word);
    consent.on_screen = part[5] == "screen";
    return consent;
}

}  // namespace

std::optional<curriculum::StudyProtocol> published_study(Store& store, const std::string& study_id,
                                                         int version) {
    const auto published = store.definitions().find("study", study_id, version);
    if (!published) return std::nullopt;
    return curriculum::load_study_text(published->json, "study " + study_id);
}

std::optional<curriculum::StudyProtocol> protocol_of(Store& store, const std::string& study_id,
                                                     const std::string& code) {
    return published_study(store, study_id, participant_of(store, study_id, code).protocol_version);
}

bool asked_at(const curriculum::StudyStep& step, int visit) {
    return visit == 1 || !first_visit_only(step);
}

void publish_on_first_use(Store& store, const curriculum::Questionnaire& questionnaire) {
    if (questionnaire.json.empty()) return;
    const auto there =
        store.definitions().find("questionnaire", questionnaire.id, questionnaire.version);
    if (there && there->json == questionnaire.json) return;
    DefinitionRecord definition;
    definition.kind = "questionnaire";
    definition.id = questionnaire.id;
    definition.version = questionnaire.version;
    definition.json = questionnaire.json;
    definition.reason = "first use of this version";
    store.definitions().publish(definition);
}

void record_consent(Store& store, const std::string& study_id, const std::string& code,
                    const std::string& language, const std::vector<std::string>& agreed,
                    const std::string& signature) {
    // An amendment is for who is enrolled after it: this one read the text of the earlier version.
    const auto protocol = protocol_of(store, study_id, code);
    const auto refuse = [&](const Said& problem) {
        throw StoreError(StoreError::Kind::kRefused,
                         "consent of " + code + " to " + study_id + ": ", problem);
    };
    if (!protocol || !protocol->needs_consent())
        refuse(Said::that("the study has no published protocol that asks for one"));
    for (const auto& statement : protocol->consent.statements)
        if (statement.required &&
            std::find(agreed.begin(), agreed.end(), statement.id) == agreed.end())
            refuse(Said::that("the statement \"%1\" is required and was not agreed to")
                       .with(statement.id));
    StepRecord step;
    step.study_id = study_id;
    step.participant = code;
    for (const auto& each : protocol->steps)
        if (each.kind == curriculum::StepKind::kConsent) step.step = each.id;
    std::string list;
    for (const std::string& each : agreed) list += (list.empty() ? "" : " ") + each;
    step.detail = "consent version " + std::to_string(protocol->consent.version) + ", " + language +
                  ", text " + checksum_hex(consent_text(protocol->consent, language)) +
                  ", agreed: " + list +
                  (signature.empty() ? "; signed on paper"
                                     : "; signed on screen, " + checksum_hex(signature));
    store.studies().record_step(step);
    if (!signature.empty()) store.records().save_consent_signature(study_id, code, signature);
}

std::map<std::string, GivenConsent> given_consents(const std::vector<StepRecord>& steps) {
    std::map<std::string, GivenConsent> given;
    for (const StepRecord& step : steps) {
        if (step.state != StepState::kDone || step.superseded()) continue;
        if (auto consent = consent_of(step.detail)) {
            consent->at_utc = step.at_utc;
            given[step.participant] = std::move(*consent);
        }
    }
    return given;
}

bool has_agreed(Store& store, const std::string& study_id, const std::string& code,
                const std::string& statement) {
    bool usable = false;
    for (const ParticipantRecord& one : store.studies().participants(study_id))
        usable = usable || (one.code == code && one.usable());
    const auto given = given_consents(store.studies().steps(study_id));
    const auto found = given.find(code);
    return usable && found != given.end() &&
           std::ranges::find(found->second.agreed, statement) != found->second.agreed.end();
}

int64_t submit_answers(Store& store, const curriculum::Questionnaire& questionnaire,
                       const AnswerRecord& answers) {
    if (const auto problem = curriculum::check_answers(questionnaire, answers.answers))
        throw StoreError(StoreError::Kind::kRefused,
                         "answers of " + answers.participant + " to " + questionnaire.id + ": ",
                         *problem);
    publish_on_first_use(store, questionnaire);
    const int64_t id = store.studies().save_answers(answers);
    // As study_progress() leads the participant on: by version and arm of enrolment.
    const ParticipantRecord who = participant_of(store, answers.study_id, answers.participant);
    const auto protocol = published_study(store, answers.study_id, who.protocol_version);
    if (!protocol) return id;
    StepRecord step;
    step.study_id = answers.study_id;
    step.participant = answers.participant;
    step.visit = answers.visit;
    step.step = step_of(store, *protocol, who.arm, answers);
    step.answer_id = id;
    step.detail = questionnaire.id + " version " + std::to_string(questionnaire.version);
    if (!step.step.empty()) store.studies().record_step(step);
    return id;
}

std::vector<Progress> study_progress(Store& store, const std::string& study_id) {
    std::map<std::string, std::vector<StepRecord>> steps;
    for (auto& step : store.studies().steps(study_id)) steps[step.participant].push_back(step);
    std::map<int, std::optional<curriculum::StudyProtocol>> protocols;
    std::vector<Progress> list;
    for (auto& participant : store.studies().participants(study_id)) {
        Progress progress;
        progress.participant = participant;
        for (const StepRecord& step : steps[participant.code]) {
            progress.last_utc = std::max(progress.last_utc, step.at_utc);
            if (step.superseded()) continue;
            if (step.state == StepState::kStarted) continue;
            progress.finished.push_back(std::to_string(step.visit) + "/" + step.step);
            if (step.state == StepState::kSkipped)
                progress.skipped.push_back(progress.finished.back());
            if (step.attempt_id != 0 && step.detail == kNothingDone)
                progress.idle.push_back(progress.finished.back());
        }
        const int version = participant.protocol_version;
        if (version > 0 && !protocols.contains(version))
            protocols[version] = published_study(store, study_id, version);
        if (version > 0 && protocols[version]) {
            for (int visit = 1; visit <= protocols[version]->visits; ++visit) {
                for (const auto& step : protocols[version]->steps) {
                    if (!asked_at(step, visit)) continue;
                    if (!step.for_arm(participant.arm)) continue;
                    ++progress.total;
                    const std::string key = std::to_string(visit) + "/" + step.id;
                    if (std::find(progress.finished.begin(), progress.finished.end(), key) !=
                        progress.finished.end()) {
                        const auto& skipped = progress.skipped;
                        if (std::find(skipped.begin(), skipped.end(), key) == skipped.end())
                            ++progress.done;
                    } else if (progress.next.empty()) {
                        progress.next = step.id;
                        progress.visit = visit;
                    }
                }
            }
        }
        for (const StepRecord& step : steps[participant.code])
            if (step.step == progress.next && step.visit == progress.visit)
                open_because(progress, step);
        list.push_back(std::move(progress));
    }
    return list;
}

void record_attempt_step(Store& store, StepRecord step) {
    for (const StepRecord& each : store.studies().steps(step.study_id)) {
        if (each.attempt_id != step.attempt_id) continue;
        if (each.participant == step.participant && each.visit == step.visit &&
            each.step == step.step)
            return;
        throw StoreError(StoreError::Kind::kConflict, "record the step \"" + step.step + "\": ",
                         Said::that("attempt %1 does the step \"%2\" of visit %3 of %4 already")
                             .with(step.attempt_id)
                             .with(each.step)
                             .with(each.visit)
                             .with(each.participant));
    }
    const AttemptRecord attempt = store.attempts().detail(step.attempt_id).record;
    const auto asked = asked_step(store, step);
    NotDone why = why_not_done(attempt, asked);
    // Not the participant's yet, who may be there to demonstrate (db/attempt_rows.h).
    if (attempt.study.study.empty() && demonstrates(store, step))
        std::erase_if(why.voids,
                      [](const VoidReason& each) { return each.cause == VoidCause::kScript; });
    step.detail = not_done_text(why);
    step.detail_meaning = not_done_meaning(why);
    step.state = step.detail.empty() ? StepState::kDone : StepState::kStarted;
    // Getting used to the instruments is no data: nobody has to operate in it.
    if (step.detail.empty() && asked && asked->kind == curriculum::StepKind::kProcedure &&
        attempt.verdict == assessment::Verdict::kNotAttempted)
        step.detail = kNothingDone;
    store.studies().record_step(step);
}

}  // namespace placode::db
