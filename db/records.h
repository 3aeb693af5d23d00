// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the store hands out: values, no handles.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring.h"
#include "curriculum/questionnaire.h"
#include "sim/recording.h"

namespace placode::db {

enum class Role : uint8_t { kTrainee = 1, kEducator = 2, kCoordinator = 4, kAdministrator = 8 };
using Roles = uint8_t;  ///< Sum of Role bits: a person may have several.
[[nodiscard]] constexpr bool has_role(Roles roles, Role role) {
    return (roles & static_cast<Roles>(role)) != 0;
}

struct UserRecord {
    int64_t id = 0;
    std::string login;  ///< Unique without case.
    std::string display_name;
    Roles roles = 0;
    bool active = true;
    bool demonstration = false;
    std::string created_utc;
};

/// One row of a history.
struct AttemptRecord {
    int64_t id = 0;
    int64_t user_id = 0;
    std::string user_name;
    std::string task_id;
    int task_version = 0;
    std::string started_utc;
    double duration_s = 0;
    std::string device;
    uint64_t seed = 0;
    std::string build;
    sim::EndReason end = sim::EndReason::kFinished;
    bool demonstration = false;
    double points = 0;
    assessment::Verdict verdict = assessment::Verdict::kNotYet;
    std::string rubric_id;
    int rubric_version = 0;
    int metric_set_version = 0;
};

/// Everything about one attempt but its recording.
struct AttemptDetail {
    AttemptRecord record;
    assessment::MetricSet metrics;
    assessment::Score score;
    std::vector<sim::Event> events;  ///< Ledger: without vaporised elements and hashes.
};

/// What is saved in one transaction when an attempt ends.
struct AttemptResult {
    sim::RecordingHeader header;
    sim::RecordingEnd end;
    assessment::MetricSet metrics;
    assessment::Score score;
    std::vector<sim::Event> events;
    std::string recording_file;  ///< Compressed into the store; empty = none.
};

/// One change of an answer before it was submitted; empty = not answered.
struct AnswerChange {
    std::string item, old_answer, new_answer, at_utc;
};

struct AnswerRecord {
    int64_t id = 0;
    std::string study_id;
    std::string participant;  ///< Pseudonymous code, "P001-K".
    std::string questionnaire_id;
    int questionnaire_version = 1;
    std::string answered_utc;
    curriculum::Answers answers;
    bool demonstration = false;
    std::string language = "en";  ///< In which the questions were read.
    int visit = 1;
    std::vector<AnswerChange> changes;  ///< In order of time.
};

/// What becomes of the data of who withdraws. The code and the withdrawal itself always stay.
enum class WithdrawalMode : uint8_t {
    kKeep,  ///< Takes no further part; the data to date stay in use.
    kStop,  ///< The data stay in the store, but no export and no report uses them any more.
    kErase  ///< Answers, steps and the attempts made for the study are deleted.
};

struct ParticipantRecord {
    std::string study_id, code, enrolled_utc;
    int number = 0;
    int protocol_version = 0;  ///< 0 = the study has no published protocol.
    int arm = -1;              ///< From 0; -1 = no allocation.
    bool demonstration = false;
    std::optional<WithdrawalMode> withdrawal;
    std::string withdrawn_utc, withdrawal_reason;
    /// False when the participant's data must not be used any more.
    [[nodiscard]] bool usable() const {
        return !withdrawal || *withdrawal == WithdrawalMode::kKeep;
    }
};

enum class StepState : uint8_t { kStarted, kDone, kSkipped };

/// Something that a participant did in a study.
struct StepRecord {
    int64_t id = 0;
    std::string study_id, participant;
    int visit = 1;
    std::string step;  ///< Id in the protocol.
    StepState state = StepState::kDone;
    int64_t attempt_id = 0, answer_id = 0;  ///< 0 = none.
    std::string detail, at_utc;
};

/// A published version of a questionnaire or study.
struct DefinitionRecord {
    std::string kind;  ///< "questionnaire" or "study".
    std::string id;
    int version = 1;
    std::string json, checksum, reason, published_by, published_utc;

    friend bool operator==(const DefinitionRecord&, const DefinitionRecord&) = default;
};

struct AuditRecord {
    int64_t id = 0;
    std::string at_utc, actor, action, object, detail;
};

}  // namespace placode::db
