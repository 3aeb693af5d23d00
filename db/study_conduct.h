// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What shell and command line do alike while a study runs: consent, answers, where everyone stands.

#include <optional>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "db/store.h"

namespace placode::db {

/// The published protocol of that version (0 = newest), if there is one.
[[nodiscard]] std::optional<curriculum::StudyProtocol> published_study(Store& store,
                                                                       const std::string& study_id,
                                                                       int version = 0);

/// Publishes the questionnaire's text where this version is not in the store yet, so that answers
/// stay readable whatever happens to the file. Throws as Store::publish().
void publish_on_first_use(Store& store, const curriculum::Questionnaire& questionnaire);

/// Records that the participant has consented: the step's detail keeps version, language and
/// checksum of the text that was read. @param agreed ids of the statements. Throws kRefused when a
/// required statement is not among them.
void record_consent(Store& store, const std::string& study_id, const std::string& code,
                    const std::string& language, const std::vector<std::string>& agreed);

/// Checks, keeps the questionnaire's text, saves, and marks the step as done. Returns the answers'
/// id. Throws kRefused naming the item that is wrong.
int64_t submit_answers(Store& store, const curriculum::Questionnaire& questionnaire,
                       const AnswerRecord& answers);

/// Where a participant stands.
struct Progress {
    ParticipantRecord participant;
    int visit = 1;                      ///< Of the next step.
    int done = 0, total = 0;            ///< Steps of all visits; total 0 = no protocol.
    std::string next;                   ///< Id of the next step; empty = finished, or no protocol.
    std::vector<std::string> finished;  ///< "visit/step", done or skipped.
    std::string last_utc;               ///< Of the newest step.
};
[[nodiscard]] std::vector<Progress> study_progress(Store& store, const std::string& study_id);

}  // namespace placode::db
