// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator for bites: the needle's point over the first mark, round on the needle's own
// circle until it comes out, let go, taken behind the point, drawn through. The plane of the needle
// stands across the shaft, so that the driver is turned and carried round the circle's centre.
// Where another bite follows, tissue takes the place of a second hand: the needle is left with its
// end in it and taken again where it is held to bite, before all of it is drawn out. Where a slit
// is to be shut, the thread is drawn back along the shaft, slowly once it pulls.

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level. Chosen by trial on the suture pad.
struct SutureHabits {
    double speed_m_s = 4e-3;    ///< Of the point along its circle.
    double aim_error_m = 1e-4;  ///< Of the circle's centre, rms in each direction.
    double push = 0;            ///< Share of the way that goes straight ahead instead of round.
    int false_starts = 0;       ///< Of a bite: goes in, draws back, goes in elsewhere.
    double out_m = 2.6e-3;      ///< Of the point, before it lets go.
    double taut_m_s = 1.5e-3;   ///< Of the thread, once it pulls.
    double most_pull_n = 0.2;   ///< Harder it does not pull or push.
    double content_n = 0;       ///< Pull that a draw ends with; 0 = as much as the task wants.
    double held_share = 0.72;   ///< Of the arc, from the point: where it is held at the start.
    double tail_m = 2.5e-3;     ///< Left in the tissue, so that this holds the needle.
    bool edges_slide = false;   ///< Skin gives way: it aims anew until the point is in it.
};
[[nodiscard]] const SutureHabits& suture_habits(OperatorLevel level) noexcept;

class SutureOperator final : public ScriptedOperator {
 public:
    SutureOperator(OperatorLevel level, uint64_t seed, size_t tool, const sim::ToolSpec& spec,
                   const Vec3& home_m);
    SutureOperator(OperatorLevel level, const SutureHabits& habits, uint64_t seed, size_t tool,
                   const sim::ToolSpec& spec, const Vec3& home_m);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

    /// Which edge of a wound another hand shall hold now: that where the point goes in, and then
    /// that where it comes out.
    enum class Edge : uint8_t { kNone, kEntry, kExit };
    [[nodiscard]] Edge edge_wanted() const noexcept;
    /// Before `act`: the other hand does not hold it yet, and the point waits before it.
    void wait(bool waits) noexcept { waits_ = waits; }

 private:
    enum class Stage : uint8_t {
        kLook,
        kReach,
        kLower,
        kDrive,
        kDrawBack,
        kEase,
        kOpen,
        kBack,
        kSwing,
        kCome,
        kClose,
        kPull,
        kLeave,
        kDraw,
        kDone
    };
    /// The needle's plane as the shaft stands: `right` x `up` = along the shaft.
    struct Plane {
        Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ(), shaft = -Vec3::UnitY();
    };
    void stage(Stage next) noexcept;
    [[nodiscard]] Plane plane() const noexcept;
    void plan() noexcept;
    void look_along(const Plane& plane) noexcept;
    /// Driver so that the wire in its jaws lies at `angle` on the circle about `centre`.
    [[nodiscard]] Vec3 jaws_at(const Plane& plane, const Vec3& centre, double angle) const noexcept;
    /// The same, with the jaws turned across the wire.
    [[nodiscard]] Vec3 hold_at(const Plane& plane, const Vec3& centre, double angle) noexcept;
    void drive(const Plane& plane, double dt_s) noexcept;
    void take_again(const Plane& plane, double dt_s) noexcept;
    void close(const Plane& plane, double dt_s) noexcept;
    void pull(const Plane& plane, double dt_s) noexcept;
    void leave(double dt_s) noexcept;
    void draw(const Plane& plane, double dt_s) noexcept;
    void next_bite() noexcept;
    [[nodiscard]] bool sees_marks() const noexcept;
    void look(const Plane& plane) noexcept;
    void come_over_mark(const Plane& plane, double dt_s) noexcept;
    void draw_back(const Plane& plane, double dt_s) noexcept;
    void go_on(const Plane& plane, double dt_s) noexcept;
    void try_again() noexcept;
    [[nodiscard]] bool too_hard() const noexcept;
    [[nodiscard]] double left_inside_m() const noexcept;

    // suture_sliding.cpp
    void tilt(const Plane& plane, const Vec3& in_m) noexcept;
    [[nodiscard]] bool follow_edges(const Plane& plane, double dt_s) noexcept;
    void follow_entry(const Plane& plane, double dt_s) noexcept;
    void look_at_point(const Plane& plane, const Vec3& mark, double dt_s) noexcept;
    void aim_at_exit(const Plane& plane, double dt_s) noexcept;
    [[nodiscard]] bool between_walls() const noexcept;
    [[nodiscard]] bool slid_off() const noexcept;
    void loosen() noexcept;
    void ease(double dt_s) noexcept;
    void give_way(const Plane& plane, double dt_s) noexcept;
    [[nodiscard]] bool slackened(const Plane& plane, double dt_s) noexcept;

    SutureHabits habits_;
    OperatorProfile profile_;
    HandMotion hand_;
    size_t tool_;
    sim::ToolSpec spec_;
    Perception seen_{};
    Stage stage_ = Stage::kLook;
    Vec3 centre_ = Vec3::Zero(), across_ = Vec3::Zero(), goal_ = Vec3::Zero();
    double time_s_ = 0, stage_s_ = 0, radius_m_ = 0;
    double strained_s_ = 0;  ///< Since it pulls as hard as it does at most.
    double content_s_ = 0;   ///< Since it pulls as hard as it wants to.
    double entry_rad_ = 0;   ///< Where the circle meets the tissue, of the point.
    double point_rad_ = 0;   ///< Where the point is.
    double held_rad_ = 0;    ///< Held this far behind it.
    double grip_rad_ = 0, side_ = 1, out_rad_ = 0;
    double take_m_ = 0;  ///< Where it is taken next, from the point.
    Vec3 in_mark_m_ = Vec3::Zero(), out_mark_m_ = Vec3::Zero();
    bool waits_ = false;
    int starts_ = 0, bites_ = 0, misses_ = 0, retries_ = 0;
    int exits_ = 0, drawn_ = 0;  ///< Before this bite.
};

}  // namespace placode::haptics
