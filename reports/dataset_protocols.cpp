// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/dataset_protocols.h"

#include <algorithm>
#include <functional>

#include "db/study_conduct.h"

namespace placode::reports {

Protocols::Protocols(db::Store& store, const std::string& study_id,
                     const std::vector<db::ParticipantRecord>& participants) {
    versions_[0] = db::published_study(store, study_id);
    if (const auto* protocol = newest(); protocol != nullptr && protocol->arms)
        arms_ = protocol->arms->names;
    for (const db::ParticipantRecord& each : participants) {
        const int number = each.protocol_version;
        enrolled_[each.code] = number;
        if (!versions_.contains(number))
            versions_[number] = db::published_study(store, study_id, number);
    }
    for (const auto& [number, unused] : versions_) add_arms(number);
}

const curriculum::StudyProtocol* Protocols::version(int number) const {
    const auto found = versions_.find(number);
    return found == versions_.end() || !found->second ? nullptr : &*found->second;
}

const curriculum::StudyProtocol* Protocols::newest() const { return version(0); }

const curriculum::StudyProtocol* Protocols::of(const std::string& code) const {
    const auto found = enrolled_.find(code);
    return version(found == enrolled_.end() ? 0 : found->second);
}

std::vector<const curriculum::StudyProtocol*> Protocols::in_use() const {
    std::map<int, const curriculum::StudyProtocol*, std::greater<>> found;
    for (const auto& [code, unused] : enrolled_)
        if (const auto* protocol = of(code)) found.emplace(protocol->version, protocol);
    std::vector<const curriculum::StudyProtocol*> list;
    for (const auto& [number, protocol] : found) list.push_back(protocol);
    return list;
}

bool Protocols::ask_consent() const {
    return std::any_of(versions_.begin(), versions_.end(), [](const auto& each) {
        return each.second && each.second->needs_consent();
    });
}

std::optional<int> Protocols::arm_of(const db::ParticipantRecord& participant) const {
    const auto found = places_.find(participant.protocol_version);
    if (found == places_.end() || participant.arm < 0) return std::nullopt;
    const auto arm = static_cast<size_t>(participant.arm);
    return arm < found->second.size() ? std::optional(found->second[arm]) : std::nullopt;
}

/// The store lets nobody rename or reorder arms once somebody is allocated; an earlier one did.
void Protocols::add_arms(int number) {
    const curriculum::StudyProtocol* protocol = version(number);
    if (protocol == nullptr || !protocol->arms) return;
    std::vector<int>& places = places_[number];
    for (const curriculum::LocalText& name : protocol->arms->names) {
        const auto same = [&](const curriculum::LocalText& arm) { return arm.en == name.en; };
        size_t at = places.size();
        if (at >= arms_.size() || !same(arms_[at])) {
            const auto found = std::find_if(arms_.begin(), arms_.end(), same);
            at = static_cast<size_t>(found - arms_.begin());
            if (found == arms_.end()) arms_.push_back(name);
        }
        places.push_back(static_cast<int>(at));
    }
}

}  // namespace placode::reports
