// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/resection_operator.h"

#include <algorithm>

namespace placode::haptics {

namespace {

constexpr double kGiveUpS = 240;

}  // namespace

ResectionOperator::ResectionOperator(OperatorLevel level, uint64_t seed,
                                     const ResectionTools& tools,
                                     std::span<const sim::ToolSpec> specs,
                                     std::span<const Vec3> homes)
    : level_(level),
      profile_(operator_profile(level)),
      tools_(tools),
      scissors_pivot_(specs[static_cast<size_t>(tools.scissors)].pivot_m),
      grasper_pivot_(specs[static_cast<size_t>(tools.grasper)].pivot_m),
      scissors_(profile_, seed + 1, homes[static_cast<size_t>(tools.scissors)]),
      grasper_(profile_, seed + 2, homes[static_cast<size_t>(tools.grasper)]) {
    if (tools.needle < 0) return;
    ring_ =
        std::make_unique<OperatorModel>(profile_, seed, homes[static_cast<size_t>(tools.needle)]);
    right_ = Right::kRing;
}

void ResectionOperator::see(const Perception& seen) {
    if (ring_ && right_ == Right::kRing) {
        const auto needle = static_cast<size_t>(tools_.needle);
        Perception own = seen;
        own.in_contact = seen.touches[needle];
        own.placode_gap_m[0] = seen.placode_gap_m[needle];
        ring_->see(own, needle < seen.tools.size() ? seen.tools[needle] : sim::ToolFeedback{});
    }
    const size_t n = seen.outline.size();
    if (line_.size() != n) {
        line_.resize(n);
        normal_.resize(n);
        cut_.resize(n);
        tries_.assign(n, 0);
    }
    std::copy(seen.outline.begin(), seen.outline.end(), line_.begin());
    std::copy_n(seen.outline_normal.begin(), std::min(n, seen.outline_normal.size()),
                normal_.begin());
    std::copy_n(seen.outline_cut.begin(), std::min(n, seen.outline_cut.size()), cut_.begin());
    // Closing jaws press the tissue in: a hand that went after it would only press more.
    if (!holds_ && left_ != Left::kClose) {
        place_ = seen.grasp_place_m;
        placed_ = n > 0;
    }
    const auto grasper = static_cast<size_t>(tools_.grasper);
    holds_ = seen.holds[grasper];
    touches_ = seen.touches[grasper];
    piece_free_ = seen.piece_free;
    pieces_out_ = seen.pieces_out;
    marked_left_ = seen.marked_left;
    marked_held_ = seen.marked_held;
    pull_n_ = seen.pull_n[grasper];
    placode_gap_m_ = seen.placode_gap_m[static_cast<size_t>(tools_.scissors)];
}

void ResectionOperator::go(Right next) noexcept {
    right_ = next;
    right_s_ = 0;
}
void ResectionOperator::go(Left next) noexcept {
    left_ = next;
    left_s_ = 0;
}

bool ResectionOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    right_s_ += dt_s;
    left_s_ += dt_s;
    right(dt_s, hands);
    left(dt_s, hands);
    if (line_.empty() && left_ == Left::kLook && left_s_ > profile_.look_s + 4 &&
        right_ != Right::kRing) {
        go(Left::kDone);  // nothing is marked
    }
    return left_ == Left::kDone || time_s_ > kGiveUpS;
}

}  // namespace placode::haptics
