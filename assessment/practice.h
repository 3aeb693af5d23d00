// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Watches the steps of a practice task while it is done, from the same samples that the recording
// keeps, and writes what it saw as events: the metrics of practice come from these.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "assessment/tissue_metrics.h"
#include "sim/core/practice.h"
#include "sim/step/recording.h"

namespace placode::assessment {

/// What was done with a suture needle so far.
struct NeedleSight {
    int taken = 0, entered = 0, left = 0, through = 0;
    bool in_tissue = false;  ///< Some of it; it may have left the first wall of a slit already.
    double held_share = 0;   ///< Where the jaws took it last, along its arc from the point.
    sim::Vec3 entry_m = sim::Vec3::Zero(), exit_m = sim::Vec3::Zero();  ///< The last, at rest.
    /// It went into a wall of a slit or the underside of freed skin, or came out there: half of a
    /// bite.
    bool entry_in_slit = false, exit_in_slit = false;
    /// Two drivers: it goes from hand to hand, and every take is one of a certain hand.
    bool handled = false;
    std::array<bool, sim::kMaxTools> held{};     ///< By which instrument.
    std::array<double, sim::kMaxTools> share{};  ///< Where these hold it, as `held_share`.
    /// Its point and its middle, in W [m], and the lowest place of its wire over the field's plane.
    sim::Vec3 point_m = sim::Vec3::Zero(), middle_m = sim::Vec3::Zero();
    double lowest_m = 0;
    [[nodiscard]] bool free() const noexcept {
        return std::find(held.begin(), held.end(), true) == held.end();
    }
    std::array<sim::Vec3, 2> mark_m{sim::Vec3::Zero(),
                                    sim::Vec3::Zero()};  ///< Of the step, likewise.
};

/// How a patch lies (curriculum/patch_watch.h).
struct PatchSight {
    std::array<bool, sim::kMaxTools> held{};  ///< By which instrument.
    double overlapped = 0;  ///< Share of the placode's edge that it overlaps as far as it shall.
    double folded = 1;      ///< Share of it that lies in folds.
    [[nodiscard]] bool free() const noexcept {
        return std::find(held.begin(), held.end(), true) == held.end();
    }
};

/// Fluid and debris over the lesion.
struct WashSight {
    double debris = 0, stuck = 0, loose = 0;  ///< At the start; now stuck, and afloat.
    double standing_m3 = 0;                   ///< Fluid.
};

/// So little fluid may stand in a field that counts as dry [m3]: planning value.
inline constexpr double kDryM3 = 2.5e-8;

/// How far skin is undermined.
struct UndermineSight {
    /// Share of the area to be freed that is free, on the side away from each tool's port.
    std::array<double, sim::kMaxTools> freed{};
};

/// So much of what is to be freed is enough; the rest parts when edges are drawn together. Planning
/// value.
inline constexpr double kEnoughUndermined = 0.75;

/// What is there to see in one sample.
struct PracticeSight {
    const sim::Sample& sample;
    std::span<const sim::Vec3> targets;  ///< Of the present step, where they lie now, in W [m].
    std::array<bool, sim::kMaxTools> holds{};  ///< Tissue; with two drivers, the needle.
    std::array<double, sim::kMaxTools> pull_n{};
    std::array<bool, sim::kMaxTools> engaged{};
    NeedleSight needle{};
    double slit_gap_m = -1;             ///< Between the step's marks; -1 where there is no slit.
    double thread_pull_n = 0;           ///< Of the thread on a needle that jaws hold.
    const PatchSight* patch = nullptr;  ///< nullptr where there is none.
    const WashSight* wash = nullptr;    ///< Likewise.
    const UndermineSight* undermine = nullptr;
};

/// The target of a step at rest [m], in the plane: where the step says, or on the clock of the
/// planned contour; `second` = the left hand's, or where the needle comes out.
[[nodiscard]] sim::Vec2 practice_target(const sim::PracticeStep& step,
                                        const sim::FieldGeometry& geometry, bool second);

/// A pass this near the line has followed it, whatever the task allows [m].
inline constexpr float kTracedWithinM = 0.001F;

/// One attempt's steps, in order. `see` neither allocates nor throws (physics thread).
class PracticeTracker {
 public:
    /// @pre steps.size() <= kMaxPracticeSteps.
    PracticeTracker(std::span<const sim::PracticeStep> steps, std::span<const sim::ToolSpec> tools,
                    const sim::FieldGeometry& geometry);

