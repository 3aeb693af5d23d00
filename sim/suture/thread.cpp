// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread.h"

#include <cmath>

namespace placode::sim {
namespace {

// Below it a way has no direction: two edges that a thread has drawn together.
constexpr double kSmoothM = 20e-6;

}  // namespace

void check(const ThreadSpec& spec) {
    if (spec.length_m != 0) need_within("thread.length_m", spec.length_m, 5e-3, 2);
    need_within("thread.stretch_n", spec.stretch_n, 0.1, 1000);
    check(spec.friction);
}

ThreadState::ThreadState(const ThreadSpec& spec) {
    if (spec.length_m == 0) return;
    passages.resize(kMostPassages);
    channels.resize(kMostThreadChannels);
    pieces.resize(kMostThreadChannels + 1);
    pieces[0].stretch_m = -spec.length_m;
    ends[1].mode = ThreadEndMode::kSwage;
}

bool is_loose(const ThreadSpec& spec, const ThreadState& thread, int piece) noexcept {
    const bool tail = piece == 0 && is_free(thread, 0);
    const bool front = piece == thread.channel_count && is_free(thread, 1);
    // A stopper holds by the first channel's mouth.
    return front || (tail && !(spec.stopper && thread.channel_count > 0));
}

double thread_path_m(const Vec3& a, const Vec3& b) noexcept {
    return std::sqrt((b - a).squaredNorm() + kSmoothM * kSmoothM);
}

}  // namespace placode::sim
