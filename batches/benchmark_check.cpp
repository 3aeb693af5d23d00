// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Is an entry what it says? Everything is taken from protocol and recordings; what the entry says
// is only compared.

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/soundness.h"
#include "batches/batch_error.h"
#include "batches/benchmark.h"
#include "batches/checksum.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/replay_check.h"
#include "db/recording_file.h"
#include "db/store_error.h"
#include "environment/hands.h"
#include "environment/judge.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

/// The first frame in which a tip goes faster than an environment lets it; -1: none does.
int64_t too_fast(const sim::Recording& recording) {
    // Poses are kept as floats, which round at some nanometres.
    const double most_m = environment::kFastestM_S * recording.header.frame_s * 1.01;
    for (size_t i = 1; i < recording.inputs.size(); ++i)
        for (size_t tool = 0; tool < recording.header.tools.size(); ++tool) {
            const auto& now = recording.inputs[i].tools[tool];
            const auto& before = recording.inputs[i - 1].tools[tool];
            if ((now.pose().p - before.pose().p).norm() > most_m) return static_cast<int64_t>(i);
        }
    return -1;
}

class Check {
 public:
    Check(const Protocol& protocol, const Json& entry, fs::path folder, bool replay,
          const EntryProgress& progress)
        : protocol_(protocol),
          entry_(entry),
          folder_(std::move(folder)),
          replay_(replay),
          progress_(progress) {}

    EntryCheck run() {
        check_.replayed = replay_;
        if (entry_.at("benchmark") != protocol_.id || entry_.at("version") != protocol_.version ||
            entry_.at("protocol_sha256") != protocol_.sha256) {
            says("entry.json", "is of another benchmark, or of other texts of its tasks, than " +
                                   protocol_.id + " version " + std::to_string(protocol_.version) +
                                   " here");
            check_.replayed = false;
            return check_;
        }
        check_attempts();
        check_sums();
        return check_;
    }

 private:
    void says(const std::string& what, const std::string& problem) {
        check_.problems.push_back(what + ": " + problem);
    }

    /// Each task of the entry with each of its seeds, once.
    void check_attempts() {
        const auto seeds = entry_.at("seeds").get<std::vector<uint64_t>>();
        if (entry_.at("held_out_seeds").get<bool>() == (seeds == protocol_.seeds))
            says("entry.json", "says wrongly whose seeds these are");
        std::set<std::pair<std::string, uint64_t>> seen;
        std::set<std::string> tasks;
        for (const Json& attempt : entry_.at("attempts")) {
            const auto task = attempt.at("task").get<std::string>();
            const auto seed = attempt.at("seed").get<uint64_t>();
            tasks.insert(task);
            if (!seen.emplace(task, seed).second ||
                std::find(seeds.begin(), seeds.end(), seed) == seeds.end())
                says(task, "seed " + std::to_string(seed) + " is there twice, or is none of its");
            check_attempt(attempt, task, seed);
        }
        if (seen.size() != tasks.size() * seeds.size()) says("entry.json", "attempts are left out");
    }

    void check_attempt(const Json& attempt, const std::string& task_id, uint64_t seed) {
        const auto name = attempt.at("recording").get<std::string>();
        if (!progress_(name)) throw Stopped{};
        const auto* known =
            std::find_if(protocol_.tasks.data(), protocol_.tasks.data() + protocol_.tasks.size(),
                         [&](const BenchmarkTask& one) { return one.task == task_id; });
        if (known == protocol_.tasks.data() + protocol_.tasks.size())
            return says(name, "its task is not in the benchmark");
        const fs::path path = folder_ / fs::path(name).filename();
        if (!fs::exists(path)) return says(name, "is not beside entry.json");
        if (sha256_of_file(path) != attempt.at("sha256").get<std::string>())
            return says(name, "is not the file of the entry: its checksum differs");
        try {
            check_recording(attempt, db::read_recording_file(path.string()), *known, seed);
        } catch (const db::StoreError& error) {
            says(name, error.what());
        } catch (const curriculum::DefinitionError& error) {
            says(name, error.what());
        }
    }

