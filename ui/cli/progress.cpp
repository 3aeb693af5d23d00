// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iostream>

namespace placode::cli {
namespace {

constexpr size_t kWidth = 78;

std::atomic<bool> cancelled{false};
void cancel(int) { cancelled = true; }

}  // namespace

void show_progress(const std::string& words) {
    if (isatty(STDERR_FILENO) == 0) return;
    std::cerr << '\r' << words << std::string(kWidth - std::min(kWidth, words.size()), ' ')
              << std::flush;
}

void clear_progress() {
    if (isatty(STDERR_FILENO) != 0) std::cerr << '\r' << std::string(kWidth + 1, ' ') << '\r';
}

CancelOn::CancelOn(std::initializer_list<int> signals) {
    for (const int signal : signals) before_.emplace_back(signal, std::signal(signal, cancel));
}

CancelOn::~CancelOn() {
    for (const auto& [signal, handler] : before_) std::signal(signal, handler);
}

bool CancelOn::requested() noexcept { return cancelled; }

}  // namespace placode::cli
