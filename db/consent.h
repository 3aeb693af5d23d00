// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a participant agreed to.

#include <map>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// A consent as record_consent() (db/study_conduct.h) kept it.
struct GivenConsent {
    std::string at_utc;
    int version = 0;  ///< Of the text.
    std::string language, text_checksum;
    std::vector<std::string> agreed;  ///< Ids of the statements.
    bool on_screen = false;           ///< Signed there; else on paper.
};

/// The last consent of everybody who gave one, by code; also of who withdrew.
/// @param steps of a study, oldest first
[[nodiscard]] std::map<std::string, GivenConsent> given_consents(
    const std::vector<StepRecord>& steps);

/// Whether the participant's consent, the last that was recorded, names the statement ("data") of
/// the protocol. False for who gave none, and for who withdrew and wanted the data unused.
[[nodiscard]] bool has_agreed(Store& store, const std::string& study_id, const std::string& code,
                              const std::string& statement);

}  // namespace placode::db
