// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/hand_identity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace placode::haptics {
namespace THIS_TEST {

/// Two arms that shake by the noise of their encoders.
struct Arms {
    std::array<DeviceState, 2> now;
    int tick = 0;
    void see(HandIdentity& identity) {
        ++tick;
        for (DeviceState& arm : now) arm.position_m.x() += tick % 2 == 0 ? 3e-5 : -3e-5;
        identity.see(now);
    }
};

TEST(HandIdentity, WaitsUntilItIsAskedAndForOneArmAlone) {
    HandIdentity identity;
    Arms arms;
    arms.now[1].buttons = 1;
    for (int i = 0; i < 10; ++i) arms.see(identity);
    EXPECT_EQ(identity.state().arm, -1) << "nobody asked";
    arms.now[0].buttons = 1;
    identity.ask();
    for (int i = 0; i < 10'000; ++i) arms.see(identity);
    EXPECT_EQ(identity.state().arm, -1) << "both buttons say nothing, noise is no way";
    arms.now[0].buttons = 0;
    arms.see(identity);
    EXPECT_EQ(identity.state().arm, 1);
}

TEST(HandIdentity, TakesTheArmThatIsMovedMuchMore) {
    HandIdentity identity;
    Arms arms;
    identity.ask();
    // Both move: no answer.
    for (int i = 0; i < 100; ++i) {
        for (DeviceState& arm : arms.now) arm.position_m.y() += 0.001;
        arms.see(identity);
    }
    EXPECT_EQ(identity.state().arm, -1);
    identity.ask();
    for (int i = 0; i < 60; ++i) {
        arms.now[0].position_m.y() += 0.001;
        arms.see(identity);
    }
    EXPECT_EQ(identity.state().arm, 0);
    EXPECT_GT(identity.state().moved_m[0], 0.03);
}

TEST(HandIdentity, DoubtsLostArmsAndNumbersThatAreNone) {
    HandIdentity identity;
    Arms arms;
    identity.ask();
    arms.see(identity);
    arms.now[0].position_m.x() = std::nan("");
    arms.now[1].status = DeviceStatus::kLost;
    arms.now[1].position_m.y() = 1;
    for (int i = 0; i < 10; ++i) arms.see(identity);
    EXPECT_EQ(identity.state().arm, -1);
}

TEST(HandIdentity, SwapsHandsInTheStationOfEveryDevice) {
    std::array<DeviceInfo, 2> arms;
    arms[0].serial.assign(1, 'R');
    arms[1].serial.assign(1, 'L');
    Station station;
    station.set("openhaptics.right", "one");
    station.set("openhaptics.left", "two");
    swap_hands(station, "openhaptics", arms);
    EXPECT_EQ(station.text("openhaptics.right"), "two");
    EXPECT_EQ(station.text("openhaptics.left"), "one");
    station.set("haply.left", "auto");
    swap_hands(station, "haply", arms);
    EXPECT_EQ(station.text("haply.right"), "L");
    EXPECT_EQ(station.text("haply.left"), "R");
    swap_hands(station, "forcedimension", arms);
    EXPECT_EQ(station.number("forcedimension.swap_hands"), 1);
    swap_hands(station, "forcedimension", arms);
    EXPECT_EQ(station.number("forcedimension.swap_hands"), 0);
    swap_hands(station, "haply", {arms.data(), 1});
    EXPECT_EQ(station.text("arm.one_hand"), "left") << "one arm stands for the other hand";
    EXPECT_THROW(swap_hands(station, "mouse", arms), DeviceError);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
