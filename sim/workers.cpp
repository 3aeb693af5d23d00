// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace placode::sim {
namespace {

inline void relax() noexcept {
#if defined(__x86_64__) || defined(__i386__)
    _mm_pause();
#endif
}

using Clock = std::chrono::steady_clock;

// Two colours of a substep are some 10 us apart and the serial part of a frame takes some 100 us,
// while waking a sleeping thread costs 50 us and more on a virtual machine: a team that sleeps
// between colours is slower than one thread (measured: 1,376 against 3,507 substeps/s on the
// default field). So the wait spins for about 250 us (140-cycle pause of current x86 cores), offers
// its time slice to others after the first 50, and only then sleeps.
constexpr int kQuietSpins = 1024;
constexpr int kSpins = 4096;
constexpr int kYieldEvery = 128;

// A barrier that takes this long has waited for a thread without a core: work is dealt in parts of
// some 10 us, a wake-up costs 50 to 100 us, a time slice of others 1.5 ms and more.
constexpr auto kStall = std::chrono::microseconds(500);
constexpr auto kAloneAtFirst = std::chrono::milliseconds(10);
constexpr auto kAloneAtMost = std::chrono::milliseconds(640);

/// Waits until `value` is no longer `old`: spins, yields, then sleeps. Returns how long the wait
/// went on after the quiet spinning, 0 when it had ended by then.
Clock::duration wait_change(const std::atomic<uint32_t>& value, uint32_t old) noexcept {
    for (int i = 0; i < kQuietSpins; ++i) {
        if (value.load(std::memory_order_acquire) != old) return {};
        relax();
    }
    const auto since = Clock::now();
    for (int i = kQuietSpins; i < kSpins; ++i) {
        if (value.load(std::memory_order_acquire) != old) return Clock::now() - since;
        i % kYieldEvery == 0 ? std::this_thread::yield() : relax();
    }
    while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
    return Clock::now() - since;
}

}  // namespace

struct Workers::Impl {
    int threads = 1;
    bool adaptive = true;
    int parts = 1;  // of the current run; written before `round` is raised
    // Caller only: when the team may be tried again, and how long it stays away next time.
    Clock::time_point alone_until{};
    Clock::duration alone = kAloneAtFirst;
    int64_t seen_stalls = 0;
    Body body = nullptr;  // written before `round` is raised, read after
    void* context = nullptr;
    alignas(64) std::atomic<uint32_t> round{0};
    alignas(64) std::atomic<int> arrived{0};
    alignas(64) std::atomic<uint32_t> phase{0};
    std::atomic<int64_t> stalls{0};
    std::atomic<bool> stop{false};
    std::vector<std::thread> team;

    void barrier() noexcept {
        const uint32_t old = phase.load(std::memory_order_acquire);
        if (arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == threads) {
            arrived.store(0, std::memory_order_relaxed);
            phase.store(old + 1, std::memory_order_release);
            phase.notify_all();
        } else {
            if (wait_change(phase, old) > kStall) stalls.fetch_add(1, std::memory_order_relaxed);
        }
    }

    /// Before a run: all threads, or the caller alone?
    [[nodiscard]] bool alone_now() noexcept {
        return adaptive && alone_until != Clock::time_point{} && Clock::now() < alone_until;
    }

    /// After a run of the team: a stall sends it away, longer each time it comes back too early.
    void look_back() noexcept {
        const int64_t now_stalls = stalls.load(std::memory_order_relaxed);
        if (!adaptive || now_stalls == seen_stalls) return;
        seen_stalls = now_stalls;
        const auto now = Clock::now();
        // It had worked well for as long as it had stayed away: a lone stall.
        alone = now - alone_until > 2 * alone ? Clock::duration(kAloneAtFirst)
                                              : std::min<Clock::duration>(2 * alone, kAloneAtMost);
        alone_until = now + alone;
    }

    void loop(int part) noexcept {
        for (uint32_t done = 0;;) {
            wait_change(round, done);
            ++done;
            if (stop.load(std::memory_order_acquire)) return;
            body(context, part);
            barrier();
        }
    }
};

Workers::Workers(int threads, Team team) : impl_(std::make_unique<Impl>()) {
    impl_->threads = std::max(1, threads);
    impl_->adaptive = team == Team::kAdaptive;
    for (int part = 1; part < impl_->threads; ++part) {
        impl_->team.emplace_back([impl = impl_.get(), part] { impl->loop(part); });
    }
}

Workers::~Workers() {
    impl_->stop.store(true, std::memory_order_release);
    impl_->round.fetch_add(1, std::memory_order_release);
    impl_->round.notify_all();
    for (auto& thread : impl_->team) thread.join();
}

int Workers::threads() const noexcept { return impl_->threads; }
int Workers::parts() const noexcept { return impl_->parts; }
int64_t Workers::stalls() const noexcept { return impl_->stalls.load(std::memory_order_relaxed); }

void Workers::run(Body body, void* context) noexcept {
    if (impl_->threads == 1 || impl_->alone_now()) {
        impl_->parts = 1;
        body(context, 0);
        return;
    }
    impl_->parts = impl_->threads;
    impl_->body = body;
    impl_->context = context;
    impl_->round.fetch_add(1, std::memory_order_release);
    impl_->round.notify_all();
    body(context, 0);
    impl_->barrier();
    impl_->look_back();
}

void Workers::barrier() noexcept {
    if (impl_->parts > 1) impl_->barrier();
}

}  // namespace placode::sim
