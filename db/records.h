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

struct AnswerRecord {
    int64_t id = 0;
    std::string study_id;
    std::string participant;  ///< Pseudonymous code, "P001-K".
    std::string questionnaire_id;
    int questionnaire_version = 1;
    std::string answered_utc;
    curriculum::Answers answers;
    bool demonstration = false;
};

struct AuditRecord {
    int64_t id = 0;
    std::string at_utc, actor, action, object, detail;
};

}  // namespace placode::db
