// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The store: users, attempts, recordings, answers, audit. SQLite embedded or PostgreSQL for a
// centre, one code over Qt Sql. One Store per thread. Every change is one transaction.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "db/migrations.h"
#include "db/records.h"

namespace placode::db {

class StudyRecords;

/// Operation, place and way out, e.g. `open sqlite:/x/placode.db: database is locked by another
/// program; close it, or wait and try again`.
class StoreError : public std::runtime_error {
 public:
    enum class Kind : uint8_t {
        kUnavailable,
        kLocked,
        kDamaged,
        kTooNew,
        kConflict,
        kRefused,
        kNotFound,
        kOther
    };
    StoreError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

enum class SignInOutcome : uint8_t { kOk, kWrong, kThrottled, kDeactivated };
struct SignIn {
    SignInOutcome outcome = SignInOutcome::kWrong;
    std::optional<UserRecord> user;
    int wait_s = 0;  ///< kThrottled: seconds until the next try.
};

struct NewUser {
    std::string login, display_name, password;
    Roles roles = static_cast<Roles>(Role::kTrainee);
    bool demonstration = false;
};

class Store {
 public:
    virtual ~Store() = default;

    /// Every change below is written into the audit trail in its own transaction, under this name.
    /// A successful sign_in() sets it to the login. Before: "unknown".
    virtual void act_as(const std::string& actor) = 0;

    // --- accounts
    virtual int64_t create_user(
        const NewUser& user) = 0;  ///< Throws kConflict, kRefused (weak password).
    /// After 5 wrong passwords in a row the login has to wait: 5 s, then twice as long each time,
    /// at most 15 min. What is not an account waits and takes as long as what is one.
    virtual SignIn sign_in(const std::string& login, const std::string& password) = 0;
    virtual void set_password(int64_t user_id, const std::string& password) = 0;
    /// Throws kRefused when it would leave no active administrator.
    virtual void set_active(int64_t user_id, bool active) = 0;
    /// Four to twelve digits for a quick return at a shared station; empty = none any more. Throws
    /// kRefused for a PIN that is too easy. A new password takes the PIN away.
    virtual void set_pin(int64_t user_id, const std::string& pin) = 0;
    [[nodiscard]] virtual bool has_pin(int64_t user_id) = 0;
    /// As sign_in(), by PIN. After 3 wrong ones in a row the PIN is gone and the password needed.
    virtual SignIn unlock(int64_t user_id, const std::string& pin) = 0;
    /// Returns the code to hand over; the store keeps its hash only.
    virtual std::string invite(const InvitationRecord& invitation) = 0;
    [[nodiscard]] virtual std::vector<InvitationRecord> invitations() = 0;
    /// Makes the account of who was invited; roles and group are the invitation's. A code works
    /// once. Throws kRefused for a code that is wrong, used or expired, else as create_user().
    virtual int64_t accept_invitation(const std::string& code, const NewUser& user) = 0;
    virtual void request_erasure(int64_t user_id, const std::string& reason) = 0;
    [[nodiscard]] virtual std::vector<ErasureRecord> erasure_requests() = 0;
    /// Removes who the account is: name, login, password, PIN, groups, assignments; it can never be
    /// signed in to again. Attempts stay without a name, or go as well. Throws kRefused for the
    /// last active administrator.
    virtual void erase_person(int64_t user_id, bool with_attempts) = 0;
    [[nodiscard]] virtual std::vector<UserRecord> users() = 0;
    [[nodiscard]] virtual std::optional<UserRecord> user(int64_t id) = 0;
    [[nodiscard]] virtual std::optional<UserRecord> user_by_login(const std::string& login) = 0;

    // --- attempts
    /// Attempt, metrics, reasons, events and the recording's bytes, all or nothing. Vaporised
    /// elements and hashes are left out of the events: the recording has them.
    virtual int64_t save_attempt(int64_t user_id, const AttemptResult& result) = 0;
    /// Oldest first; user_id 0 = everybody's and those of studies; task_id empty = all. A person's
    /// own never hold what a participant did while that person was signed in.
    [[nodiscard]] virtual std::vector<AttemptRecord> attempts(int64_t user_id,
                                                              const std::string& task_id = {}) = 0;
    [[nodiscard]] virtual AttemptDetail attempt(int64_t id) = 0;  ///< Throws kNotFound.
    /// Writes the recording file of an attempt to `path`.
    virtual void extract_recording(int64_t attempt_id, const std::string& path) = 0;

