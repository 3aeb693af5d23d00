// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Smooths what was cut open, for the eye only: elements go or part whole, so that their edges
// zigzag by half an element. Place now, place at rest, depth and damage go through the same filter,
// so that colours and patterns stay on the tissue that they belong to.

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace placode::view {

/// Drawn vertices around a cut. A rim vertex is drawn twice, on the skin and on the wall (its
/// twin): both move alike, or the crease would open.
class WoundSmoothing {
 public:
    struct Vertex {
        int twin = -1;       ///< The other half of a rim vertex.
        bool fresh = false;  ///< On a wall.
        bool moves = false;  ///< Part of a fresh triangle.
    };
    void build(std::span<const Vertex> vertices, std::span<const unsigned> triangles);

    /// Shrinking and swelling by turns: the zigzag goes, the depth of the cut stays.
    /// Source: Taubin 1995, "Curve and surface smoothing without shrinkage".
    template <class Value>
    void shape(std::vector<Value>& values) const;
    /// Plain means, for shares between 0 and 1.
    template <class Value>
    void spread(std::vector<Value>& values, int passes) const;
    /// Vertices that move, by number among the drawn ones, each rim vertex once.
    [[nodiscard]] std::span<const int> moving() const { return moving_; }

 private:
    enum class Along { kAll, kRim };
    template <class Value>
    void pass(std::vector<Value>& values, std::vector<Value>& next, Along along,
              float factor) const;
    void link(std::span<const Vertex> vertices, std::span<const unsigned> triangles);

    std::vector<int> moving_, twin_;              // (M) drawn vertex and its other half or -1
    std::vector<int> all_start_, all_;            // neighbours of each, by CSR
    std::vector<int> rim_, rim_start_, rim_all_;  // of moving_: those on the rim, and theirs there
};

template <class Value>
void WoundSmoothing::pass(std::vector<Value>& values, std::vector<Value>& next, Along along,
                          float factor) const {
    const bool rim = along == Along::kRim;
    const std::vector<int>&start = rim ? rim_start_ : all_start_, &near = rim ? rim_all_ : all_;
    const size_t count = rim ? rim_.size() : moving_.size();
    next.resize(count);
    const auto vertex = [&](size_t i) {
        return rim ? static_cast<size_t>(rim_[i]) : i;  // among moving_
    };
    for (size_t i = 0; i < count; ++i) {
        const auto c = static_cast<size_t>(moving_[vertex(i)]);
        const int first = start[i], last = start[i + 1];
        next[i] = values[c];
        if (first == last) continue;
        Value sum = Value::Zero();
        for (int k = first; k < last; ++k)
            sum += values[static_cast<size_t>(near[static_cast<size_t>(k)])];
        next[i] += factor * (sum / static_cast<float>(last - first) - values[c]);
    }
    for (size_t i = 0; i < count; ++i) {
        const size_t m = vertex(i);
        values[static_cast<size_t>(moving_[m])] = next[i];
        if (twin_[m] >= 0) values[static_cast<size_t>(twin_[m])] = next[i];
    }
}

template <class Value>
void WoundSmoothing::shape(std::vector<Value>& values) const {
    constexpr float kShrink = 0.55F, kSwell = -0.58F;
    // First the rim as a line: elements that are gone leave corners. Always in pairs, or the ends
    // of a kerf would draw back and small holes close.
    constexpr int kRimPairs = 8, kAllPairs = 6;
    std::vector<Value> next;
    for (int i = 0; i < kRimPairs; ++i) {
        pass(values, next, Along::kRim, kShrink);
        pass(values, next, Along::kRim, kSwell);
    }
    for (int i = 0; i < kAllPairs; ++i) {
        pass(values, next, Along::kAll, kShrink);
        pass(values, next, Along::kAll, kSwell);
    }
}

template <class Value>
void WoundSmoothing::spread(std::vector<Value>& values, int passes) const {
    constexpr float kShare = 0.5F;
    std::vector<Value> next;
    for (int i = 0; i < passes; ++i) pass(values, next, Along::kAll, kShare);
}

}  // namespace placode::view
