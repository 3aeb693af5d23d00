// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/sessions.h"

#include <QCryptographicHash>
#include <algorithm>

#include "db/password.h"

namespace placode::web {
namespace {

bool is_over(const Session& session, int64_t now) {
    return now - session.seen_s >= Sessions::kIdleS || now - session.begun_s >= Sessions::kLongestS;
}

}  // namespace

std::string hash_of_token(const std::string& token) {
    return QCryptographicHash::hash(QByteArray::fromStdString(token), QCryptographicHash::Sha256)
        .toHex()
        .toStdString();
}

std::string new_token() {
    // 31 letters: 4.95 bits each.
    return db::random_letters(52);
}

bool same_token(const std::string& a, const std::string& b) {
    if (a.empty() || a.size() != b.size()) return false;
    unsigned difference = 0;
    for (size_t i = 0; i < a.size(); ++i)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return difference == 0;
}

Sessions::Sessions(std::function<int64_t()> now_s) : now_s_(std::move(now_s)) {}

std::string Sessions::begin(int64_t account, CameFrom came_from) {
    const std::string token = new_token();
    const int64_t now = now_s_();
    const std::lock_guard lock(mutex_);
    forget_old(now);
    make_room(account);
    sessions_[hash_of_token(token)] = {account, new_token(), now, now, std::move(came_from)};
    return token;
}

std::optional<Session> Sessions::find(const std::string& token) {
    const int64_t now = now_s_();
    const std::lock_guard lock(mutex_);
    const auto found = sessions_.find(hash_of_token(token));
    if (found == sessions_.end()) return std::nullopt;
    if (is_over(found->second, now)) {
        sessions_.erase(found);
        return std::nullopt;
    }
    found->second.seen_s = now;
    return found->second;
}

void Sessions::end(const std::string& token) {
    const std::lock_guard lock(mutex_);
    sessions_.erase(hash_of_token(token));
}

size_t Sessions::count() {
    const std::lock_guard lock(mutex_);
    return sessions_.size();
}

void Sessions::forget_old(int64_t now) {
    std::erase_if(sessions_, [now](const auto& each) { return is_over(each.second, now); });
}

void Sessions::make_room(int64_t account) {
    const auto end_longest_idle = [this](const auto& wanted) {
        auto oldest = sessions_.end();
        for (auto each = sessions_.begin(); each != sessions_.end(); ++each)
            if (wanted(each->second) &&
                (oldest == sessions_.end() || each->second.seen_s < oldest->second.seen_s))
                oldest = each;
        if (oldest != sessions_.end()) sessions_.erase(oldest);
    };
    const auto own = [account](const Session& session) { return session.account == account; };
    const auto held = std::count_if(sessions_.begin(), sessions_.end(),
                                    [&](const auto& each) { return own(each.second); });
    if (static_cast<size_t>(held) >= kOfAccount) end_longest_idle(own);
    if (sessions_.size() >= kMost) end_longest_idle([](const Session&) { return true; });
}

}  // namespace placode::web
