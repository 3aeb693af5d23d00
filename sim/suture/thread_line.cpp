// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread_line.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

constexpr double kNoDirectionM = 40e-6;  // a shorter way between two channels has none
constexpr int kMostSlides = 64;          // sweeps over the channels; a sweep costs 50 ns a channel
constexpr double kEnoughM = 1e-10;       // less than a micronewton
// Of friction's bound, where there is no pull to say how it is spread: keeps shares defined.
constexpr double kLeastPullN = 1e-3;

/// Path of the thread across one channel, from where nothing has slid.
double slide_length(const LineChannel& channel, const LinePiece& in,
                    const LinePiece& out) noexcept {
    const auto stiffness = [](const LinePiece& p) {
        return p.loose || p.stretch_m() < 0 ? 0 : 1 / p.give_m_n;
    };
    const double path = slide_thread(channel.out, channel.back, in.pull_n(), out.pull_n(),
                                     stiffness(in), stiffness(out))
                            .slid_m;
    // What hung slack has been drawn tight on the way: it answers from there on, as a pull below
    // zero would that rises with the way.
    const LinePiece& taken_from = path > 0 ? in : out;
    if (path == 0 || taken_from.loose || std::abs(path) <= -taken_from.stretch_m()) return path;
    const auto pull = [](const LinePiece& p) { return p.loose ? 0 : p.stretch_m() / p.give_m_n; };
    const double in_n_m = in.loose ? 0 : 1 / in.give_m_n,
                 out_n_m = out.loose ? 0 : 1 / out.give_m_n;
    return slide_thread(channel.out, channel.back, pull(in), pull(out), in_n_m, out_n_m).slid_m;
}

}  // namespace

Vec3 swage_m(const Suture& suture, const SutureState& state) noexcept {
    return state.needle * Vec3(-suture.needle().radius_m(), 0, 0);
}

ThreadLine::ThreadLine(const ThreadSpec& spec) : stretch_n_(spec.stretch_n) {
    if (spec.length_m == 0) return;
    nodes_.resize(kMostPassages + 2);
    segments_.resize(kMostPassages + 1);
    bends_.resize(kMostPassages);
    pieces_.resize(kMostThreadChannels + 1);
    channels_.resize(kMostThreadChannels);
}

void ThreadLine::lay_nodes(const SutureState& state, const Suture& suture,
                           const SuturedTissue& tissue) noexcept {
    const ThreadState& thread = state.thread;
    node_count_ = channel_count_ = tail_nodes_ = front_nodes_ = 0;
    const auto placed = [&](int end) { return is_free(thread, end) ? 0 : 1; };
    const int count = thread.passage_count + placed(0) + placed(1);
    if (suture.spec().thread.length_m == 0 || count < 2 ||
        (thread.channel_count == 0 && placed(0) + placed(1) < 2))
        return;
    tail_nodes_ = placed(0);
    front_nodes_ = placed(1);
    node_count_ = count;
    channel_count_ = thread.channel_count;
    if (tail_nodes_ > 0) nodes_[0] = {thread.ends[0].was_m, -1};
    for (int i = 0; i < thread.passage_count; ++i)
        nodes_[as(node_of(i))] = {place_of(tissue, thread.passages[as(i)].at), i};
    if (front_nodes_ > 0) {
        const ThreadEnd& end = thread.ends[1];
        const bool needle = end.mode == ThreadEndMode::kSwage;
        nodes_[as(count - 1)] = {needle ? swage_m(suture, state) : end.was_m, -1};
    }
    for (int s = 0; s + 1 < count; ++s) segments_[as(s)] = {};
    for (int c = 0; c < channel_count_; ++c) {
        const ThreadChannel& channel = thread.channels[as(c)];
        const int first = node_of(channel.first), last = first + channel.count - 1;
        if (first > 0) segments_[as(first - 1)].before = segments_[as(first - 1)].behind = c;
        for (int s = first; s < last; ++s) {
            segments_[as(s)].before = c;
            segments_[as(s)].behind = c + 1;
        }
        if (last + 1 < count) segments_[as(last)].before = segments_[as(last)].behind = c + 1;
    }
}

