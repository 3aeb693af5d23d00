// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recording of an episode in memory, and the harm that stands in it so far.

#include <array>
#include <span>
#include <string_view>

#include "curriculum/attempt_frames.h"

namespace placode::environment {

/// One kind of harm, counted or summed up from the ledger.
struct HarmKind {
    std::string_view name;  ///< Ends in its unit where it has one.
    sim::EventKind event;
    double scale = 0;  ///< Of the event's value; 0 = events are counted.
};
/// The first ones may happen in any scene, the rest with needle and thread.
inline constexpr size_t kFieldHarms = 12;
inline constexpr std::array<HarmKind, 15> kHarms{{
    {"torn_mm3", sim::EventKind::kTorn, 1e9},
    {"placode_contacts", sim::EventKind::kPlacodeContact, 0},
    {"placode_energised", sim::EventKind::kPlacodeEnergised, 0},
    {"placode_burned_places", sim::EventKind::kPlacodeBurned, 0},
    {"placode_cut_mm2", sim::EventKind::kPlacodeCut, 1e6},
    {"over_force", sim::EventKind::kOverForce, 0},
    {"over_stretch", sim::EventKind::kOverStretch, 0},
    {"over_traction", sim::EventKind::kOverTraction, 0},
    {"crushed", sim::EventKind::kCrushed, 0},
    {"slipped", sim::EventKind::kSlipped, 0},
    {"buried_s", sim::EventKind::kBuried, 1},
    {"energy_in_air_s", sim::EventKind::kEnergyInAir, 1},
    {"needle_slips", sim::EventKind::kNeedleSlipped, 0},
    {"needle_turns", sim::EventKind::kNeedleTurned, 0},
    {"thread_cuts", sim::EventKind::kThreadCut, 0},
}};

class EpisodeBook final : public curriculum::AttemptBook {
 public:
    EpisodeBook() = default;
    /// @param keep_inputs 160 bytes a frame; without them nothing can be replayed.
    EpisodeBook(sim::RecordingHeader header, bool keep_inputs) : keep_inputs_(keep_inputs) {
        recording_.header = std::move(header);
    }

    void write(const sim::Input& input) noexcept override;
    void write(const sim::Sample& sample) noexcept override;
    void write(const sim::Event& event) noexcept override;
    void end(const sim::RecordingEnd& end) { recording_.end = end; }

    [[nodiscard]] const sim::Recording& recording() const noexcept { return recording_; }
    /// For what is added and taken away again (judge.h).
    [[nodiscard]] sim::Recording& recording() noexcept { return recording_; }
    [[nodiscard]] std::span<const double> harms() const noexcept { return harms_; }
    [[nodiscard]] bool keeps_inputs() const noexcept { return keep_inputs_; }
    /// An entry was lost because there was no memory for it.
    [[nodiscard]] bool lost() const noexcept { return lost_; }

 private:
    template <class T>
    void add(std::vector<T>& list, const T& value) noexcept;

    sim::Recording recording_;
    std::array<double, kHarms.size()> harms_{};
    bool keep_inputs_ = false, lost_ = false;
};

}  // namespace placode::environment
