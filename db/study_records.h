// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: care of a study's data after they were given: lock and signature of a
// participant's record, corrections with a reason, repeats of a procedure, notes, double entry from
// paper, the hand's signature under a consent.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "curriculum/questionnaire.h"
#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

enum class RecordEventKind : uint8_t { kLocked, kSigned, kUnlocked };

/// Something that happened to the whole record of a participant.
struct RecordEvent {
    int64_t id = 0;
    std::string study_id, code;
    RecordEventKind kind = RecordEventKind::kLocked;
    std::string remark;               ///< Signed: what the signature means. Unlocked: the reason.
    std::string checksum;             ///< Of the record as it was.
    std::string login, name, at_utc;  ///< Whose account; the printed name.
};

/// Where a record stands after its events.
struct RecordState {
    bool locked = false;
    std::optional<RecordEvent> signature;  ///< Absent when none, or cancelled by an unlock.
    bool signature_fits = true;            ///< False when the record is not what was signed.
};

/// An answer that was changed after it had been submitted.
struct Correction {
    int64_t id = 0, answer_id = 0;
    int entry = 1;  ///< 2 = in the second entry from paper.
    std::string item, old_answer, new_answer, reason, corrected_by, at_utc;
};

struct SecondEntry {
    int64_t answer_id = 0;  ///< Of the first entry.
    curriculum::Answers answers;
    std::string entered_by, at_utc;
};

struct ConsentSignature {
    std::string code, path, at_utc;  ///< Path of an SVG, in pixels of the field it was drawn in.
};

/// What a coordinator remarks on a step.
struct StepNote {
    int64_t id = 0;
    std::string study_id, code;
    int visit = 1;
    std::string step, note, noted_by, at_utc;
};

/// `store.records()`. Every change is one transaction and in the audit trail.
class StudyRecords {
 public:
    explicit StudyRecords(StoreContext& context);

    /// Nothing more is recorded for the participant until it is unlocked. Throws kConflict when it
    /// is locked, kNotFound.
    void lock(const std::string& study_id, const std::string& code);
    /// Login and password are asked for again (two components). Throws kRefused for a record that
    /// is not locked, a wrong password or an empty meaning, kConflict when it is signed.
    void sign(const std::string& study_id, const std::string& code, const std::string& login,
              const std::string& password, const std::string& meaning);
    /// Cancels the signature. Throws kRefused without a reason, kConflict when not locked.
    void unlock(const std::string& study_id, const std::string& code, const std::string& reason);
    /// Oldest first.
    [[nodiscard]] std::vector<RecordEvent> events(const std::string& study_id);
    /// By code; participants without events are absent.
    [[nodiscard]] std::map<std::string, RecordState> states(const std::string& study_id);

    // study_records_corrections.cpp
    /// Changes answers for a reason; an empty answer takes one away. The whole set must be valid
    /// for its questionnaire. Throws kRefused (invalid, no reason, locked), kNotFound.
    /// @param entry 2 = those of the second entry.
    void correct_answers(int64_t answer_id, int entry, const curriculum::Answers& changes,
                         const std::string& reason);
    [[nodiscard]] std::vector<Correction> corrections(const std::string& study_id);

    /// The same answers typed again; they must be valid, too. Throws kConflict when there is a
    /// second entry already, kRefused, kNotFound.
    void save_second_entry(const SecondEntry& entry);
    [[nodiscard]] std::vector<SecondEntry> second_entries(const std::string& study_id);

    // study_records_repeats.cpp
    /// What was recorded of the step is kept, marked with the reason, and counts no more: the step
    /// is to be done again. For steps with an attempt. Throws kRefused (no reason, nothing that
    /// counts, no attempt, locked, withdrawn), kNotFound.
    void repeat_step(const std::string& study_id, const std::string& code, int visit,
                     const std::string& step, const std::string& reason);
    /// Throws kRefused for an empty note or a locked record, kNotFound.
    void note_step(const std::string& study_id, const std::string& code, int visit,
                   const std::string& step, const std::string& note);
    [[nodiscard]] std::vector<StepNote> step_notes(const std::string& study_id);

    // study_records_corrections.cpp
    void save_consent_signature(const std::string& study_id, const std::string& code,
                                const std::string& path);
    [[nodiscard]] std::optional<ConsentSignature> consent_signature(const std::string& study_id,
                                                                    const std::string& code);

 private:
    /// Over everything that was recorded of the participant.
    [[nodiscard]] std::string checksum_of(const std::string& study_id, const std::string& code);
    /// The same of many, with as many questions as for one.
    [[nodiscard]] std::map<std::string, std::string> checksums_of(
        const std::string& study_id, const std::set<std::string>& codes);
    void insert_event(RecordEvent event);
    /// The answers of that entry (1 or 2), and of which questionnaire and participant they are.
    [[nodiscard]] AnswerRecord need_answers(int64_t answer_id, int entry);
    void need_valid(const AnswerRecord& answers);

    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
