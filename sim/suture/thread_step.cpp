// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread_step.h"

#include <cmath>

#include "sim/core/as_index.h"
#include "sim/suture/needle_motion.h"
#include "sim/suture/thread_tear.h"

namespace placode::sim {
namespace {

/// A free end that has come as far as the next passage leaves the last one behind.
void draw_in_end(const Suture& suture, SutureState& state, const SuturedTissue& tissue, int end,
                 SutureReport& report) noexcept {
    ThreadState& thread = state.thread;
    while (thread.channel_count > 0) {
        const int piece = end == 0 ? 0 : thread.channel_count;
        if (!is_loose(suture.spec().thread, thread, piece)) return;
        if (thread.pieces[as_index(piece)].stretch_m <= 0) return;
        const int i = end == 0 ? 0 : thread.passage_count - 1;
        const Passage gone = thread.passages[as_index(i)];
        const int before = thread.channel_count;
        drop_passage(suture, state, tissue, i);
        if (thread.channel_count < before)
            tell_of(report, tissue, SutureEventKind::kThreadOut, gone);
    }
}

/// What the hands feel, and their work: half of the force before and half of that after, as for a
/// spring.
void feel_ends(ThreadState& thread, const ThreadLine& line) noexcept {
    for (int end = 0; end < 2; ++end) {
        ThreadEnd& hand = thread.ends[as_index(end)];
        const Vec3 before = hand.force_n;
        hand.force_n = Vec3::Zero();
        if (hand.mode == ThreadEndMode::kFree) continue;
        if (line.active()) hand.force_n = line.force_on(end == 0 ? 0 : line.nodes() - 1);
        if (hand.mode != ThreadEndMode::kHeld) continue;
        thread.work.hands -= 0.5 * (before + hand.force_n).dot(hand.place_m - hand.was_m);
        hand.was_m = hand.place_m;
    }
}

}  // namespace

void finish_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   ThreadLine& line, SutureReport& report) noexcept {
    ThreadState& thread = state.thread;
    report.thread_pull_n = 0;
    if (line.active()) {
        line.refresh(tissue, thread);
        if (thread.ends[1].mode == ThreadEndMode::kSwage) line.place_front(swage_m(suture, state));
        line.slide();
        if (!std::isfinite(line.energy_j())) {  // as the last substep left it
            report.not_finite = true;
            for (ThreadEnd& end : thread.ends) end.was_m = end.place_m;
            return;
        }
        thread.work.friction += line.energy_unslid_j() - line.energy_j();
        for (int i = 0; i < line.pieces(); ++i) {
            const LinePiece& p = line.piece(i);
            thread.pieces[as_index(i)] = {p.stretch_m(), p.give_m_n, p.pull_n()};
            report.thread_pull_n = std::max(report.thread_pull_n, p.pull_n());
        }
        for (int c = 0; c < thread.channel_count; ++c) {
            thread.channels[as_index(c)].slid_m += line.channel(c).slid_m;
            thread.channels[as_index(c)].wrap_rad = line.channel(c).wrap_rad;
        }
    }
    feel_ends(thread, line);
    if (!line.active()) return;
    tear_channels(suture, state, tissue, line, report);
    for (const int end : {0, 1}) draw_in_end(suture, state, tissue, end, report);
}

double thread_energy(const ThreadState& thread) noexcept {
    double sum = 0;
    for (int i = 0; i <= thread.channel_count && !thread.pieces.empty(); ++i) {
        const ThreadPiece& p = thread.pieces[as_index(i)];
        sum += 0.5 * p.pull_n * p.pull_n * p.give_m_n;
    }
    return sum;
}

}  // namespace placode::sim
