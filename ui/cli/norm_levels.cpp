// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/norm_levels.h"

#include <filesystem>
#include <system_error>

#include "ui/cli/batch.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

batches::SkillLevels levels_of_store(const Context& context, const QualityOptions& options) {
    if (options.novices.empty() || options.experts.empty())
        throw InputError(
            "norms quality: give --novices and --experts, --recordings FOLDER, or --batch FOLDER");
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    std::map<std::string, std::vector<int64_t>> people{
        {"expert", find_group(session, options.experts).members},
        {"novice", find_group(session, options.novices).members}};
    if (!options.intermediates.empty())
        people["intermediate"] = find_group(session, options.intermediates).members;
    batches::SkillLevels found;
    for (db::LevelAttempts& level : db::level_attempts(session.store(), options.task, people)) {
        db::LevelAttempts& place = level.level == "expert"   ? found.experts
                                   : level.level == "novice" ? found.novices
                                                             : found.intermediates;
        place = std::move(level);
    }
    return found;
}

batches::SkillLevels levels_of_recordings(const QualityOptions& options) {
    std::error_code problem;
    (void)std::filesystem::directory_iterator(options.recordings, problem);
    if (problem) throw InputError("--recordings " + options.recordings + ": " + problem.message());
    try {
        return batches::levels_of_recordings(options.task, options.recordings);
    } catch (const db::StoreError& error) {
        throw InputError(error.what());
    }
}

}  // namespace

batches::SkillLevels norm_levels(const Context& context, const QualityOptions& options) {
    if (!options.batch.empty())
        return of_batch([&] { return batches::levels_of_rollouts(options.task, options.batch); });
    if (!options.recordings.empty()) return levels_of_recordings(options);
    return levels_of_store(context, options);
}

}  // namespace placode::cli
