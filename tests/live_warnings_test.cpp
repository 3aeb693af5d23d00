// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is said at the rim of the picture while it happens.

#include "curriculum/live_warnings.h"

#include <gtest/gtest.h>

#include <string_view>

#include "tests/box_scene.h"

namespace placode::curriculum {
namespace THIS_TEST {

TEST(LiveWarnings, ASpellOfCurrentIsSaidWhileThePedalIsDown) {
    const sim::Scene scene = sim::test::box_scene({});
    sim::State state(scene, 1);
    LiveWarnings warnings(scene);
    const sim::ToolInput input = sim::test::upright(sim::Vec3(0, 0, 0.01));
    const auto said_at = [&](double time_s) {
        state.time_s = time_s;
        warnings.look(state, {&input, 1}, false);
        return warnings.said_s();
    };
    state.ledger.tools[0].dwell_s = 1.5F;
    state.tools[0].energised = 1;
    EXPECT_EQ(said_at(2), 2);
    EXPECT_EQ(std::string_view(warnings.phrase().data()), "Too long on one spot");
    // Between two taps the ledger keeps the spell, and nobody is told.
    state.tools[0].energised = 0;
    EXPECT_EQ(said_at(2.5), 2);
    state.ledger.tools[0].air_s = 1.5F;
    EXPECT_EQ(said_at(2.6), 2);
}

TEST(LiveWarnings, ANeedleThatIsDroppedIsSaidAndOneThatIsLaidDownIsNot) {
    const sim::Scene scene = sim::test::box_scene({});
    LiveWarnings warnings(scene);
    sim::Event event;
    event.kind = sim::EventKind::kNeedleLaid;
    event.time_s = 3;
    warnings.hear(event);
    EXPECT_LT(warnings.said_s(), 0);
    event.kind = sim::EventKind::kNeedleDropped;
    event.time_s = 4;
    warnings.hear(event);
    EXPECT_EQ(warnings.said_s(), 4);
    EXPECT_EQ(std::string_view(warnings.phrase().data()), "Needle dropped");
    event.kind = sim::EventKind::kTargetMissed;
    event.time_s = 5;
    warnings.hear(event);
    EXPECT_EQ(std::string_view(warnings.phrase().data()), "Beside the mark");
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
