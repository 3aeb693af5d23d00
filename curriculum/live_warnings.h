// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The short warnings that a trainee sees in the picture while operating. Physics thread; allocates
// in the constructor only. Private to curriculum.

#include <array>
#include <optional>
#include <span>

#include "assessment/tissue_metrics.h"
#include "curriculum/buried_watch.h"
#include "sim/step/step.h"

namespace placode::curriculum {

class LiveWarnings {
 public:
    /// `scene` must outlive it.
    explicit LiveWarnings(const sim::Scene& scene);
    /// After a frame with these inputs; `sampled` = look at what is judged once a sample, too.
    void look(const sim::State& state, std::span<const sim::ToolInput> inputs,
              bool sampled) noexcept;
    /// What the last look has to add to the ledger; valid until the next one.
    [[nodiscard]] std::span<const sim::Event> events() const noexcept { return events_; }
    /// The end of the attempt: the last entries for the ledger.
    [[nodiscard]] std::span<const sim::Event> end(double time_s) noexcept {
        return buried_.end(time_s);
    }
    /// An event of the steps of practice: some are warned of. The newest wins.
    void hear(const sim::Event& event) noexcept;

    /// The ring is whole and the task ends with it: what is left to do.
    void ring_closed(double time_s) noexcept;

    [[nodiscard]] const std::array<char, 64>& phrase() const noexcept { return phrase_; }
    [[nodiscard]] double said_s() const noexcept { return said_s_; }  ///< Simulated time.

 private:
    void say(const char* phrase, double time_s) noexcept;
    void look_at_energy(const sim::State& state, std::span<const sim::ToolInput> inputs, size_t i,
                        bool sampled) noexcept;

    const sim::Scene* scene_;
    std::optional<assessment::ClosedContour> placode_;
    std::array<char, 64> phrase_{};
    double said_s_ = -1e9;
    BuriedWatch buried_;
    std::span<const sim::Event> events_;
};

}  // namespace placode::curriculum
