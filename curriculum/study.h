// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study is data: what a participant is told, consents to, does and answers, in this order. A
// published version is never edited; a change is a new version with a reason.

#include <optional>
#include <string>
#include <vector>

#include "curriculum/conduct.h"
#include "curriculum/task.h"

namespace placode::curriculum {

enum class StepKind : uint8_t {
    kConsent,
    kQuestionnaire,
    kBriefing,         ///< Text to read.
    kFamiliarisation,  ///< Free practice of a task, at most max_s.
    kProcedure,        ///< One attempt of a task, with or without a time limit.
};
[[nodiscard]] const char* step_kind_name(StepKind kind);

struct StudyStep {
    std::string id;
    StepKind kind = StepKind::kBriefing;
    LocalText title;
    std::vector<LocalText> text;         ///< Briefing.
    std::string questionnaire;           ///< Questionnaire: its id.
    std::string task;                    ///< Familiarisation and procedure.
    double max_s = 0;                    ///< Familiarisation.
    std::optional<double> time_limit_s;  ///< Procedure; absent = none beyond the task's own.
    double min_s = 0;                    ///< A shorter attempt does not count as done.
    std::string device;        ///< As on the command line; empty = the coordinator chooses once.
    std::optional<Aids> aids;  ///< Absent = those of conduct_of(AttemptMode::kStudy).
    bool required = true;
    std::vector<int> arms;  ///< Only for these, from 0; empty = for everybody.

    /// Of an attempt: a familiarisation or a procedure.
    [[nodiscard]] bool is_attempt() const {
        return kind == StepKind::kFamiliarisation || kind == StepKind::kProcedure;
    }
    /// What the picture may show beyond the fetoscope's view.
    [[nodiscard]] Aids allowed_aids() const;

    [[nodiscard]] bool for_arm(int arm) const;  ///< arm -1 = not allocated.
};

struct ConsentStatement {
    std::string id;
    LocalText text;
    bool required = true;
};

/// What a participant reads and agrees to. A participant's consent keeps the version.
struct Consent {
    int version = 1;
    std::vector<LocalText> information;
    std::vector<ConsentStatement> statements;
};

/// Allocation in permuted blocks; the seed is drawn when the study is published, and nobody sees
/// it.
struct Arms {
    std::vector<LocalText> names;  ///< At least two.
    int block_size = 4;            ///< A multiple of the number of arms.
};

struct StudyProtocol {
    std::string id;
    int version = 1;
    LocalText title, description;
    std::string source;
    std::string reason;  ///< Why this version differs from the one before; may be empty.
    Consent consent;
    std::optional<Arms> arms;
    int visits = 1;
    int keep_years = 0;  ///< Records go so long after a participant's last step; 0 = not said.
    std::vector<StudyStep> steps;  ///< Of every visit; consent and demographics of the first only.
    std::string json;              ///< The text it was read from, for the store.

    [[nodiscard]] const StudyStep* step(const std::string& step_id) const;
    [[nodiscard]] bool needs_consent() const;
};

/// By id of a shipped study, or by path of a JSON file. Throws DefinitionError; also when a task or
/// questionnaire it names is not there.
[[nodiscard]] StudyProtocol load_study(const std::string& id_or_file);
/// From the text that a store keeps.
[[nodiscard]] StudyProtocol load_study_text(const std::string& json, const std::string& origin);

/// Arm (from 0) of the participant with this number, counted from 1: permuted blocks, the same for
/// the same seed.
[[nodiscard]] int allocated_arm(const Arms& arms, uint64_t seed, int participant_number);

}  // namespace placode::curriculum
