// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How thread comes into channels and out of them, and who holds its ends. Nothing here changes a
// pull that somebody feels: what the tissue gives at once where a channel begins comes in with it
// (ThreadWork::made), as with the needle's bonds.

#include <span>

#include "sim/suture/thread_line.h"

namespace placode::sim {

/// The swage has gone through a passage: the thread takes it over.
void take_passage(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  const Passage& passage, double h_s, SutureReport& report) noexcept;
/// The newest passage, if the needle is still in its channel; the needle comes back for it.
[[nodiscard]] const Passage* newest_open(const ThreadState& thread) noexcept;
/// Takes a passage away. @param i of the thread's passages.
void drop_passage(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  int i) noexcept;

/// An event at a passage, without a force.
void tell_of(SutureReport& report, const SuturedTissue& tissue, SutureEventKind kind,
             const Passage& passage) noexcept;

/// Start of a substep: passages whose tissue is gone.
void drop_lost_passages(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                        SutureReport& report) noexcept;

/// A hand takes the thread near an end (0 tail, 1 front), at `place`, so that `slack_m` more than
/// the straight way lies before it. What is beyond stays in reserve. Not for the step.
void hold_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue, int end,
                 const Vec3& place, double slack_m) noexcept;
/// Hand or needle lose it. Not for the step.
void let_go_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   int end) noexcept;
/// A thread that lies in tissue when a scene begins: one channel through these points, after the
/// ones that it has, drawn tight to it; its front is free. Not for the step.
/// @param front_m thread in front of the first channel, where the tail is free: the rest is there.
/// @throws SutureError where there is no room or no thread.
void lay_channel(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                 std::span<const TissuePoint> points, double h_s, double front_m);

}  // namespace placode::sim
