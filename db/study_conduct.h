// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What shell and command line do alike while a study runs: consent, answers, where everyone stands.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "curriculum/study.h"
#include "db/store.h"

namespace placode::db {

/// The published protocol of that version (0 = newest), if there is one.
[[nodiscard]] std::optional<curriculum::StudyProtocol> published_study(Store& store,
                                                                       const std::string& study_id,
                                                                       int version = 0);

/// The published protocol that the participant was enrolled under; the newest for who was enrolled
/// before there was one.
[[nodiscard]] std::optional<curriculum::StudyProtocol> protocol_of(Store& store,
                                                                   const std::string& study_id,
                                                                   const std::string& code);

/// Consent and demographics are asked for at the first visit only, everything else at each.
/// @param visit from 1.
[[nodiscard]] bool asked_at(const curriculum::StudyStep& step, int visit);

/// Publishes the questionnaire's text where this version is not in the store yet, so that answers
/// stay readable whatever happens to the file. Throws as Definitions::publish().
void publish_on_first_use(Store& store, const curriculum::Questionnaire& questionnaire);

/// Records that the participant has consented: the step's detail keeps version, language and
/// checksum of the text that was read, which is that of protocol_of(). @param agreed ids of the
/// statements. Throws kRefused when a required statement is not among them.
/// @param signature the hand's lines (path of an SVG); empty = signed on paper.
void record_consent(Store& store, const std::string& study_id, const std::string& code,
                    const std::string& language, const std::vector<std::string>& agreed,
                    const std::string& signature = {});

/// Checks, keeps the questionnaire's text, saves, and marks the step as done: the one that is due
/// in protocol_of(), of those for the participant's arm. Returns the answers' id. Throws kRefused
/// naming the item that is wrong.
int64_t submit_answers(Store& store, const curriculum::Questionnaire& questionnaire,
                       const AnswerRecord& answers);

/// Detail of a step that is done by an attempt in which nobody operated.
inline constexpr std::string_view kNothingDone = "nothing was done";

/// Marks the step as done by an attempt that is in the store; one that was broken off, was shorter
/// than the protocol asks, or is void is noted with the reason, and the step stays open. One in
/// which nothing was done is kept as done, with kNothingDone as its detail. Does nothing where this
/// step names the attempt already; throws kConflict where another one does, or as
/// Studies::record_step().
/// @param step without state and detail.
void record_attempt_step(Store& store, StepRecord step);

/// Where a participant stands.
struct Progress {
    ParticipantRecord participant;
    int visit = 1;  ///< Of the next step.
    /// Steps of all visits that were done, and all of them; total 0 = no protocol.
    int done = 0, total = 0;
    std::string next;                   ///< Id of the next step; empty = finished, or no protocol.
    std::vector<std::string> finished;  ///< "visit/step", done or skipped, and not superseded.
    std::string open_because;           ///< Why the next step was tried and is not done; or empty.
    std::string open_meaning;           ///< What that means, as the step's detail_meaning.
    std::string last_utc;               ///< Of the newest step.
    /// "visit/step" of the finished ones in which nothing was done: whoever runs the study sees it.
    std::vector<std::string> idle;
    std::vector<std::string> skipped;  ///< "visit/step" of the finished ones: over, but not done.
};
[[nodiscard]] std::vector<Progress> study_progress(Store& store, const std::string& study_id);

/// An item in which the two entries from paper differ; empty = not answered.
struct EntryDifference {
    int64_t answer_id = 0;
    std::string study_id, participant, questionnaire_id, item, first, second;
    std::string entered_by;  ///< Who typed the second entry.
    int visit = 1;           ///< Of the first entry, as the time.
    std::string answered_utc;
};
// double_entry.cpp
/// Over all second entries of a study: what is still to be decided.
[[nodiscard]] std::vector<EntryDifference> entry_differences(Store& store,
                                                             const std::string& study_id);
/// Makes the other entry say the same, also in every item that one of the entries hides and the
/// other shows because of this one, or with it. @param right 1 or 2: which entry says what the
/// paper says. Throws as StudyRecords::correct_answers().
void decide_difference(Store& store, const EntryDifference& difference, int right,
                       const std::string& reason);

}  // namespace placode::db