void ThreadLine::begin(const Suture& suture, SutureState& state,
                       const SuturedTissue& tissue) noexcept {
    lay_nodes(state, suture, tissue);
    if (!active()) return;
    ThreadState& thread = state.thread;
    const ThreadSpec& spec = suture.spec().thread;
    for (int s = 0; s + 1 < node_count_; ++s) measure(s);
    for (int c = 0; c < channel_count_; ++c) set_channel(spec.friction, thread, c);
    for (int i = 0; i < pieces(); ++i) {
        pieces_[as(i)] = {};
        pieces_[as(i)].loose = is_loose(spec, thread, i);
    }
    for (int s = 0; s + 1 < node_count_; ++s) {
        LineSegment& segment = segments_[as(s)];
        pieces_[as(segment.before)].path_m += (1 - segment.share) * segment.path_m;
        pieces_[as(segment.behind)].path_m += segment.share * segment.path_m;
    }
    for (int i = 0; i < pieces(); ++i) {
        LinePiece& piece = pieces_[as(i)];
        ThreadPiece& kept = thread.pieces[as(i)];
        piece.rest_m = piece.path_m - kept.stretch_m;
        // Thread that has slid in brings its own give along.
        piece.give_m_n = std::max(0.0, piece.rest_m) / stretch_n_;
        if (i > 0) piece.give_m_n += thread.channels[as(i - 1)].give_m_n;
        if (i < channel_count_) piece.give_m_n += thread.channels[as(i)].give_m_n;
        thread.work.made += piece.energy_j() - 0.5 * kept.pull_n * kept.pull_n * kept.give_m_n;
    }
    for (int end = 0; end < 2; ++end) {
        const ThreadEnd& hand = thread.ends[as(end)];
        if (hand.mode != ThreadEndMode::kHeld) continue;
        move_node(end == 0 ? 0 : node_count_ - 1, hand.place_m - hand.was_m);
    }
}

Vec3 ThreadLine::direction(int segment) const noexcept {
    const LineSegment& s = segments_[as(segment)];
    const Vec3 offset = nodes_[as(segment + 1)].p - nodes_[as(segment)].p;
    const bool between = s.before == s.behind && segment > 0 && segment + 2 < node_count_;
    if (!between || s.path_m > kNoDirectionM) return offset;
    return nodes_[as(segment + 2)].p - nodes_[as(segment - 1)].p;
}

void ThreadLine::set_channel(const ThreadFriction& friction, const ThreadState& thread,
                             int c) noexcept {
    const ThreadChannel& channel = thread.channels[as(c)];
    const int first = node_of(channel.first);
    const double pull_n =
        kLeastPullN + 0.5 * (thread.pieces[as(c)].pull_n + thread.pieces[as(c + 1)].pull_n);
    const double drag_n_m = friction.drag_n_m + 0.5 * friction.barb_n_m;
    double sum = 0, wrap = 0;
    for (int i = 0; i < channel.count; ++i) {
        const int node = first + i;
        ChannelPiece& bend = bends_[as(i)];
        bend = {};
        if (node > 0 && node + 1 < node_count_)
            bend.bend_rad = angle_between(direction(node - 1), direction(node));
        wrap += bend.bend_rad;
        sum += friction.friction * bend.bend_rad * pull_n;
        if (i + 1 == channel.count) break;
        LineSegment& s = segments_[as(node)];
        bend.length_m = s.path_m;
        s.share = sum + 0.5 * drag_n_m * s.path_m;
        sum += drag_n_m * s.path_m;
    }
    for (int i = 0; i + 1 < channel.count; ++i) {
        LineSegment& s = segments_[as(first + i)];
        s.share = sum > 0 ? s.share / sum : 0.5;
    }
    const std::span<const ChannelPiece> bends(bends_.data(), as(channel.count));
    channels_[as(c)] = {capstan_law(friction, bends, true), capstan_law(friction, bends, false), 0,
                        wrap};
}

