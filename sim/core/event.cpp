// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/core/event.h"

namespace placode::sim {

std::string_view event_name(EventKind kind) noexcept {
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
        case EventKind::kRestored:
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
        case EventKind::kNoRoomToCut:
            return "no_room_to_cut";
        case EventKind::kPracticeSteps:
            return "practice_steps";
        case EventKind::kStepDone:
            return "step_done";
        case EventKind::kTargetTouched:
            return "target_touched";
        case EventKind::kTargetMissed:
            return "target_missed";
        case EventKind::kTraced:
            return "traced";
        case EventKind::kTractionHeld:
            return "traction_held";
        case EventKind::kBiteEntry:
            return "bite_entry";
        case EventKind::kBiteExit:
            return "bite_exit";
        case EventKind::kBiteMark:
            return "bite_mark";
        case EventKind::kThreadDrawn:
            return "thread_drawn";
        case EventKind::kTuned:
            return "tuned";
        case EventKind::kStretchSum:
            return "stretch_sum";
        case EventKind::kThermalSpread:
            return "thermal_spread";
        case EventKind::kTakenOut:
            return "taken_out";
        case EventKind::kMarkedLost:
            return "marked_lost";
        case EventKind::kRingGap:
            return "ring_gap";
        case EventKind::kLedgerWritten:
            return "ledger_written";
        case EventKind::kSlitGap:
            return "slit_gap";
        case EventKind::kWatertight:
            return "watertight";
        case EventKind::kPatchEdge:
            return "patch_edge";
        case EventKind::kPatchFold:
            return "patch_fold";
        case EventKind::kNeedleTaken:
            return "needle_taken";
        case EventKind::kNeedleReleased:
            return "needle_released";
        case EventKind::kNeedleSlipped:
            return "needle_slipped";
        case EventKind::kNeedleTurned:
            return "needle_turned";
        case EventKind::kNeedleEntered:
            return "needle_entered";
        case EventKind::kNeedleLeft:
            return "needle_left";
        case EventKind::kNeedleWithdrawn:
            return "needle_withdrawn";
        case EventKind::kNeedleThrough:
            return "needle_through";
        case EventKind::kPassageLost:
            return "passage_lost";
        case EventKind::kThreaded:
            return "threaded";
        case EventKind::kThreadOut:
            return "thread_out";
        case EventKind::kThreadCut:
            return "thread_cut";
        case EventKind::kThreadToreOut:
            return "thread_tore_out";
        case EventKind::kJetOnPlacode:
            return "jet_on_placode";
        case EventKind::kSuctionHeld:
            return "suction_held";
        case EventKind::kIrrigated:
            return "irrigated";
        case EventKind::kDebrisLeft:
            return "debris_left";
        case EventKind::kUndermined:
            return "undermined";
        case EventKind::kClosingTension:
            return "closing_tension";
        case EventKind::kSlitPressed:
            return "slit_pressed";
        case EventKind::kSlitOpened:
            return "slit_opened";
        case EventKind::kNeedleGrip:
            return "needle_grip";
        case EventKind::kNeedleHandedOver:
            return "needle_handed_over";
        case EventKind::kNeedleSwung:
            return "needle_swung";
        case EventKind::kNeedleLeftIn:
            return "needle_left_in";
        case EventKind::kNeedlePlaced:
            return "needle_placed";
        case EventKind::kNeedleShown:
            return "needle_shown";
        case EventKind::kNeedleLaid:
            return "needle_laid";
        case EventKind::kNeedleDropped:
            return "needle_dropped";
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
    return kind == EventKind::kVaporised || kind == EventKind::kStateHash ||
           kind == EventKind::kStretchSum || kind == EventKind::kThermalSpread ||
           kind == EventKind::kTakenOut || kind == EventKind::kMarkedLost ||
           kind == EventKind::kRingGap || kind == EventKind::kSlitGap ||
           kind == EventKind::kWatertight || kind == EventKind::kLedgerWritten ||
           kind == EventKind::kPatchEdge || kind == EventKind::kPatchFold ||
           kind == EventKind::kIrrigated || kind == EventKind::kDebrisLeft ||
           kind == EventKind::kUndermined || kind == EventKind::kClosingTension ||
           kind == EventKind::kSlitPressed || kind == EventKind::kSlitOpened;
}

}  // namespace placode::sim
