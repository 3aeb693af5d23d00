// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several environments stepped at once by threads of their own, and begun again by themselves when
// an attempt is over. The result does not depend on the number of threads.

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "environment/environment.h"

namespace placode::environment {

/// What happens after the last step of an attempt; as Gymnasium names it.
enum class Autoreset : uint8_t {
    kNextStep,  ///< The next call resets it and ignores its action.
    kSameStep,  ///< The same call resets it; the last observation is handed out apart.
    kDisabled   ///< Somebody else does.
};

/// Where a step of a batch puts what it brings; sizes for N environments.
struct BatchOutput {
    std::span<double> observations;        ///< (N x observation)
    std::span<double> final_observations;  ///< (N x observation) kSameStep; else empty.
    std::span<double> rewards;             ///< (N)
    std::span<uint8_t> terminated, truncated, success;  ///< (N)
};

class Batch {
 public:
    /// All of one task and one set of options; they must outlive this. Throws std::system_error
    /// where the system gives no more threads.
    Batch(std::vector<Environment*> environments, Autoreset autoreset, int threads);
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// One seed for each. `observations` (N x observation). After its n-th attempt an environment
    /// goes on with its seed + n N.
    void reset(std::span<const uint64_t> seeds, std::span<double> observations);
    /// `actions` (N x tools x kActionSize). The first exception of any of them is thrown, after all
    /// are done.
    void step(std::span<const double> actions, int frames, const BatchOutput& out);
    /// Whose hands are done with the next step (N), as a person declares it.
    void finish(std::span<const uint8_t> which);
    /// What the last step brought to each, and the points after it; where a new attempt began in
    /// the same call, those of the one that ended.
    struct Last {
        StepOutcome outcome;
        double points = 0;
    };
    [[nodiscard]] std::span<const Last> last() const { return last_; }
    [[nodiscard]] size_t size() const { return environments_.size(); }

 private:
    void for_all(const std::function<void(size_t)>& work);
    void step_one(size_t i, std::span<const double> action, int frames, const BatchOutput& out);
    void begin_again(size_t i);
    void run();
    void end() noexcept;
    void work_on();

    std::vector<Environment*> environments_;
    Autoreset autoreset_;
    std::vector<uint64_t> seeds_;
    std::vector<uint8_t> over_, finish_;
    std::vector<Last> last_;
    // Threads: all but the caller's.
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const std::function<void(size_t)>* work_ = nullptr;
    size_t next_ = 0, left_ = 0;
    std::exception_ptr problem_;
    bool stop_ = false;
};

}  // namespace placode::environment
