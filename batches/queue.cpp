// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/queue.h"

#include <chrono>
#include <map>
#include <new>
#include <system_error>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "batches/shard.h"
#include "db/store_error.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;
using Clock = std::chrono::steady_clock;

/// A task that is a file, and not one of the program's own.
bool is_file(const Json& task) { return fs::path(task.at("ref").get<std::string>()).is_absolute(); }

/// Says that this computer is still there, three times in the time after which it would be
/// forgotten.
class Heartbeat {
 public:
    Heartbeat(db::WorkQueue& queue, const db::WorkLease& lease, int lease_s)
        : queue_(queue), lease_(lease), lease_s_(lease_s), said_(Clock::now()) {}
    /// False once somebody else may have the shard.
    bool beat() {
        const std::chrono::duration<double> since = Clock::now() - said_;
        if (!lost_ && since.count() > lease_s_ / 3.0) {
            said_ = Clock::now();
            lost_ = !queue_.renew(lease_, lease_s_);
        }
        return !lost_;
    }
    [[nodiscard]] bool lost() const { return lost_; }

 private:
    db::WorkQueue& queue_;
    const db::WorkLease& lease_;
    int lease_s_;
    Clock::time_point said_;
    bool lost_ = false;
};

/// The folder of a batch of which one shard is done here.
class Bench {
 public:
    Bench(db::WorkQueue& queue, const fs::path& folder, const std::string& seal)
        : queue_(queue), folder_(folder / seal.substr(0, 16)) {
        for (const char* part : {"shards", "inputs"}) fs::create_directories(folder_ / part);
        write_whole(folder_ / "manifest.json", queue.batch(seal).manifest);
        manifest_ = read_manifest(folder_);
        if (manifest_.seal != seal)
            throw BatchError(Kind::kBadInput, "the queue's manifest is of another batch");
        for (const Json& task : manifest_.tasks)
            if (is_file(task)) fetch(task.at("sha256"), ".json");
    }
    ~Bench() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    [[nodiscard]] const Manifest& manifest() const { return manifest_; }

    /// The text of the shard's file.
    std::string perform(int shard, const std::string& build, const GoOn& go_on,
                        const ShardProgress& progress) {
        if (shard < 0 || shard >= manifest_.shards())
            throw BatchError(Kind::kBadInput, "the queue names a shard that the batch has not");
        const auto [first, behind] = manifest_.range(shard);
        for (size_t i = first; i < behind; ++i)
            if (manifest_.items[i].contains("recording")) fetch(manifest_.items[i].at("sha256"));
        do_shard(folder_, manifest_, shard, build, go_on, progress);
        std::string text = read_text(shard_path(folder_, shard));
        fs::remove(shard_path(folder_, shard));
        for (size_t i = first; i < behind; ++i)
            if (manifest_.items[i].contains("recording"))
                fs::remove(own_input(folder_, manifest_.items[i].at("sha256")));
        return text;
    }

 private:
    void fetch(const std::string& sha, const std::string& ending = {}) {
        // A name from elsewhere: nothing but a checksum becomes a file here.
        if (sha.size() != 64 || sha.find_first_not_of("0123456789abcdef") != std::string::npos)
            throw BatchError(Kind::kBadInput, "the queue's manifest names no checksum: " + sha);
        const fs::path path = own_input(folder_, sha, ending);
        if (!fs::exists(path)) write_whole(path, queue_.input(sha));
    }

    db::WorkQueue& queue_;
    fs::path folder_;
    Manifest manifest_;
};

/// A full disk, no memory: the shard has nothing to do with it, and the next would go the same way.
bool of_this_computer(const std::exception& error) {
    if (const auto* refused = dynamic_cast<const BatchError*>(&error))
        return refused->kind() != Kind::kBadInput;
    if (const auto* file = dynamic_cast<const db::StoreError*>(&error)) return db::may_pass(*file);
    return dynamic_cast<const std::system_error*>(&error) != nullptr ||
           dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
}

}  // namespace

