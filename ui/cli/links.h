// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is linked with a learning platform. The links stand in a file beside the store, so that an
// erasure does not reach them: they outlive the person.

#include <algorithm>
#include <string>
#include <vector>

#include "ui/cli/session.h"
#include "ui/lti/grades.h"
#include "ui/lti/settings.h"

namespace placode::cli {

/// What is left out, in sentences for people.
struct LeftOut {
    std::vector<std::string> problems;  ///< Somebody has to mend these.
    std::vector<std::string> erased;    ///< These are as they should be; the link may go.
};

/// Whether the account of a link was erased; then it is said once.
[[nodiscard]] inline bool is_erased(Session& session, const lti::Link& link, LeftOut& left_out) {
    if (session.store().accounts().find(link.account)) return false;
    left_out.erased.push_back("sub \"" + link.subject + "\": account " +
                              std::to_string(link.account) +
                              " was erased; take the link away as well: placodectl lti unlink");
    return true;
}

/// The platform without those who were erased.
[[nodiscard]] inline lti::Platform without_erased(Session& session, const lti::Platform& platform,
                                                  LeftOut& left_out) {
    lti::Platform there = platform;
    std::erase_if(there.links,
                  [&](const lti::Link& link) { return is_erased(session, link, left_out); });
    return there;
}

/// The accounts that are linked in a file, each once: where number and log-in name are still the
/// same one's. Throws lti::SettingsError, db::StoreError.
[[nodiscard]] inline std::vector<db::UserRecord> linked_people(Session& session,
                                                               const std::string& file,
                                                               LeftOut& left_out) {
    std::vector<db::UserRecord> people;
    for (const lti::Platform& platform : lti::read_settings(file).platforms)
        for (const lti::Link& link : without_erased(session, platform, left_out).links) {
            if (!lti::is_theirs(session.store(), link))
                left_out.problems.push_back(lti::not_theirs(link));
            else if (std::none_of(people.begin(), people.end(),
                                  [&](const auto& each) { return each.id == link.account; }))
                people.push_back(*session.store().accounts().find(link.account));
        }
    return people;
}

}  // namespace placode::cli
