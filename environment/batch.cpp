// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/batch.h"

#include <algorithm>
#include <string>
#include <utility>

namespace placode::environment {

Batch::Batch(std::vector<Environment*> environments, Autoreset autoreset, int threads)
    : environments_(std::move(environments)),
      autoreset_(autoreset),
      seeds_(environments_.size()),
      over_(environments_.size(), 0),
      finish_(environments_.size(), 0),
      last_(environments_.size()) {
    if (environments_.empty() || threads < 1)
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "a batch has at least one environment and one thread");
    for (const Environment* environment : environments_)
        if (environment->task().json != environments_[0]->task().json)
            throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                                   "all environments of a batch have the same task");
    const size_t extra = std::min(static_cast<size_t>(threads), environments_.size()) - 1;
    try {
        for (size_t i = 0; i < extra; ++i) threads_.emplace_back([this] { run(); });
    } catch (...) {  // the system gives no more: those begun must not outlive this
        end();
        throw;
    }
}

Batch::~Batch() { end(); }

void Batch::end() noexcept {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

/// Takes environments one by one until none is left. Each is worked on by one thread only, so who
/// takes which changes nothing.
void Batch::work_on() {
    std::unique_lock lock(mutex_);
    while (work_ != nullptr && next_ < environments_.size()) {
        const size_t i = next_++;
        const std::function<void(size_t)>& work = *work_;
        lock.unlock();
        std::exception_ptr problem;
        try {
            work(i);
        } catch (...) {
            problem = std::current_exception();
        }
        lock.lock();
        if (problem && !problem_) problem_ = problem;
        if (--left_ == 0) done_.notify_all();
    }
}

void Batch::run() {
    while (true) {
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] {
                return stop_ || (work_ != nullptr && next_ < environments_.size());
            });
            if (stop_) return;
        }
        work_on();
    }
}

void Batch::for_all(const std::function<void(size_t)>& work) {
    {
        const std::lock_guard lock(mutex_);
        work_ = &work;
        next_ = 0;
        left_ = environments_.size();
        problem_ = nullptr;
    }
    wake_.notify_all();
    work_on();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return left_ == 0; });
    work_ = nullptr;
    if (problem_) std::rethrow_exception(problem_);
}

void Batch::reset(std::span<const uint64_t> seeds, std::span<double> observations) {
    const size_t size = environments_[0]->observation_names().size();
    if (seeds.size() != environments_.size() || observations.size() != seeds.size() * size)
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "reset of a batch: expected a seed and an observation for each");
    for_all([&](size_t i) {
        seeds_[i] = seeds[i];
        over_[i] = finish_[i] = 0;
        last_[i] = {};
        environments_[i]->reset(seeds[i]);
        environments_[i]->observe(observations.subspan(i * size, size));
    });
}

void Batch::finish(std::span<const uint8_t> which) {
    if (which.size() != finish_.size())
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "finish of a batch: expected " + std::to_string(finish_.size()) +
                                   " flags, found " + std::to_string(which.size()));
    std::ranges::copy(which, finish_.begin());
}

void Batch::begin_again(size_t i) {
    seeds_[i] += environments_.size();
    environments_[i]->reset(seeds_[i]);
    over_[i] = 0;
}

void Batch::step_one(size_t i, std::span<const double> action, int frames, const BatchOutput& out) {
    Environment& environment = *environments_[i];
    const size_t size = environment.observation_names().size();
    const auto observation = out.observations.subspan(i * size, size);
    out.terminated[i] = out.truncated[i] = out.success[i] = 0;
    out.rewards[i] = 0;
    last_[i] = {};
    const bool finish = std::exchange(finish_[i], uint8_t{0}) != 0;
    if (over_[i] != 0 && autoreset_ == Autoreset::kNextStep) {
        begin_again(i);
        environment.observe(observation);
        return;
    }
    const StepOutcome outcome = environment.step(action, frames, finish);
    last_[i] = {outcome, environment.judged().score.points};
    out.rewards[i] = outcome.reward;
    out.truncated[i] = outcome.end == sim::EndReason::kTimeLimit ? 1 : 0;
    out.terminated[i] = environment.ended() && out.truncated[i] == 0 ? 1 : 0;
    out.success[i] = outcome.success ? 1 : 0;
    over_[i] = environment.ended() ? 1 : 0;
    if (over_[i] != 0 && autoreset_ == Autoreset::kSameStep) {
        environment.observe(out.final_observations.subspan(i * size, size));
        begin_again(i);
    }
    environment.observe(observation);
}

void Batch::step(std::span<const double> actions, int frames, const BatchOutput& out) {
    const size_t n = environments_.size();
    const size_t observation = environments_[0]->observation_names().size();
    const size_t action = environments_[0]->tools() * kActionSize;
    const bool final =
        autoreset_ != Autoreset::kSameStep || out.final_observations.size() == n * observation;
    if (actions.size() != n * action || out.observations.size() != n * observation || !final ||
        out.rewards.size() != n || out.terminated.size() != n || out.truncated.size() != n ||
        out.success.size() != n)
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "step of a batch: expected " + std::to_string(n * action) +
                                   " numbers as actions, found " + std::to_string(actions.size()));
    for_all([&](size_t i) { step_one(i, actions.subspan(i * action, action), frames, out); });
}

}  // namespace placode::environment
