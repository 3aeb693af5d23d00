// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which version of a study's protocol holds for whom.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "db/store.h"

namespace placode::reports {

/// The published protocols of a study: everybody's data are read by the version of their enrolment.
class Protocols {
 public:
    /// Of no study: nobody has a version.
    Protocols() = default;
    /// @param participants of the study. Throws as Definitions::find() and load_study_text().
    Protocols(db::Store& store, const std::string& study_id,
              const std::vector<db::ParticipantRecord>& participants);

    /// nullptr = none is published.
    [[nodiscard]] const curriculum::StudyProtocol* newest() const;
    /// That of the participant's enrolment; the newest for who was enrolled before there was one.
    [[nodiscard]] const curriculum::StudyProtocol* of(const std::string& code) const;
    /// Those that of() gives for anybody, the newest first, each once.
    [[nodiscard]] std::vector<const curriculum::StudyProtocol*> in_use() const;
    /// Whether any version asks for consent.
    [[nodiscard]] bool ask_consent() const;

    /// Arms of all versions, those of the newest first: the same arm where the English name is.
    [[nodiscard]] const std::vector<curriculum::LocalText>& arms() const { return arms_; }
    /// Place of the participant's arm in arms(); nullopt = not allocated.
    [[nodiscard]] std::optional<int> arm_of(const db::ParticipantRecord& participant) const;

 private:
    void add_arms(int number);
    [[nodiscard]] const curriculum::StudyProtocol* version(int number) const;

    std::map<int, std::optional<curriculum::StudyProtocol>> versions_;  ///< 0 = the newest.
    std::map<std::string, int> enrolled_;                               ///< Version by code.
    std::vector<curriculum::LocalText> arms_;
    std::map<int, std::vector<int>> places_;  ///< In arms_, of a version's arms.
};

}  // namespace placode::reports
