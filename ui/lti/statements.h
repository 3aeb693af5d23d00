// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Statements into a learning record store. Source: xAPI 1.0.3, part three, 2.1.

#include <string>
#include <vector>

#include "ui/lti/sending.h"
#include "ui/lti/sent_file.h"

namespace placode::lti {

struct Statement {
    std::string id, json;
};

struct RecordStore {
    std::string endpoint;   ///< "https://lrs.example.org/xapi"
    std::string user_pass;  ///< "user:password", for Basic authentication.
};

/// The first line of the file, "user:password". Throws SettingsError as read_secret() does, and
/// where there is no colon.
[[nodiscard]] std::string read_user_pass(const std::string& path);

struct StatementsSent {
    int sent = 0;
    int there = 0;   ///< The record store has a statement of this id, perhaps in other words.
    int before = 0;  ///< Sent by an earlier run.
    std::vector<std::string> problems;
};

/// In parts of 50, which a record store takes whole or not at all; where it refuses one, each
/// alone. Stops where the store cannot be reached or does not let us in. Throws SettingsError.
[[nodiscard]] StatementsSent send_statements(const RecordStore& store,
                                             const std::vector<Statement>& statements,
                                             SentFile& sent, const Patience& patience);
[[nodiscard]] bool was_sent(const RecordStore& store, const Statement& statement,
                            const SentFile& sent);

}  // namespace placode::lti
