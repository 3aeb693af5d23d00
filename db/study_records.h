// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Care of a study's data after they were given: lock and signature of a participant's record,
// corrections with a reason, repeats of a procedure, notes, double entry from paper, the hand's
// signature under a consent.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/questionnaire.h"

namespace placode::db {

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

/// One implementation with Store; every change is one transaction and in the audit trail.
class StudyRecords {
 public:
    virtual ~StudyRecords() = default;

    /// Nothing more is recorded for the participant until it is unlocked. Throws kConflict when it
    /// is locked, kNotFound.
    virtual void lock_record(const std::string& study_id, const std::string& code) = 0;
    /// Login and password are asked for again (two components). Throws kRefused for a record that
    /// is not locked, a wrong password or an empty meaning, kConflict when it is signed.
    virtual void sign_record(const std::string& study_id, const std::string& code,
                             const std::string& login, const std::string& password,
                             const std::string& meaning) = 0;
    /// Cancels the signature. Throws kRefused without a reason, kConflict when not locked.
    virtual void unlock_record(const std::string& study_id, const std::string& code,
                               const std::string& reason) = 0;
    /// Oldest first.
    [[nodiscard]] virtual std::vector<RecordEvent> record_events(const std::string& study_id) = 0;
    /// By code; participants without events are absent.
    [[nodiscard]] virtual std::map<std::string, RecordState> record_states(
        const std::string& study_id) = 0;

    /// Changes answers for a reason; an empty answer takes one away. The whole set must be valid
    /// for its questionnaire. Throws kRefused (invalid, no reason, locked), kNotFound.
    /// @param entry 2 = those of the second entry.
    virtual void correct_answers(int64_t answer_id, int entry, const curriculum::Answers& changes,
                                 const std::string& reason) = 0;
    [[nodiscard]] virtual std::vector<Correction> corrections(const std::string& study_id) = 0;

    /// The same answers typed again; they must be valid, too. Throws kConflict when there is a
    /// second entry already, kRefused, kNotFound.
    virtual void save_second_entry(const SecondEntry& entry) = 0;
    [[nodiscard]] virtual std::vector<SecondEntry> second_entries(const std::string& study_id) = 0;

    /// What was recorded of the step is kept, marked with the reason, and counts no more: the step
    /// is to be done again. For steps with an attempt. Throws kRefused (no reason, nothing that
    /// counts, no attempt, locked, withdrawn), kNotFound.
    virtual void repeat_step(const std::string& study_id, const std::string& code, int visit,
                             const std::string& step, const std::string& reason) = 0;
    /// Throws kRefused for an empty note or a locked record, kNotFound.
    virtual void note_step(const std::string& study_id, const std::string& code, int visit,
                           const std::string& step, const std::string& note) = 0;
    [[nodiscard]] virtual std::vector<StepNote> step_notes(const std::string& study_id) = 0;

    virtual void save_consent_signature(const std::string& study_id, const std::string& code,
                                        const std::string& path) = 0;
    [[nodiscard]] virtual std::optional<ConsentSignature> consent_signature(
        const std::string& study_id, const std::string& code) = 0;
};

}  // namespace placode::db
