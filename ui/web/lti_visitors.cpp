// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/lti_visitors.h"

#include <algorithm>

#include "ui/web/sessions.h"

namespace placode::web {

bool Turns::take(int64_t now_s) {
    const std::lock_guard lock(mutex_);
    const int64_t passed = std::clamp<int64_t>(now_s - filled_s_, 0, most_);
    left_ = std::min(most_, left_ + passed * a_second_);
    filled_s_ = now_s;
    if (left_ == 0) return false;
    --left_;
    return true;
}

std::string Arrivals::begin(Arrival arrival) {
    const std::string state = new_token();
    const std::lock_guard lock(mutex_);
    std::erase_if(arrivals_, [&](const auto& each) {
        return arrival.begun_s - each.second.begun_s >= kLifeS;
    });
    arrivals_[hash_of_token(state)] = std::move(arrival);
    return state;
}

std::optional<Arrival> Arrivals::take(const std::string& state, int64_t now_s) {
    const std::lock_guard lock(mutex_);
    const auto found = arrivals_.find(hash_of_token(state));
    if (found == arrivals_.end()) return std::nullopt;
    const Arrival arrival = std::move(found->second);
    arrivals_.erase(found);
    if (now_s - arrival.begun_s >= kLifeS) return std::nullopt;
    return arrival;
}

size_t Arrivals::count() {
    const std::lock_guard lock(mutex_);
    return arrivals_.size();
}

}  // namespace placode::web
