// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace placode::haptics {

namespace {

constexpr int kOrdinaryNice = -10;  // as the limits file grants

// Touches the stack once, so that no page fault comes in the loop.
void prefault_stack() noexcept {
    volatile char room[512 * 1024];
    for (size_t i = 0; i < sizeof room; i += 4096) room[i] = 0;
}

int64_t clock_ns(clockid_t clock) noexcept {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

int64_t monotonic_ns() noexcept { return clock_ns(CLOCK_MONOTONIC); }

int64_t asleep_ns() noexcept {
    // Both clocks in one moment: who was interrupted between them looks again.
    constexpr int64_t kMomentNs = 1'000'000;
    for (int tries = 3;; --tries) {
        const int64_t before = monotonic_ns(), since_boot = clock_ns(CLOCK_BOOTTIME),
                      after = monotonic_ns();
        if (after - before < kMomentNs || tries == 0) return since_boot - after;
    }
}

void sleep_until(int64_t t_ns) noexcept {
    const timespec until{static_cast<time_t>(t_ns / 1'000'000'000), t_ns % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
}

bool make_thread_real_time(int priority) noexcept {
    prctl(PR_SET_TIMERSLACK, 1);
    prefault_stack();
    const sched_param param{.sched_priority = priority};
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &param) == 0) return true;
    // The next best, where it is allowed: before other programs among ordinary threads.
    (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kOrdinaryNice);
    return false;
}

void make_thread_ordinary() noexcept {
    const sched_param param{.sched_priority = 0};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &param);
}

bool lock_memory() noexcept {
    rlimit limit{};
    const bool free = geteuid() == 0 ||
                      (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
    return free && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

void unlock_memory() noexcept { munlockall(); }

std::string missing_rights(bool real_time, bool locked) {
    if (real_time && locked) return {};
    std::string text = "The servo runs without ";
    if (!real_time) text += "real-time priority (SCHED_FIFO)";
    if (!real_time && !locked) text += " and ";
    if (!locked) text += "locked memory (mlockall)";
    text += ". To grant it, an administrator adds to /etc/security/limits.d/placode.conf: ";
    if (!real_time) text += "\"@placode - rtprio 85\"";
    if (!real_time && !locked) text += " and ";
    if (!locked) text += "\"@placode - memlock unlimited\"";
    return text +
           " (placode-sim --limits-file prints the file), puts the user into the group placode, "
           "and the user logs in again.";
}

std::string limits_file() {
    return "# /etc/security/limits.d/placode.conf: real time for the haptic loop of Placode.\n"
           "#   placode-sim --limits-file | sudo tee /etc/security/limits.d/placode.conf\n"
           "#   sudo groupadd -f placode && sudo usermod -aG placode USER   # then log in again\n"
           "@placode - rtprio 85\n"
           "@placode - memlock unlimited\n"
           "@placode - nice -10\n";
}

}  // namespace placode::haptics
