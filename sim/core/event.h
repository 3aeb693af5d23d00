// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happened: the damage ledger's entries, and bits that a step can raise.

#include <array>
#include <cstdint>
#include <string_view>

#include "sim/core/tissue.h"

namespace placode::sim {

/// Kinds are stored as numbers in recordings: append only, never renumber.
enum class EventKind : uint16_t {
    kPhase = 1,      ///< value = Phase
    kEnergyOn = 2,   ///< value = nominal W
    kEnergyOff = 3,  ///< value = seconds on, value2 = joules delivered
    // Raised when they end, over 1 s; taps with pauses up to 1 s are one. Time = the last current.
    kEnergyInAir = 4,  ///< value = seconds of current
    kDwell = 5,        ///< value = seconds of current on one spot
    kVaporised = 6,  ///< one tet removed by heat: value = rest volume [m^3], value2 = depth of its
                     ///< centroid below the rest surface [m]
    kTorn = 7,       ///< one tet torn: value = rest volume [m^3], value2 = stretch; or all
                     ///< tissue of a kind that left with a loose piece though it was not to go
                     ///< (sim/cutting/piece_fate.h): value = its volume, value2 = 0
    kPlacodeContact = 8,  ///< raised when contact ends: value = seconds, value2 = peak force [N]
    kPlacodeEnergised =
        9,  ///< energised contact with the placode: value = seconds, value2 = peak T [C]
    kPlacodeOverheated =
        10,  ///< first vertex above the warning dose: value = CEM43 [min], value2 = T [C]
    kPlacodeBurned =
        11,  ///< first vertex above the injury dose, or 60 C: value = CEM43 [min], value2 = T [C]
    kOverForce = 12,     ///< value = seconds, value2 = peak force [N]
    kOverStretch = 13,   ///< value = stretch
    kTetherBroken = 14,  ///< value = force [N]
    kSubsteps = 15,      ///< value = new number of substeps (under load)
    kStateHash = 16,     ///< hash = state_hash, once a second and at the end
    kRestored = 17,      ///< element recovered from its rest shape
    kFinished = 18,      ///< the operator declared the task done
    kGrasped = 19,       ///< jaws closed on tissue: value = vertices held, value2 = jaw force [N]
    kReleased = 20,      ///< jaws let go: value = seconds held, value2 = peak traction [N]
    kSlipped = 21,       ///< tissue slid in the jaws: value = way [m], value2 = peak traction [N]
    kCrushed = 22,       ///< jaw pressure above the tissue's limit: value = Pa, value2 = N
    kOverTraction = 23,  ///< pulled above the tissue's limit, over 0.3 s: value = seconds, value2 =
                         ///< peak [N]. Tugs with pauses up to 0.3 s are one, time = end of the last
    kSnipped = 24,       ///< scissors closed: value = area parted [m^2], value2 = depth [m]
    kPlacodeCut = 25,    ///< scissors parted placode from placode: value = area [m^2]
    kPieceFree = 26,     ///< tissue came loose: value = volume [m^3]
    kPieceOut = 27,    ///< a loose piece was taken out of the field: value = volume [m^3], value2 =
                       ///< share of the marked tissue that is gone with it
    kCrumb = 28,       ///< a loose crumb was washed away: value = volume [m^3]
    kSectorFree = 29,  ///< a sector of 5 degrees came free: value = sector, value2 = free sectors
    kSacOpened = 30,   ///< first hole in the wall of a sac: value = pressure [Pa]
    kBuried = 31,      ///< a tip was below the surface: value = seconds (raised when it ends, over
                       ///< 0.3 s), value2 = largest depth [m]
    // About the attempt and not about tissue.
    kPaused = 32,        ///< simulated time stood still: value = seconds of wall clock, value2 =
                         ///< PauseCause
    kMachineSpeed = 33,  ///< once, at the end: value = simulated over wall-clock time, value2 =
                         ///< pictures a second (0 = nothing was drawn)
    kSlowSpell = 34,     ///< the computer fell behind: value = seconds, value2 = as kMachineSpeed
    kNoRoomToCut = 35,   ///< blades met tissue that the scene has no spare vertices to part, so
                         ///< that it was left whole: value = faces (raised with the end of a snip)
    // Practice (sim/core/practice.h).
    kPracticeSteps = 60,  ///< value = number of steps, at the start
    kStepDone = 61,       ///< value = step, value2 = seconds that it took
    kTargetTouched = 62,  ///< value = step, value2 = distance from it [m]
    kTargetMissed = 63,   ///< tissue touched beside it; as above
    kTraced = 64,         ///< value = bin of the contour, value2 = mean offset over the way [m]
    kTractionHeld = 65,   ///< value = seconds in the band, value2 = peak [N]
    kBiteEntry = 66,      ///< value = step, value2 = distance of a needle's entry from its mark [m]
    kBiteExit = 67,       ///< the same of its exit; distances along the tissue at rest
    kBiteMark = 68,       ///< a bite of several is next: value = its step, value2 = 0 where the
                          ///< needle is to go in, 1 where out (one event each), place = the mark,
                          ///< element = number of the bite, from 0
    kThreadDrawn = 69,    ///< a thread was drawn, where the step has `enough_n`: value = step,
                          ///< value2 = hardest pull while the slit was shut [N]
    kNeedlePlaced = 71,   ///< jaws took a needle as a step wants it: value = step, value2 = how far
                          ///< from the place that it names, as a share of the arc
    kNeedleShown = 72,    ///< its point was held at a mark: value = step, value2 = distance [m]
    kNeedleLaid = 73,     ///< it was let go at its mark: value = step, value2 = distance of its
                          ///< middle from the mark [m]
    kNeedleDropped = 74,  ///< it was let go in the open elsewhere: value = step, value2 = height of
                          ///< its lowest place over the tissue [m]
    // Live tuning (sim/step/live_tuning.h).
    kTuned = 70,  ///< value = the new value, element = TuneParameter, tissue = which one, hash =
                  ///< frame before which it was done
    // Sums, told now and then and after the last frame.
    kStretchSum = 80,  ///< over-stretch of one tissue since the last such event: value = rest
                       ///< volume x time [m^3 s], value2 = largest principal stretch, element and
                       ///< place = where that was. An attempt has one at its first frame, so that
                       ///< its absence says "not recorded"
    kThermalSpread = 81,  ///< at the end, one for each ray that crosses an incision: value = how
                          ///< far beyond the edge Omega is above 1 [m], value2 = the same for CEM43
                          ///< above 240 min [m], rest_position = the edge, element = 2 * point of
                          ///< the planned contour + side (0 towards the placode, 1 outwards). The
                          ///< first has element -1 and value = number of rays: its absence says
                          ///< "not recorded"
    kTakenOut = 82,  ///< marked tissue drawn out of the field as pieces: value = its rest volume so
                     ///< far [m^3], value2 = its share of all that is marked. One at the first
                     ///< frame, one with every piece that goes, one after the last frame (value2 of
                     ///< kPieceOut counts all that is gone). The last has where most of the rest
                     ///< hangs in rest_position (0 0 0 = none)
    kMarkedLost = 83,  ///< after the last frame: marked tissue that went otherwise (burned, torn,
                       ///< washed away as crumbs), as above
    kRingGap = 84,  ///< after the last frame, one for each stretch of the planned contour that is
                    ///< not cut: value = its length [m], rest_position = its middle. The first has
                    ///< element -1, value = their number, value2 = ring_share()
    kLedgerWritten = 85,  ///< at the first frame: value = kLedgerVersion. What a ledger without it
                          ///< lacks is not known
    kSlitGap = 86,  ///< after the last frame, one for each station along a slit: value = how far
                    ///< its walls stand apart [m], the least over the depth, value2 = the same at
                    ///< the surface, element = station, rest_position = its middle. The first has
                    ///< element -1, value = number of stations, value2 = depth of the slit [m]
    kWatertight = 87,  ///< after the last frame, a slit under pressure (sim/step/watertight.h):
                       ///< value = leak [m3/s], value2 = pressure [Pa], element = station, -1 = of
                       ///< all, -2 = the pressure at which it burst, or the highest where it held.
                       ///< Stations follow each -1, and stand before the -2
    kPatchEdge = 88,   ///< after the last frame, one for each point of the placode's edge: value =
                       ///< how far a patch reaches beyond it [m], at most 10 mm, 0 = not over it,
                       ///< element = point, rest_position = the point. The first has element -1,
                       ///< value = number of points, value2 = share of the placode left open
    kPatchFold = 89,   ///< after the last frame: value = area of a patch that lies in folds [m^2],
                       ///< value2 = its whole area [m^2], rest_position = the middle of the folds
    // Needle and thread (sim/suture). Place: on the tissue at rest, or of the jaws for those of the
    // hold. hash = number of the channel, 1 for the first bite.
    kNeedleTaken = 90,  ///< jaws closed on the needle: value = where, from the point [m], value2 =
                        ///< the same as a share of the arc
    kNeedleReleased = 91,  ///< jaws let go of it: value = seconds held, value2 = peak pull [N]
    kNeedleSlipped = 92,   ///< it slid through the jaws (raised when it ends): value = seconds,
                           ///< value2 = peak pull along the wire [N]
    kNeedleTurned = 93,    ///< it turned in the jaws, likewise: value2 = peak torque [N m]
    kNeedleEntered = 94,   ///< its point opened a surface: value = force [N], value2 = sine of the
                           ///< angle between its way and the surface at rest
    kNeedleLeft = 95,  ///< it came out on the far side: value = force [N], value2 = deepest place
                       ///< of the channel below the surface at rest [m]
    kNeedleWithdrawn = 96,  ///< it was drawn back out of its entry
    kNeedleThrough = 97,    ///< its swage has left the channel
    kPassageLost = 98,      ///< tissue around needle or thread is gone (burned, torn)
    kThreaded = 99,         ///< thread runs through the channel from end to end
    kThreadOut = 100,       ///< an end of the thread has left a channel, which is empty
    kThreadCut = 101,       ///< thread cut through the mouth of its channel: value = load [N/m]
    kThreadToreOut = 102,   ///< and through the last of it, likewise
    // Irrigation and suction (sim/fluid).
    kJetOnPlacode = 103,  ///< a jet pressed on the placode with more than kJetLimitPa (raised when
                          ///< it ends): value = seconds, value2 = peak pressure [Pa]
    kSuctionHeld = 104,   ///< suction held tissue (raised when it ends): value = seconds, value2 =
                          ///< peak pull [N]
    kIrrigated = 105,     ///< after the last frame, sums: element = IrrigationSum, which says what
                          ///< value and value2 are
    kDebrisLeft = 106,  ///< after the last frame, one for each crumb or spot that is left: value =
                        ///< DebrisKind, value2 = 0 stuck, 1 loose, element = its number
    // Undermining (sim/step/undermining_when_let_go.h), after the last frame.
    kUndermined = 110,  ///< one for each line from a station of the slit outwards: value = how far
                        ///< the skin is undermined there [m], value2 = side (1 left, -1 right),
                        ///< element = line, rest_position = the edge. Element -1: value = number
                        ///< of lines; -2: value, value2 = area undermined left, right [m^2];
                        ///< -3: the same of what is to be freed, -4: of that what is free; -5:
                        ///< free beyond what may be
    kClosingTension = 111,  ///< pull of the edges at the midline: value = now, value2 = before
                            ///< anything was done [N/m], element = station of the slit,
                            ///< rest_position = its middle; -1 = of all
    // More of a slit under pressure (sim/step/watertight.h), after the last frame.
    kSlitPressed = 112,  ///< one after each kWatertight of a station: value = how far its walls
                         ///< stand apart under that pressure [m], the least over the depth, value2
                         ///< = the pressure [Pa], element = station, rest_position = its middle
    kSlitOpened = 113,   ///< one for each station: value = pressure at which more than a hundredth
                         ///< of a burst first passed there, or the highest of the test where it
                         ///< never did [Pa], value2 = 1 opened, 0 not, element = station,
    ///< rest_position = its middle. The first has element -1, value = number of
    ///< stations, value2 = 1 where the slit burst, 0 where it held
    // A needle that may go from hand to hand: scenes with two drivers. Place: of the jaws.
    kNeedleGrip = 114,  ///< with each kNeedleTaken: value = cosine of the angle between the
                        ///< needle's axis and the shaft (1 = its plane is square to it), value2 =
                        ///< cosine of that between the wire and the jaws' width (1 = the wire is)
    kNeedleHandedOver = 115,  ///< it went to another driver, tool = this one: value = sine of half
                              ///< the angle by which it turned while both held it, value2 = largest
                              ///< force between them [N], element = how long both held it [ms]; 0
                              ///< of all of these: it was let go in between. Element -1: both held
                              ///< it, and it stayed with tool, or the attempt is over
    kNeedleSwung = 116,  ///< nobody holds it any more, or the attempt is over: value = how far it
                         ///< was turned in hands since it was taken [rad]
    kNeedleLeftIn = 117  ///< the attempt is over with more of the needle in tissue than 2 mm of its
                         ///< tail; place: where it went in last, at rest
};
/// What a kIrrigated event tells: value, value2.
enum class IrrigationSum : int32_t {
    kJet = 0,  ///< Highest pressure on the placode [Pa], seconds above the limit; place = where.
    kFluid,    ///< Left standing, given by jets [m^3].
    kView,     ///< Share of the lesion that blood hides, seconds in which it hid too much.
    kSuction,  ///< Seconds in which suction held tissue, those with the placode.
    kDebris    ///< Crumbs and spots at the start, left.
};
/// Why simulated time stood still. Stored as numbers in recordings: append only.
enum class PauseCause : uint8_t { kMenu = 0, kHelp, kClosing, kFocus, kDevice, kAsleep };
[[nodiscard]] std::string_view event_name(EventKind kind) noexcept;

/// True for events that stand in hundreds in a recording and say nothing by themselves: lost
/// elements, sums, hashes. Lists for people leave them out.
[[nodiscard]] bool only_in_recording(EventKind kind) noexcept;

enum class Phase : uint8_t { kInspect = 0, kIncise, kRelease, kResect, kCheck };
[[nodiscard]] std::string_view phase_name(Phase phase) noexcept;

/// One entry. Trivially copyable.
struct Event {
    double time_s = 0;
    EventKind kind = EventKind::kPhase;
    int8_t tool = -1;  ///< Index into Scene::tools, -1 = none.
    Tissue tissue = Tissue::kSkin;
    float value = 0, value2 = 0;             ///< See EventKind.
    std::array<float, 3> rest_position_m{};  ///< Where, on the rest shape.
    int32_t element = -1;                    ///< Tet or vertex.
    uint64_t hash = 0;
};

/// Bits of StepReport::flags.
enum StepFlag : uint32_t {
    kNotFinite = 1u << 0,          ///< A vertex was not finite and was put back.
    kStepLimited = 1u << 1,        ///< A vertex hit the step limit (1/4 of its shortest edge).
    kContactsDropped = 1u << 2,    ///< More contacts than the scene's capacity.
    kEventsDropped = 1u << 3,      ///< More events in one frame than State can hold.
    kRestShapeRestored = 1u << 4,  ///< A collapsed element was put back into its rest shape.
    kCutRefused = 1u << 5,         ///< No room for a split: raise the scene's spare vertices.
};

}  // namespace placode::sim
