// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A fixed team of threads for one solver. Work is split by index, never stolen, and the same input
// gives the same bits at any number of threads. Waiting spins briefly and then sleeps. A team whose
// member has lost its core waits a whole time slice at every barrier: when that happens the caller
// works alone for a while and then tries the team again, so that a busy machine slows the solver
// down smoothly.

#include <cstdint>
#include <memory>

namespace placode::sim {

class Workers {
 public:
    enum class Team : uint8_t {
        kAdaptive,  ///< Works alone for a while after a stall.
        kFixed,     ///< Always all threads; for tests and measurements.
    };

    /// `threads` >= 1 counts the calling thread; 1 starts no thread at all.
    explicit Workers(int threads, Team team = Team::kAdaptive);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] int threads() const noexcept;
    /// Number of parts of the current run: threads(), or 1 while the caller works alone.
    [[nodiscard]] int parts() const noexcept;
    /// How often a member had lost its core so far.
    [[nodiscard]] int64_t stalls() const noexcept;

    /// Runs `body(context, part)` for part = 0 .. parts()-1, part 0 on the caller; returns when
    /// all are done. Never allocates.
    using Body = void (*)(void* context, int part) noexcept;
    void run(Body body, void* context) noexcept;

    /// Inside a body: waits until all parts are here.
    void barrier() noexcept;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::sim
