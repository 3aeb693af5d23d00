// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/machine_speed.h"

#include <algorithm>
#include <cmath>

namespace placode::curriculum {

void MachineSpeed::start(Clock::time_point now, uint64_t pictures) noexcept {
    second_ = now;
    second_pictures_ = pictures;
    second_simulated_s_ = 0;
}

void MachineSpeed::close_second(double wall_s, uint64_t pictures) noexcept {
    const double rate = static_cast<double>(pictures - second_pictures_) / wall_s;
    const auto bin = static_cast<size_t>(std::clamp(rate, 0.0, kRates - 1.0));
    ++seconds_at_[bin];
    drawn_ = drawn_ || pictures > 0;
    ++seconds_;
    wall_s_ += wall_s;
    simulated_s_ += second_simulated_s_;
    now_share_ = second_simulated_s_ / wall_s;
    now_hz_ = rate;
    const bool slow =
        second_simulated_s_ / wall_s < kLeastRealTime || std::floor(rate) < kLeastPicturesHz;
    if (slow) {
        worst_hz_ = slow_seconds_ == 0 ? rate : std::min(worst_hz_, rate);
        spell_s_ = slow_seconds_ == 0 ? wall_s : spell_s_ + wall_s;
    }
    slow_seconds_ = slow ? slow_seconds_ + 1 : 0;
}

std::optional<sim::Event> MachineSpeed::frame(Clock::time_point now, double simulated_s,
                                              uint64_t pictures, double attempt_s) noexcept {
    second_simulated_s_ += simulated_s;
    const double wall_s = std::chrono::duration<double>(now - second_).count();
    if (wall_s < 1) return std::nullopt;
    const bool before = slow();
    close_second(wall_s, pictures);
    start(now, pictures);
    if (!before || slow()) return std::nullopt;
    sim::Event spell;
    spell.kind = sim::EventKind::kSlowSpell;
    spell.time_s = attempt_s;
    spell.value = static_cast<float>(spell_s_);
    spell.value2 = static_cast<float>(worst_hz_);
    return spell;
}

double MachineSpeed::real_time() const noexcept { return wall_s_ > 0 ? simulated_s_ / wall_s_ : 1; }

double MachineSpeed::pictures_hz() const noexcept {
    // The slowest tenth of the seconds may be worse, and a start or a hiccup in any attempt; but
    // not more than half of a short one.
    uint32_t left = std::min(std::max(seconds_ / 10, kHiccupSeconds), seconds_ / 2);
    for (size_t rate = 0; rate < kRates; ++rate) {
        if (seconds_at_[rate] > left) return static_cast<double>(rate);
        left -= seconds_at_[rate];
    }
    return 0;
}

bool MachineSpeed::counts_for_nothing() const noexcept {
    return seconds_ > 0 && (real_time() < kLeastRealTime || pictures_hz() < kLeastPicturesHz);
}

std::optional<sim::Event> MachineSpeed::closing(double attempt_s) const noexcept {
    if (seconds_ == 0) return std::nullopt;
    sim::Event event;
    event.kind = sim::EventKind::kMachineSpeed;
    event.time_s = attempt_s;
    event.value = static_cast<float>(real_time());
    // Zero says that nothing was drawn at all; a slide show of less than one a second is none.
    event.value2 = static_cast<float>(drawn_ ? std::max(0.5, pictures_hz()) : 0.0);
    return event;
}

}  // namespace placode::curriculum
