// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/practice_hint.h"

#include "haptics/control_words.h"

namespace placode::view {

using namespace sim;
namespace {

using Act = HintAct;
using Thing = HintThing;
using Symbols = std::vector<HintSymbol>;

constexpr HintSymbol key(const char* name, bool together = false, Act act = Act::kPress) {
    return {Thing::kKey, act, name, together};
}

Symbols with_mouse(PracticeKind kind, bool scope) {
    const HintSymbol move{Thing::kMouse, Act::kSideways};
    const HintSymbol down{Thing::kMouseWheel, Act::kIn}, left{Thing::kMouseLeft, Act::kPress};
    switch (kind) {
        case PracticeKind::kMove:
            if (scope) return {{Thing::kMouseMiddle, Act::kSideways}};
            return {move};
        case PracticeKind::kDepth:
            return {{Thing::kMouseWheel, Act::kInOut}};
        case PracticeKind::kTurn:
            return {key("Shift", true), move};
        case PracticeKind::kTouch:
            return {move, down};
        case PracticeKind::kCut:
            return {down, left};
        case PracticeKind::kCoag:
        case PracticeKind::kSuck:
            return {down, {Thing::kMouseRight, Act::kPress}};
        case PracticeKind::kWash:
            return {move, left};
        case PracticeKind::kGrasp:
            return {down, left};
        case PracticeKind::kRelease:
            return {{Thing::kMouseLeft, Act::kRelease}};
        case PracticeKind::kTrace:
            return {down, move};
        case PracticeKind::kTraction:
            return {left, key("Tab"), left, move};
        case PracticeKind::kWithdraw:
            return {{Thing::kMouseWheel, Act::kOut}};
        case PracticeKind::kNeedleIn:
            return {move, down, key("Shift", true), move};
        case PracticeKind::kNeedleOut:
            return {key("Shift", true), move};
        case PracticeKind::kNeedleThrough:
            return {left, key("Shift", true), move};
        case PracticeKind::kThreadDraw:
            return {left, {Thing::kMouseWheel, Act::kOut}};
        case PracticeKind::kNeedleTake:
            return {{Thing::kMouseLeft, Act::kRelease}, move, left};
        case PracticeKind::kPatchTake:
            return {down, left};
        case PracticeKind::kPatchLay:
            return {left, {Thing::kMouseWheel, Act::kOut}, move, down};
        case PracticeKind::kPatchSpread:
            return {{Thing::kMouseLeft, Act::kRelease}, left, move};
        case PracticeKind::kUndermine:
            return {left, move, {Thing::kMouseWheel, Act::kOut}};
        case PracticeKind::kNeedleShow:
            return {left, move, down};
        case PracticeKind::kNeedleLay:
            return {move, down, {Thing::kMouseLeft, Act::kRelease}};
    }
    return {};
}

Symbols with_keyboard(PracticeKind kind, bool scope) {
    const Symbols plane{key("W"), key("A"), key("S"), key("D")};
    switch (kind) {
        case PracticeKind::kMove:
            if (scope)
                return {key("\xE2\x86\x90"), key("\xE2\x86\x92"), key("\xE2\x86\x91"),
                        key("\xE2\x86\x93")};
            return plane;
        case PracticeKind::kDepth:
            return {key("F"), key("R")};
        case PracticeKind::kTurn:
            return {key("Q"), key("E")};
        case PracticeKind::kTouch:
            return {key("Ctrl", true), key("F")};
        case PracticeKind::kCut:
            return {key("F"), key("X")};
        case PracticeKind::kCoag:
        case PracticeKind::kSuck:
            return {key("F"), key("C")};
        case PracticeKind::kWash:
            return {key("W"), key("A"), key("S"), key("D"), key("X")};
        case PracticeKind::kGrasp:
            return {key("F"), key("X")};
        case PracticeKind::kRelease:
            return {key("X", false, Act::kRelease)};
        case PracticeKind::kTrace: {
            Symbols all{key("Ctrl", true)};
            all.insert(all.end(), plane.begin(), plane.end());
            return all;
        }
        case PracticeKind::kTraction:
            return {key("X"), key("Tab"), key("X")};
        case PracticeKind::kWithdraw:
            return {key("R")};
        case PracticeKind::kNeedleIn:
            return {key("F"), key("Q"), key("E")};
        case PracticeKind::kNeedleOut:
            return {key("Q"), key("E")};
        case PracticeKind::kNeedleThrough:
            return {key("X"), key("Q"), key("E")};
        case PracticeKind::kThreadDraw:
            return {key("X"), key("R")};
        case PracticeKind::kNeedleTake:
            return {key("X", false, Act::kRelease), key("X")};
        case PracticeKind::kPatchTake:
            return {key("F"), key("X")};
        case PracticeKind::kPatchLay:
            return {key("X"), key("R"), key("W"), key("A"), key("S"), key("D"), key("F")};
        case PracticeKind::kPatchSpread:
            return {
                key("X", false, Act::kRelease), key("X"), key("W"), key("A"), key("S"), key("D")};
        case PracticeKind::kUndermine:
            return {key("X"), key("W"), key("R")};
        case PracticeKind::kNeedleShow:
            return {key("X"), key("W"), key("A"), key("S"), key("D"), key("F")};
        case PracticeKind::kNeedleLay:
            return {key("F"), key("X", false, Act::kRelease)};
    }
    return {};
}

Symbols with_gamepad(PracticeKind kind) {
    const HintSymbol stick{Thing::kStick, Act::kSideways, "L"};
    switch (kind) {
        case PracticeKind::kMove:
            return {stick};
        case PracticeKind::kDepth:
            return {key("RT"), key("LT")};
        case PracticeKind::kTurn:
            return {{Thing::kStick, Act::kSideways, "R"}};
        case PracticeKind::kTouch:
            return {stick, key("LB", true), key("RT")};
        case PracticeKind::kCut:
            return {key("RT"), key("A")};
        case PracticeKind::kCoag:
        case PracticeKind::kSuck:
            return {key("RT"), key("B")};
        case PracticeKind::kWash:
            return {stick, key("A")};
        case PracticeKind::kGrasp:
            return {key("RT"), key("A")};
        case PracticeKind::kRelease:
            return {key("A", false, Act::kRelease)};
        case PracticeKind::kTrace:
            return {key("LB", true), stick};
        case PracticeKind::kTraction:
            return {key("A"), key("Tab"), key("A")};
        case PracticeKind::kWithdraw:
            return {key("LT")};
        case PracticeKind::kNeedleIn:
            return {stick, key("RT"), {Thing::kStick, Act::kSideways, "R"}};
        case PracticeKind::kNeedleOut:
            return {{Thing::kStick, Act::kSideways, "R"}};
        case PracticeKind::kNeedleThrough:
            return {key("A"), {Thing::kStick, Act::kSideways, "R"}};
        case PracticeKind::kThreadDraw:
            return {key("A"), key("LT")};
        case PracticeKind::kNeedleTake:
            return {key("A", false, Act::kRelease), stick, key("A")};
        case PracticeKind::kPatchTake:
            return {key("RT"), key("A")};
        case PracticeKind::kPatchLay:
            return {key("A"), key("LT"), stick, key("RT")};
        case PracticeKind::kPatchSpread:
            return {key("A", false, Act::kRelease), key("A"), stick};
        case PracticeKind::kUndermine:
            return {key("A"), stick, key("LT")};
        case PracticeKind::kNeedleShow:
            return {key("A"), stick, key("RT")};
        case PracticeKind::kNeedleLay:
            return {stick, key("RT"), key("A", false, Act::kRelease)};
    }
    return {};
}

/// A SpaceMouse's cap and an arm's handle are moved alike.
Symbols with_grip(PracticeKind kind, Thing grip, HintSymbol close) {
    const HintSymbol move{grip, Act::kSideways}, in{grip, Act::kIn};
    switch (kind) {
        case PracticeKind::kMove:
            return {move};
        case PracticeKind::kDepth:
            return {{grip, Act::kInOut}};
        case PracticeKind::kTurn:
            return {{grip, Act::kTurn}};
        case PracticeKind::kTouch:
            return {move, in};
        case PracticeKind::kCut:
            return {in, {Thing::kYellowPedal, Act::kPress}};
        case PracticeKind::kCoag:
        case PracticeKind::kSuck:
            return {in, {Thing::kBluePedal, Act::kPress}};
        case PracticeKind::kWash:
            return {move, {Thing::kYellowPedal, Act::kPress}};
        case PracticeKind::kGrasp:
            return {in, close};
        case PracticeKind::kRelease:
            close.act = Act::kRelease;
            return {close};
        case PracticeKind::kTrace:
            return {in, move};
        case PracticeKind::kTraction:
            if (grip == Thing::kCap) return {close, key("Tab"), close, move};
            return {close, move};
        case PracticeKind::kWithdraw:
            return {{grip, Act::kOut}};
        case PracticeKind::kNeedleIn:
            return {move, in, {grip, Act::kTurn}};
        case PracticeKind::kNeedleOut:
            return {{grip, Act::kTurn}};
        case PracticeKind::kNeedleTake: {
            HintSymbol open = close;
            open.act = Act::kRelease;
            return {open, move, close};
        }
        case PracticeKind::kNeedleThrough:
            return {close, {grip, Act::kTurn}};
        case PracticeKind::kThreadDraw:
            return {close, {grip, Act::kOut}};
        case PracticeKind::kPatchTake:
            return {in, close};
        case PracticeKind::kPatchLay:
            return {close, {grip, Act::kOut}, move, in};
        case PracticeKind::kPatchSpread: {
            HintSymbol open = close;
            open.act = Act::kRelease;
            return {open, close, move};
        }
        case PracticeKind::kUndermine:
            return {close, move, {grip, Act::kOut}};
        case PracticeKind::kNeedleShow:
            return {close, move, in};
        case PracticeKind::kNeedleLay: {
            HintSymbol open = close;
            open.act = Act::kRelease;
            return {move, in, open};
        }
    }
    return {};
}

/// Keys, buttons and sticks that a person has chosen, in place of those as delivered.
void put_on_keys(Symbols& symbols, haptics::HintDevice device,
                 const haptics::ControlLayout& layout) {
    const bool mouse = device == haptics::HintDevice::kMouse;
    for (HintSymbol& symbol : symbols) {
        const std::string_view name = symbol.name;
        if (symbol.thing == Thing::kKey) {
            for (const haptics::Control& control : haptics::layout_controls())
                if (haptics::is_key_with(device, control.does) &&
                    name == haptics::key_name(control.does)) {
                    // A name is a literal and ends with a zero.
                    symbol.name = haptics::key_name(layout.key_for(control.does)).data();
                    break;
                }
        } else if (mouse && layout.buttons_exchanged && symbol.thing == Thing::kMouseLeft) {
            symbol.thing = Thing::kMouseRight;
        } else if (mouse && layout.buttons_exchanged && symbol.thing == Thing::kMouseRight) {
            symbol.thing = Thing::kMouseLeft;
        } else if (symbol.thing == Thing::kStick && layout.sticks_exchanged) {
            symbol.name = name == "L" ? "R" : "L";
        }
    }
}

}  // namespace

std::vector<HintSymbol> hint_symbols(const PracticeStep& step, haptics::HintDevice device,
                                     bool changes_hand, const haptics::ControlLayout& layout) {
    const bool scope = step.hand == Hand::kCamera;
    Symbols symbols;
    switch (device) {
        case haptics::HintDevice::kNone:
            return {};
        case haptics::HintDevice::kMouse:
            symbols = with_mouse(step.kind, scope);
            break;
        case haptics::HintDevice::kKeyboard:
            symbols = with_keyboard(step.kind, scope);
            break;
        case haptics::HintDevice::kGamepad:
            if (!scope) symbols = with_gamepad(step.kind);
            break;
        case haptics::HintDevice::kSpaceMouse:
            if (!scope) symbols = with_grip(step.kind, HintThing::kCap, key("1"));
            break;
        case haptics::HintDevice::kArm:
            if (!scope) symbols = with_grip(step.kind, HintThing::kHandle, key("1"));
            break;
    }
    if (changes_hand && !scope && !symbols.empty())
        symbols.insert(symbols.begin(), key(device == haptics::HintDevice::kArm ? "2" : "Tab"));
    put_on_keys(symbols, device, layout);
    return symbols;
}

}  // namespace placode::view
