// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt as moving surfaces, for whoever looks at it without the simulation: the recording is
// simulated again, which proves it, and what can be seen is kept 30 times a second.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/step/recording.h"

namespace placode::reports {

inline constexpr int kReviewPicturesPerS = 30;
inline constexpr int kReviewPicturesOfPart = 120;  ///< 4 s: what is fetched to go to a moment.

struct ReviewTrack {
    std::string head;                ///< JSON: what is the same in all parts. docs/web.md.
    std::vector<std::string> parts;  ///< review_part.h, compressed.
    bool identical = false;          ///< The simulation gave every recorded state again.
    double until_s = 0;              ///< How far the track goes; where it differs, no further.
    [[nodiscard]] size_t bytes() const;
};

/// @param go_on is told how far it is, 0 to 1, about ten times a second of the attempt; false ends
/// it. Empty: nobody asks.
/// @return nothing when it was ended. Throws DefinitionError or MeshError where the recording's
/// task cannot be built any more. Any thread; one thread of physics.
[[nodiscard]] std::optional<ReviewTrack> make_review_track(
    const sim::Recording& recording, const std::function<bool(double)>& go_on = {});

}  // namespace placode::reports
