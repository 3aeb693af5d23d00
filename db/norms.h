// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: norm packs, the key of the centre that signs them, and the attempts with metrics
// that they are made of. How they are made: db/norm_bands.h.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// `store.norms()`. Every change is one transaction and in the audit trail.
class Norms {
 public:
    explicit Norms(StoreContext& context);

    /// Attempts of a task with their metrics, oldest first; user_id 0 = everybody's. None of
    /// studies.
    [[nodiscard]] std::vector<MeasuredAttempt> measured_attempts(int64_t user_id,
                                                                 const std::string& task_id);
    /// Made on first use under this name. Throws kRefused when it has to be made without a name.
    CentreKey centre_key(const std::string& centre);
    /// What this centre calls itself; empty while it has no key. No secret.
    [[nodiscard]] std::string centre_name();
    void trust_centre(const std::string& public_key, const std::string& centre);
    /// Name by public key.
    [[nodiscard]] std::map<std::string, std::string> trusted_centres();
    /// Keeps a pack whose signature is right and whose centre is trusted; the same pack once.
    /// Throws kRefused, DefinitionError.
    int64_t save(const curriculum::SignedNorms& norms);
    /// task_id empty = all.
    [[nodiscard]] std::vector<NormPackRecord> list(const std::string& task_id);
    void use(int64_t id);  ///< For its task, in place of the one before.

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
