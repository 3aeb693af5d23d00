// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a computer keeps outside of a store to prove what it wrote: a key that signs, and how far
// the store's audit trail went. The key file (Ed25519, mode 0600) is $PLACODE_STATION_KEY, else
// placode/station.key in the user's data folder. It is made at its first use and is in no backup.
// One that others can read or write, or that is another account's, is refused at every opening; a
// systemd credential (below $CREDENTIALS_DIRECTORY) is the service's alone by other means.

#include <cstdint>
#include <string>
#include <vector>

#include "db/secret.h"
#include "db/signature.h"
#include "db/store_url.h"

namespace placode::db {

class Station {
 public:
    Station();  ///< The key alone, for recordings.
    explicit Station(const StoreUrl& url);

    /// Hexadecimal; "" where there can be no key: a folder that is not writable.
    /// Throws kDamaged for a file that holds none, kRefused for one that is not private.
    [[nodiscard]] const std::string& public_key();
    /// As it is on the disk, without making one.
    [[nodiscard]] std::string public_key_if_any();
    [[nodiscard]] std::string sign(const std::string& text);  ///< "" without a key.

    /// The last entry that was written here into the store at this address.
    struct Head {
        int64_t entry = 0;
        std::string chain;
        bool operator==(const Head&) const = default;
    };
    /// What is remembered in the key's folder, and beside an embedded store, where other users of
    /// this computer remember it as well: whoever can write to one of both cannot hide from the
    /// other.
    [[nodiscard]] std::vector<Head> heads() const;
    /// Does nothing where nothing can be written: the trail itself is in the store.
    void remember(const Head& head) const noexcept;
    /// Another store is at the address from now on, on purpose. Throws StoreError(kUnavailable)
    /// when the note of the one before stays: check() would say that the trail was cut off.
    void forget() const;

 private:
    [[nodiscard]] bool read_key();
    void need_private(int file) const;
    [[noreturn]] void say_damaged() const;
    void make_key();

    std::string key_path_;
    std::vector<std::string> head_paths_;  ///< A store in memory has none.
    std::string public_key_;
    Secret secret_key_;  ///< As long as this lives: in no core file.
    bool tried_ = false;
};

}  // namespace placode::db