    /// The steps before `step` were given: only this one and those behind it are asked for.
    /// @pre nothing was seen yet.
    void begin_at(int step) noexcept;
    /// One sample later. Returns the events that it brought (valid until the next call).
    [[nodiscard]] std::span<const sim::Event> see(const PracticeSight& sight) noexcept;
    /// The end of the attempt: what was going on is written down.
    [[nodiscard]] std::span<const sim::Event> end(double time_s) noexcept;

    [[nodiscard]] int index() const noexcept { return index_; }
    [[nodiscard]] int count() const noexcept { return static_cast<int>(steps_.size()); }
    [[nodiscard]] bool done() const noexcept { return index_ >= count(); }
    [[nodiscard]] const sim::PracticeStep& step() const noexcept;
    [[nodiscard]] double progress() const noexcept { return progress_; }
    /// Bites of a needle in all, and number of the present one, from 0.
    [[nodiscard]] int bites() const noexcept { return bites_; }
    [[nodiscard]] int bite() const noexcept;
    [[nodiscard]] const std::array<uint8_t, sim::kTraceBins>& traced() const noexcept {
        return traced_;
    }

 private:
    void emit(sim::EventKind kind, double value, double value2, int tool,
              const sim::Vec3& at) noexcept;
    void advance(double time_s) noexcept;
    void tell_marks(const NeedleSight& needle) noexcept;
    [[nodiscard]] int tool_of(sim::Hand hand, const PracticeSight& sight) const noexcept;

    // practice_steps.cpp
    [[nodiscard]] bool did(const PracticeSight& sight) noexcept;
    [[nodiscard]] bool did_grasp(const PracticeSight& sight, int tool) noexcept;
    [[nodiscard]] bool did_motion(const sim::ToolSample& tool) noexcept;
    [[nodiscard]] bool did_touch(const PracticeSight& sight, int tool) noexcept;
    [[nodiscard]] bool did_trace(const sim::ToolSample& tool, int index, double time_s) noexcept;
    [[nodiscard]] bool did_traction(const PracticeSight& sight) noexcept;
    [[nodiscard]] bool did_bite(const PracticeSight& sight, int tool) noexcept;
    void watch_handling(const PracticeSight& sight) noexcept;
    [[nodiscard]] bool did_handle(const PracticeSight& sight, int tool) noexcept;
    [[nodiscard]] bool did_take(const NeedleSight& needle, int tool) noexcept;
    [[nodiscard]] bool eased_off(double slit_gap_m, double pull_n) noexcept;
    [[nodiscard]] bool did_draw(double slit_gap_m, double pull_n) noexcept;
    [[nodiscard]] bool did_wash(const WashSight* wash) noexcept;
    [[nodiscard]] bool did_undermine(const UndermineSight* undermine, size_t tool) noexcept;
    [[nodiscard]] bool did_patch(const PatchSight* patch, size_t tool) noexcept;
    void weigh_offset(const sim::Vec2& at, double offset_m) noexcept;
    void close_bin(int tool, double time_s) noexcept;
    void close_traction(double time_s) noexcept;

    std::vector<sim::PracticeStep> steps_;
    std::vector<sim::ToolSpec> tools_;
    std::vector<ClosedContour> contour_;  // empty or one
    double dt_ = 0.01;
    int index_ = 0, first_ = 0;
    double progress_ = 0, began_s_ = 0, now_s_ = 0, amount_ = 0, held_s_ = 0, enough_s_ = 0,
           peak_n_ = 0;
    bool started_ = false, has_last_ = false, touched_ = false, open_ = false;
    int last_tool_ = -1;
    sim::ToolSample last_;
    std::array<uint8_t, sim::kTraceBins> traced_{};
    int bin_ = -1, bins_done_ = 0;
    double bin_weight_ = 0, bin_offset_ = 0;
    sim::Vec2 bin_from_ = sim::Vec2::Zero();  // where the pass was weighed last, and the distance
    double bin_from_offset_ = 0;              // from the line there
    NeedleSight needle_;                      // of the last sample
    bool carried_ = false;                    // a needle was in hands then
    int through_before_ = 0;       // times it had been drawn through when it came out of this bite
    int bites_ = 0, marked_ = -1;  // marked: the last step whose marks were told
    std::array<sim::Event, 8> events_{};
    size_t event_count_ = 0;
};

/// Of each target the touch that came first: whoever taps it again has aimed at it already.
[[nodiscard]] std::vector<const sim::Event*> first_touches(const sim::Recording& recording);

/// Metrics of practice from the events of a recording; nothing where it had no steps.
void add_practice_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