    /// The attempt that holds exactly this recording file, if any: a file left over from a crash
    /// between saving and removing is not saved twice.
    [[nodiscard]] virtual std::optional<int64_t> attempt_of_recording(
        const std::string& recording_file) = 0;

    /// Keeps a further score beside the first one. Throws kConflict when the attempt has one under
    /// the same rubric, metric set and pre-processing.
    virtual int64_t save_rescore(const RescoreRecord& rescore) = 0;
    [[nodiscard]] virtual std::vector<RescoreRecord> rescores(int64_t attempt_id) = 0;

    /// One page of a list.
    [[nodiscard]] virtual AttemptPage attempt_page(const AttemptFilter& filter) = 0;
    /// By name and task; group_id 0 = everybody. task_id empty = all.
    [[nodiscard]] virtual std::vector<TaskStanding> task_standings(
        int64_t group_id, const std::string& task_id = {}) = 0;
    /// Ids of the tasks that anybody has attempted, by name.
    [[nodiscard]] virtual std::vector<std::string> tasks_with_attempts() = 0;
    /// Mean of each one's last `last` finished attempts at a task, by name.
    [[nodiscard]] virtual std::vector<RecentMean> recent_means(const std::string& task_id,
                                                               int last) = 0;
    /// By person, task and time.
    [[nodiscard]] virtual std::vector<AttemptPoint> attempt_points(
        int64_t group_id, const std::string& task_id = {}) = 0;

    // --- norms
    /// Attempts of a task with their metrics, oldest first; user_id 0 = everybody's. None of
    /// studies.
    [[nodiscard]] virtual std::vector<MeasuredAttempt> measured_attempts(
        int64_t user_id, const std::string& task_id) = 0;
    /// Made on first use under this name. Throws kRefused when it has to be made without a name.
    virtual CentreKey centre_key(const std::string& centre) = 0;
    virtual void trust_centre(const std::string& public_key, const std::string& centre) = 0;
    /// Name by public key.
    [[nodiscard]] virtual std::map<std::string, std::string> trusted_centres() = 0;
    /// Keeps a pack whose signature is right and whose centre is trusted; the same pack once.
    /// Throws kRefused, DefinitionError.
    virtual int64_t save_norms(const curriculum::SignedNorms& norms) = 0;
    /// task_id empty = all.
    [[nodiscard]] virtual std::vector<NormPackRecord> norm_packs(const std::string& task_id) = 0;
    virtual void use_norms(int64_t id) = 0;  ///< For its task, in place of the one before.

    // --- groups, courses
    virtual int64_t create_group(const std::string& name) = 0;  ///< Throws kConflict, kRefused.
    virtual void set_group_role(int64_t group_id, int64_t user_id, GroupRole role) = 0;
    [[nodiscard]] virtual std::vector<GroupRecord> groups() = 0;  ///< By name.
    /// True when `subject` is in no group, or in one where `actor` is educator.
    [[nodiscard]] virtual bool in_reach(int64_t actor, int64_t subject) = 0;
    /// Assigns a published version. Throws kRefused (not published, dates), kConflict (already).
    virtual int64_t assign_course(const AssignmentRecord& assignment) = 0;
    virtual void end_assignment(int64_t id) = 0;  ///< Throws kNotFound, kConflict.
    /// What holds for a person, also by group, by due date; user_id 0 = all, also ended ones.
    [[nodiscard]] virtual std::vector<AssignmentRecord> assignments(int64_t user_id) = 0;
    virtual void grant_attempts(const GrantRecord& grant) = 0;  ///< Throws kRefused.
    [[nodiscard]] virtual std::vector<GrantRecord> grants(int64_t user_id) = 0;
    /// The same certificate again where this version has one. Whether it is deserved is decided by
    /// issue_certificate() in db/course_conduct.h.
    virtual CertificateRecord save_certificate(int64_t user_id, const std::string& course_id,
                                               int course_version,
                                               const std::string& mastered_utc) = 0;
    [[nodiscard]] virtual std::vector<CertificateRecord> certificates(int64_t user_id) = 0;

    // --- review: remarks and ratings by people
    /// Throws kNotFound, kRefused (time outside the attempt, neither text nor time).
    virtual int64_t add_comment(const CommentRecord& comment) = 0;
    /// Takes a remark away, or puts it back. Throws kNotFound.
    virtual void set_comment_removed(int64_t id, bool removed) = 0;
    [[nodiscard]] virtual std::vector<CommentRecord> comments(
        int64_t attempt_id) = 0;  ///< By time.
    /// Throws kConflict (rated already), kRefused (own attempt), kNotFound.
    virtual int64_t save_rating(const RatingRecord& rating) = 0;
    /// Of all attempts, oldest first.
    [[nodiscard]] virtual std::vector<RatingRecord> ratings(
        const std::string& questionnaire_id) = 0;

