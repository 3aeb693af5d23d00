// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the shell, a terminal and the system end an attempt: by signals.

#include <atomic>
#include <csignal>

#include "ui/attempt/sessions.h"

namespace placode::ui {
namespace {

// All that a signal handler may touch.
std::atomic<bool> g_stop{false};
std::atomic<bool> g_finish{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

bool stop_requested() noexcept { return g_stop.load(std::memory_order_relaxed); }

bool finish_requested() noexcept { return g_finish.load(std::memory_order_relaxed); }

void catch_stop_signals() {
    const auto handler = [](int) { g_stop.store(true, std::memory_order_relaxed); };
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
    // A terminal or connection that closes; under nohup it is to go on.
    if (std::signal(SIGHUP, handler) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    std::signal(SIGUSR1, [](int) { g_finish.store(true, std::memory_order_relaxed); });
    std::signal(SIGPIPE, SIG_IGN);  // the shell may go away; the attempt is recorded all the same
}

}  // namespace placode::ui
