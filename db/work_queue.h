// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Shards of batches (batches/manifest.h) in the centre's PostgreSQL, for computers that are idle:
// each takes the next one that nobody is at, says now and then that it is still there, and puts
// the result beside it. A computer that goes silent loses its shard to another after a while.
// The tables stand in a schema of their own, `placode_work`: nothing of the store is in it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/store_url.h"

namespace placode::db {

class Connection;

struct QueuedBatch {
    std::string seal;      ///< Of the manifest: which batch it is.
    std::string build;     ///< Only the same program and instruction set may take its shards.
    std::string manifest;  ///< Its text.
    int shards = 0;
};

/// A shard that this computer is at. Another one that takes it later has another token.
struct WorkLease {
    std::string seal;
    int shard = 0;
    int64_t token = 0;
};

struct QueueState {
    std::string seal, build, queued_utc;
    int shards = 0, done = 0, held = 0;
    std::vector<std::string> failed;  ///< "shard 3: problem", of those that are not tried again.
};

/// One connection, one thread. Every method is one transaction and throws StoreError.
class WorkQueue {
 public:
    /// Tries of a shard before it is left: one that ends its computer's program would go round.
    static constexpr int kMostTries = 5;

    /// Throws kRefused for an embedded store, which has no server.
    explicit WorkQueue(const StoreUrl& url);
    ~WorkQueue();
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;

    /// Makes the tables where they are missing and gives `placode_station` its rights on them.
    void set_up();
    /// Adds a batch, or lets what has failed of it be tried again. `read` gives an input by its
    /// SHA-256; one that is there already is not asked for.
    void put(const QueuedBatch& batch, const std::vector<std::string>& inputs,
             const std::function<std::string(const std::string&)>& read);
    void remove(const std::string& seal);            ///< With its results. Throws kNotFound.
    [[nodiscard]] std::vector<QueueState> states();  ///< In the order in which they were put.

    /// The next shard for this build, nullopt where there is none to be had now.
    [[nodiscard]] std::optional<WorkLease> take(const std::string& build, const std::string& worker,
                                                int lease_s);
    [[nodiscard]] QueuedBatch batch(const std::string& seal);    ///< Throws kNotFound.
    [[nodiscard]] std::string input(const std::string& sha256);  ///< Throws kNotFound.
    /// Still at it. False: it took too long, and somebody else may have the shard.
    [[nodiscard]] bool renew(const WorkLease& lease, int lease_s);
    /// False where somebody else has put the result meanwhile: ours is the same and not needed.
    bool finish(const WorkLease& lease, const std::string& result);
    /// Another computer may take it at once; with a problem it counts as a try.
    void give_back(const WorkLease& lease, const std::string& problem);
    /// Of a shard; empty while it is not done.
    [[nodiscard]] std::string result(const std::string& seal, int shard);

 private:
    std::unique_ptr<Connection> connection_;
};

}  // namespace placode::db
