// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/centre_passphrase.h"

#include <cstdlib>
#include <filesystem>

#include "ui/lti/secret_file.h"

namespace placode::cli {
namespace {

db::Secret first_line(std::string text, const std::string& file) {
    const size_t end = text.find_first_of("\r\n");
    std::string line = text.substr(0, end);
    db::wipe(text);
    db::Secret secret(line);
    db::wipe(line);
    if (secret.empty()) throw InputError(file + ": its first line is empty; write the passphrase");
    return secret;
}

/// systemd gives a service its credentials for it alone, at times by an access list that shows as
/// rights of the group.
std::string credential_file() {
    const char* folder = std::getenv("CREDENTIALS_DIRECTORY");
    if (folder == nullptr || *folder == '\0') return {};
    const std::string file = std::string(folder) + "/" + kPassphraseCredential;
    return std::filesystem::exists(file) ? file : std::string();
}

db::Secret typed_phrase(const char* variable, const std::string& prompt, bool twice) {
    std::string typed = read_password(variable, prompt, twice);
    db::Secret secret(typed);
    db::wipe(typed);
    return secret;
}

}  // namespace

db::Secret centre_passphrase(const std::string& file, const std::string& purpose) {
    if (!file.empty()) return first_line(lti::read_secret(file), file);
    if (const std::string given = credential_file(); !given.empty())
        return first_line(lti::read_settings_text(given), given);
    return typed_phrase("PLACODE_PASSPHRASE", "Passphrase of the centre's key, " + purpose, false);
}

db::Secret new_centre_passphrase(const std::string& file) {
    if (!file.empty()) return first_line(lti::read_secret(file), file);
    return typed_phrase("PLACODE_NEW_PASSPHRASE", "New passphrase of the centre's key", true);
}

db::Secret passphrase_to_sign(Session& session, const std::string& file) {
    const auto key = session.store().norms().centre_key();
    if ((key && key->sealed) || !credential_file().empty())
        return centre_passphrase(file, "to sign the norm pack");
    return new_centre_passphrase(file);
}

std::string clear_key_note(Session& session) {
    const auto key = session.store().norms().centre_key();
    if (!key || key->sealed) return {};
    return "the centre's signing key lies in clear in this store and in its backups; `placodectl "
           "norms key seal` puts it under a passphrase";
}

}  // namespace placode::cli
