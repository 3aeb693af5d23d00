// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is behind a code: a file of its own, apart from the store and from every export and backup of
// it, encrypted under a passphrase. Argon2id makes the key from the passphrase, XSalsa20-Poly1305
// (libsodium's secretbox) hides and proves the content; nonce and salt are new with every save.
// Source: RFC 9106; Bernstein 2011 (XSalsa20).

#include <string>
#include <vector>

#include "db/consent_encryption.h"

namespace placode::db {

inline constexpr int kLeastPassphraseLength = 12;  ///< Characters.

struct PersonEntry {
    std::string code;                   ///< "P001-C"
    std::string name, contact, remark;  ///< Free text; only the name is required.
    std::string added_utc;              ///< Filled in by put() where it is empty.

    friend bool operator==(const PersonEntry&, const PersonEntry&) = default;
};

class ParticipantKey {
 public:
    /// A new file; throws StoreError: kConflict when there is one, kRefused for a passphrase that
    /// is too short, kUnavailable when it cannot be written.
    /// @param cheap tests only: least work for Argon2id.
    static ParticipantKey create(const std::string& path, const std::string& study_id,
                                 const std::string& passphrase, bool cheap = false);
    /// Throws StoreError: kNotFound, kRefused (wrong passphrase, or a file that was changed),
    /// kDamaged (no key file).
    static ParticipantKey open(const std::string& path, const std::string& passphrase);
    ~ParticipantKey();
    ParticipantKey(ParticipantKey&&) = default;
    ParticipantKey& operator=(ParticipantKey&&) = default;
    ParticipantKey(const ParticipantKey&) = delete;
    ParticipantKey& operator=(const ParticipantKey&) = delete;

    [[nodiscard]] const std::string& study_id() const { return study_id_; }
    [[nodiscard]] const std::vector<PersonEntry>& entries() const {
        return entries_;
    }  ///< By code.
    /// Reads what consent_encryption.h encrypted. A file of an older version gets its pair when it
    /// is opened.
    [[nodiscard]] const ConsentKeys& consent_keys() const { return consent_keys_; }
    /// Adds or replaces the entry of that code and saves. Throws kRefused for a code whose check
    /// letter does not fit or an entry without a name.
    void put(PersonEntry entry);
    /// Takes the entry out and saves. Throws kNotFound.
    void remove(const std::string& code);
    void change_passphrase(const std::string& passphrase);

 private:
    ParticipantKey() = default;
    void save() const;

    std::string path_, study_id_, passphrase_;
    bool cheap_ = false;
    std::vector<PersonEntry> entries_;
    ConsentKeys consent_keys_;
};

/// "keys/STUDY.placode-key" beside an embedded store, else in the user's data folder.
[[nodiscard]] std::string default_key_path(const std::string& store_url,
                                           const std::string& study_id);

}  // namespace placode::db
