// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Thread that lies in a block of tissue, and hands at its ends. The needle is out of the way.

#include <gtest/gtest.h>

#include <memory>

#include "suture_block.h"

namespace placode::sim::test {

inline BlockOptions threaded_block(double friction = 0.15) {
    BlockOptions options = skin_block();
    options.suture.thread.length_m = 0.1;
    options.suture.thread.friction.friction = friction;
    return options;
}
inline std::unique_ptr<SutureBlock> block_of(const BlockOptions& options) {
    return std::make_unique<SutureBlock>(options, SutureBlock::upright(Vec3(0, 0, 0.05)));
}

/// The point of the tissue nearest to a place at rest: inside a tet, or on the surface beside it.
inline TissuePoint point_at(const SutureBlock& block, const Vec3& place) {
    TissuePoint best;
    double out = 1e9;
    const TetMesh& mesh = block.body.mesh();
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto& c = mesh.tets[t];
        Mat3 edges;
        for (int k = 0; k < 3; ++k)
            edges.col(k) = mesh.rest[as_index(c[as_index(k + 1)])] - mesh.rest[as_index(c[0])];
        const Vec3 w = edges.inverse() * (place - mesh.rest[as_index(c[0])]);
        std::array<double, 4> b{1 - w.sum(), w.x(), w.y(), w.z()};
        const double least = -*std::min_element(b.begin(), b.end());
        if (least >= out) continue;
        out = least;
        double sum = 0;
        for (double& one : b) sum += one = std::max(one, 0.0);
        for (double& one : b) one /= sum;
        best = {static_cast<int32_t>(t), b};
    }
    return best;
}

/// One channel along `curve(s)`, s from 0 to 1, with a passage about every 0.3 mm.
template <class Curve>
void lay_along(SutureBlock& block, double length_m, Curve&& curve) {
    const int n = std::max(1, static_cast<int>(std::ceil(length_m / 0.3e-3)));
    std::vector<TissuePoint> points;
    for (int i = 0; i <= n; ++i) points.push_back(point_at(block, curve(1.0 * i / n)));
    lay_channel(block.suture, block.needle, block.tissue, points, SutureBlock::kStep,
                0.5 * block.suture.spec().thread.length_m);
}
inline void hold(SutureBlock& block, int end, const Vec3& place, double slack_m = 0) {
    hold_thread(block.suture, block.needle, block.tissue, end, place, slack_m);
}
inline void let_go(SutureBlock& block, int end) {
    let_go_thread(block.suture, block.needle, block.tissue, end);
}
inline ThreadEnd& end_of(SutureBlock& block, int end) {
    return block.needle.thread.ends[as_index(end)];
}
inline double pull_n(SutureBlock& block, int end) { return end_of(block, end).force_n.norm(); }

/// The hand at an end goes by `way`; `look(block)` after every frame, false stops.
template <class Look>
void draw(SutureBlock& block, int end, const Vec3& offset, double speed_m_s, Look&& look) {
    const Vec3 start = end_of(block, end).place_m;
    const int frames = static_cast<int>(std::ceil(offset.norm() / (speed_m_s * 1e-3)));
    const Pose nobody = block.needle.hold.hand;
    for (int i = 0; i < frames; ++i) {
        block.report.event_count = 0;
        block.begin_frame();
        for (int s = 1; s <= SutureBlock::kSubsteps; ++s) {
            end_of(block, end).place_m =
                start + offset * (i + 1.0 * s / SutureBlock::kSubsteps) / frames;
            block.substep(nobody);
        }
        if (!look(block)) return;
    }
}
inline void draw(SutureBlock& block, int end, const Vec3& offset, double speed_m_s) {
    draw(block, end, offset, speed_m_s, [](SutureBlock&) { return true; });
}

/// Half a circle into the block and out again, from x = -r to r.
inline void lay_bite(SutureBlock& block, double radius_m = 1.2e-3, double x = 0) {
    lay_along(block, std::numbers::pi * radius_m, [=](double s) {
        const double a = std::numbers::pi * s;
        return Vec3(x - radius_m * std::cos(a), 0, -radius_m * std::sin(a));
    });
}

/// A measured number, into the test's XML (--gtest_output).
inline void record(const char* name, double value) {
    ::testing::Test::RecordProperty(name, shortest_text(value));
}

/// Largest distance of a vertex from where it is at rest [m].
inline double off_rest_m(const SutureBlock& block) {
    double most = 0;
    for (int v = 0; v < block.body.vertex_count(); ++v)
        most = std::max(
            most, (position(block.tissue_state, v) - block.body.mesh().rest[as_index(v)]).norm());
    return most;
}

}  // namespace placode::sim::test