    void check_recording(const Json& attempt, const sim::Recording& recording,
                         const BenchmarkTask& wanted, uint64_t seed) {
        const auto name = attempt.at("recording").get<std::string>();
        const sim::RecordingHeader& head = recording.header;
        const curriculum::Task task = protocol_task(protocol_, wanted.task);
        if (head.task_id != task.id || head.seed != seed ||
            curriculum::load_task_text(head.task_json, name).json !=
                curriculum::load_task_text(task.json, task.id).json)
            return says(name, "is of another task, scene or seed than the protocol's");
        if (const auto problem = assessment::unsound(recording))
            return says(name, problem->english());
        if (recording.end.duration_s > wanted.budget_s + 1e-6)
            says(name, "is longer than the budget");
        if (const int64_t frame = too_fast(recording); frame >= 0)
            says(name, "a tip moves faster than an environment lets it, in frame " +
                           std::to_string(frame));
        const auto judged = environment::judge_finished(task.rubric, recording);
        if (attempt.at("points").get<double>() != judged.score.points ||
            attempt.at("passed").get<bool>() !=
                (judged.score.verdict == assessment::Verdict::kPassed) ||
            attempt.at("final_hash") != hash_text(recording.end.final_hash))
            says(name, "the entry says other points, verdict or hash than its recording");
        if (replay_) replay(name, recording, task);
    }

    void replay(const std::string& name, const sim::Recording& recording,
                const curriculum::Task& task) {
        // Bits are promised for one build and instruction set: others prove nothing, against
        // nobody.
        if (recording.header.build != curriculum::this_build()) {
            check_.replayed = false;
            return;
        }
        curriculum::ReplayCheck again(recording, task, 1);
        for (int64_t frame = 0; again.step(); ++frame)
            if (frame % 50 == 0 && !progress_(name)) throw Stopped{};
        if (const auto verdict = again.verdict(); !verdict.identical)
            says(name, "simulated again it differs: " + verdict.difference.english());
    }

    /// Sums over attempts that were checked above.
    void check_sums() {
        double sum = 0;
        for (const Json& task : entry_.at("tasks")) {
            double points = 0;
            int attempts = 0, passed = 0;
            for (const Json& attempt : entry_.at("attempts")) {
                if (attempt.at("task") != task.at("task")) continue;
                points += attempt.at("points").get<double>();
                ++attempts;
                passed += attempt.at("passed").get<bool>() ? 1 : 0;
            }
            // The board prints both.
            if (task.at("attempts") != attempts || task.at("passed") != passed)
                says("entry.json", "says other numbers of attempts or passes of " +
                                       task.at("task").get<std::string>() + " than there are");
            if (attempts == 0 ||
                std::abs(points / attempts - task.at("points").get<double>()) > 1e-9)
                says("entry.json", "the mean of " + task.at("task").get<std::string>() +
                                       " is not that of its attempts");
            sum += task.at("points").get<double>();
        }
        const size_t tasks = entry_.at("tasks").size();
        std::set<std::string> names;
        for (const Json& attempt : entry_.at("attempts"))
            names.insert(attempt.at("task").get<std::string>());
        if (tasks == 0 || names.size() != tasks ||
            std::abs(sum / static_cast<double>(tasks) - entry_.at("score").get<double>()) > 1e-9 ||
            entry_.at("complete").get<bool>() != (tasks == protocol_.tasks.size()))
            says("entry.json", "its score is not the mean over its tasks");
    }

    const Protocol& protocol_;
    const Json& entry_;
    fs::path folder_;
    bool replay_;
    const EntryProgress& progress_;
    EntryCheck check_;
};

}  // namespace

fs::path entry_file(const fs::path& entry) {
    std::error_code none;
    return fs::is_directory(entry, none) ? entry / "entry.json" : entry;
}

Json read_entry(const fs::path& entry_json) {
    Json entry = Json::parse(read_text(entry_json), nullptr, false);
    if (!entry.is_object() || !entry.contains("benchmark") || !entry.contains("attempts"))
        throw BatchError(BatchError::Kind::kBadInput,
                         entry_json.string() +
                             ": is no entry to a benchmark; expected an "
                             "entry.json of `placodectl bench tasks`");
    return entry;
}

EntryCheck check_entry(const Protocol& protocol, const fs::path& entry_json, bool replay,
                       const EntryProgress& progress) {
    const Json entry = read_entry(entry_json);
    try {
        return Check(protocol, entry, entry_json.parent_path(), replay, progress).run();
    } catch (const Json::exception& error) {
        throw BatchError(BatchError::Kind::kBadInput,
                         entry_json.string() + ": is damaged: " + error.what());
    }
}

}  // namespace placode::batches
