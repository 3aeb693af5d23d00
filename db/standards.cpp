// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/standards.h"

#include <algorithm>

#include "assessment/statistics.h"
#include "db/attempt_counting.h"
#include "db/demonstration.h"

namespace placode::db {
namespace {

constexpr const char* kKind = "standard";

/// The attempts of each of these people by which others may be judged, the last ones.
std::vector<std::vector<AttemptRecord>> judging(Store& store, const std::string& task_id,
                                                const std::vector<int64_t>& people, int last) {
    const bool shows = is_demonstration_store(store.accounts().list());
    std::vector<std::vector<AttemptRecord>> found;
    for (const int64_t person : people) {
        std::vector<AttemptRecord> own = store.attempts().list(person, task_id);
        std::erase_if(own, [shows](const AttemptRecord& each) {
            return !counts(each) || (each.demonstration && !shows);
        });
        if (own.size() > static_cast<size_t>(last)) own.erase(own.begin(), own.end() - last);
        found.push_back(std::move(own));
    }
    return found;
}

void need_proof_of(const std::string& task_id,
                   const std::vector<std::vector<AttemptRecord>>& judged) {
    int all = 0, unproven = 0;
    for (const auto& own : judged)
        for (const AttemptRecord& each : own) {
            ++all;
            if (!each.demonstration && each.replay != ReplayState::kIdentical) ++unproven;
        }
    if (unproven > 0)
        throw StoreError(StoreError::Kind::kRefused, "standard of " + task_id + ": ",
                         Said::that("%1 of %2 attempts were never simulated again; let `placodectl "
                                    "verify --all` do that first")
                             .with(unproven)
                             .with(all));
}

void need_one_version_of(const std::string& task_id,
                         const std::vector<std::vector<AttemptRecord>>& judged) {
    const AttemptRecord* first = nullptr;
    for (const auto& own : judged)
        for (const AttemptRecord& each : own) {
            if (first == nullptr) first = &each;
            need_same_rules("standard of " + task_id + ": ", *first, each);
        }
}

std::vector<std::vector<AttemptRecord>> fit_to_judge(Store& store, const std::string& task_id,
                                                     const std::vector<int64_t>& people, int last) {
    auto judged = judging(store, task_id, people, last);
    need_proof_of(task_id, judged);
    need_one_version_of(task_id, judged);
    return judged;
}

}  // namespace

std::optional<StandardRecord> standard_at(Store& store, const std::string& task_id,
                                          const std::string& at_utc) {
    auto found = store.definitions().find(kKind, task_id);
    while (found && !at_utc.empty() && found->published_utc > at_utc)
        found = found->version > 1 ? store.definitions().find(kKind, task_id, found->version - 1)
                                   : std::nullopt;
    if (!found) return std::nullopt;
    return StandardRecord{curriculum::load_standard_text(found->json, "standard of " + task_id),
                          found->reason, found->published_by, found->published_utc};
}

int set_standard(Store& store, curriculum::PassStandard standard, const std::string& reason) {
    const auto newest = store.definitions().find(kKind, standard.task_id);
    standard.version = newest ? newest->version + 1 : 1;
    DefinitionRecord definition;
    definition.kind = kKind;
    definition.id = standard.task_id;
    definition.version = standard.version;
    definition.json = curriculum::standard_json(standard);
    definition.reason = reason;
    store.definitions().publish(definition);
    return standard.version;
}

assessment::Rubric rubric_at(Store& store, const curriculum::Task& task,
                             const std::string& at_utc) {
    assessment::Rubric rubric = task.rubric;
    if (const auto set = standard_at(store, task.id, at_utc))
        rubric.pass_points = set->standard.pass_points;
    return rubric;
}

void need_fit_to_judge(Store& store, const std::string& task_id, const std::vector<int64_t>& people,
                       int last) {
    (void)fit_to_judge(store, task_id, people, last);
}

std::vector<double> person_means(Store& store, const std::string& task_id,
                                 const std::vector<int64_t>& people, int last) {
    std::vector<double> means;
    for (const auto& own : fit_to_judge(store, task_id, people, last)) {
        std::vector<double> points;
        points.reserve(own.size());
        for (const AttemptRecord& each : own) points.push_back(each.points);
        if (const auto mean = assessment::mean_of(points)) means.push_back(*mean);
    }
    return means;
}

curriculum::PassStandard standard_of_groups(const std::string& task_id,
                                            const std::vector<double>& novices,
                                            const std::vector<double>& experts, int last) {
    const auto result = assessment::contrasting_groups(novices, experts);
    curriculum::PassStandard standard;
    standard.task_id = task_id;
    standard.pass_points = result.cut_score;
    standard.mean_of_last_attempts = last;
    standard.novice = {result.n_novice, result.mean_novice, result.sd_novice,
                       result.theoretical_false_positive, result.observed_false_positive};
    standard.expert = {result.n_expert, result.mean_expert, result.sd_expert,
                       result.theoretical_false_negative, result.observed_false_negative};
    return standard;
}

curriculum::PassStandard standard_of_judges(const std::string& task_id,
                                            const assessment::Angoff& judges) {
    curriculum::PassStandard standard;
    standard.task_id = task_id;
    standard.method = "angoff";
    standard.pass_points = judges.cut_percent;
    standard.angoff = {judges.judges, judges.items, judges.se_percent};
    return standard;
}

}  // namespace placode::db
