// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Does this computer keep up? Simulated time against the clock, and pictures a second, over the
// whole attempt: who operated in slow motion, or on a slide show, shall know it, and so shall who
// reads the score. Physics thread; never allocates.

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "sim/core/event.h"

namespace placode::curriculum {

/// Below these an attempt counts for nothing.
inline constexpr double kLeastRealTime = 0.95;  ///< Simulated seconds a second.
inline constexpr double kLeastPicturesHz = 20;

class MachineSpeed {
 public:
    using Clock = std::chrono::steady_clock;

    /// Simulated time begins to run, at first or after a pause.
    void start(Clock::time_point now, uint64_t pictures) noexcept;
    /// A frame of `simulated_s` has ended; `pictures` were drawn in all.
    /// @param attempt_s for the event. @return a spell of slowness that ended just now.
    std::optional<sim::Event> frame(Clock::time_point now, double simulated_s, uint64_t pictures,
                                    double attempt_s) noexcept;
    /// What the recording ends with; nothing when less than a second was measured.
    [[nodiscard]] std::optional<sim::Event> closing(double attempt_s) const noexcept;

    /// The last whole seconds were slow.
    [[nodiscard]] bool slow() const noexcept { return slow_seconds_ >= kSpellSeconds; }
    [[nodiscard]] double real_time_now() const noexcept { return now_share_; }  ///< Last second.
    [[nodiscard]] double pictures_now_hz() const noexcept { return now_hz_; }   ///< Last second.
    /// What was measured so far would make the attempt count for nothing.
    [[nodiscard]] bool counts_for_nothing() const noexcept;
    [[nodiscard]] double real_time() const noexcept;  ///< Share of the whole attempt.
    [[nodiscard]] double pictures_hz()
        const noexcept;  ///< Reached in nine of ten seconds, see the code.

 private:
    void close_second(double wall_s, uint64_t pictures) noexcept;

    static constexpr int kSpellSeconds = 3;
    static constexpr uint32_t kHiccupSeconds = 5;
    static constexpr size_t kRates = 128;  // pictures a second, the last for all above

    Clock::time_point second_{};
    uint64_t second_pictures_ = 0;
    double second_simulated_s_ = 0;
    double wall_s_ = 0, simulated_s_ = 0;
    std::array<uint32_t, kRates> seconds_at_{};  // how many seconds had that many pictures
    uint32_t seconds_ = 0;
    int slow_seconds_ = 0;
    bool drawn_ = false;
    double spell_s_ = 0, worst_hz_ = 0, now_share_ = 1, now_hz_ = 0;
};

}  // namespace placode::curriculum
