// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "sim/core/team_trial.h"

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

// Two runs of a substep are some 10 us apart and the serial part of a frame takes some 100 us,
// while waking a sleeping thread costs 50 us and more on a virtual machine: a team that sleeps
// between runs is slower than one thread (measured: 1,376 against 3,507 substeps/s on the default
// field). So the wait spins for about 250 us (140-cycle pause of current x86 cores), offers its
// time slice to others after the first 50, and only then sleeps.
constexpr int kQuietSpins = 1024;
constexpr int kSpins = 4096;
constexpr int kYieldEvery = 128;

// A job takes some 10 to 100 us. One that lets the caller wait this long belongs to a thread that
// has lost its core; a time slice of others is 1.5 ms and more.
constexpr auto kStall = std::chrono::microseconds(500);
constexpr auto kAloneAtFirst = std::chrono::milliseconds(5);
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

/// Which run, and the jobs [front, back) that nobody has taken yet, in one word: who changes it
/// from what he has seen owns a job of the run that he has seen.
struct Ticket {
    uint32_t run = 0;
    uint16_t front = 0, back = 0;

    [[nodiscard]] uint64_t word() const noexcept {
        return uint64_t{run} << 32 | uint64_t{front} << 16 | back;
    }
    static Ticket of(uint64_t word) noexcept {
        return {static_cast<uint32_t>(word >> 32), static_cast<uint16_t>(word >> 16),
                static_cast<uint16_t>(word)};
    }
};

}  // namespace

struct Workers::Impl {
    Impl() = default;
    /// Also where the constructor of Workers throws: the system gives no more threads.
    ~Impl() {
        stop.store(true, std::memory_order_release);
        run.fetch_add(1, std::memory_order_release);
        run.notify_all();
        for (auto& thread : team) thread.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    int threads = 1;
    bool adaptive = true;
    // Of the current run. Changed only while no job of an older run is open, but a thread that
    // comes late may look at them meanwhile (and then fails to take a job).
    std::atomic<Body> body{nullptr};
    std::atomic<void*> context{nullptr};
    alignas(64) std::atomic<uint64_t> ticket{0};
    alignas(64) std::atomic<uint32_t> run{0};   // what sleepers wait for
    alignas(64) std::atomic<uint32_t> open{0};  // jobs of the run that are not done
    std::atomic<bool> stop{false};
    std::vector<std::thread> team;
    // Caller only: until when the team stays away, and for how long the next time.
    Clock::time_point alone_until{};
    Clock::duration alone = kAloneAtFirst;
    std::atomic<int64_t> stalls{0};
    // Caller only: what frames cost either way.
    TeamTrial trial;
    Clock::time_point frame_start{};
    bool shared = false;   // the frame had jobs to share
    bool stalled = false;  // and a part of it was done without the team for want of cores

    /// Takes and does one job of run `number`. False when there is none left.
    bool work(uint32_t number, bool from_front) noexcept {
        uint64_t seen = ticket.load(std::memory_order_acquire);
        for (;;) {
            Ticket t = Ticket::of(seen);
            if (t.run != number || t.front >= t.back) return false;
            const Body f = body.load(std::memory_order_relaxed);
            void* with = context.load(std::memory_order_relaxed);
            const int job = from_front ? t.front++ : --t.back;
            if (ticket.compare_exchange_weak(seen, t.word(), std::memory_order_acq_rel,
                                             std::memory_order_acquire)) {
                f(with, job);
                if (open.fetch_sub(1, std::memory_order_acq_rel) == 1) open.notify_all();
                return true;
            }
        }
    }

    void loop() noexcept {
        for (uint32_t done = 0;;) {
            wait_change(run, done);
            done = run.load(std::memory_order_acquire);
            if (stop.load(std::memory_order_acquire)) return;
            while (work(done, false)) {
            }
        }
    }

    [[nodiscard]] bool stays_away() const noexcept {
        return adaptive && alone_until != Clock::time_point{} && Clock::now() < alone_until;
    }

    /// Whether the caller does a run by itself; notes what the frame's cost then means.
    bool does_alone() noexcept {
        if (!adaptive) return false;
        shared = true;
        const bool away = stays_away();
        stalled = stalled || away;
        return away || trial.alone();
    }

    /// Waits for the jobs that others have begun.
    void wait_for_open() noexcept {
        Clock::duration waited{};
        for (uint32_t left = open.load(std::memory_order_acquire); left != 0;
             left = open.load(std::memory_order_acquire)) {
            waited += wait_change(open, left);
        }
        if (waited < kStall) return;
        stalls.fetch_add(1, std::memory_order_relaxed);
        const auto now = Clock::now();
        // Longer each time it comes back too early.
        const bool long_ago = now - alone_until > 4 * alone;
        alone = long_ago ? Clock::duration(kAloneAtFirst)
                         : std::min<Clock::duration>(2 * alone, kAloneAtMost);
        alone_until = now + alone;
    }
};

Workers::Workers(int threads, Team team) : impl_(std::make_unique<Impl>()) {
    impl_->threads = std::max(1, threads);
    impl_->adaptive = team == Team::kAdaptive;
    for (int i = 1; i < impl_->threads; ++i) {
        impl_->team.emplace_back([impl = impl_.get()] { impl->loop(); });
    }
}

Workers::~Workers() = default;

int Workers::threads() const noexcept { return impl_->threads; }
int64_t Workers::stalls() const noexcept { return impl_->stalls.load(std::memory_order_relaxed); }
bool Workers::alone() const noexcept {
    return impl_->threads == 1 || impl_->stays_away() || (impl_->adaptive && impl_->trial.alone());
}

Workers::Frame::Frame(Workers& workers) noexcept : workers_(workers) {
    Impl& team = *workers_.impl_;
    if (team.threads == 1) return;
    team.shared = team.stalled = false;
    team.frame_start = Clock::now();
}

Workers::Frame::~Frame() {
    Impl& team = *workers_.impl_;
    if (team.shared && !team.stalled) team.trial.done(Clock::now() - team.frame_start);
}

void Workers::run(int jobs, Body body, void* context) noexcept {
    if (jobs <= 1 || impl_->threads == 1 || impl_->does_alone()) {
        for (int job = 0; job < jobs; ++job) body(context, job);
        return;
    }
    Impl& team = *impl_;
    team.body.store(body, std::memory_order_relaxed);
    team.context.store(context, std::memory_order_relaxed);
    team.open.store(static_cast<uint32_t>(jobs), std::memory_order_relaxed);
    const uint32_t number = team.run.load(std::memory_order_relaxed) + 1;
    team.ticket.store(Ticket{number, 0, static_cast<uint16_t>(jobs)}.word(),
                      std::memory_order_release);
    team.run.store(number, std::memory_order_release);
    team.run.notify_all();
    while (team.work(number, true)) {
    }
    team.wait_for_open();
}

}  // namespace placode::sim
