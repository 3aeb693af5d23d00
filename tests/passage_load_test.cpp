// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Thread that pulls at tissue from within. The needle's wire: suturing_test.
#include "sim/suture/passage_load.h"

#include <gtest/gtest.h>

#include <numbers>

#include "thread_block.h"

namespace placode::sim {
namespace THIS_TEST {

using test::SutureBlock;

/// As in the next substep, which is done.
double load_n(SutureBlock& block, Tissue kind) {
    block.begin_frame();
    begin_substep(block.body, block.tissue_state, SutureBlock::kStep, block.workers);
    begin_suture(block.suture, block.needle, block.tissue, block.scratch, block.needle.hold.hand,
                 SutureBlock::kStep, block.report);
    solve_suture(block.suture, block.needle, block.tissue, block.scratch, SutureBlock::kStep,
                 false);
    sweep(block.body, block.tissue_state, SutureBlock::kStep, block.workers);
    solve_suture(block.suture, block.needle, block.tissue, block.scratch, SutureBlock::kStep, true);
    const double load =
        passage_load_n(block.suture, block.needle, block.tissue, block.scratch, kind);
    finish_suture(block.suture, block.needle, block.tissue, block.scratch, SutureBlock::kStep,
                  block.report);
    end_substep(block.body, block.tissue_state, SutureBlock::kStep, block.workers);
    return load;
}

// Along half a circle a pull T presses with T a radian: pi T in all, less where friction has taken
// some of it, more where the hands draw the mouths aside.
TEST(PassageLoad, ThreadThatIsDrawnLoadsTheTissueItRunsThroughAndNoOther) {
    const auto block = test::block_of(test::threaded_block());
    test::lay_bite(*block);
    const Tissue kind = block->body.mesh().tissue[0];
    EXPECT_EQ(load_n(*block, kind), 0) << "nobody pulls";
    test::hold(*block, 0, Vec3(-1.2e-3, 0, 3e-3));
    test::hold(*block, 1, Vec3(1.2e-3, 0, 3e-3));
    test::draw(*block, 1, Vec3(0, 0, 0.5e-3), 5e-3);
    const double pull = test::pull_n(*block, 1);
    ASSERT_GT(pull, 5e-3);
    const double load = load_n(*block, kind);
    EXPECT_GT(load, pull);
    EXPECT_LT(load, 2 * std::numbers::pi * pull);
    EXPECT_EQ(load_n(*block, kind == Tissue::kPlacode ? Tissue::kSkin : Tissue::kPlacode), 0);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