    // --- studies: published definitions, participants, what they did and answered
    /// Publishes a version for good. The same text again is no change; another text under a
    /// version that is there throws kConflict, a version above 1 without a reason kRefused.
    virtual void publish(const DefinitionRecord& definition) = 0;
    /// All versions of one kind, by id and version.
    [[nodiscard]] virtual std::vector<DefinitionRecord> definitions(const std::string& kind) = 0;
    /// version 0 = the newest.
    [[nodiscard]] virtual std::optional<DefinitionRecord> definition(const std::string& kind,
                                                                     const std::string& id,
                                                                     int version = 0) = 0;
    /// The device for a participant's attempts where the protocol names none. Throws kNotFound.
    virtual void set_participant_device(const std::string& study_id, const std::string& code,
                                        const std::string& device) = 0;
    /// Next code with check character; where the study is published with arms, allocates.
    virtual std::string new_participant(const std::string& study_id,
                                        bool demonstration = false) = 0;
    [[nodiscard]] virtual std::vector<ParticipantRecord> participants(
        const std::string& study_id) = 0;
    /// Ids of all studies that have participants or a published protocol.
    [[nodiscard]] virtual std::vector<std::string> study_ids() = 0;
    /// Throws kRefused without a reason, kConflict when the participant has withdrawn already and
    /// the new mode does not erase.
    virtual void withdraw(const std::string& study_id, const std::string& code, WithdrawalMode mode,
                          const std::string& reason) = 0;
    /// Throws kRefused for who has withdrawn, and where consent is needed and missing. An attempt
    /// that the step names belongs to the participant from then on.
    virtual int64_t record_step(const StepRecord& step) = 0;
    [[nodiscard]] virtual std::vector<StepRecord> steps(const std::string& study_id) = 0;
    /// Refuses as record_step() does.
    virtual int64_t save_answers(const AnswerRecord& answers) = 0;
    [[nodiscard]] virtual std::vector<AnswerRecord> answers(const std::string& study_id) = 0;
    /// Locks, signatures, corrections, second entries: db/study_records.h.
    [[nodiscard]] virtual StudyRecords& records() = 0;

    // --- audit, health
    virtual void audit(const std::string& actor, const std::string& action,
                       const std::string& object, const std::string& detail) = 0;
    [[nodiscard]] virtual std::vector<AuditRecord> audit_trail(int limit) = 0;
    virtual std::vector<std::string> check() = 0;       ///< Problems found; empty = sound.
    virtual void backup(const std::string& path) = 0;   ///< SQLite: a consistent copy.
    [[nodiscard]] virtual std::string url() const = 0;  ///< For people: without the password.
};

/// What only tests and special programs set.
struct StoreOptions {
    bool cheap_passwords = false;     ///< Tests: weakest Argon2id, because hashing takes 50 ms.
    std::function<int64_t()> now_ms;  ///< Clock of the sign-in waits [ms]; empty = the system's.
    std::vector<EmbeddedSql> migrations;  ///< Empty = embedded_migrations().
};

/// "sqlite:PATH", "sqlite::memory:" or "postgresql://user:password@host:port/name", each with
/// "?timeout_ms=5000" behind it if wanted: how long to wait for a lock. Creates (folder 0700, file
/// 0600) and migrates; an existing SQLite file is checked and copied before it is migrated. A file
/// that is not a Placode store, or is damaged, is not touched. Throws StoreError.
/// @pre A QCoreApplication exists: Qt finds its database drivers through it.
[[nodiscard]] std::unique_ptr<Store> open_store(const std::string& url,
                                                const StoreOptions& options = {});

/// Puts a backup in the place of an embedded store; the old file is kept beside it. Returns where
/// ("" when there was none). Throws kLocked when a program uses the store, kDamaged or kTooNew for
/// the backup; the store is then as it was.
std::string restore_store(const std::string& url, const std::string& backup_path,
                          const std::string& actor = "restore");

/// "sqlite:" + the user's data folder + "/placode.db" (the folder is created by open_store).
[[nodiscard]] std::string default_store_url();

}  // namespace placode::db
