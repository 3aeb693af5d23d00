// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/platform_keys.h"

#include <algorithm>
#include <chrono>

#include "ui/lti/web_client.h"

namespace placode::lti {
namespace {

std::optional<PublicKey> find_in(const std::vector<PublicKey>& keys, const std::string& id) {
    const auto found = std::find_if(keys.begin(), keys.end(),
                                    [&](const PublicKey& each) { return each.id == id; });
    return found == keys.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

PlatformKeys::PlatformKeys(std::function<int64_t()> now_s,
                           std::function<void(const std::string&)> log)
    : now_s_(std::move(now_s)), log_(std::move(log)) {}

std::optional<PublicKey> PlatformKeys::find(const Platform& platform, const std::string& id) {
    if (!platform.keys_file.empty()) {
        try {
            return find_in(parse_key_set(read_settings_text(platform.keys_file)), id);
        } catch (const std::exception& error) {
            log_(platform.keys_file + ": " + error.what());
            return std::nullopt;
        }
    }
    if (const Looked seen = look(platform.keys_url, id); seen.key || !seen.is_to_ask)
        return seen.key;
    // A class comes at once: the first asks, the others wait for the answer.
    const std::unique_lock turn(asking_, std::chrono::seconds(15));
    if (!turn.owns_lock()) return std::nullopt;
    if (const Looked seen = look(platform.keys_url, id); seen.key || !seen.is_to_ask)
        return seen.key;
    keep(platform.keys_url, asked(platform.keys_url));
    return look(platform.keys_url, id).key;
}

PlatformKeys::Looked PlatformKeys::look(const std::string& address, const std::string& id) {
    const std::lock_guard lock(mutex_);
    const auto found = by_address_.find(address);
    if (found == by_address_.end()) return {std::nullopt, true};
    const Kept& kept = found->second;
    const int64_t now = now_s_();
    if (kept.read_s && now - *kept.read_s < kKeptS)
        if (auto key = find_in(kept.keys, id)) return {std::move(key), false};
    // Whoever makes up ids of keys cannot have the platform asked for each.
    return {std::nullopt, now - kept.asked_s >= (kept.failed ? kAfterFaultS : kAskAgainS)};
}

void PlatformKeys::keep(const std::string& address,
                        const std::optional<std::vector<PublicKey>>& keys) {
    const std::lock_guard lock(mutex_);
    Kept& kept = by_address_[address];
    kept.asked_s = now_s_();
    kept.failed = !keys;
    if (!keys) return;
    kept.keys = *keys;
    kept.read_s = kept.asked_s;
}

std::optional<std::vector<PublicKey>> PlatformKeys::asked(const std::string& address) const {
    WebCall call;
    call.address = address;
    try {
        const WebReply reply = ask(call);
        if (reply.status == 200) return parse_key_set(reply.body);
        log_(address + ": " +
             (reply.status == 0 ? reply.problem : "status " + std::to_string(reply.status)));
    } catch (const std::exception& error) {
        log_(address + ": " + error.what());
    }
    return std::nullopt;
}

}  // namespace placode::lti
