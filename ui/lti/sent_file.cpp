// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/sent_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace placode::lti {

SentFile::SentFile(std::string path) : path_(std::move(path)) {
    // A file of its own: the other takes a new place each time it is kept.
    const std::string lock = path_ + ".lock";
    lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock_ < 0)
        throw SettingsError(lock + ": cannot be written; choose another place with --sent");
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        ::close(lock_);
        throw SettingsError(path_ + ": another program is sending; wait until it is done");
    }
    try {
        if (::access(path_.c_str(), F_OK) != 0) return;
        const auto json = nlohmann::json::parse(read_secret(path_), nullptr, false);
        const auto found = json.is_object() ? json.find("sent") : json.end();
        if (!json.is_object() || found == json.end() || !found->is_object())
            throw SettingsError(path_ +
                                ": is no list of what was sent; move it away to send all again");
        for (const auto& [key, value] : found->items())
            if (value.is_string()) sent_[key] = value.get<std::string>();
    } catch (...) {
        ::close(lock_);
        throw;
    }
}

SentFile::~SentFile() { ::close(lock_); }

std::optional<std::string> SentFile::find(const std::string& key) const {
    const auto found = sent_.find(key);
    return found == sent_.end() ? std::nullopt : std::optional(found->second);
}

void SentFile::keep() const {
    replace_text(path_, nlohmann::json{{"version", 1}, {"sent", sent_}}.dump(1) + "\n");
}

}  // namespace placode::lti
