// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one implementation of Store, for both engines. Only db/sql_store_*.cpp include this.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "db/sql_connection.h"
#include "db/store.h"
#include "db/study_records.h"

namespace placode::db {

/// SELECT ... FROM attempts t ..., for read_attempt(). sql_store_attempts.cpp
[[nodiscard]] const std::string& attempt_columns();
[[nodiscard]] AttemptRecord read_attempt(const Statement& row);
/// From a question for item, reason, points, time_s, critical, meaning.
[[nodiscard]] assessment::Reason read_reason(const Statement& row);

/// WHERE over `attempts t`. Conditions are written only where they are asked for: "(? = 0 OR ...)"
/// would keep the engine from using an index. sql_store_lists.cpp
struct AttemptConditions {
    std::string sql;  ///< " WHERE ...", or empty.
    std::vector<QVariant> values;

    void add(const std::string& condition) {
        sql += (sql.empty() ? " WHERE " : " AND ") + condition;
    }
    void add(const std::string& condition, const QVariant& value) {
        add(condition);
        values.push_back(value);
    }
};
/// What participants did in studies is nobody's training.
enum class Studies : uint8_t { kLeftOut, kTakenIn };
/// 0 and empty = no condition.
[[nodiscard]] AttemptConditions conditions_of(int64_t user_id, int64_t group_id,
                                              const std::string& task_id,
                                              Studies studies = Studies::kLeftOut);
/// Interrupted attempts count nowhere, nor do those that are void for cause or of a study.
[[nodiscard]] std::string is_finished(const std::string& table);

class SqlStore final : public Store, private StudyRecords {
 public:
    SqlStore(const StoreUrl& url, StoreOptions options);

    void act_as(const std::string& actor) override { actor_ = actor; }

    // sql_store_accounts.cpp
    int64_t create_user(const NewUser& user) override;
    SignIn sign_in(const std::string& login, const std::string& password) override;
    void set_password(int64_t user_id, const std::string& password) override;
    void set_active(int64_t user_id, bool active) override;
    // sql_store_people.cpp
    void set_pin(int64_t user_id, const std::string& pin) override;
    bool has_pin(int64_t user_id) override;
    SignIn unlock(int64_t user_id, const std::string& pin) override;
    std::string invite(const InvitationRecord& invitation) override;
    std::vector<InvitationRecord> invitations() override;
    int64_t accept_invitation(const std::string& code, const NewUser& user) override;
    void request_erasure(int64_t user_id, const std::string& reason) override;
    std::vector<ErasureRecord> erasure_requests() override;
    void erase_person(int64_t user_id, bool with_attempts) override;

    // sql_store_accounts.cpp
    std::vector<UserRecord> users() override;
    std::optional<UserRecord> user(int64_t id) override;
    std::optional<UserRecord> user_by_login(const std::string& login) override;

    // sql_store_attempts.cpp
    int64_t save_attempt(int64_t user_id, const AttemptResult& result) override;
    std::vector<AttemptRecord> attempts(int64_t user_id, const std::string& task_id) override;
    AttemptDetail attempt(int64_t id) override;
    void extract_recording(int64_t attempt_id, const std::string& path) override;
    std::optional<int64_t> attempt_of_recording(const std::string& recording_file) override;

    // sql_store_lists.cpp
    AttemptPage attempt_page(const AttemptFilter& filter) override;
    std::vector<TaskStanding> task_standings(int64_t group_id, const std::string& task_id) override;
    std::vector<std::string> tasks_with_attempts() override;
    std::vector<RecentMean> recent_means(const std::string& task_id, int last) override;
    std::vector<AttemptPoint> attempt_points(int64_t group_id, const std::string& task_id) override;

    // sql_store_scores.cpp
    int64_t save_rescore(const RescoreRecord& rescore) override;
    std::vector<RescoreRecord> rescores(int64_t attempt_id) override;

    // sql_store_norms.cpp
    std::vector<MeasuredAttempt> measured_attempts(int64_t user_id,
                                                   const std::string& task_id) override;
    CentreKey centre_key(const std::string& centre) override;
    void trust_centre(const std::string& public_key, const std::string& centre) override;
    std::map<std::string, std::string> trusted_centres() override;
    int64_t save_norms(const curriculum::SignedNorms& norms) override;
    std::vector<NormPackRecord> norm_packs(const std::string& task_id) override;
    void use_norms(int64_t id) override;

    // sql_store_courses.cpp
    int64_t create_group(const std::string& name) override;
    void set_group_role(int64_t group_id, int64_t user_id, GroupRole role) override;
    std::vector<GroupRecord> groups() override;
    bool in_reach(int64_t actor, int64_t subject) override;
    int64_t assign_course(const AssignmentRecord& assignment) override;
    void end_assignment(int64_t id) override;
    std::vector<AssignmentRecord> assignments(int64_t user_id) override;
    void grant_attempts(const GrantRecord& grant) override;
    std::vector<GrantRecord> grants(int64_t user_id) override;
    CertificateRecord save_certificate(int64_t user_id, const std::string& course_id,
                                       int course_version,
                                       const std::string& mastered_utc) override;
    std::vector<CertificateRecord> certificates(int64_t user_id) override;

