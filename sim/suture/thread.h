// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Thread that has followed the needle into its channels: what never changes (ThreadSpec) and what
// does (ThreadState). Between two channels, and between a channel and an end, lies one piece of
// thread: a spring that pulls and never pushes. It reaches into the channels at its ends; where the
// pull changes from one piece to the next along the wall is the channel's geometry. What passes
// from piece to piece is length, by the capstan law. How it works: docs/suture.md.

#include <array>
#include <vector>

#include "sim/core/fields.h"
#include "sim/suture/capstan.h"
#include "sim/suture/passage.h"

namespace placode::sim {

inline constexpr int kMostThreadChannels = 64;

/// Planning values: a monofilament 4/0.
struct ThreadSpec {
    double length_m = 0;    ///< 0: no thread. Else 5e-3 to 2.
    double stretch_n = 25;  ///< EA: 0.1 to 1000 [N].
    ThreadFriction friction;
    /// Its tail carries a loop or a knot that no channel lets in, as barbed threads have.
    bool stopper = false;
};
/// @throws SutureError
void check(const ThreadSpec& spec);

enum class ThreadEndMode : uint8_t {
    kFree,
    kHeld,   ///< By a hand, at `place_m`.
    kSwage,  ///< On the needle; the front end only.
};
struct ThreadEnd {
    ThreadEndMode mode = ThreadEndMode::kFree;
    Vec3 place_m = Vec3::Zero();  ///< kHeld: where it is at the end of the next substep; set it.
    Vec3 was_m = Vec3::Zero();    ///< And where at the end of the last one.
    double spare_m = 0;           ///< kHeld: thread beyond the hand.
    Vec3 force_n = Vec3::Zero();  ///< Of the thread on what holds it.
};
template <class Visit>
void fields(Of<ThreadEnd> auto& s, Visit&& visit) {
    auto& [mode, place_m, was_m, spare_m, force_n] = s;
    visit.state(mode, place_m, was_m, spare_m, force_n);
}

/// A run of passages.
struct ThreadChannel {
    int32_t first = 0, count = 0;
    int32_t channel = 0;  ///< Of its passages.
    uint8_t open = 0;     ///< The needle is still in it.
    double give_m_n = 0;  ///< How the tissue gives at once at either end [m/N]; for life.
    double wrap_rad = 0;  ///< Sum of its bends, in the last substep.
    double slid_m = 0;    ///< Of thread towards the exit, in all.
};
template <class Visit>
void fields(Of<ThreadChannel> auto& s, Visit&& visit) {
    auto& [first, count, channel, open, give_m_n, wrap_rad, slid_m] = s;
    visit.state(first, count, channel, open, give_m_n, wrap_rad, slid_m);
}

/// The thread between two channels, or between a channel and an end.
struct ThreadPiece {
    /// Its way less its length [m]: above zero it is stretched, below it hangs slack. Where its end
    /// is free: less what lies outside of the tissue.
    double stretch_m = 0;
    double give_m_n = 0;  ///< Of thread and walls [m/N].
    double pull_n = 0;
};
template <class Visit>
void fields(Of<ThreadPiece> auto& s, Visit&& visit) {
    auto& [stretch_m, give_m_n, pull_n] = s;
    visit.state(stretch_m, give_m_n, pull_n);
}

/// Where energy went [J].
struct ThreadWork {
    double hands = 0;     ///< Done by hands on the ends; not through the needle.
    double friction = 0;  ///< Dissipated in channels.
    double torn = 0;      ///< Dissipated where thread cut through tissue.
    double made = 0;      ///< Came in where channels began, less what left where thread was let go.
};
template <class Visit>
void fields(Of<ThreadWork> auto& s, Visit&& visit) {
    auto& [hands, friction, torn, made] = s;
    visit.state(hands, friction, torn, made);
}

/// Ordered from the tail to the front, as the needle drew it in. Sized by the constructor.
struct ThreadState {
    /// Its front on the needle.
    explicit ThreadState(const ThreadSpec& spec);

    std::vector<Passage> passages;        ///< First `passage_count`.
    std::vector<ThreadChannel> channels;  ///< First `channel_count`.
    std::vector<ThreadPiece> pieces;      ///< First `channel_count` + 1.
    int32_t passage_count = 0, channel_count = 0;
    std::array<ThreadEnd, 2> ends;  ///< Tail, front.
    ThreadWork work;
};
template <class Visit>
void fields(Of<ThreadState> auto& s, Visit&& visit) {
    auto& [passages, channels, pieces, passage_count, channel_count, ends, work] = s;
    visit.state(passages, channels, pieces, passage_count, channel_count, ends, work);
}

/// Nothing holds the thread at an end: neither hand nor needle.
[[nodiscard]] inline bool is_free(const ThreadState& thread, int end) noexcept {
    return thread.ends[static_cast<size_t>(end)].mode == ThreadEndMode::kFree;
}
/// A piece that nothing can pull at, as one of its ends is free.
[[nodiscard]] bool is_loose(const ThreadSpec& spec, const ThreadState& thread, int piece) noexcept;

/// Way from one passage to the next as the thread counts it: smooth where they meet.
[[nodiscard]] double thread_path_m(const Vec3& a, const Vec3& b) noexcept;

}  // namespace placode::sim
