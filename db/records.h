// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the store hands out: values, no handles.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/cohort.h"
#include "assessment/scoring.h"
#include "curriculum/norm_pack.h"
#include "curriculum/questionnaire.h"
#include "db/void_reason.h"
#include "sim/step/recording.h"

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
    bool password_given = false;  ///< Somebody else chose the password, and knows it.
};

/// Under which exam of a course an attempt was made; `course_id` empty = practice.
struct ExamContext {
    std::string course_id;
    int course_version = 0;
    std::string stage_id;
    std::string proctor;             ///< Log-in or name of who was present.
    std::string device_certificate;  ///< Of the haptic device; empty = none.
    int64_t begin = 0;  ///< Courses::begin_exam(); 0 = begun elsewhere, as of an import.

    friend bool operator==(const ExamContext&, const ExamContext&) = default;
};

/// An invitation to make an account oneself.
struct InvitationRecord {
    int64_t id = 0;
    Roles roles = 0;
    int64_t group_id = 0;                                           ///< 0 = none.
    std::string note, invited_by, made_utc, expires_utc, used_utc;  ///< used: empty while open.
};

/// Somebody asked to be erased.
struct ErasureRecord {
    int64_t user_id = 0;
    std::string reason, asked_utc, done_utc;  ///< done: empty while it waits.
};

/// Of which study an attempt is, and whose; `study` empty = a person's own.
struct StudyContext {
    std::string study, participant;

    friend bool operator==(const StudyContext&, const StudyContext&) = default;
};

/// Whether the inputs of an attempt, simulated again, gave the same states, samples and events.
/// Stored as a number: append only.
enum class ReplayState : uint8_t {
    kNotReplayed,  ///< Nobody asked for it: practice, or made before this was asked.
    kWaiting,      ///< An exam or of a study: counts once it is identical.
    kIdentical,
    kDiffers
};

/// One row of a history.
struct AttemptRecord {
    int64_t id = 0;
    int64_t user_id = 0;    ///< 0 = of a study: it belongs to a participant's code.
    std::string user_name;  ///< Of a study: the code.
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
    int preprocessing_version = 1;  ///< assessment::kPreprocessingVersion of that time.
    bool generated = false;         ///< Multiplied from a simulated attempt, to measure the store.
    ExamContext exam;
    StudyContext study;
    std::string haptic_grade;  ///< not_applicable, sound, bad; empty: no certificate was kept.
    /// Why the attempt is void for cause: the computer was too slow or, in an exam, the haptic loop
    /// failed, and the person did not; or tissue was tuned by hand. Empty: it is not. A void
    /// attempt is kept, counts for nothing and uses up no attempt.
    std::string void_reason;
    std::string void_meaning;  ///< JSON of db/void_reason.h; empty: none, or of an older program.
    ReplayState replay = ReplayState::kNotReplayed;
    bool ended = true;  ///< Its end was written down: false of one that a crash broke off.
};

/// An attempt that says something about the person: it came to its end and something was done.
[[nodiscard]] inline bool was_tried(const AttemptRecord& attempt) noexcept {
    return attempt.end != sim::EndReason::kInterrupted &&
           attempt.verdict != assessment::Verdict::kNotAttempted;
}

/// Which attempts a list shows.
struct AttemptFilter {
    int64_t user_id = 0, group_id = 0;  ///< 0 = everybody's.
    std::string task_id;                ///< Empty = every task's.
    /// Also those of studies, which belong to nobody; for who may run studies.
    bool studies = false;
    bool newest_first = true;
    int limit = 100;
    int64_t offset = 0;
};
struct AttemptPage {
    std::vector<AttemptRecord> rows;
    int64_t total = 0;  ///< Of all pages.
};

/// Where a person stands in a task, over all finished attempts.
struct TaskStanding {
    int64_t user_id = 0;
    std::string user_name, task_id;
    int attempts = 0, failed = 0;
    double best_points = 0, mean_points = 0, first_points = 0, last_points = 0;
    std::string last_utc;
    assessment::TrialSummary trials;  ///< For judge_standing().
    bool active = true;               ///< False: the account is closed; who has left needs no help.
};

/// How a person, or a scripted operator that a person had play, did at a task of late.
struct RecentMean {
    int64_t user_id = 0;
    std::string user_name;
    std::string script;  ///< "script:expert"; empty: the person.
    int attempts = 0;    ///< Finished ones, of all time.
    double mean_points = 0;
    bool demonstration = false;
};

/// One finished attempt, as small as it gets: for curves of a whole cohort.
struct AttemptPoint {
    int64_t user_id = 0, attempt_id = 0;
    std::string task_id, started_utc;
    double points = 0;
    assessment::Verdict verdict = assessment::Verdict::kNotYet;
    int task_version = 0;
};

/// Everything about one attempt but its recording.
struct AttemptDetail {
    AttemptRecord record;
    assessment::MetricSet metrics;
    assessment::Score score;
    std::vector<sim::Event> events;  ///< Ledger: without vaporised elements and hashes.
    std::string haptic_certificate;  ///< JSON of haptics/certificate.h; empty: none was kept.
};

