// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of making a data set: its forms (that of attempts is declared in dataset.h), and the store
// that it comes from.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/consent.h"
#include "db/study_records.h"
#include "reports/dataset.h"
#include "reports/dataset_protocols.h"

namespace placode::reports {

[[nodiscard]] Field text_field(const std::string& id, const std::string& label);
[[nodiscard]] Field code_field(const std::string& id, const std::string& label,
                               std::vector<Code> codes);
/// Sorts by participant and counts the rows of each; a form with a second row repeats.
void number_rows(Form& form);
/// Puts the visit in front of a form's fields: "visit", or "visit_number" where an item is called
/// so.
/// @param visit_of number of a row's visit, from 1.
void add_visits(Form& form, int visits, const std::function<int(const Row&)>& visit_of);
/// @param states by code; a record that was never locked nor signed may be absent.
/// @param consents by code; shown where a version of the protocol asks for one.
[[nodiscard]] Form participants_form(const std::vector<db::ParticipantRecord>& all,
                                     const std::map<std::string, db::RecordState>& states,
                                     const std::map<std::string, db::GivenConsent>& consents,
                                     const Protocols& protocols, const DatasetOptions& options);

/// Adds to the rows of attempts_form() of which step they are and whether they count.
/// @param steps of the study, by attempt.
void add_study_fields(Form& form, const std::map<int64_t, const db::StepRecord*>& steps,
                      const std::vector<db::StepNote>& notes, const DatasetOptions& options);
/// A row each; at least one.
[[nodiscard]] Form deviations_form(const std::vector<db::Deviation>& deviations,
                                   const DatasetOptions& options);
/// Adds a form for every version of a questionnaire that was answered in `data.answers`.
/// @param steps of the study: a questionnaire that several of them ask says of which an answer is.
void add_questionnaires(db::Store& store, const std::vector<db::StepRecord>& steps,
                        const DatasetOptions& options, Dataset& data);

/// Identity of a store, from the first entry of its audit trail: the making of the store.
[[nodiscard]] std::string identity_of(db::Store& store);

}  // namespace placode::reports
