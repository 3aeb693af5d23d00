// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A fixed team of threads for one solver. A run is a handful of jobs that touch nothing in common,
// so that the same input gives the same bits whoever does them. The caller takes jobs from the
// front, the others from the back, and the caller never waits for a thread that has not begun: on a
// busy machine, where a thread may be without a core for a whole time slice, it does the work
// alone. Waiting spins briefly and then sleeps. Whether the team pays at all is tried frame by
// frame (team_trial.h).

#include <cstdint>
#include <memory>

namespace placode::sim {

class Workers {
 public:
    enum class Team : uint8_t {
        kAdaptive,  ///< The caller works alone for a while after a stall, and where that is
                    ///< cheaper.
        kFixed,     ///< Always offers jobs to all threads; for tests and measurements.
    };

    /// `threads` >= 1 counts the calling thread; 1 starts no thread at all. Throws
    /// std::system_error where the system gives no more threads.
    explicit Workers(int threads, Team team = Team::kAdaptive);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// One frame: as long as it lives its cost is measured, for the choice between team and caller.
    class Frame {
     public:
        explicit Frame(Workers& workers) noexcept;
        ~Frame();
        Frame(const Frame&) = delete;
        Frame& operator=(const Frame&) = delete;

     private:
        Workers& workers_;
    };

    [[nodiscard]] int threads() const noexcept;
    /// How often a thread had lost its core in the middle of a job so far.
    [[nodiscard]] int64_t stalls() const noexcept;
    /// True while the caller works alone.
    [[nodiscard]] bool alone() const noexcept;

    /// Calls `body(context, job)` for job = 0 .. jobs-1, each once, on the caller and the team in
    /// any order; returns when all are done. `jobs` up to 65,535. Never allocates.
    using Body = void (*)(void* context, int job) noexcept;
    void run(int jobs, Body body, void* context) noexcept;

    /// The same for an object: calls `(object.*method)(job)`.
    template <auto kMethod, class Object>
    void run(int jobs, Object& object) noexcept {
        run(
            jobs,
            [](void* context, int job) noexcept { (static_cast<Object*>(context)->*kMethod)(job); },
            &object);
    }

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::sim
