// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The statements of the export xapi, one by one, for who sends them to a learning record store.

#include <string>
#include <vector>

#include "reports/dataset.h"

namespace placode::reports {

struct XapiStatement {
    std::string id;         ///< UUID, the same for the same thing whenever it is made.
    std::string timestamp;  ///< "2026-11-21T18:03:00.000Z"
    std::string json;       ///< On one line.
};

/// In the order of the file that the export writes. People are pseudonyms; identifying fields have
/// no statement, and an attempt has none while it waits for its replay: a record store keeps what
/// it was told first.
[[nodiscard]] std::vector<XapiStatement> xapi_statements(const Dataset& data);

}  // namespace placode::reports
