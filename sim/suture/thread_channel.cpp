// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread_channel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/core/as_index.h"
#include "sim/suture/needle_motion.h"

namespace placode::sim {
namespace {

// Of the tissue's answer at once, as the needle's bonds (puncture.cpp). A channel's mouth that gave
// less would hand the whole thread's stiffness to single vertices.
constexpr double kMouthRatio = 4, kStiffestN_m = 3000;
constexpr double kThinnedM = 0.7e-3;  // between passages that stay, at most

double energy_of(const ThreadPiece& p) noexcept { return 0.5 * p.pull_n * p.pull_n * p.give_m_n; }

/// Where a node next to a passage is; nothing where the thread ends.
std::optional<Vec3> place_at(const Suture& suture, const SutureState& state,
                             const SuturedTissue& tissue, int passage) noexcept {
    const ThreadState& thread = state.thread;
    if (passage >= 0 && passage < thread.passage_count)
        return place_of(tissue, thread.passages[as_index(passage)].at);
    const ThreadEnd& end = thread.ends[passage < 0 ? 0 : 1];
    if (end.mode == ThreadEndMode::kFree) return {};
    return end.mode == ThreadEndMode::kSwage ? swage_m(suture, state) : end.was_m;
}

double path_between(const std::optional<Vec3>& a, const std::optional<Vec3>& b) noexcept {
    return a && b ? thread_path_m(*a, *b) : 0;
}

int channel_of(const ThreadState& thread, int passage) noexcept {
    int c = 0;
    while (passage >= thread.channels[as_index(c)].first + thread.channels[as_index(c)].count) ++c;
    return c;
}

/// Two pieces become one: what they had of thread and of way.
void remove_channel(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                    int c) noexcept {
    ThreadState& thread = state.thread;
    const int passage = thread.channels[as_index(c)].first;
    const auto me = place_at(suture, state, tissue, passage);
    const auto before = place_at(suture, state, tissue, passage - 1);
    const auto behind = place_at(suture, state, tissue, passage + 1);
    ThreadPiece& in = thread.pieces[as_index(c)];
    const ThreadPiece out = thread.pieces[as_index(c + 1)];
    thread.work.made -= energy_of(in) + energy_of(out);
    in.stretch_m += out.stretch_m - path_between(before, me) - path_between(me, behind) +
                    path_between(before, behind);
    in.give_m_n += out.give_m_n - 2 * thread.channels[as_index(c)].give_m_n;
    const auto erase = [](auto& list, int at, int count) {
        std::copy(list.begin() + at + 1, list.begin() + count, list.begin() + at);
        list[as_index(count - 1)] = {};
    };
    erase(thread.channels, c, thread.channel_count);
    erase(thread.pieces, c + 1, thread.channel_count + 1);
    --thread.channel_count;
    const bool loose = is_loose(suture.spec().thread, thread, c);
    in.pull_n = loose || in.stretch_m <= 0 || in.give_m_n <= 0 ? 0 : in.stretch_m / in.give_m_n;
    thread.work.made += energy_of(in);
}

/// A new channel at the front, of which `path_m` lies from its first passage to the front.
void add_channel(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                 const Passage& passage, double path_m, double h_s) noexcept {
    ThreadState& thread = state.thread;
    const int n = thread.channel_count;
    ThreadPiece& in = thread.pieces[as_index(n)];
    ThreadPiece& out = thread.pieces[as_index(n + 1)];
    const double answer = answer_of(tissue, passage.at, h_s);
    const double give =
        1 / (answer > 0 ? std::min(kMouthRatio * answer, kStiffestN_m) : kStiffestN_m);
    thread.work.made -= energy_of(in);
    out = {0, give + path_m / suture.spec().thread.stretch_n, in.pull_n};
    if (in.pull_n > 0) {
        // Both go on pulling as they did.
        in.give_m_n += give;
        in.stretch_m = in.pull_n * in.give_m_n;
        out.stretch_m = out.pull_n * out.give_m_n;
    } else if (n == 0 && is_free(thread, 0)) {
        in.stretch_m += path_m;  // less lies outside
    }
    thread.work.made += energy_of(in) + energy_of(out);
    thread.channels[as_index(n)] = {thread.passage_count, 0, passage.channel, 1, give, 0, 0};
    ++thread.channel_count;
}

void append(ThreadState& thread, const Passage& passage) noexcept {
    thread.passages[as_index(thread.passage_count++)] = passage;
    ++thread.channels[as_index(thread.channel_count - 1)].count;
}

/// A channel that the needle has left needs fewer passages: each has four vertices that are solved
/// by themselves. On a needle's circle the way shrinks by 0.1 %.
void thin_newest(const Suture& suture, SutureState& state, const SuturedTissue& tissue) noexcept {
    ThreadState& thread = state.thread;
    const int first = thread.channels[as_index(thread.channel_count - 1)].first;
    const auto place = [&](int i) { return place_of(tissue, thread.passages[as_index(i)].at); };
    for (int i = first + 1; i + 1 < thread.passage_count;) {
        if (thread_path_m(place(i - 1), place(i + 1)) < kThinnedM)
            drop_passage(suture, state, tissue, i);
        else
            ++i;
    }
}

}  // namespace

void tell_of(SutureReport& report, const SuturedTissue& tissue, SutureEventKind kind,
             const Passage& passage) noexcept {
    tell(report, {kind, tissue.body.mesh().tissue[as_index(passage.at.tet)], 0,
                  rest_place_of(tissue, passage.at), passage.channel, passage.at.tet, 0});
}

const Passage* newest_open(const ThreadState& thread) noexcept {
    if (thread.channel_count == 0) return nullptr;
    const ThreadChannel& last = thread.channels[as_index(thread.channel_count - 1)];
    return last.open != 0 ? &thread.passages[as_index(thread.passage_count - 1)] : nullptr;
}

void take_passage(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  const Passage& passage, double h_s, SutureReport& report) noexcept {
    ThreadState& thread = state.thread;
    ThreadChannel* last =
        thread.channel_count > 0 ? &thread.channels[as_index(thread.channel_count - 1)] : nullptr;
    const bool fresh = last == nullptr || last->open == 0 || last->channel != passage.channel;
    if (thread.passage_count == kMostPassages ||
        (fresh && thread.channel_count == kMostThreadChannels)) {
        report.dropped = true;
        return;
    }
    if (fresh) {
        if (last != nullptr) last->open = 0;
        const double path = thread_path_m(place_of(tissue, passage.at), swage_m(suture, state));
        add_channel(suture, state, tissue, passage, path, h_s);
    }
    append(thread, passage);
    if (passage.kind != PassageKind::kExit) return;
    thread.channels[as_index(thread.channel_count - 1)].open = 0;
    thin_newest(suture, state, tissue);
    tell_of(report, tissue, SutureEventKind::kThreaded, passage);
}

void drop_passage(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  int i) noexcept {
    ThreadState& thread = state.thread;
    const int c = channel_of(thread, i);
    ThreadChannel& channel = thread.channels[as_index(c)];
    if (channel.count == 1) {
        remove_channel(suture, state, tissue, c);
    } else {
        // The thread of a free end that lay behind it is outside of the channel now.
        const int n = thread.channel_count;
        const auto me = place_at(suture, state, tissue, i);
        if (i == 0 && is_free(thread, 0))
            thread.pieces[0].stretch_m -= path_between(me, place_at(suture, state, tissue, 1));
        if (i == thread.passage_count - 1 && is_free(thread, 1))
            thread.pieces[as_index(n)].stretch_m -=
                path_between(place_at(suture, state, tissue, i - 1), me);
        --channel.count;
    }
    auto* const at = thread.passages.data() + i;
    std::copy(at + 1, thread.passages.data() + thread.passage_count, at);
    thread.passages[as_index(--thread.passage_count)] = {};
    for (int k = 0; k < thread.channel_count; ++k) {
        ThreadChannel& other = thread.channels[as_index(k)];
        if (other.first > i) --other.first;
    }
}

void drop_lost_passages(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                        SutureReport& report) noexcept {
    ThreadState& thread = state.thread;
    for (int i = thread.passage_count - 1; i >= 0; --i) {
        const Passage gone = thread.passages[as_index(i)];
        if (tissue.state.tet_alive[as_index(gone.at.tet)] != 0) continue;
        drop_passage(suture, state, tissue, i);
        tell_of(report, tissue, SutureEventKind::kLost, gone);
    }
}

void hold_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue, int end,
                 const Vec3& place, double slack_m) noexcept {
    ThreadState& thread = state.thread;
    let_go_thread(suture, state, tissue, end);
    ThreadPiece& piece = thread.pieces[as_index(end == 0 ? 0 : thread.channel_count)];
    ThreadEnd& hand = thread.ends[as_index(end)];
    const int next = end == 0 ? 0 : thread.passage_count - 1;
    const bool other = thread.passage_count > 0 || !is_free(thread, 1 - end);
    hand = {ThreadEndMode::kHeld, place, place, 0, Vec3::Zero()};
    if (!other) return;  // of the whole thread nothing else is held
    const double outside = -piece.stretch_m;
    const double path = path_between(place, place_at(suture, state, tissue, next));
    const double slack = std::clamp(slack_m, 0.0, std::max(0.0, outside - path));
    hand.spare_m = std::max(0.0, outside - path - slack);
    piece.stretch_m = -slack;
}

