// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: published versions of questionnaires, studies, courses, rubrics, standards and
// seals. A version's text is never changed.

#include <optional>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// `store.definitions().list()`. Every change is one transaction and in the audit trail.
class Definitions {
 public:
    explicit Definitions(StoreContext& context);

    /// Publishes a version for good. The same text again is no change; another text under a
    /// version that is there throws kConflict, a version above 1 without a reason kRefused, and so
    /// does another text of a task that the program was built with, and a study whose arms get
    /// other names or another order after somebody was allocated.
    void publish(const DefinitionRecord& definition);
    /// All versions of one kind, by id and version.
    [[nodiscard]] std::vector<DefinitionRecord> list(const std::string& kind);
    /// version 0 = the newest.
    [[nodiscard]] std::optional<DefinitionRecord> find(const std::string& kind,
                                                       const std::string& id, int version = 0);

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
