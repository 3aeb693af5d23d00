// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which keys, buttons or motions do a step of practice, as symbols in the order of their use. The
// words beside them are the task's or those of curriculum/step_hints.h.

#include <span>
#include <vector>

#include "haptics/control_layout.h"
#include "haptics/hint_device.h"
#include "sim/core/practice.h"

namespace placode::view {

/// What is drawn: a thing of the device and what is done with it.
enum class HintThing : uint8_t {
    kKey,         ///< Key of a keyboard or button with a name.
    kMouse,       ///< The whole mouse.
    kMouseWheel,  ///< Its wheel.
    kMouseLeft,   ///< Its buttons.
    kMouseRight,
    kMouseMiddle,
    kStick,   ///< Of a gamepad.
    kCap,     ///< Of a SpaceMouse.
    kHandle,  ///< Of an arm.
    kYellowPedal,
    kBluePedal
};
enum class HintAct : uint8_t { kPress, kRelease, kSideways, kIn, kOut, kInOut, kTurn };

struct HintSymbol {
    HintThing thing = HintThing::kKey;
    HintAct act = HintAct::kPress;
    const char* name = "";  ///< Written on a key or below a thing; as it stands on the device.
    bool together = false;  ///< Held while the next one is done.
};

/// Empty where this device has nothing for the step. Keys and buttons as `layout` has them.
[[nodiscard]] std::vector<HintSymbol> hint_symbols(const sim::PracticeStep& step,
                                                   haptics::HintDevice device, bool changes_hand,
                                                   const haptics::ControlLayout& layout = {});

}  // namespace placode::view
