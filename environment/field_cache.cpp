// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/field_cache.h"

#include <algorithm>

#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"

namespace placode::environment {

namespace {

std::shared_ptr<const Field> build(curriculum::Task task, uint64_t seed) {
    auto field = std::make_shared<Field>();
    task.scene.seed = seed;
    field->seed = seed;
    field->scene = sim::build_operative_field(task.scene);
    sim::State state(*field->scene, 1);
    sim::settle(*field->scene, state, task.settle_s);
    field->settled = sim::save_state(*field->scene, state);
    field->task = std::move(task);
    return field;
}

}  // namespace

void FieldCache::keep(const std::shared_ptr<const Field>& field) {
    kept_.remove(field);
    kept_.push_front(field);
    while (kept_.size() > most_kept_) kept_.pop_back();
}

std::shared_ptr<const Field> FieldCache::field(const curriculum::Task& task, uint64_t seed) {
    const Key key{task.json, seed};
    std::promise<std::shared_ptr<const Field>> promise;
    Built built;
    {
        const std::lock_guard lock(mutex_);
        if (auto known = known_[key].lock()) {
            keep(known);
            return known;
        }
        const auto under_way = building_.find(key);
        if (under_way != building_.end())
            built = under_way->second;
        else
            building_[key] = promise.get_future().share();
    }
    if (built.valid()) return built.get();  // another thread builds it
    try {
        auto field = build(task, seed);
        const std::lock_guard lock(mutex_);
        std::erase_if(known_, [](const auto& entry) { return entry.second.expired(); });
        known_[key] = field;
        ++built_;
        keep(field);
        promise.set_value(field);
        building_.erase(key);
        return field;
    } catch (...) {
        const std::lock_guard lock(mutex_);
        promise.set_exception(std::current_exception());
        building_.erase(key);
        throw;
    }
}

size_t FieldCache::built() const {
    const std::lock_guard lock(mutex_);
    return built_;
}

}  // namespace placode::environment
