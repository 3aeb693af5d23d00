// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread_tear.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/suture/needle_motion.h"
#include "sim/suture/thread_step.h"

namespace placode::sim {
namespace {

// A thread is stiff: at 0.3 N a 4/0 spreads its load over sqrt(EI / T) = 0.4 mm at either side.
constexpr double kSpreadM = 0.8e-3;
constexpr double kShortestM = 0.3e-3;  // of a channel with one passage left: the spacing

void give_way(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
              const ThreadLine& line, int c, int mouth, double load_n, SutureReport& report) {
    ThreadState& thread = state.thread;
    const ThreadChannel channel = thread.channels[as_index(c)];
    const int i = mouth == 0 ? channel.first : channel.first + channel.count - 1;
    const Passage gone = thread.passages[as_index(i)];
    const double stored = thread_energy(thread), made = thread.work.made;
    // The way across the corner is shorter by what the thread has cut off.
    const int node = line.node_of(i), piece = mouth == 0 ? c : c + 1;
    const bool ends = node == 0 || node + 1 == line.nodes();
    if (channel.count > 1 && !ends) {
        ThreadPiece& p = thread.pieces[as_index(piece)];
        p.stretch_m -= line.segment(node - 1).path_m + line.segment(node).path_m -
                       thread_path_m(line.node(node - 1).p, line.node(node + 1).p);
        p.pull_n = p.stretch_m > 0 ? p.stretch_m / p.give_m_n : 0;
    }
    drop_passage(suture, state, tissue, i);
    thread.work.torn += stored - thread_energy(thread);
    thread.work.made = made;
    tell(report, {channel.count == 1 ? SutureEventKind::kToreOut : SutureEventKind::kCutThrough,
                  tissue.body.mesh().tissue[as_index(gone.at.tet)], load_n,
                  rest_place_of(tissue, gone.at), gone.channel, gone.at.tet, 0});
}

}  // namespace

double mouth_load_n_m(const SuturedTissue& tissue, const ThreadState& thread,
                      const ThreadLine& line, int c, int mouth) noexcept {
    const ThreadChannel& channel = thread.channels[as_index(c)];
    const int step = mouth == 0 ? 1 : -1;
    int i = channel.first + (mouth == 0 ? 0 : channel.count - 1);
    const auto at_rest = [&](int passage) {
        return rest_place_of(tissue, thread.passages[as_index(passage)].at);
    };
    const Vec3 mouth_m = line.node(line.node_of(i)).p;
    Vec3 force = line.force_on(line.node_of(i)), last = at_rest(i);
    double length = 0;
    for (int k = 1; k < channel.count && length < kSpreadM; ++k) {
        i += step;
        const Vec3 next = at_rest(i);
        length += (next - last).norm();
        last = next;
        force += line.force_on(line.node_of(i));
    }
    // What goes along the channel is friction's.
    const Vec3 offset = line.node(line.node_of(i)).p - mouth_m;
    if (offset.squaredNorm() > 0) force -= offset * (offset.dot(force) / offset.squaredNorm());
    return force.norm() / std::max(length, kShortestM);
}

void tear_channels(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   const ThreadLine& line, SutureReport& report) noexcept {
    if (!line.active()) return;
    ThreadState& thread = state.thread;
    for (int c = thread.channel_count - 1; c >= 0; --c) {
        const ThreadChannel channel = thread.channels[as_index(c)];
        const auto strength = [&](int i) {
            const int32_t tet = thread.passages[as_index(i)].at.tet;
            return suture.strength(tissue.body.mesh().tissue[as_index(tet)]).tear_n_m;
        };
        const double at_entry = mouth_load_n_m(tissue, thread, line, c, 0);
        const double at_exit = mouth_load_n_m(tissue, thread, line, c, 1);
        const bool entry = at_entry > strength(channel.first);
        const bool exit = at_exit > strength(channel.first + channel.count - 1);
        if (exit && channel.open == 0) give_way(suture, state, tissue, line, c, 1, at_exit, report);
        if (entry && (channel.count > 1 || !exit || channel.open != 0))
            give_way(suture, state, tissue, line, c, 0, at_entry, report);
    }
}

}  // namespace placode::sim
