// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: norm packs, the key of the centre that signs them, and the attempts with metrics
// that they are made of. How they are made: db/norm_bands.h. The key's secret half lies in the
// store sealed under a passphrase (db/sealed_key.h), which whoever signs types.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "db/records.h"
#include "db/secret.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// The centre's key, ready to sign; its secret half is overwritten when this goes.
struct OpenCentreKey {
    std::string centre, public_key;
    Secret secret_key;
};

/// `store.norms()`. Every change is one transaction and in the audit trail.
class Norms {
 public:
    explicit Norms(StoreContext& context);

    /// Attempts of a task with their metrics, oldest first; user_id 0 = everybody's. None of
    /// studies.
    [[nodiscard]] std::vector<MeasuredAttempt> measured_attempts(int64_t user_id,
                                                                 const std::string& task_id);
    /// Whether there is a key, whose, and whether it is sealed. No secret.
    [[nodiscard]] std::optional<CentreKey> centre_key();
    /// To sign with it. Made at its first use, under this name and passphrase; one that an earlier
    /// version kept in clear is sealed under the passphrase now. Throws kRefused for a wrong
    /// passphrase, one too short for a new seal, and when a key has to be made without a name.
    [[nodiscard]] OpenCentreKey open_centre_key(const std::string& centre,
                                                std::string_view passphrase);
    /// Seals what lies in clear: written sealed, read back and opened, and only then committed.
    /// Throws kNotFound without a key, kConflict for one that is sealed. As the next three it needs
    /// the log-in of the tables' owner on a server, and throws kRefused for another one.
    void seal_centre_key(std::string_view passphrase);
    void change_key_passphrase(std::string_view old_one, std::string_view new_one);
    /// Another key in its place, for a passphrase that is lost or a key that somebody else may
    /// have. What the old one signed stays right: its public half stays trusted here.
    void renew_centre_key(std::string_view passphrase);
    /// The sealed key as a file for another store of the centre; it opens with the same passphrase.
    /// Throws kRefused while it lies in clear.
    [[nodiscard]] std::string exported_centre_key();
    /// Takes what exported_centre_key() wrote. Throws kDamaged for another text, kRefused for a
    /// wrong passphrase, kConflict where there is a key, unless another one is to be replaced.
    void take_centre_key(const std::string& text, std::string_view passphrase, bool replace);
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
    /// A row of the table, with whatever lies in it.
    struct KeptKey;
    [[nodiscard]] std::optional<KeptKey> kept_key();
    [[nodiscard]] KeptKey need_key();
    [[nodiscard]] KeptKey need_sealed_key();
    /// A new one, sealed, and its secret half; kept by nobody yet.
    [[nodiscard]] std::pair<KeptKey, Secret> fresh_key(const std::string& centre,
                                                       std::string_view passphrase);
    [[nodiscard]] OpenCentreKey opened(const KeptKey& kept, std::string_view passphrase);
    void need_passphrase(std::string_view passphrase);
    void need_owner_of_key();
    void add_key(const KeptKey& key);
    void replace_key(const KeptKey& key);
    void trust_own(const KeptKey& key);
    void need_readable(const KeptKey& key, std::string_view passphrase, const Secret& secret);
    void overwrite_clear_bytes();

    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