void let_go_thread(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   int end) noexcept {
    ThreadState& thread = state.thread;
    ThreadEnd& hand = thread.ends[as_index(end)];
    if (hand.mode == ThreadEndMode::kFree) return;
    ThreadPiece& piece = thread.pieces[as_index(end == 0 ? 0 : thread.channel_count)];
    const int me = end == 0 ? -1 : thread.passage_count, next = end == 0 ? 0 : me - 1;
    const bool other = thread.passage_count > 0 || !is_free(thread, 1 - end);
    thread.work.made -= energy_of(piece);
    piece.stretch_m -= hand.spare_m;
    if (other)
        piece.stretch_m -= path_between(place_at(suture, state, tissue, me),
                                        place_at(suture, state, tissue, next));
    piece.pull_n = 0;
    hand = {};
}

void lay_channel(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                 std::span<const TissuePoint> points, double h_s, double front_m) {
    ThreadState& thread = state.thread;
    if (suture.spec().thread.length_m == 0)
        throw SutureError("thread.length_m", "no thread can be laid where there is none");
    const int room = kMostPassages - thread.passage_count;
    if (points.empty() || static_cast<int>(points.size()) > room ||
        thread.channel_count == kMostThreadChannels)
        throw SutureError("channel", "no points, or no room for its passages");
    let_go_thread(suture, state, tissue, 1);
    const auto before = place_at(suture, state, tissue, thread.passage_count - 1);
    double path = path_between(before, place_of(tissue, points[0]));
    for (size_t i = 1; i < points.size(); ++i)
        path += thread_path_m(place_of(tissue, points[i - 1]), place_of(tissue, points[i]));
    ++state.channels;
    const int n = thread.channel_count;
    for (size_t i = 0; i < points.size(); ++i) {
        Passage passage;
        passage.at = points[i];
        passage.channel = state.channels;
        if (i == 0) passage.kind = PassageKind::kEntry;
        if (i + 1 == points.size()) passage.kind = PassageKind::kExit;
        if (i == 0) add_channel(suture, state, tissue, passage, path, h_s);
        append(thread, passage);
    }
    thread.channels[as_index(n)].open = 0;
    // As if the front had been drawn through without a pull.
    ThreadPiece& in = thread.pieces[as_index(n)];
    if (before) {
        front_m = std::max(0.0, -in.stretch_m - path);
        in.stretch_m = 0;
    } else {
        front_m = std::min(front_m, std::max(0.0, -in.stretch_m));
        in.stretch_m += front_m;
    }
    thread.pieces[as_index(n + 1)].stretch_m = -front_m;
}

}  // namespace placode::sim