/// What is saved in one transaction when an attempt ends.
struct AttemptResult {
    sim::RecordingHeader header;
    sim::RecordingEnd end;
    assessment::MetricSet metrics;
    assessment::Score score;
    std::vector<sim::Event> events;
    std::string recording_file;  ///< Compressed into the store; empty = none.
    ExamContext exam;
    StudyContext study;
    std::string haptic_certificate;  ///< JSON; empty: as the recording file has it.
    /// Why it proves nothing; empty = its task is the published one and its recording is sound
    /// (db/evidence.h).
    std::vector<VoidReason> not_verified;
    /// Text of the order that lay beside the recording, "" where none did. It must be the one that
    /// the recording was begun with (db/recording_order.h). nullopt: who saves it answers for whose
    /// it is, as an import does.
    std::optional<std::string> order;
};

/// A further score of an attempt; the first one is in its AttemptDetail.
struct RescoreRecord {
    int64_t id = 0, attempt_id = 0;
    assessment::MetricSet metrics;
    assessment::Score score;
    int preprocessing_version = 1;
    std::string scored_utc, scored_by;
};

/// An attempt with its metrics, without reasons and events.
struct MeasuredAttempt {
    AttemptRecord record;
    assessment::MetricSet metrics;
};

/// The key with which this centre signs its norms, without its secret half. Hexadecimal.
struct CentreKey {
    std::string centre, public_key, made_utc;
    bool sealed = false;  ///< Under a passphrase; false: an earlier version kept it in clear.
};

struct NormPackRecord {
    int64_t id = 0;
    curriculum::SignedNorms norms;
    curriculum::NormPack pack;  ///< What `norms.content` says.
    bool in_use = false;        ///< The bands against which attempts of the task are shown.
    std::string added_by, added_utc;
};

enum class GroupRole : uint8_t { kNone, kMember, kEducator };

/// A group (cohort) of people.
struct GroupRecord {
    int64_t id = 0;
    std::string name;  ///< Unique without case.
    std::string created_utc;
    std::vector<int64_t> members, educators;  ///< Account ids.
};

/// A course that somebody, or everybody in a group, is to do.
struct AssignmentRecord {
    int64_t id = 0;
    std::string course_id;
    int course_version = 0;
    int64_t user_id = 0, group_id = 0;                 ///< One of them is 0.
    std::string starts_utc, due_utc;                   ///< Empty = no such date.
    std::string assigned_by, assigned_utc, ended_utc;  ///< ended: empty while it holds.
};

/// Attempts beyond a stage's limit.
struct GrantRecord {
    int64_t user_id = 0;
    std::string course_id, stage_id;
    int attempts = 0;
    std::string reason, granted_by, granted_utc;
};

/// An exam that was begun. Its case was seen: it uses up an attempt, whatever becomes of it.
struct ExamBeginRecord {
    int64_t id = 0, user_id = 0;
    std::string course_id, stage_id, task_id;
    int course_version = 0;
    int task_version = 0;  ///< The newest one then; 0 = none was published.
    uint64_t seed = 0;
    std::string proctor, device_certificate;  ///< As in ExamContext.
    std::string begun_utc;                    ///< By the store's clock.
    int64_t attempt_id = 0;                   ///< What it became; 0 = it was not finished.
};

/// A mastered course. The code is printed on the certificate and found again in the store.
struct CertificateRecord {
    int64_t id = 0;
    int64_t user_id = 0;
    std::string course_id;
    int course_version = 0;
    std::string mastered_utc, issued_utc, issued_by, code;
};

/// A remark on an attempt, visible to who made the attempt.
struct CommentRecord {
    int64_t id = 0, attempt_id = 0, author_id = 0;
    std::string author_name;
    double time_s = -1;  ///< Within the recording; negative = on the whole attempt.
    std::string text;    ///< Empty = a bare mark.
    std::string at_utc;
};

/// What a person judged of an attempt, with a questionnaire for raters.
struct RatingRecord {
    int64_t id = 0, attempt_id = 0, rater_id = 0;
    std::string questionnaire_id;
    int questionnaire_version = 1;
    bool blinded = true;  ///< The rater saw neither name nor score.
    std::string rated_utc;
    curriculum::Answers answers;
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
    std::string device;  ///< Chosen by the coordinator, as on the command line; empty = not yet.
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
    std::string detail_meaning;  ///< Why it is not done, as JSON of db/void_reason.h; or empty.
    /// Why and by whom the step is done again; empty = this record counts.
    std::string superseded_reason, superseded_by, superseded_utc;
    [[nodiscard]] bool superseded() const { return !superseded_utc.empty(); }
};

/// A published version of a questionnaire or study.
struct DefinitionRecord {
    std::string kind;  ///< "questionnaire", "study", "course" or "rubric".
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
