// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/live_warnings.h"

#include <cstring>

#include "curriculum/attempt_sample.h"
#include "sim/cutting/diathermy.h"

namespace placode::curriculum {

namespace {

using sim::EventKind;

constexpr double kNearPlacodeM = 0.001;
constexpr double kAirS = 1, kDwellS = 1;

/// Null for an event that nobody is warned of.
const char* phrase_of(EventKind kind) {
    switch (kind) {
        case EventKind::kOverForce:
            return "Too much force";
        case EventKind::kTorn:
            return "Tissue torn";
        case EventKind::kSlipped:
            return "Grasp slips";
        case EventKind::kCrushed:
            return "Tissue crushed";
        case EventKind::kNeedleSlipped:
            return "Needle slips in the jaws";
        case EventKind::kNeedleTurned:
            return "Needle turns in the jaws";
        case EventKind::kNeedleDropped:
            return "Needle dropped";
        case EventKind::kThreadCut:
            return "Thread cuts through tissue";
        case EventKind::kThreadToreOut:
            return "Thread torn out";
        case EventKind::kOverTraction:
            return "Pulled too hard";
        case EventKind::kPlacodeCut:
            return "Placode cut";
        case EventKind::kPlacodeOverheated:
            return "Placode heated";
        case EventKind::kPlacodeBurned:
            return "Placode burned";
        case EventKind::kNoRoomToCut:
            return "No more cuts in this scene";
        case EventKind::kTargetMissed:
            return "Beside the mark";
        default:
            return nullptr;
    }
}

}  // namespace

LiveWarnings::LiveWarnings(const sim::Scene& scene) : scene_(&scene) {
    if (scene.geometry.placode_edge.size() >= 3) placode_.emplace(scene.geometry.placode_edge);
}

void LiveWarnings::say(const char* phrase, double time_s) noexcept {
    phrase_.fill('\0');
    std::strncpy(phrase_.data(), phrase, phrase_.size() - 1);
    said_s_ = time_s;
}

void LiveWarnings::hear(const sim::Event& event) noexcept {
    const char* phrase = phrase_of(event.kind);
    if (phrase != nullptr) say(phrase, event.time_s);
}

void LiveWarnings::ring_closed(double time_s) noexcept {
    say("Ring closed: lift the needle", time_s);
}

void LiveWarnings::look_at_energy(const sim::State& state, std::span<const sim::ToolInput> inputs,
                                  size_t i, bool sampled) noexcept {
    const sim::ToolState& tool = state.tools[i];
    const sim::ToolLedger& spell = state.ledger.tools[i];
    // A spell outlasts a short pause; it is said while the pedal is down.
    const bool flows = tool.energised != 0;
    if (flows && spell.air_s > kAirS) say("Energy in air", state.time_s);
    if (flows && spell.dwell_s > kDwellS) say("Too long on one spot", state.time_s);
    if (!sampled || !sim::conducts(scene_->tools[i].kind) || inputs[i].pedals == 0) return;
    const sim::Vec2 tip = tool.proxy.p.head<2>();
    if (placode_ && tool.in_contact != 0 && placode_->nearest(tip).offset < kNearPlacodeM)
        say("Too close to the placode", state.time_s);
    if (!tip_in_view(*scene_, state, i)) say("Energy out of view", state.time_s);
}

void LiveWarnings::look(const sim::State& state, std::span<const sim::ToolInput> inputs,
                        bool sampled) noexcept {
    // The worst last, so that it wins.
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        const sim::ToolState& tool = state.tools[i];
        if (scene_->tools[i].kind == sim::ToolKind::kScope) continue;
        look_at_energy(state, inputs, i, sampled);
        if (tool.in_contact != 0 && tool.touched == sim::Tissue::kPlacode &&
            state.ledger.tools[i].contact_s > 0)
            say("Placode touched", state.time_s);
    }
    for (const sim::TipFlow& tip : state.irrigation.tips)
        if (tip.shut > 0.5F) say("Suction holds tissue", state.time_s);
    if (state.irrigation.placode_pa > sim::kJetLimitPa)
        say("Jet presses on the placode", state.time_s);
    for (int i = 0; i < state.event_count; ++i) {
        const char* phrase = phrase_of(state.events[static_cast<size_t>(i)].kind);
        if (phrase != nullptr) say(phrase, state.time_s);
    }
    events_ = sampled ? buried_.look(*scene_, state) : std::span<const sim::Event>{};
    if (sampled && buried_.warns(state.time_s)) say("Stuck in tissue: draw back", state.time_s);
}

}  // namespace placode::curriculum
