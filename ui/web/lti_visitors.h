// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// People who are on their way in from a learning platform (LTI 1.3). Kept in memory only.

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "ui/lti/platform_keys.h"

namespace placode::web {

/// So many at once and so many a second, whoever they are. Any thread.
class Turns {
 public:
    Turns(int at_once, int a_second) : most_(at_once), a_second_(a_second), left_(at_once) {}
    /// False: no turn now; one comes within a second.
    [[nodiscard]] bool take(int64_t now_s);

 private:
    const int64_t most_, a_second_;
    std::mutex mutex_;
    int64_t left_, filled_s_ = 0;
};

/// A sign-in that a platform was asked for and has not answered.
struct Arrival {
    std::string issuer, client_id;
    std::string nonce;    ///< The answer names it.
    std::string browser;  ///< What the cookie of the browser that began it holds.
    int64_t begun_s = 0;
};

/// Any thread.
class Arrivals {
 public:
    static constexpr int64_t kLifeS = 300;  ///< Nobody types anything meanwhile.

    /// Returns the `state`, 256 random bits; only its hash is kept.
    [[nodiscard]] std::string begin(Arrival arrival);
    /// Once for each: it is gone then. Nothing for one that is unknown or older than kLifeS.
    [[nodiscard]] std::optional<Arrival> take(const std::string& state, int64_t now_s);
    [[nodiscard]] size_t count();

 private:
    std::mutex mutex_;
    std::map<std::string, Arrival> arrivals_;  ///< By hash of the state.
};

struct LtiVisitors {
    LtiVisitors(std::function<int64_t()> now_s, std::function<void(const std::string&)> log)
        : keys(std::move(now_s), std::move(log)) {}

    Arrivals arrivals;
    lti::PlatformKeys keys;
    /// A class begins together. A flood leaves 3,200 arrivals in memory: 200 and 10 a second of
    /// Arrivals::kLifeS.
    Turns logins{200, 10}, launches{200, 10};
};

}  // namespace placode::web
