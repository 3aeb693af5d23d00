// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: participants of studies, what they did and answered. Pseudonymous: nothing here
// knows an account. What becomes of it later: db/study_records.h.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// How store, trail and command line name a WithdrawalMode, in its order.
inline constexpr std::string_view kWithdrawalModeNames[] = {"keep", "stop", "erase"};
/// The mode of one of these words; nullopt for every other.
[[nodiscard]] std::optional<WithdrawalMode> withdrawal_mode_named(std::string_view name) noexcept;
/// The other way round.
[[nodiscard]] std::string withdrawal_mode_name(WithdrawalMode mode);

/// `store.studies()`. Every change is one transaction and in the audit trail.
class Studies {
 public:
    explicit Studies(StoreContext& context);

    /// Ids of all studies that have participants or a published protocol.
    [[nodiscard]] std::vector<std::string> ids();
    /// Those of them that have participants.
    [[nodiscard]] std::vector<std::string> with_participants();
    /// Next code with check character; where the study is published with arms, allocates.
    std::string new_participant(const std::string& study_id, bool demonstration = false);
    [[nodiscard]] std::vector<ParticipantRecord> participants(const std::string& study_id);
    /// The device for a participant's attempts where the protocol names none. Throws kNotFound.
    void set_participant_device(const std::string& study_id, const std::string& code,
                                const std::string& device);

    // studies_steps.cpp
    /// Throws kRefused for who has withdrawn, and where consent is needed and missing. An attempt
    /// that the step names belongs to the participant from then on; kRefused where it was neither
    /// made for the participant nor recorded for a study by who acts, or is of another task.
    int64_t record_step(const StepRecord& step);
    [[nodiscard]] std::vector<StepRecord> steps(const std::string& study_id);

    // studies_answers.cpp
    /// Refuses as record_step() does.
    int64_t save_answers(const AnswerRecord& answers);
    [[nodiscard]] std::vector<AnswerRecord> answers(const std::string& study_id);

    // studies_withdrawal.cpp
    /// Throws kRefused without a reason, kConflict when the participant has withdrawn already and
    /// the new mode does not erase.
    void withdraw(const std::string& study_id, const std::string& code, WithdrawalMode mode,
                  const std::string& reason);
    /// Erases a participant's records as WithdrawalMode::kErase does, at the end of the time for
    /// which they were to be kept (study_retention.h); nobody has withdrawn. Throws kNotFound,
    /// kRefused when that time is not over by this computer's clock.
    void erase_kept(const std::string& study_id, const std::string& code,
                    const std::string& until_utc);

 private:
    int64_t insert_step(StepRecord step);
    void erase_participant(const std::string& study_id, const std::string& code);

    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
