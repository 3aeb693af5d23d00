// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A recording is the truth about an attempt: inputs bit for bit at the frame rate, samples at
// 100 Hz, events, and hashes by which a replay proves itself.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/core/event.h"
#include "sim/core/tool.h"
#include "sim/world/scene.h"

namespace placode::sim {

/// 2: a fourth tool, jaws. 3: a part that was given. 1 and 2 are still read.
inline constexpr int kRecordingFormat = 3;
/// Stages that a task may offer.
inline constexpr int kMostStages = 8;

/// Inputs of one frame. Trivially copyable, no padding that matters.
struct Input {
    int64_t frame = 0;
    int32_t substeps = 4;
    int32_t tool_count = 0;
    ToolInput tools[kMaxTools];
};

/// State of one tool in a sample.
struct ToolSample {
    std::array<float, 3> tip_m{};                  ///< Proxy tip in W.
    std::array<float, 4> orientation{1, 0, 0, 0};  ///< w x y z
    std::array<float, 3> force_n{};                ///< Tissue on tool.
    float jaw_rad = 0;
    float tip_gap_m = 1;
    float power_w = 0;  ///< Delivered into tissue.
    uint8_t pedals = 0, in_contact = 0, in_view = 1;
    Tissue touched = Tissue::kSkin;
};

/// 100 Hz.
struct Sample {
    double time_s = 0;
    ToolSample tools[kMaxTools];
    float placode_peak_c = 37, placode_peak_cem43_min = 0, placode_burned_m3 = 0;
    float cut_fraction = 0;
    Phase phase = Phase::kInspect;
    uint32_t step_flags = 0;
};

enum class EndReason : uint8_t { kRunning = 0, kFinished, kTimeLimit, kClosed, kInterrupted };

/// Known before the first frame.
struct RecordingHeader {
    int format = kRecordingFormat;
    std::string task_id;
    int task_version = 0;
    std::string task_json;  ///< The task with its scene resolved: enough to rebuild the scene.
    uint64_t seed = 0;
    std::string build;              ///< Program version and kernel target.
    std::string device;             ///< As on the command line, e.g. "script:expert".
    std::string started_utc;        ///< ISO 8601.
    bool demonstration = false;     ///< Simulated operator or demonstration data.
    std::string mode = "practice";  ///< practice, exam or study (curriculum/conduct.h).
    double frame_s = 1e-3;
    double sample_s = 0.01;
    std::vector<ToolSpec> tools;
    FieldGeometry geometry;
    /// What it began with: 0 = the field as the task has it, k = the task's stage k, counted from
    /// 1. What comes before a stage is given: a script did it.
    int stage = 0;
    int64_t given_frames = 0;  ///< Of Recording::given.
    uint64_t given_hash = 0;   ///< whole_hash() of the state that the attempt began with.
};

struct RecordingEnd {
    EndReason reason = EndReason::kRunning;
    double duration_s = 0;
    uint64_t final_hash = 0;
    int64_t dropped = 0;  ///< Entries lost because a ring was full; 0 in a sound recording.
};

struct Recording {
    RecordingHeader header;
    /// Inputs of the part that was given, from the task's own beginning; what they lead to, and
    /// begin_here(), is the state that the attempt began with. They are checked and simulated like
    /// any others: bytes of a state, which nothing could check, are never taken from a file.
    std::vector<Input> given;
    std::vector<Input> inputs;
    std::vector<Sample> samples;
    std::vector<Event> events;
    RecordingEnd end;
};

/// Where the recorder thread writes. `append` commits what it got; it may throw, and the attempt
/// then goes on unrecorded with a warning.
class RecordingSink {
 public:
    virtual ~RecordingSink() = default;
    virtual void begin(const RecordingHeader& header) = 0;
    /// Once, after begin(), where something was given.
    virtual void give(std::span<const Input> /*given*/) {}
    virtual void append(std::span<const Input> inputs, std::span<const Sample> samples,
                        std::span<const Event> events) = 0;
    virtual void finish(const RecordingEnd& end) = 0;
};

}  // namespace placode::sim
