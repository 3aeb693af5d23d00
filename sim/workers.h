// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A fixed team of threads for one solver. Work is split by index, never stolen, so that the same
// input gives the same bits at any number of threads. Waiting spins briefly and then sleeps: on
// an oversubscribed machine a spinning barrier loses whole time slices.

#include <memory>

namespace placode::sim {

class Workers {
 public:
    /// `threads` >= 1 counts the calling thread; 1 starts no thread at all.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] int threads() const noexcept;

    /// Runs `body(context, part)` for part = 0 .. threads()-1, part 0 on the caller; returns when
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
