// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/norm_bands.h"

#include <algorithm>
#include <set>
#include <utility>

#include "assessment/statistics.h"
#include "db/attempt_counting.h"
#include "db/demonstration.h"
#include "db/said.h"
#include "db/signature.h"

namespace placode::db {

using assessment::Direction;

Direction direction_of(const std::string& metric) {
    if (metric == "points") return Direction::kHigherIsBetter;
    const assessment::MetricDefinition* definition = assessment::metric_definition(metric);
    return definition != nullptr ? definition->direction : Direction::kNeutral;
}

namespace {

/// "points" first, then metrics in the order of their definitions.
std::vector<std::string> metrics_in(const std::vector<const LevelAttempts*>& levels) {
    std::set<std::string> there;
    for (const LevelAttempts* level : levels)
        for (const auto& [person, attempts] : level->by_person)
            for (const MeasuredAttempt& attempt : attempts)
                for (const auto& metric : attempt.metrics.values) there.insert(metric.id);
    std::vector<std::string> ids{"points"};
    for (const auto& definition : assessment::metric_definitions())
        if (there.contains(std::string(definition.id))) ids.emplace_back(definition.id);
    return ids;
}

using Versions = std::pair<int, int>;
Versions versions_of(const MeasuredAttempt& attempt) {
    return {attempt.record.metric_set_version, attempt.record.preprocessing_version};
}

[[noreturn]] void refuse(const Said& problem) {
    throw StoreError(StoreError::Kind::kRefused, "norms: ", problem);
}

const AttemptRecord& first_of(const LevelAttempts& level) {
    return level.by_person.begin()->second.front().record;
}

curriculum::NormGroup group_of(const LevelAttempts& level, const std::vector<std::string>& ids) {
    curriculum::NormGroup group;
    group.level = level.level;
    group.persons = static_cast<int>(level.by_person.size());
    group.attempts = level.attempts();
    for (const std::string& id : ids) {
        const auto values = level_values(level, id, true);
        // Fewer people than the least group may have this metric.
        if (static_cast<int>(values.size()) < curriculum::kLeastNormGroup) continue;
        const auto band = assessment::make_benchmark(values, assessment::is_log_metric(id));
        if (band) group.metrics.push_back({id, *band});
    }
    return group;
}

}  // namespace

void need_proof(const std::vector<LevelAttempts>& levels) {
    int all = 0, unproven = 0;
    for (const LevelAttempts& level : levels)
        for (const auto& [person, attempts] : level.by_person)
            for (const MeasuredAttempt& attempt : attempts) {
                ++all;
                if (!attempt.record.demonstration &&
                    attempt.record.replay != ReplayState::kIdentical)
                    ++unproven;
            }
    if (unproven > 0)
        refuse(Said::that("%1 of %2 attempts were never simulated again; let `placodectl verify "
                          "--all` do that first")
                   .with(unproven)
                   .with(all));
}

void need_same_rules(const std::vector<LevelAttempts>& levels) {
    const AttemptRecord* first = nullptr;
    for (const LevelAttempts& level : levels)
        for (const auto& [person, attempts] : level.by_person)
            for (const MeasuredAttempt& attempt : attempts) {
                if (first == nullptr) first = &attempt.record;
                need_same_rules("norms: ", *first, attempt.record);
            }
}

void leave_demonstrations_out(Store& store, std::vector<LevelAttempts>& levels) {
    if (is_demonstration_store(store.accounts().list())) return;
    for (LevelAttempts& level : levels) {
        for (auto& [person, attempts] : level.by_person)
            std::erase_if(attempts,
                          [](const MeasuredAttempt& one) { return one.record.demonstration; });
        std::erase_if(level.by_person, [](const auto& each) { return each.second.empty(); });
    }
}

int LevelAttempts::attempts() const {
    size_t n = 0;
    for (const auto& [person, each] : by_person) n += each.size();
    return static_cast<int>(n);
}

int LevelAttempts::passed() const {
    int n = 0;
    for (const auto& [person, attempts] : by_person)
        for (const MeasuredAttempt& each : attempts)
            n += each.record.verdict == assessment::Verdict::kPassed ? 1 : 0;
    return n;
}

std::vector<LevelAttempts> level_attempts(
    Store& store, const std::string& task_id,
    const std::map<std::string, std::vector<int64_t>>& people) {
    std::vector<LevelAttempts> levels;
    Versions newest{0, 0};
    for (const auto& [name, ids] : people) {
        LevelAttempts level;
        level.level = name;
        for (const int64_t id : ids)
            for (MeasuredAttempt& attempt : store.norms().measured_attempts(id, task_id)) {
                if (attempt.record.generated || !counts(attempt.record)) continue;
                newest = std::max(newest, versions_of(attempt));
                level.by_person[id].push_back(std::move(attempt));
            }
        levels.push_back(std::move(level));
    }
    for (LevelAttempts& level : levels) {
        for (auto& [person, attempts] : level.by_person)
            level.left_out += static_cast<int>(std::erase_if(
                attempts, [&](const MeasuredAttempt& one) { return versions_of(one) != newest; }));
        std::erase_if(level.by_person, [](const auto& each) { return each.second.empty(); });
    }
    return levels;
}

std::optional<double> value_of(const MeasuredAttempt& attempt, const std::string& metric) {
    if (metric == "points") return attempt.record.points;
    return attempt.metrics.find(metric);
}

std::vector<double> level_values(const LevelAttempts& level, const std::string& metric,
                                 bool per_person) {
    std::vector<double> values;
    for (const auto& [person, attempts] : level.by_person) {
        std::vector<double> own;
        for (const MeasuredAttempt& attempt : attempts)
            if (const auto value = value_of(attempt, metric)) own.push_back(*value);
        if (own.empty()) continue;
        if (per_person)
            values.push_back(*assessment::mean_of(own));
        else
            values.insert(values.end(), own.begin(), own.end());
    }
    return values;
}

assessment::ContrastingGroups pass_mark_between(const LevelAttempts& novices,
                                                const LevelAttempts& experts,
                                                const std::string& metric, bool per_person) {
    auto low = level_values(novices, metric, per_person);
    auto high = level_values(experts, metric, per_person);
    // The method wants high values to be good.
    const double sign = direction_of(metric) == assessment::Direction::kLowerIsBetter ? -1 : 1;
    for (auto* values : {&low, &high})
        for (double& value : *values) value *= sign;
    assessment::ContrastingGroups groups = assessment::contrasting_groups(low, high);
    for (double* each : {&groups.cut_score, &groups.mean_novice, &groups.mean_expert})
        *each *= sign;
    return groups;
}

curriculum::NormPack make_norms(const std::vector<LevelAttempts>& levels, const std::string& centre,
                                const std::string& made_utc, int least) {
    least = std::max(least, curriculum::kLeastNormGroup);
    std::vector<const LevelAttempts*> all;
    for (const LevelAttempts& level : levels) {
        if (static_cast<int>(level.by_person.size()) < least)
            refuse(Said::that("the level \"%1\" has %2 persons with attempts; at least %3 are "
                              "needed, because bands of fewer tell about persons")
                       .with(level.level)
                       .with(static_cast<int64_t>(level.by_person.size()))
                       .with(least));
        all.push_back(&level);
    }
    if (levels.empty()) refuse(Said::as_is("no level was named"));
    const AttemptRecord& first = first_of(levels.front());
    curriculum::NormPack pack;
    pack.centre = centre;
    pack.made_utc = made_utc;
    pack.task_id = first.task_id;
    pack.task_version = first.task_version;
    pack.rubric_id = first.rubric_id;
    pack.rubric_version = first.rubric_version;
    pack.metric_set_version = first.metric_set_version;
    pack.preprocessing_version = first.preprocessing_version;
    need_proof(levels);
    need_same_rules(levels);
    for (const LevelAttempts& level : levels)
        for (const auto& [person, attempts] : level.by_person)
            for (const MeasuredAttempt& attempt : attempts)
                pack.demonstration = pack.demonstration || attempt.record.demonstration;
    for (const LevelAttempts& level : levels)
        pack.groups.push_back(group_of(level, metrics_in(all)));
    return pack;
}

int64_t keep_own_norms(Store& store, const curriculum::NormPack& pack,
                       std::string_view passphrase) {
    const OpenCentreKey key = store.norms().open_centre_key(pack.centre, passphrase);
    curriculum::NormPack own = pack;
    own.centre = key.centre;
    curriculum::SignedNorms norms;
    norms.content = curriculum::norm_pack_text(own);
    norms.signature = sign_text(norms.content, key.secret_key.text());
    norms.public_key = key.public_key;
    return store.norms().save(norms);
}

std::optional<NormPackRecord> norms_in_use(Store& store, const std::string& task_id) {
    for (NormPackRecord& record : store.norms().list(task_id))
        if (record.in_use) return std::move(record);
    return std::nullopt;
}

std::vector<BandComparison> compare_with_band(const MeasuredAttempt& attempt,
                                              const curriculum::NormGroup& group) {
    std::vector<BandComparison> found;
    for (const curriculum::NormMetric& metric : group.metrics) {
        const auto value = value_of(attempt, metric.id);
        if (!value) continue;
        BandComparison one{metric.id, *value, metric.band, {}, {}};
        one.z = assessment::benchmark_z(metric.band, *value, direction_of(metric.id));
        if (one.z) one.score = assessment::item_score(*one.z);
        found.push_back(std::move(one));
    }
    return found;
}

std::vector<assessment::MetricQuality> metric_panel(const LevelAttempts& novices,
                                                    const LevelAttempts& experts, int repeats) {
    std::vector<assessment::MetricQuality> panel;
    for (const std::string& id : metrics_in({&novices, &experts})) {
        std::vector<assessment::Repeats> people;
        for (const LevelAttempts* level : {&novices, &experts})
            for (const auto& [person, attempts] : level->by_person) {
                assessment::Repeats own;
                own.level = level == &experts ? 1 : 0;
                for (const MeasuredAttempt& attempt : attempts)
                    if (const auto value = value_of(attempt, id)) own.values.push_back(*value);
                people.push_back(std::move(own));
            }
        panel.push_back(assessment::metric_quality(id, direction_of(id), people, repeats));
    }
    return panel;
}

}  // namespace placode::db