void ThreadLine::measure(int segment) noexcept {
    LineSegment& s = segments_[as(segment)];
    const Vec3 offset = nodes_[as(segment + 1)].p - nodes_[as(segment)].p;
    const double now = thread_path_m(nodes_[as(segment)].p, nodes_[as(segment + 1)].p);
    pieces_[as(s.before)].path_m += (1 - s.share) * (now - s.path_m);
    pieces_[as(s.behind)].path_m += s.share * (now - s.path_m);
    s.path_m = now;
    s.along = offset / now;
}

void ThreadLine::refresh(const SuturedTissue& tissue, const ThreadState& thread) noexcept {
    if (!active()) return;
    for (int i = 0; i < thread.passage_count; ++i)
        nodes_[as(node_of(i))].p = place_of(tissue, thread.passages[as(i)].at);
    for (int s = 0; s + 1 < node_count_; ++s) measure(s);
}

void ThreadLine::move_node(int node, const Vec3& by) noexcept {
    nodes_[as(node)].p += by;
    if (node > 0) measure(node - 1);
    if (node + 1 < node_count_) measure(node);
}

void ThreadLine::place_front(const Vec3& p) noexcept {
    if (!active() || front_nodes_ == 0) return;
    move_node(node_count_ - 1, p - nodes_[as(node_count_ - 1)].p);
}

double ThreadLine::slide_one(int c) noexcept {
    LineChannel& channel = channels_[as(c)];
    LinePiece &in = pieces_[as(c)], &out = pieces_[as(c + 1)];
    const double was = channel.slid_m;
    in.rest_m += was;
    out.rest_m -= was;
    channel.slid_m = slide_length(channel, in, out);
    in.rest_m -= channel.slid_m;
    out.rest_m += channel.slid_m;
    return std::abs(channel.slid_m - was);
}

void ThreadLine::slide() noexcept {
    if (!active()) return;
    for (int turn = 0; turn < kMostSlides; ++turn) {
        double most = 0;
        for (int i = 0; i < channel_count_; ++i)
            most = std::max(most, slide_one(turn % 2 == 0 ? channel_count_ - 1 - i : i));
        if (!(most > kEnoughM)) break;
    }
}

Vec3 ThreadLine::force_on(int node) const noexcept {
    Vec3 force = Vec3::Zero();
    if (node > 0) force -= pull_n(segment(node - 1)) * segment(node - 1).along;
    if (node + 1 < node_count_) force += pull_n(segment(node)) * segment(node).along;
    return force;
}

double ThreadLine::front_stiffness() const noexcept {
    const auto taut = [&](int i) { return piece(i).pull_n() > 0; };
    double n_m = taut(0) ? 1 / piece(0).give_m_n : 0;
    for (int c = 0; c < channel_count_; ++c) {
        if (!taut(c + 1)) {
            n_m = 0;
            continue;
        }
        // Where the thread slides the piece before it gives as well; its pull is as many times
        // less, or more on the way back.
        const LineChannel& at = channel(c);
        const double gain = at.slid_m > 0 ? at.out.gain : 1 / at.back.gain;
        double give = piece(c + 1).give_m_n;
        if (at.slid_m != 0) give = n_m > 0 ? give + 1 / (gain * n_m) : 0;
        n_m = give > 0 ? 1 / give : 0;
    }
    return n_m;
}

double ThreadLine::energy_j() const noexcept {
    double sum = 0;
    for (int i = 0; active() && i < pieces(); ++i) sum += piece(i).energy_j();
    return sum;
}

double ThreadLine::energy_unslid_j() const noexcept {
    double sum = 0;
    for (int i = 0; active() && i < pieces(); ++i) {
        LinePiece p = piece(i);
        if (i > 0) p.rest_m -= channel(i - 1).slid_m;
        if (i < channel_count_) p.rest_m += channel(i).slid_m;
        sum += p.energy_j();
    }
    return sum;
}

}  // namespace placode::sim
