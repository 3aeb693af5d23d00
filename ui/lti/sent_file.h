// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What has been sent elsewhere, so that nothing is sent twice.

#include <map>
#include <optional>
#include <string>

#include "ui/lti/secret_file.h"

namespace placode::lti {

/// A file of keys and what was sent under each. One program has it at a time. It says whose scores
/// went where: for its owner alone.
class SentFile {
 public:
    /// Reads the file, if it is there. Throws SettingsError: it cannot be read, or another program
    /// is sending.
    explicit SentFile(std::string path);
    ~SentFile();
    SentFile(const SentFile&) = delete;
    SentFile& operator=(const SentFile&) = delete;

    [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
    void set(const std::string& key, const std::string& value) { sent_[key] = value; }
    /// On the disk when it returns. Throws SettingsError.
    void keep() const;

 private:
    std::string path_;
    int lock_ = -1;
    std::map<std::string, std::string> sent_;
};

}  // namespace placode::lti
