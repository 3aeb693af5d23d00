// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Operative fields, built and settled once and shared by all environments that use them: what never
// changes during an attempt (sim::Scene) takes most of the memory and all of the time of a reset.

#include <cstdint>
#include <future>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "curriculum/task.h"
#include "sim/world/scene.h"

namespace placode::environment {

/// A task's field for one seed, and the state in which an attempt begins.
struct Field {
    curriculum::Task task;  ///< With the seed in its scene.
    uint64_t seed = 1;
    std::shared_ptr<const sim::Scene> scene;
    std::vector<uint8_t> settled;  ///< sim/world/saved_state.h
};

/// Any thread. Fields of different seeds are built at the same time.
class FieldCache {
 public:
    /// @param most_kept so many stay although nobody uses them, the last used ones.
    explicit FieldCache(size_t most_kept = 8) : most_kept_(most_kept) {}

    /// Throws MeshError.
    [[nodiscard]] std::shared_ptr<const Field> field(const curriculum::Task& task, uint64_t seed);
    /// How many were built so far.
    [[nodiscard]] size_t built() const;

 private:
    using Key = std::pair<std::string, uint64_t>;
    using Built = std::shared_future<std::shared_ptr<const Field>>;

    void keep(const std::shared_ptr<const Field>& field);

    mutable std::mutex mutex_;
    std::map<Key, std::weak_ptr<const Field>> known_;
    std::map<Key, Built> building_;
    std::list<std::shared_ptr<const Field>> kept_;  // last used first
    size_t most_kept_, built_ = 0;
};

}  // namespace placode::environment
