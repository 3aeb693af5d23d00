// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The thread during one substep: a line of nodes (passages, and what holds its ends) with straight
// segments between them. Piece i has the energy
//   1/2 (way - rest)^2 / give          way > rest; nothing where it hangs slack
// where its way is a sum over segments. A segment inside a channel counts for both pieces at the
// channel's ends, by shares that say how much of the change of pull lies before it: the wall takes
// everywhere the same share of what it could. So tissue and thread pull at each other at every
// passage, and all forces of a channel add up to those of its ends.
//
// Length slides from piece to piece until no channel carries more than friction's bound, counted
// from where the thread was when the substep began: what has slid too far in the first pass comes
// back in the second.
//
// Source: return mapping of plasticity (Simo & Hughes 1998), with the capstan law as its bound.

#include <vector>

#include "sim/suture/suture.h"

namespace placode::sim {

struct LineNode {
    Vec3 p = Vec3::Zero();
    int32_t passage = -1;  ///< -1: an end.
};
/// From node i to node i + 1.
struct LineSegment {
    double path_m = 0;
    Vec3 along = Vec3::Zero();       ///< Derivative of the way by its far end.
    int32_t before = 0, behind = 0;  ///< Pieces; the same one outside of channels.
    double share = 0;                ///< Of the one behind.
};
struct LinePiece {
    double path_m = 0, rest_m = 0, give_m_n = 0;
    bool loose = false;
    [[nodiscard]] double stretch_m() const noexcept { return path_m - rest_m; }
    [[nodiscard]] double pull_n() const noexcept {
        return loose || path_m <= rest_m ? 0 : (path_m - rest_m) / give_m_n;
    }
    [[nodiscard]] double energy_j() const noexcept { return 0.5 * pull_n() * pull_n() * give_m_n; }
};
struct LineChannel {
    CapstanLaw out, back;
    double slid_m = 0;  ///< Slid in this substep, towards the exit.
    double wrap_rad = 0;
};

/// Lists of a substep. Nothing in it decides the future.
class ThreadLine {
 public:
    explicit ThreadLine(const ThreadSpec& spec);

    /// Start of a substep, when the tissue is where the last one left it: pulls are those of the
    /// last one. Then what holds the ends goes to where it is now.
    void begin(const Suture& suture, SutureState& state, const SuturedTissue& tissue) noexcept;
    /// Nodes to where the tissue is.
    void refresh(const SuturedTissue& tissue, const ThreadState& thread) noexcept;
    /// One node moves.
    void move_node(int node, const Vec3& by) noexcept;
    void place_front(const Vec3& p) noexcept;
    /// Length slides until friction holds.
    void slide() noexcept;

    /// Nothing pulls while it is false.
    [[nodiscard]] bool active() const noexcept { return node_count_ > 1; }
    [[nodiscard]] int node_of(int passage) const noexcept { return passage + tail_nodes_; }
    [[nodiscard]] double pull_n(const LineSegment& s) const noexcept {
        return (1 - s.share) * piece(s.before).pull_n() + s.share * piece(s.behind).pull_n();
    }
    /// Of the whole thread on a node [N].
    [[nodiscard]] Vec3 force_on(int node) const noexcept;
    /// How the front's pull grows with its way, sliding counted [N/m].
    [[nodiscard]] double front_stiffness() const noexcept;
    [[nodiscard]] double energy_j() const noexcept;
    /// What it would be if nothing had slid.
    [[nodiscard]] double energy_unslid_j() const noexcept;

    [[nodiscard]] int nodes() const noexcept { return node_count_; }
    [[nodiscard]] int pieces() const noexcept { return channel_count_ + 1; }
    [[nodiscard]] const LineNode& node(int i) const noexcept { return nodes_[as(i)]; }
    [[nodiscard]] const LineSegment& segment(int i) const noexcept { return segments_[as(i)]; }
    [[nodiscard]] const LinePiece& piece(int i) const noexcept { return pieces_[as(i)]; }
    [[nodiscard]] const LineChannel& channel(int i) const noexcept { return channels_[as(i)]; }

 private:
    [[nodiscard]] static size_t as(int i) noexcept { return static_cast<size_t>(i); }
    void lay_nodes(const SutureState& state, const Suture& suture,
                   const SuturedTissue& tissue) noexcept;
    void set_channel(const ThreadFriction& friction, const ThreadState& thread, int c) noexcept;
    void measure(int segment) noexcept;
    [[nodiscard]] Vec3 direction(int segment) const noexcept;
    [[nodiscard]] double slide_one(int c) noexcept;

    std::vector<LineNode> nodes_;
    std::vector<LineSegment> segments_;
    std::vector<LinePiece> pieces_;
    std::vector<LineChannel> channels_;
    std::vector<ChannelPiece> bends_;
    int node_count_ = 0, channel_count_ = 0, tail_nodes_ = 0, front_nodes_ = 0;
    double stretch_n_ = 1;
};

/// Where the needle's swage is [m].
[[nodiscard]] Vec3 swage_m(const Suture& suture, const SutureState& state) noexcept;

}  // namespace placode::sim
