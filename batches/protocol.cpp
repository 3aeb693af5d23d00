// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "batches/batch_error.h"
#include "batches/benchmark.h"
#include "batches/checksum.h"
#include "curriculum/definitions.h"
#include "curriculum/scene_changes.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& problem) {
    throw BatchError(BatchError::Kind::kBadInput, path.string() + ": " + problem);
}

Protocol protocol_from_json(const Json& json) {
    Protocol protocol;
    protocol.id = json.at("id").get<std::string>();
    protocol.version = json.at("version").get<int>();
    protocol.frames_per_step = json.at("frames_per_step").get<int>();
    protocol.scene_changes = json.value("scene_changes", Json());
    protocol.seeds = json.at("seeds").get<std::vector<uint64_t>>();
    for (const Json& one : json.at("tasks"))
        protocol.tasks.push_back(
            {one.at("task").get<std::string>(), one.at("budget_s").get<double>()});
    return protocol;
}

void check(const fs::path& path, const Protocol& protocol) {
    if (protocol.frames_per_step < 1 || protocol.frames_per_step > 1000)
        refuse(path, "/frames_per_step: found " + std::to_string(protocol.frames_per_step) +
                         "; expected 1 to 1000");
    if (protocol.seeds.empty() || protocol.tasks.empty())
        refuse(path, "expected at least one of /seeds and one of /tasks");
    std::set<std::string> tasks;
    for (const BenchmarkTask& one : protocol.tasks)
        if (!(one.budget_s > 0) || one.budget_s > 3600 || !tasks.insert(one.task).second)
            refuse(path, "/tasks: " + one.task +
                             " is there twice, or its budget_s is not above 0 and at most 3600");
    if (std::set<uint64_t>(protocol.seeds.begin(), protocol.seeds.end()).size() !=
        protocol.seeds.size())
        refuse(path, "/seeds: expected each once");
}

}  // namespace

fs::path shipped_protocol() { return curriculum::data_folder() / "benchmarks" / "tasks.json"; }

Protocol read_protocol(const fs::path& path) {
    Protocol protocol;
    std::string text;
    try {
        const Json json = Json::parse(text = read_text(path));
        protocol = protocol_from_json(json);
        text = json.dump();
    } catch (const Json::exception& error) {
        refuse(path, std::string("is no protocol of a benchmark: ") + error.what());
    }
    check(path, protocol);
    for (const BenchmarkTask& one : protocol.tasks) text += protocol_task(protocol, one.task).json;
    protocol.sha256 = sha256(text);
    return protocol;
}

curriculum::Task protocol_task(const Protocol& protocol, const std::string& task) {
    const curriculum::Task published = curriculum::load_task(task);
    return protocol.scene_changes.is_null()
               ? published
               : curriculum::with_scene_changes(published, protocol.scene_changes.dump());
}

}  // namespace placode::batches
