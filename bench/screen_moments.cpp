// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/screen_moments.h"

#include <stdexcept>

namespace placode::bench {

std::vector<sim::Snapshot> screen_moments(curriculum::Replay& replay, double from_s, int count) {
    std::vector<sim::Snapshot> all;
    while (static_cast<int>(all.size()) < count && replay.step()) {
        const double next_s = from_s + kScreenS * static_cast<double>(all.size());
        if (replay.state().time_s < next_s) continue;
        sim::fill_snapshot(replay.scene(), replay.state(), all.emplace_back());
    }
    // Pictures of tissue that the recording never had are no pictures of the attempt.
    if (static_cast<int>(all.size()) < count && !replay.result().identical)
        throw std::runtime_error(replay.result().message);
    return all;
}

}  // namespace placode::bench
