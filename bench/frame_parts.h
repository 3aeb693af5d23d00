// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a frame of 1 ms costs and where it goes (solve, contact, heat, cut, rest, recording), on a
// field, from hands off to cutting. Wall clock of every frame.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/step/step.h"
#include "sim/world/scene.h"

namespace placode::bench {

inline constexpr int kParts = 6;
inline constexpr const char* kPartNames[kParts] = {"solve", "contact", "heat",
                                                   "cut",   "rest",    "recording"};

/// What the hands do.
enum class Work { kAway, kPress, kDrag, kCut };

struct WorkCase {
    const char* name;
    Work work;
};
[[nodiscard]] std::span<const WorkCase> work_cases() noexcept;

struct FrameParts {
    std::string case_name;
    int threads = 0, substeps = 0, frames = 0;
    double contacts = 0;
    double awake = 0;                    ///< Share of the blocks of tissue that are solved, mean.
    std::vector<double> us[kParts + 1];  ///< By frame; the last is the whole frame.
};

/// The least value that `share` of them do not exceed; 0 without any.
[[nodiscard]] double percentile(std::vector<double> values, double share);
[[nodiscard]] double sum(const std::vector<double>& values);
/// Share of everything but the solve, of all frames together.
[[nodiscard]] double other_share(const FrameParts& costs);
/// The same against the time that a frame stands for: how much of real time it takes.
[[nodiscard]] double other_of_frame(const FrameParts& costs, double frame_s);

/// Adds a frame: `recording_us` of `frame_us` went into recording it.
void add_frame(FrameParts& costs, const sim::StepReport& report, const sim::State& state,
               double recording_us, double frame_us);
/// After the last frame: sums of contacts and awake blocks become means.
void close_frames(FrameParts& costs);

/// Which frames of a case are done, and from which on they count.
struct FrameRange {
    int first = 0, counted = 0, end = 0;
};
/// Sets what the hands ask in a frame.
using Hands = std::function<void(int frame, std::vector<sim::ToolInput>& inputs)>;
/// Recorded as in an attempt, into a file that is thrown away.
[[nodiscard]] FrameParts measure_hands(const sim::Scene& scene, sim::State& state,
                                       const std::string& name, const FrameRange& range,
                                       const Hands& hands);

[[nodiscard]] FrameParts measure_frames(const sim::Scene& scene, const WorkCase& what, int threads,
                                        int frames);

}  // namespace placode::bench