    // sql_store_review.cpp
    int64_t add_comment(const CommentRecord& comment) override;
    void set_comment_removed(int64_t id, bool removed) override;
    std::vector<CommentRecord> comments(int64_t attempt_id) override;
    int64_t save_rating(const RatingRecord& rating) override;
    std::vector<RatingRecord> ratings(const std::string& questionnaire_id) override;

    // sql_store_protocols.cpp
    void publish(const DefinitionRecord& definition) override;
    std::vector<DefinitionRecord> definitions(const std::string& kind) override;
    std::optional<DefinitionRecord> definition(const std::string& kind, const std::string& id,
                                               int version) override;
    void withdraw(const std::string& study_id, const std::string& code, WithdrawalMode mode,
                  const std::string& reason) override;
    int64_t record_step(const StepRecord& step) override;
    std::vector<StepRecord> steps(const std::string& study_id) override;

    // sql_store_studies.cpp
    std::string new_participant(const std::string& study_id, bool demonstration) override;
    void set_participant_device(const std::string& study_id, const std::string& code,
                                const std::string& device) override;
    std::vector<ParticipantRecord> participants(const std::string& study_id) override;
    std::vector<std::string> study_ids() override;
    int64_t save_answers(const AnswerRecord& answers) override;
    std::vector<AnswerRecord> answers(const std::string& study_id) override;

    // sql_store_records.cpp
    StudyRecords& records() override { return *this; }

    // sql_store.cpp
    void audit(const std::string& actor, const std::string& action, const std::string& object,
               const std::string& detail) override;
    std::vector<AuditRecord> audit_trail(int limit) override;
    std::vector<std::string> check() override;
    void backup(const std::string& path) override;
    std::string url() const override { return connection_.url().shown; }

 private:
    // sql_store_records.cpp
    void lock_record(const std::string& study_id, const std::string& code) override;
    void sign_record(const std::string& study_id, const std::string& code, const std::string& login,
                     const std::string& password, const std::string& meaning) override;
    void unlock_record(const std::string& study_id, const std::string& code,
                       const std::string& reason) override;
    std::vector<RecordEvent> record_events(const std::string& study_id) override;
    std::map<std::string, RecordState> record_states(const std::string& study_id) override;
    // sql_store_repeats.cpp
    void repeat_step(const std::string& study_id, const std::string& code, int visit,
                     const std::string& step, const std::string& reason) override;
    void note_step(const std::string& study_id, const std::string& code, int visit,
                   const std::string& step, const std::string& note) override;
    std::vector<StepNote> step_notes(const std::string& study_id) override;
    // sql_store_corrections.cpp
    void correct_answers(int64_t answer_id, int entry, const curriculum::Answers& changes,
                         const std::string& reason) override;
    std::vector<Correction> corrections(const std::string& study_id) override;
    void save_second_entry(const SecondEntry& entry) override;
    std::vector<SecondEntry> second_entries(const std::string& study_id) override;
    void save_consent_signature(const std::string& study_id, const std::string& code,
                                const std::string& path) override;
    std::optional<ConsentSignature> consent_signature(const std::string& study_id,
                                                      const std::string& code) override;

    void need_participant(const std::string& study_id, const std::string& code);
    /// Throws kRefused while the record is locked.
    void need_unlocked(const std::string& study_id, const std::string& code);
    [[nodiscard]] bool is_locked(const std::string& study_id, const std::string& code);
    /// Over everything that was recorded of the participant.
    [[nodiscard]] std::string record_checksum(const std::string& study_id, const std::string& code);
    void insert_record_event(RecordEvent event);
    /// The answers of that entry (1 or 2), and of which questionnaire and participant they are.
    [[nodiscard]] AnswerRecord need_answers(int64_t answer_id, int entry);
    void need_valid(const AnswerRecord& answers);

    [[nodiscard]] int64_t now_ms() const;
    /// Inside a transaction, so that a change and its trace are one.
    void append_audit(const std::string& actor, const std::string& action,
                      const std::string& object, const std::string& detail);
    [[nodiscard]] int wait_before_sign_in(const std::string& key);
    [[nodiscard]] UserRecord need_user(int64_t id);
    void need_another_administrator(const UserRecord& user);
    /// Inside a transaction, everything checked.
    int64_t insert_user(const NewUser& user, const std::string& hash);
    /// Throws kRefused for what a new account may not be; returns the hash of the password.
    [[nodiscard]] std::string check_new_user(const NewUser& user);
    void need_group(int64_t id);
    void delete_attempt(int64_t id);  ///< With all that hangs on it, inside a transaction.
    [[nodiscard]] std::optional<DefinitionRecord> find_definition(const std::string& kind,
                                                                  const std::string& id,
                                                                  int version);
    /// Throws unless this participant may go on: there, not withdrawn, consented where that is
    /// needed. `step` is the one that gives the consent, or empty.
    void need_active_participant(const std::string& study_id, const std::string& code,
                                 const std::string& step);
    void erase_participant(const std::string& study_id, const std::string& code);
    int64_t insert_step(const StepRecord& step);
    void check_audit_chain(std::vector<std::string>& problems);
    void check_recordings(std::vector<std::string>& problems);

    Connection connection_;
    StoreOptions options_;
    std::vector<EmbeddedSql> migrations_;
    std::string actor_ = "unknown";
};

}  // namespace placode::db
