// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is signed in. Kept in memory only: a restart signs everybody out.

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace placode::web {

/// Who somebody is on a learning platform, for whom a platform vouched; empty: a password did.
struct CameFrom {
    std::string issuer, client_id, subject;
};

struct Session {
    int64_t account = 0;
    std::string form_token;  ///< A form of this session carries it.
    int64_t begun_s = 0, seen_s = 0;
    CameFrom came_from;
};

/// Any thread.
class Sessions {
 public:
    static constexpr int64_t kIdleS = 30 * 60, kLongestS = 12 * 3600;
    static constexpr size_t kMost = 1000;    ///< At once; then the one that was idle longest goes.
    static constexpr size_t kOfAccount = 5;  ///< Of one account, likewise.

    /// @param now_s a clock that only goes forward [s].
    explicit Sessions(std::function<int64_t()> now_s);

    /// Returns the token for the cookie, 256 random bits; only its hash is kept.
    [[nodiscard]] std::string begin(int64_t account, CameFrom came_from = {});
    /// Nothing for one that is unknown, idle for kIdleS or older than kLongestS; else it is now
    /// seen.
    [[nodiscard]] std::optional<Session> find(const std::string& token);
    void end(const std::string& token);
    [[nodiscard]] size_t count();

 private:
    void forget_old(int64_t now);
    void make_room(int64_t account);

    std::function<int64_t()> now_s_;
    std::mutex mutex_;
    std::map<std::string, Session> sessions_;  ///< By hash of the token.
};

/// Tokens are looked up by it, so that the time of the search says nothing about one.
[[nodiscard]] std::string hash_of_token(const std::string& token);
/// 256 random bits as letters and digits.
[[nodiscard]] std::string new_token();
/// In a time that does not depend on where they differ; false for an empty one.
[[nodiscard]] bool same_token(const std::string& a, const std::string& b);

}  // namespace placode::web
