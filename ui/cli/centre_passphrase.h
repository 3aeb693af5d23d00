// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a passphrase of the centre's key comes from. Never from the command line: `ps` shows it to
// everybody on the computer.

#include <string>

#include "db/secret.h"
#include "ui/cli/session.h"

namespace placode::cli {

/// The name of a systemd credential (LoadCredential=) that holds the passphrase.
inline constexpr const char* kPassphraseCredential = "placode-centre-passphrase";

/// The passphrase of the key that is there: the first line of `file`, else of the credential in
/// $CREDENTIALS_DIRECTORY, else $PLACODE_PASSPHRASE, else typed. Throws lti::SettingsError for a
/// file that others may read, InputError where there is nothing to ask at.
/// @param purpose said in the prompt: "to sign the norm pack"
[[nodiscard]] db::Secret centre_passphrase(const std::string& file, const std::string& purpose);

/// A new one: the first line of `file`, else $PLACODE_NEW_PASSPHRASE, else typed twice.
[[nodiscard]] db::Secret new_centre_passphrase(const std::string& file);

/// To sign: a new one where the key is not made yet or lies in clear, and then also from the
/// credential.
[[nodiscard]] db::Secret passphrase_to_sign(Session& session, const std::string& file);

/// What `check` and `backup` add while the key of the centre lies in clear; "" once it is sealed.
[[nodiscard]] std::string clear_key_note(Session& session);

}  // namespace placode::cli
