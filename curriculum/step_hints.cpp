// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/step_hints.h"

#include <array>

#include "curriculum/bilingual.h"
#include "haptics/hint_device.h"

namespace placode::curriculum {

namespace {

using haptics::HintDevice;
using sim::PracticeKind;

/// Mouse, keyboard, gamepad, SpaceMouse, arm.
using ByDevice = std::array<Bilingual::Phrase, 5>;

// In the order of PracticeKind.
constexpr std::array<ByDevice, sim::kPracticeKinds> kHints{{
    // kMove
    {{Bilingual::that("Move the mouse. Ctrl makes it precise, Space holds the instrument still."),
      Bilingual::that("W A S D. Ctrl makes it precise."),
      Bilingual::that("Left stick. The left bumper makes it precise."),
      Bilingual::that("Push the cap sideways, up and down."),
      Bilingual::that("Move the handle sideways. The tip goes the other way, as through a port.")}},
    // kDepth
    {{Bilingual::that("Turn the wheel: away from you is deeper. Shift makes it quicker."),
      Bilingual::that("F goes deeper, R back."),
      Bilingual::that("Right trigger goes deeper, left trigger back."),
      Bilingual::that("Push the cap away from you to go deeper, pull it to come back."),
      Bilingual::that("Push the handle in to go deeper, draw it out to come back.")}},
    // kTurn
    {{Bilingual::that("Hold Shift and move the mouse sideways."), Bilingual::that("Q and E turn."),
      Bilingual::that("Right stick, sideways."), Bilingual::that("Twist the cap."),
      Bilingual::that("Turn the handle about its axis.")}},
    // kTouch
    {{Bilingual::that(
          "Go above the ring, then down with the wheel, notch by notch. Ctrl makes notches small."),
      Bilingual::that("Go above the ring, then F with Ctrl."),
      Bilingual::that("Go above the ring, then the right trigger with the left bumper."),
      Bilingual::that("Go above the ring, then push the cap gently away from you."),
      Bilingual::that("Go above the ring, then push the handle in until the tip touches.")}},
    // kCut
    {{Bilingual::that("Touch the ring's middle, then hold the left button: yellow pedal, cut."),
      Bilingual::that("Touch the ring's middle, then hold X: yellow pedal, cut."),
      Bilingual::that("Touch the ring's middle, then hold A: yellow pedal, cut."),
      Bilingual::that(
          "Touch the ring's middle, then hold the left button or the yellow pedal: cut."),
      Bilingual::that("Touch the ring's middle, then press the yellow pedal: cut.")}},
    // kCoag
    {{Bilingual::that(
          "Touch the ring's middle, then hold the right button: blue pedal, coagulation."),
      Bilingual::that("Touch the ring's middle, then hold C: blue pedal, coagulation."),
      Bilingual::that("Touch the ring's middle, then hold B: blue pedal, coagulation."),
      Bilingual::that(
          "Touch the ring's middle, then hold the right button or the blue pedal: coagulation."),
      Bilingual::that("Touch the ring's middle, then press the blue pedal: coagulation.")}},
    // kGrasp
    {{Bilingual::that("Down until it touches, then hold the left button: the jaws close."),
      Bilingual::that("Down until it touches, then hold X: the jaws close."),
      Bilingual::that("Down until it touches, then hold A: the jaws close."),
      Bilingual::that("Down until it touches, then hold the left button: the jaws close."),
      Bilingual::that(
          "Push in until it touches, then close the handle or hold its first button.")}},
    // kRelease
    {{Bilingual::that("Let go of the left button."), Bilingual::that("Let go of X."),
      Bilingual::that("Let go of A."), Bilingual::that("Let go of the left button."),
      Bilingual::that("Open the handle, or let go of its button.")}},
    // kTrace
    {{Bilingual::that(
          "Down with the wheel until the tip nearly touches, then follow the line with the mouse."),
      Bilingual::that("F until the tip nearly touches, then W A S D with Ctrl along the line."),
      Bilingual::that(
          "Right trigger until the tip nearly touches, then the left stick along the line."),
      Bilingual::that(
          "Push the cap away from you until the tip nearly touches, then sideways along the line."),
      Bilingual::that("Push the handle in until the tip nearly touches, then follow the line.")}},
    // kTraction
    {{Bilingual::that("Hold the left button to grasp, Tab keeps it held; grasp with the other "
                      "hand, then pull gently."),
      Bilingual::that("Hold X to grasp, Tab keeps it held; grasp with the other hand, then pull "
                      "gently with Ctrl."),
      Bilingual::that("Hold A to grasp, Tab on the keyboard keeps it held; grasp with the other "
                      "hand, then pull gently."),
      Bilingual::that("Hold the left button to grasp, Tab on the keyboard keeps it held; grasp "
                      "with the other hand, then pull gently."),
      Bilingual::that(
          "Grasp with both hands, then pull gently until both bars stand in the green band.")}},
    // kWithdraw
    {{Bilingual::that("Wheel towards you."), Bilingual::that("R draws back."),
      Bilingual::that("Left trigger draws back."), Bilingual::that("Pull the cap towards you."),
      Bilingual::that("Draw the handle out.")}},
    // kNeedleIn
    {{Bilingual::that(
          "Mouse and wheel bring the point over the mark; Shift and mouse sideways turn it in."),
      Bilingual::that("W A S D, F and R bring the point over the mark; Q and E turn it in."),
      Bilingual::that(
          "Left stick and triggers bring the point over the mark; the right stick turns it in."),
      Bilingual::that(
          "Push the cap until the point stands over the mark; twist it to turn the needle in."),
      Bilingual::that("Bring the point over the mark, then turn the handle about its axis.")}},
    // kNeedleOut
    {{Bilingual::that("Go on turning with Shift and the mouse until the point comes out."),
      Bilingual::that("Go on turning with Q or E until the point comes out."),
      Bilingual::that("Go on turning with the right stick until the point comes out."),
      Bilingual::that("Go on twisting the cap until the point comes out."),
      Bilingual::that("Go on turning the handle until the point comes out.")}},
    // kNeedleTake
    {{Bilingual::that("Press and let go of the left button, go over the needle behind its point, "
                      "hold the button."),
      Bilingual::that("Press and let go of X, go over the needle behind its point, hold X."),
      Bilingual::that("Press and let go of A, go over the needle behind its point, hold A."),
      Bilingual::that("Press and let go of the left button, go over the needle behind its point, "
                      "hold it again."),
      Bilingual::that("Open the handle, go over the needle behind its point, and close it.")}},
    // kNeedleThrough
    {{Bilingual::that(
          "Hold the left button and turn with Shift and the mouse, round the needle's own circle."),
      Bilingual::that("Hold X and turn with Q or E, round the needle's own circle."),
      Bilingual::that("Hold A and turn with the right stick, round the needle's own circle."),
      Bilingual::that("Hold the left button and twist the cap, round the needle's own circle."),
      Bilingual::that("Keep it closed and turn the handle, round the needle's own circle.")}},
    // kThreadDraw
    {{Bilingual::that("Hold the left button and draw back with the wheel, towards you; go slowly "
                      "once it is taut."),
      Bilingual::that("Hold X and draw back with R; with Ctrl once it is taut."),
      Bilingual::that("Hold A and draw back with the left trigger; go slowly once it is taut."),
      Bilingual::that(
          "Hold the left button and pull the cap towards you; go slowly once it is taut."),
      Bilingual::that(
          "Keep it closed and draw the handle out; go slowly once you feel the thread.")}},
    // kPatchTake
    {{Bilingual::that(
          "Down with the wheel at the ring until the jaws touch, then hold the left button."),
      Bilingual::that("F at the ring until the jaws touch, then hold X."),
      Bilingual::that("Right trigger at the ring until the jaws touch, then hold A."),
      Bilingual::that("Push the cap at the ring until the jaws touch, then hold the left button."),
      Bilingual::that("Push the handle in at the ring until the jaws touch, then close it.")}},
    // kPatchLay
    {{Bilingual::that("Keep the left button down, lift a little with the wheel, draw it over with "
                      "the mouse, lower it."),
      Bilingual::that(
          "Keep X down, lift a little with R, draw it over with W A S D, lower it with F."),
      Bilingual::that("Keep A down, lift a little with the left trigger, draw it over with the "
                      "left stick, lower it."),
      Bilingual::that("Keep the left button down, lift a little with the cap, draw it over "
                      "sideways, lower it."),
      Bilingual::that("Keep it closed, lift a little, draw it over its place, lower it.")}},
    // kPatchSpread
    {{Bilingual::that(
          "Let go of the left button; where a fold is, take its rim again and draw it outwards."),
      Bilingual::that("Let go of X; where a fold is, take its rim again and draw it outwards."),
      Bilingual::that("Let go of A; where a fold is, take its rim again and draw it outwards."),
      Bilingual::that(
          "Let go of the left button; where a fold is, take its rim again and draw it outwards."),
      Bilingual::that(
          "Open the handle; where a fold is, take its rim again and draw it outwards.")}},
    // kWash
    {{Bilingual::that(
          "Stay 1 cm above, point the jet beside the ring, hold the left button: water."),
      Bilingual::that("Stay 1 cm above, point the jet beside the ring, hold X: water."),
      Bilingual::that("Stay 1 cm above, point the jet beside the ring, hold A: water."),
      Bilingual::that(
          "Stay 1 cm above, point the jet beside the ring, hold the left button: water."),
      Bilingual::that(
          "Stay 1 cm above, point the jet beside the ring, press the yellow pedal: water.")}},
    // kSuck
    {{Bilingual::that("Down with the wheel into the fluid at the ring, not onto tissue; hold the "
                      "right button."),
      Bilingual::that("F down into the fluid at the ring, not onto tissue; hold C."),
      Bilingual::that("Right trigger down into the fluid at the ring, not onto tissue; hold B."),
      Bilingual::that(
          "Push the cap down into the fluid at the ring, not onto tissue; hold the right button."),
      Bilingual::that("Down into the fluid at the ring, not onto tissue; press the blue pedal.")}},
    // kUndermine
    {{Bilingual::that("Left button down, in below the lifted edge, raise the tip by 2 mm with the "
                      "wheel; deeper."),
      Bilingual::that(
          "Hold X, in below the lifted edge, raise the tip by 2 mm with R, F down; deeper."),
      Bilingual::that(
          "Hold A, in below the lifted edge, raise the tip by 2 mm with the left trigger; deeper."),
      Bilingual::that("Left button down, in below the lifted edge, raise the tip by 2 mm with the "
                      "cap; deeper."),
      Bilingual::that("Closed, in below the lifted edge; raise the tip and open a little, 2 mm; "
                      "then deeper.")}},
    // kNeedleShow
    {{Bilingual::that("Keep the needle held; mouse and wheel bring its point to the ring, Shift "
                      "and mouse turn it."),
      Bilingual::that("Keep the needle held; W A S D, F and R bring its point to the ring, Q and E "
                      "turn it."),
      Bilingual::that("Keep the needle held; left stick and triggers bring its point to the ring, "
                      "the right stick turns it."),
      Bilingual::that("Keep the needle held; push the cap until its point is at the ring, twist "
                      "to turn it."),
      Bilingual::that("Keep it closed; bring the needle's point to the ring, turn the handle about "
                      "its axis.")}},
    // kNeedleLay
    {{Bilingual::that("Lower the needle over the ring with the wheel until it lies there, then "
                      "press and let go of the left button."),
      Bilingual::that("Lower the needle over the ring with F until it lies there, then press "
                      "and let go of X."),
      Bilingual::that("Lower the needle over the ring with the right trigger until it lies there, "
                      "then press and let go of A."),
      Bilingual::that("Push the cap until the needle lies at the ring, then press and let go of "
                      "the left button."),
      Bilingual::that("Lower the needle until it lies at the ring, then open the handle.")}},
}};

// A needle that is taken at a place of its arc, for the next bite: it is turned there first.
constexpr ByDevice kTakeAtPlace{
    {Bilingual::that("Turn with Shift and the mouse; press and let go of the left button, go to "
                     "the ring, hold the button."),
     Bilingual::that("Turn with Q or E; press and let go of X, go to the ring, hold X."),
     Bilingual::that("Turn with the right stick; press and let go of A, go to the ring, hold A."),
     Bilingual::that("Twist the cap to turn; press and let go of the left button, go to the ring, "
                     "hold it again."),
     Bilingual::that("Turn the handle; open it, go to the ring, and close it.")}};

// Jaws that were left stay closed until the next press.
constexpr ByDevice kReleaseAfterChange{
    {Bilingual::that("Press and let go of the left button: the jaws open."),
     Bilingual::that("Press and let go of X: the jaws open."),
     Bilingual::that("Press and let go of A: the jaws open."),
     Bilingual::that("Press and let go of the left button: the jaws open."),
     Bilingual::that("Open the handle, or let go of its button.")}};

// Before the hand changes that frees skin below an edge: the one that has taken it lifts it.
constexpr ByDevice kLiftFirst{
    {Bilingual::that("Lift the edge by 2 mm with the wheel, then Tab with the button down."),
     Bilingual::that("Lift the edge by 2 mm with R, then Tab with X down."),
     Bilingual::that("Lift the edge by 2 mm with the left trigger, then Tab on the keyboard with A "
                     "down."),
     Bilingual::that("Lift the edge by 2 mm with the cap, then Tab on the keyboard with the button "
                     "down."),
     Bilingual::that("Lift the edge by 2 mm and keep it. With one arm: tap its second button to "
                     "change hands.")}};

// The scope has devices of its own.
constexpr ByDevice kScope{{Bilingual::that("Hold the middle button and move the mouse."),
                           Bilingual::that("Arrow keys."),
                           {},
                           {},
                           {}}};

constexpr ByDevice kOtherHand{
    {Bilingual::that("Tab changes hands."), Bilingual::that("Tab changes hands."),
     Bilingual::that("Tab on the keyboard changes hands."),
     Bilingual::that("Tab on the keyboard changes hands."),
     Bilingual::that("With one arm: tap its second button to change hands.")}};

/// What to do with this device, with the hand that is to do it.
Bilingual::Phrase words_of(const sim::PracticeStep& goal, size_t column, bool changes_hand) {
    if (goal.hand == sim::Hand::kCamera) return kScope[column];
    if (goal.kind == PracticeKind::kNeedleTake && goal.take_share > 0) return kTakeAtPlace[column];
    if (goal.kind == PracticeKind::kRelease && changes_hand) return kReleaseAfterChange[column];
    return kHints[static_cast<size_t>(goal.kind)][column];
}

}  // namespace

LocalText step_hint(const TaskStep& step, const std::string& device, bool changes_hand) {
    const auto own = step.hints.find(device.substr(0, device.find(':')));
    if (own != step.hints.end()) return own->second;
    const HintDevice hand = haptics::hint_device(device);
    if (hand == HintDevice::kNone) return {};
    const size_t column = static_cast<size_t>(hand) - 1;
    const Bilingual::Phrase words = words_of(step.goal, column, changes_hand);
    if (*words.english == '\0') return {};
    LocalText text = Bilingual::phrase(words);
    if (changes_hand && step.goal.hand != sim::Hand::kCamera) {
        const bool lifts = step.goal.kind == PracticeKind::kUndermine;
        const LocalText other = Bilingual::phrase(lifts ? kLiftFirst[column] : kOtherHand[column]);
        text.en.insert(0, other.en + ' ');
        text.pl.insert(0, other.pl + ' ');
    }
    return text;
}

}  // namespace placode::curriculum
