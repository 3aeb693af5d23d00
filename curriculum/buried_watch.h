// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Notes tips that were pushed below the surface: such an instrument has no force, so that neither
// hand nor force bar says it. Physics thread; never allocates. Private to curriculum.

#include <array>
#include <span>

#include "sim/ledger/burial.h"

namespace placode::curriculum {

class BuriedWatch {
 public:
    /// Once a sample. Returns the events of what ended, valid until the next call.
    [[nodiscard]] std::span<const sim::Event> look(const sim::Scene& scene,
                                                   const sim::State& state) noexcept;
    /// The end of the attempt: what is still buried is written down.
    [[nodiscard]] std::span<const sim::Event> end(double time_s) noexcept;
    /// A tip has been below the surface for longer than a passing touch.
    [[nodiscard]] bool warns(double time_s) const noexcept;

 private:
    struct Spell {
        bool open = false;
        double since_s = 0;
        sim::Burial deepest;
    };
    void close(int tool, double time_s) noexcept;

    std::array<Spell, sim::kMaxTools> spells_;
    std::array<sim::Event, sim::kMaxTools> events_;
    size_t event_count_ = 0;
};

}  // namespace placode::curriculum
