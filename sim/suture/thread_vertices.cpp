// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/thread_vertices.h"

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

struct Share {
    int passage = 0;
    double b = 0;  ///< Of the vertex in it.
};
Share share_of(const ThreadState& thread, int32_t entry) noexcept {
    const int32_t at = ~entry;
    return {at / 4, thread.passages[as_index(at / 4)].at.b[as_index(at % 4)]};
}

/// How the ways of pieces change with the vertex. Passages come in order, so that two pieces are
/// open at a time; one that is done adds its stiffness.
class PieceGradients {
 public:
    PieceGradients(const ThreadLine& line, VertexSystem& system) noexcept
        : line_(line), system_(system) {}
    ~PieceGradients() {
        close(0);
        close(1);
    }
    PieceGradients(const PieceGradients&) = delete;
    PieceGradients& operator=(const PieceGradients&) = delete;

    void add(const LineSegment& s, double b) noexcept {
        if (s.share < 1) of(s.before) += (1 - s.share) * b * s.along;
        if (s.share > 0) of(s.behind) += s.share * b * s.along;
    }

 private:
    Vec3& of(int piece) noexcept {
        while (piece > first_ + 1) {
            close(0);
            way_[0] = way_[1];
            way_[1].setZero();
            ++first_;
        }
        return way_[piece == first_ ? 0 : 1];
    }
    void close(size_t i) noexcept {
        const int piece = first_ + static_cast<int>(i);
        if (piece < 0 || piece >= line_.pieces() || !(line_.piece(piece).pull_n() > 0)) return;
        system_.hessian += way_[i] * way_[i].transpose() / line_.piece(piece).give_m_n;
    }

    const ThreadLine& line_;
    VertexSystem& system_;
    int first_ = -1;
    std::array<Vec3, 2> way_{Vec3::Zero(), Vec3::Zero()};
};

}  // namespace

void add_thread(const ThreadLine& line, const ThreadState& thread, std::span<const int32_t> entries,
                VertexSystem& system) noexcept {
    PieceGradients pieces(line, system);
    for (const int32_t entry : entries) {
        const Share share = share_of(thread, entry);
        if (share.b == 0) continue;
        const int node = line.node_of(share.passage);
        const auto add = [&](const LineSegment& s, double b) {
            const double pull = line.pull_n(s);
            if (pull == 0) return;
            pieces.add(s, b);
            system.gradient += pull * b * s.along;
            // A straight way resists being drawn aside.
            system.hessian +=
                pull * b * b / s.path_m * (Mat3::Identity() - s.along * s.along.transpose());
        };
        if (node > 0) add(line.segment(node - 1), share.b);
        if (node + 1 < line.nodes()) add(line.segment(node), -share.b);
    }
}

void move_thread(ThreadLine& line, const ThreadState& thread, std::span<const int32_t> entries,
                 const Vec3& by) noexcept {
    for (const int32_t entry : entries) {
        const Share share = share_of(thread, entry);
        if (share.b != 0) line.move_node(line.node_of(share.passage), share.b * by);
    }
}

}  // namespace placode::sim
