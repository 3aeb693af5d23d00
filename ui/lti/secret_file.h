// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that this computer keeps for itself: keys, passwords, who is who on a platform.

#include <stdexcept>
#include <string>

namespace placode::lti {

/// A file of settings or a secret cannot be used; names the file and says what to do. Never holds
/// what stands in a secret.
class SettingsError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// The whole file. Throws SettingsError where it is not there, larger than 1 MB, or open to others:
/// a secret is for its owner alone (mode 0600), settings nobody else may write.
[[nodiscard]] std::string read_secret(const std::string& path);
[[nodiscard]] std::string read_settings_text(const std::string& path);

/// As these, whoever may read or write it: what it holds is sealed or signed.
[[nodiscard]] std::string read_text(const std::string& path);

/// Takes the place of `path` in one step, with the owner and the mode of the file that was there; a
/// new one is for its owner alone. It is on the disk when this returns. Throws SettingsError.
void replace_text(const std::string& path, const std::string& text);

}  // namespace placode::lti
