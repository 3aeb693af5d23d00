// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/phases.h"

#include <algorithm>

namespace placode::assessment {

namespace {

constexpr double kShortestPartS = 0.1;

/// The recording between two samples, as if it had been an attempt of its own.
sim::Recording slice(const sim::Recording& recording, size_t first, size_t last) {
    sim::Recording part;
    part.header = recording.header;
    part.samples.assign(recording.samples.begin() + static_cast<long>(first),
                        recording.samples.begin() + static_cast<long>(last));
    const double from = part.samples.front().time_s, to = part.samples.back().time_s;
    // An event belongs to the part in which it was raised; the ends of the attempt take in all.
    const double begin = first == 0 ? -1 : from;
    const double end = last == recording.samples.size() ? recording.end.duration_s + 1
                                                        : to + recording.header.sample_s;
    for (const sim::Event& event : recording.events)
        if (event.time_s >= begin && event.time_s < end) part.events.push_back(event);
    part.end = recording.end;
    part.end.duration_s = to;
    return part;
}

}  // namespace

std::vector<PhasePart> compute_phase_metrics(const sim::Recording& recording) {
    std::vector<PhasePart> parts;
    const auto& samples = recording.samples;
    for (size_t first = 0; first < samples.size();) {
        size_t last = first;
        while (last < samples.size() && samples[last].phase == samples[first].phase) ++last;
        const double from = samples[first].time_s, to = samples[last - 1].time_s;
        if (to - from >= kShortestPartS)
            parts.push_back(
                {samples[first].phase, from, to, compute_metrics(slice(recording, first, last))});
        first = last;
    }
    return parts;
}

}  // namespace placode::assessment
