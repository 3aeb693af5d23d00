// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// When the next picture is drawn, and how simple it has to be so that tissue and picture keep up:
// first the picture gives way, then the substeps of the physics, and the user is told. Main thread.

#include <chrono>
#include <string>

#include "curriculum/attempt_runner.h"

namespace placode::ui {

/// What the pace does to the picture; the view behind it, or a test.
class PictureQuality {
 public:
    virtual ~PictureQuality() = default;
    /// One step simpler; false when it is as simple as it gets.
    virtual bool simplify() = 0;
    /// One step back towards what it began with; false when it is there.
    virtual bool enrich() = 0;
    [[nodiscard]] virtual bool software() const = 0;  ///< The processor draws.
};

class PicturePace {
 public:
    using Clock = std::chrono::steady_clock;

    explicit PicturePace(PictureQuality& quality) : quality_(quality) {}

    [[nodiscard]] bool due(Clock::time_point now) const { return now >= next_; }
    /// A picture was drawn from `start` to `end`.
    void drawn(Clock::time_point start, Clock::time_point end);
    /// Looks at what the attempt reaches; at most twice a second it does something. What a
    /// picture costs is looked at before the attempt has begun too, so that it begins steadily.
    void watch(const curriculum::AttemptStatus& status, Clock::time_point now);

    /// Fewer substeps may be taken: the picture cannot give way any more, or never competes.
    [[nodiscard]] bool may_save_substeps() const { return simplest_ || !quality_.software(); }
    /// As slow as it was so far the attempt counts for nothing; known after some seconds of it.
    [[nodiscard]] static bool will_not_count(const curriculum::AttemptStatus& status);
    /// A sentence for the user in English, empty = none. Taken once.
    [[nodiscard]] std::string take_note();

 private:
    void simplify(Clock::time_point now);
    void enrich(Clock::time_point now);

    PictureQuality& quality_;
    Clock::time_point next_{}, looked_{};
    Clock::time_point cheap_since_{}, enriched_at_{};
    bool settled_ = false;  ///< What was given back was too much: it stays as it is.
    std::chrono::duration<double, std::milli> cost_{};  ///< Of a picture, running mean.
    int pictures_ = 0;                                  ///< In that mean.
    bool late_ = false, simplest_ = false, told_slow_ = false, told_simple_ = false;
    std::string note_;
};

}  // namespace placode::ui