void queue_batch(db::WorkQueue& queue, const fs::path& folder, const Manifest& manifest,
                 const InputProgress& progress) {
    if (manifest.kind == "rollouts" && manifest.options.value("record", false))
        throw BatchError(Kind::kBadInput,
                         "rollouts with --record keep their recordings in the batch's folder, "
                         "which other computers do not have; plan them without it, or do them "
                         "here with `placodectl batch run`");
    std::map<std::string, fs::path> files;
    std::map<std::string, std::string> texts;
    std::vector<std::string> inputs;
    for (const Json& task : manifest.tasks)
        if (is_file(task)) {
            const auto sha = task.at("sha256").get<std::string>();
            texts[sha] = task_of_entry(task, folder).json;
            inputs.push_back(sha);
        }
    for (const Json& item : manifest.items)
        if (item.contains("recording")) {
            const auto sha = item.at("sha256").get<std::string>();
            if (files.emplace(sha, input_path(folder, item)).second) inputs.push_back(sha);
        }
    size_t done = 0;
    queue.put(
        {manifest.seal, manifest.build, read_text(folder / "manifest.json"), manifest.shards()},
        inputs, [&](const std::string& sha) {
            if (progress) progress(done++, inputs.size());
            const auto text = texts.find(sha);
            std::string bytes = text != texts.end() ? text->second : read_text(files.at(sha));
            if (sha256(bytes) != sha)
                throw BatchError(Kind::kBadInput,
                                 files.at(sha).string() +
                                     ": is not the file that the batch was planned with "
                                     "(its checksum differs); put that one back, or plan "
                                     "anew in another folder");
            return bytes;
        });
}

PullOutcome pull_shards(db::WorkQueue& queue, const PullOrder& order) {
    PullOutcome outcome;
    std::unique_ptr<Bench> bench;
    std::string at;
    while (!order.go_on || order.go_on()) {
        const auto lease = queue.take(order.build, order.worker, order.lease_s);
        if (!lease) return outcome;
        Heartbeat heart(queue, *lease, order.lease_s);
        try {
            if (at != lease->seal) {
                bench.reset();
                at.clear();
                bench = std::make_unique<Bench>(queue, order.folder, lease->seal);
                at = lease->seal;
            }
            const std::string text = bench->perform(
                lease->shard, order.build,
                [&] { return heart.beat() && (!order.go_on || order.go_on()); },
                [&](size_t done, size_t of) {
                    if (order.progress) order.progress(*lease, done, of);
                });
            ++(queue.finish(*lease, text) ? outcome.done : outcome.lost);
        } catch (const Stopped&) {
            if (heart.lost()) {
                ++outcome.lost;
                continue;
            }
            queue.give_back(*lease, {});
            break;
        } catch (const std::exception& error) {
            outcome.failed.push_back("shard " + std::to_string(lease->shard) + ": " + error.what());
            // Where the server is gone, giving back throws as well.
            if (of_this_computer(error)) {
                queue.give_back(*lease, {});
                break;
            }
            queue.give_back(*lease, error.what());
        }
    }
    outcome.stopped = true;
    return outcome;
}

Collected collect_results(db::WorkQueue& queue, const fs::path& folder, const Manifest& manifest) {
    Collected collected;
    for (int shard = 0; shard < manifest.shards(); ++shard) {
        const ShardState there = read_shard(folder, manifest, shard).state;
        if (there == ShardState::kDone) continue;
        const std::string text = queue.result(manifest.seal, shard);
        if (text.empty()) {
            ++collected.waiting;
            continue;
        }
        const fs::path path = shard_path(folder, shard);
        write_whole(path, text);
        const Shard read = read_shard(folder, manifest, shard);
        if (read.state == ShardState::kDone) {
            ++collected.fresh;
            continue;
        }
        fs::remove(path);
        collected.damaged.push_back(read.problem);
    }
    return collected;
}

}  // namespace placode::batches
