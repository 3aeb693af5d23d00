// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Attempts that count where only recorded ones do: with a small recording that this computer
// signed, and the outcome of simulating it again.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "db/recording_file.h"
#include "db/store.h"

namespace placode::test {

/// Writes a recording of a few frames of what `result` says to `path`, and names it in `result`.
/// No two of them are alike. @param order checksum of what it was begun for; empty = nothing.
inline void record_to(const std::string& path, db::AttemptResult& result,
                      const std::string& order = {}) {
    static int count = 0;
    ++count;
    if (result.header.started_utc.empty()) result.header.started_utc = "2026-01-02T03:04:05.000Z";
    const auto sink = db::create_recording_file(path, order);
    sink->begin(result.header);
    std::vector<sim::Input> inputs(10);
    for (size_t i = 0; i < inputs.size(); ++i) {
        inputs[i].frame = static_cast<int64_t>(i);
        inputs[i].tools[0].position_m[0] = 1e-3F * static_cast<float>(count);
    }
    sink->append(inputs, {}, result.events);
    sink->finish(result.end);
    result.recording_file = path;
}

/// Says of an attempt that waits that simulating it again gave the same. One that is void does not
/// wait. @param store acts for a program.
inline void replay_as_identical(db::Store& store, int64_t id) {
    if (store.attempts().detail(id).record.replay == db::ReplayState::kWaiting)
        store.attempts().set_replay(id, db::ReplayState::kIdentical);
}

/// Saves `result` with a recording in `folder`, simulated again.
inline int64_t save_recorded(db::Store& store, int64_t user, db::AttemptResult result,
                             const std::string& folder) {
    static int count = 0;
    record_to(folder + "/recorded" + std::to_string(++count) + ".placode", result);
    const int64_t id = store.attempts().save(user, result);
    replay_as_identical(store, id);
    return id;
}

}  // namespace placode::test
