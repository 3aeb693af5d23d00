// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/event.h"

#include "sim/damage.h"
#include "sim/practice.h"
#include "sim/reached.h"
#include "sim/retune.h"

namespace placode::sim {

std::string_view event_name(EventKind kind) noexcept {
    if (kind == kPracticeSteps) return "practice_steps";
    if (kind == kStepDone) return "step_done";
    if (kind == kTargetTouched) return "target_touched";
    if (kind == kTargetMissed) return "target_missed";
    if (kind == kTraced) return "traced";
    if (kind == kTractionHeld) return "traction_held";
    if (kind == kStretchSum) return "stretch_sum";
    if (kind == kThermalSpread) return "thermal_spread";
    if (kind == kTakenOut) return "taken_out";
    if (kind == kMarkedLost) return "marked_lost";
    if (kind == kRingGap) return "ring_gap";
    if (kind == kLedgerWritten) return "ledger_written";
    if (kind == kTuned) return "tuned";
    switch (kind) {
        case EventKind::kPhase:
            return "phase";
        case EventKind::kEnergyOn:
            return "energy_on";
        case EventKind::kEnergyOff:
            return "energy_off";
        case EventKind::kEnergyInAir:
            return "energy_in_air";
        case EventKind::kDwell:
            return "dwell";
        case EventKind::kVaporised:
            return "vaporised";
        case EventKind::kTorn:
            return "torn";
        case EventKind::kPlacodeContact:
            return "placode_contact";
        case EventKind::kPlacodeEnergised:
            return "placode_energised";
        case EventKind::kPlacodeOverheated:
            return "placode_overheated";
        case EventKind::kPlacodeBurned:
            return "placode_burned";
        case EventKind::kOverForce:
            return "over_force";
        case EventKind::kOverStretch:
            return "over_stretch";
        case EventKind::kTetherBroken:
            return "tether_broken";
        case EventKind::kSubsteps:
            return "substeps";
        case EventKind::kStateHash:
            return "state_hash";
        case EventKind::kReseeded:
            return "reseeded";
        case EventKind::kFinished:
            return "finished";
        case EventKind::kGrasped:
            return "grasped";
        case EventKind::kReleased:
            return "released";
        case EventKind::kSlipped:
            return "slipped";
        case EventKind::kCrushed:
            return "crushed";
        case EventKind::kOverTraction:
            return "over_traction";
        case EventKind::kSnipped:
            return "snipped";
        case EventKind::kPlacodeCut:
            return "placode_cut";
        case EventKind::kPieceFree:
            return "piece_free";
        case EventKind::kPieceOut:
            return "piece_out";
        case EventKind::kCrumb:
            return "crumb";
        case EventKind::kSectorFree:
            return "sector_free";
        case EventKind::kSacOpened:
            return "sac_opened";
        case EventKind::kBuried:
            return "buried";
        case EventKind::kPaused:
            return "paused";
        case EventKind::kMachineSpeed:
            return "machine_speed";
        case EventKind::kSlowSpell:
            return "slow_spell";
    }
    return "unknown";
}

std::string_view phase_name(Phase phase) noexcept {
    switch (phase) {
        case Phase::kInspect:
            return "inspect";
        case Phase::kIncise:
            return "incise";
        case Phase::kRelease:
            return "release";
        case Phase::kResect:
            return "resect";
        case Phase::kCheck:
            return "check";
    }
    return "unknown";
}

bool only_in_recording(EventKind kind) noexcept {
    return kind == EventKind::kVaporised || kind == EventKind::kStateHash || kind == kStretchSum ||
           kind == kThermalSpread || kind == kTakenOut || kind == kMarkedLost || kind == kRingGap ||
           kind == kLedgerWritten;
}

}  // namespace placode::sim
