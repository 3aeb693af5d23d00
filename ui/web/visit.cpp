// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>

#include "curriculum/definitions.h"
#include "db/standards.h"
#include "ui/web/pages.h"
#include "ui/web/words.h"

namespace placode::web {
namespace {

/// -1 for what is no whole number from 0.
int64_t whole_number(const std::string& words) {
    int64_t value = 0;
    const char* end = words.data() + words.size();
    const auto [rest, error] = std::from_chars(words.data(), end, value);
    return error == std::errc{} && rest == end && value >= 0 ? value : -1;
}

}  // namespace

Tasks::Known Tasks::of(const std::string& task_id) {
    const std::lock_guard lock(mutex_);
    auto found = shipped_.find(task_id);
    // An id, never a path: it may come from an address.
    const bool is_id =
        task_id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") == std::string::npos;
    try {
        // What is asked for in addresses must not fill the memory: only tasks are kept.
        if (found == shipped_.end() && is_id && !task_id.empty()) {
            const curriculum::Task task = curriculum::load_task(task_id);
            found = shipped_.emplace(task_id, Shipped{task.title, task.rubric.pass_points}).first;
        }
    } catch (const curriculum::DefinitionError&) {
        // A task that no longer ships: its id is title enough.
    }
    if (found == shipped_.end()) return {task_id, 0, false};
    return {in_words(found->second.title), found->second.pass_points, true};
}

double Tasks::pass_points(db::Store& store, const std::string& task_id) {
    const auto set = db::standard_at(store, task_id);
    return set ? set->standard.pass_points : of(task_id).pass_points;
}

std::string Visit::asked(const std::string& key) const {
    const auto found = query.find(key);
    return found == query.end() ? std::string() : found->second;
}

int64_t Visit::number(const std::string& key) const {
    return std::max<int64_t>(0, whole_number(asked(key)));
}

int64_t Visit::id(size_t part) const {
    const int64_t value = part < parts.size() ? whole_number(parts[part]) : -1;
    if (value <= 0) throw NotThere(Web::plain_phrase("There is no such page."));
    return value;
}

bool Visit::may(db::Action action) const {
    return user.active && db::allowed(user.roles, action, db::Scope::kOther);
}

const std::vector<Route>& routes() {
    static const std::vector<Route> all{
        {"/", own_page},
        {"/people/*", person_page},
        {"/people/*/tasks/*", curve_page},
        {"/people/*/attempts", persons_attempts_page},
        {"/attempts", attempts_page},
        {"/attempts/*", attempt_page},
        {"/attempts/*/review", review_page},
        {"/attempts/*/review/track", nullptr, review_track},
        {"/attempts/*/review/parts/*", nullptr, review_part},
        {"/cohort", cohort_page},
        {"/help", help_page},
        {"/refreshers", refreshers_page},
        {"/scores", scores_page},
        {"/standards", standards_page},
        {"/norms", norms_page},
        {"/norms/*", norm_pack_page},
        {"/studies", studies_page},
        {"/studies/*", study_page},
        {"/studies/*/entries", entries_page},
        {"/studies/*/deviations", deviations_page},
        {"/people", people_page},
    };
    return all;
}

}  // namespace placode::web
