// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Real-time scheduling of a thread, locked memory, an absolute sleep. Everything goes on without
// the rights; what is missing and how to grant it is said in words.

#include <cstdint>
#include <string>

namespace placode::haptics {

inline constexpr int kServoPriority = 80;    ///< SCHED_FIFO
inline constexpr int kPhysicsPriority = 60;  ///< SCHED_FIFO

/// CLOCK_MONOTONIC [ns].
[[nodiscard]] int64_t monotonic_ns() noexcept;
/// How long this computer has slept since it was started [ns]: CLOCK_MONOTONIC stands still then.
/// Only differences mean something. As quick as a clock.
[[nodiscard]] int64_t asleep_ns() noexcept;
/// Sleeps to an absolute time, so that errors do not add up.
void sleep_until(int64_t t_ns) noexcept;

/// Puts the calling thread under SCHED_FIFO, with a fine timer slack and its stack in memory.
/// False: not permitted; the thread then is an ordinary one, at nice -10 where that is allowed.
[[nodiscard]] bool make_thread_real_time(int priority) noexcept;
/// Back to the ordinary scheduler.
void make_thread_ordinary() noexcept;

/// Locks the memory of the process, where no limit can turn a later allocation into a failure.
[[nodiscard]] bool lock_memory() noexcept;
void unlock_memory() noexcept;

/// What is missing and how an administrator grants it; empty when nothing is.
[[nodiscard]] std::string missing_rights(bool real_time, bool locked);
/// Text of /etc/security/limits.d/placode.conf.
[[nodiscard]] std::string limits_file();

}  // namespace placode::haptics
