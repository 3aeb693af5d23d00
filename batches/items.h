// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One item of a batch, done: a pure function of manifest, item and files. What comes out holds no
// clock, host or path of the machine, so that it is the same wherever it was computed.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "batches/manifest.h"
#include "environment/environment.h"
#include "sim/step/recording.h"

namespace placode::batches {

/// Asked now and then; false = stop, and nothing of the item is kept.
using GoOn = std::function<bool()>;
/// Thrown when it said so.
struct Stopped {};

/// Does the items of one shard, one after the other.
class Worker {
 public:
    Worker(std::filesystem::path folder, const Manifest& manifest, GoOn go_on);
    ~Worker();

    /// An input that cannot be used is a result, with "problem" in it. Throws BatchError when an
    /// input is not the planned one, and Stopped.
    [[nodiscard]] Json perform(size_t item);

 private:
    Json rescore(const Json& item);
    Json replay(const Json& item);
    Json rollout(const Json& item);
    [[nodiscard]] sim::Recording planned_recording(const Json& item) const;
    [[nodiscard]] const curriculum::Task* task(const std::string& key, const std::string& value);
    environment::Environment& environment_for(const std::string& task, const std::string& policy);
    void check_stop() const;

    std::filesystem::path folder_;
    const Manifest& manifest_;
    GoOn go_on_;
    std::map<std::string, curriculum::Task> tasks_;  // by ref
    std::shared_ptr<environment::FieldCache> fields_;
    std::map<std::string, std::unique_ptr<environment::Environment>> environments_;
};

/// The whole recording under a temporary name, then renamed.
void write_recording(const sim::Recording& recording, const std::filesystem::path& path);

}  // namespace placode::batches
