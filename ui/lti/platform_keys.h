// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The keys by which platforms sign. They change them now and then, without a word.

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ui/lti/settings.h"
#include "ui/lti/web_token.h"

namespace placode::lti {

/// Any thread.
class PlatformKeys {
 public:
    static constexpr int64_t kKeptS = 3600;    ///< A key that the platform takes back is over then.
    static constexpr int64_t kAskAgainS = 60;  ///< For a key that is not among those kept.
    static constexpr int64_t kAfterFaultS = 10;

    /// @param now_s a clock that only goes forward [s]. @param log what went wrong.
    PlatformKeys(std::function<int64_t()> now_s, std::function<void(const std::string&)> log);

    /// Nothing where the platform has no such key, or cannot be asked. Waits for the platform.
    [[nodiscard]] std::optional<PublicKey> find(const Platform& platform, const std::string& id);

 private:
    struct Kept {
        std::vector<PublicKey> keys;
        std::optional<int64_t> read_s;
        int64_t asked_s = 0;
        bool failed = false;  ///< The last question had no answer.
    };
    struct Looked {
        std::optional<PublicKey> key;
        bool is_to_ask = false;
    };
    [[nodiscard]] Looked look(const std::string& address, const std::string& id);
    void keep(const std::string& address, const std::optional<std::vector<PublicKey>>& keys);
    [[nodiscard]] std::optional<std::vector<PublicKey>> asked(const std::string& address) const;

    std::function<int64_t()> now_s_;
    std::function<void(const std::string&)> log_;
    std::timed_mutex asking_;  ///< One question at a time; a key that is kept does not wait for it.
    std::mutex mutex_;         ///< Of what follows; never held while a platform is asked.
    std::map<std::string, Kept> by_address_;
};

}  // namespace placode::lti
