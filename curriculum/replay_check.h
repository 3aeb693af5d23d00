// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Proof that an attempt was made as it was recorded: its inputs are simulated again, and states,
// samples, events, field and end must be the recorded ones. State hashes alone do not show that a
// sample was changed or an event left out, and those are what is scored.

#include <memory>

#include "curriculum/task.h"
#include "sim/core/said.h"
#include "sim/step/recording.h"

namespace placode::curriculum {

struct ReplayVerdict {
    bool identical = false;
    sim::Said difference;  ///< What differs first and when; nothing is said where nothing does.
};

/// One recording, frame by frame: whoever calls step() may stop at any frame. Any one thread.
class ReplayCheck {
 public:
    /// `published` is the task as it was published: what the recording carries is not used.
    /// `recording` must outlive it. Throws MeshError or DefinitionError.
    ReplayCheck(const sim::Recording& recording, const Task& published, int threads);
    ~ReplayCheck();

    /// One frame, of an attempt from a stage first those that were given; false when nothing is
    /// left to simulate or something differs.
    bool step();
    [[nodiscard]] double share() const;  ///< 0..1 of all these frames.
    /// Complete when step() was false.
    [[nodiscard]] ReplayVerdict verdict();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::curriculum
