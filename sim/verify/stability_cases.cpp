// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/verify/stability_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "sim/core/event.h"
#include "sim/core/number_text.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/step/step.h"
#include "sim/verify/random_pokes.h"
#include "sim/verify/stability_block.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

constexpr double kCheck = 0.01;  // between two looks [s]
constexpr double kRestoreEvery = 0.256;

void put(SoftBodyState& state, size_t v, const Vec3& p) {
    state.x[v] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()),
                  state.x[v].w};
}

using Disturb = std::function<void(const SoftBody&, SoftBodyState&)>;

/// Runs the bare solver on a disturbed block.
void run_block(StabilityResult& result, const StabilityBlock& block, Method method, double seconds,
               const Disturb& disturb) {
    const SoftBody body(block_spec(block, method));
    SoftBodyState state(body);
    Workers workers(1);
    disturb(body, state);
    const SolverSettings& s = body.spec().solver;
    const double h = s.frame_s / s.substeps;
    const auto count = static_cast<int64_t>(seconds / h);
    const auto look = std::max<int64_t>(1, static_cast<int64_t>(kCheck / h));
    const auto search = std::max<int64_t>(1, static_cast<int64_t>(kRestoreEvery / h));
    BlockWatch watch;
    watch.look(0, shape_of(body, state));
    bool restored = false;
    for (int64_t n = 1; n <= count; ++n) {
        begin_substep(body, state, h, workers);
        for (int i = 0; i < s.iterations; ++i) sweep(body, state, h, workers);
        end_substep(body, state, h, workers);
        if (n % search == 0) restored |= restore_collapsed(body, state) > 0;
        if (n % look == 0) watch.look(static_cast<double>(n) * h, shape_of(body, state));
    }
    watch.finish(result, restored);
}

/// StabilityBlock with probes of 1 mm radius and a hand of 600 N/m.
Scene probe_scene(const StabilityBlock& block, Method method, int tools) {
    Scene scene{SoftBody(block_spec(block, method))};
    scene.id = "block";
    for (const Vec3& x : scene.body.mesh().rest) {
        scene.field.depth_m.push_back(static_cast<float>(kCells * kCell / 2 - x.z()));
    }
    ToolSpec tool;
    tool.kind = ToolKind::kProbe;
    tool.tip_radius_m = tool.shaft_radius_m = 0.001;
    scene.tools.assign(static_cast<size_t>(tools), tool);
    return scene;
}

/// Hands that follow `path(tool, time)`: tip and direction.
using Path = std::function<Pose(int tool, double time)>;

void run_probes(StabilityResult& result, const StabilityBlock& block, Method method, int tools,
                double seconds, const Path& path) {
    const Scene scene = probe_scene(block, method, tools);
    State state(scene, 1);
    std::vector<ToolInput> inputs(static_cast<size_t>(tools));
    std::vector<ToolFeedback> feedback(inputs.size());
    BlockWatch watch;
    double force = 0, deepest = 0;
    const double frame_s = block.frame_s;
    const auto frames = static_cast<int64_t>(seconds / frame_s);
    for (int64_t n = 1; n <= frames; ++n) {
        for (int t = 0; t < tools; ++t) {
            inputs[static_cast<size_t>(t)].set_pose(path(t, static_cast<double>(n) * frame_s));
            inputs[static_cast<size_t>(t)].engaged = 1;
        }
        step(scene, state, inputs, feedback);
        for (int t = 0; t < tools; ++t) {
            force = std::max(force, feedback[static_cast<size_t>(t)].force_n.norm());
            deepest = std::max(deepest, penetration(state, t, 1e-4));
        }
        if (n % 10 == 0) {
            watch.look(static_cast<double>(n) * frame_s, shape_of(scene.body, state.body));
        }
    }
    watch.finish(result, false);
    result.detail += (result.detail.empty() ? "" : "; ") + std::string("peak force ") +
                     rounded_text(force, 3) + " N, deepest " + length_text(deepest);
}

Quat pointing(const Vec3& distal) { return Quat::FromTwoVectors(Vec3::UnitZ(), distal); }

void run_through(StabilityResult& result, Method method, double seconds) {
    StabilityBlock block;
    block.hold_bottom = true;
    const double top = kCells * kCell / 2;
    // One frame from 2 mm above to 2 mm below the whole block, and back up after half the time.
    run_probes(result, block, method, 1, seconds, [&](int, double t) {
        const bool down = t > 0.1 && t < seconds / 2;
        return Pose{Vec3(0.0002, 0.0001, down ? -top - 0.002 : top + 0.002),
                    pointing(-Vec3::UnitZ())};
    });
}

void run_squeeze(StabilityResult& result, Method method, double seconds) {
    StabilityBlock block;
    const double side = kCells * kCell / 2;
    // From both sides to 60 % of the width within 0.2 s, held, and let go in the second half.
    run_probes(result, block, method, 2, seconds, [&](int tool, double t) {
        const double in = t < seconds / 2 ? std::min(1.0, t / 0.2) * 0.0012 : -0.004;
        const double sign = tool == 0 ? 1 : -1;
        return Pose{Vec3(sign * (side - in), 0.0001, 0.0002), pointing(Vec3(-sign, 0, 0))};
    });
}

void run_pokes(StabilityResult& result, Method method, const StabilityOptions& options) {
    StabilityBlock block;
    block.hold_bottom = true;
    Scene scene = probe_scene(block, method, 1);
    scene.tools[0] = ToolSpec{};  // a needle
    State state(scene, 1);
    PokeOptions pokes;
    pokes.frames = options.poke_frames;
    pokes.longest_drag_m = 0.001;
    if (options.progress) {
        pokes.progress = [&](int64_t done) {
            options.progress("random pokes, " + result.method + ": " + std::to_string(done) +
                             " frames");
        };
    }
    const PokeReport report = random_pokes(scene, state, pokes);
    result.error = report.deepest_m;
    const bool sound = report.not_finite == 0 && report.p99_m < 1e-4 && report.deepest_m < 3e-4;
    result.verdict = sound ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    result.detail = std::to_string(report.touching) + " of " + std::to_string(report.frames) +
                    " frames in touch, penetration p50 " + length_text(report.median_m) + ", p99 " +
                    length_text(report.p99_m) + ", max " + length_text(report.deepest_m) +
                    ", peak force " + rounded_text(report.largest_force_n, 3) + " N";
}

void run_rest(StabilityResult& result, Method method, double seconds) {
    StabilityBlock block;
    block.hold_bottom = true;
    // Undamped where nothing has to come to rest first.
    if (method != Method::kXpbdPair) block.damping_per_s = 0;
    const SoftBody body(block_spec(block, method));
    SoftBodyState state(body);
    Workers workers(1);
    const SolverSettings& s = body.spec().solver;
    const double h = s.frame_s / s.substeps;
    const auto run = [&](double time) {
        for (auto n = static_cast<int64_t>(time / h); n > 0; --n) {
            begin_substep(body, state, h, workers);
            sweep(body, state, h, workers);
            end_substep(body, state, h, workers);
        }
    };
    // The sequential pair finds a rest shape of its own in the first moments (its two constraints
    // are both loaded at rest and are solved one after the other); from then on nothing may move.
    run(0.5);
    std::vector<Vec3> settled;
    double own = 0;
    for (int32_t v = 0; v < body.vertex_count(); ++v) {
        settled.push_back(place_of(state, v));
        own = std::max(own, (settled.back() - body.mesh().rest[static_cast<size_t>(v)]).norm());
    }
    run(seconds);
    for (int32_t v = 0; v < body.vertex_count(); ++v) {
        const double moved = (place_of(state, v) - settled[static_cast<size_t>(v)]).norm();
        result.error = std::isfinite(moved) ? std::max(result.error, moved) : 1.0;
    }
    // A unit in the last place of 3 mm is 0.2 nm.
    result.verdict = result.error < 1e-6 ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    result.detail = "moved " + length_text(result.error) + " in " + rounded_text(seconds, 3) +
                    " s; its rest shape lies " + length_text(own) + " from the body's";
}

Disturb stretch(double factor) {
    return [factor](const SoftBody& body, SoftBodyState& state) {
        for (size_t v = 0; v < state.x.size(); ++v) {
            Vec3 p = body.mesh().rest[v];
            p.x() *= factor;
            put(state, v, p);
        }
    };
}

Disturb flatten(double factor) {
    return [factor](const SoftBody& body, SoftBodyState& state) {
        for (size_t v = 0; v < state.x.size(); ++v) {
            Vec3 p = body.mesh().rest[v];
            p.z() *= factor;
            put(state, v, p);
        }
    };
}

Disturb scramble() {
    return [](const SoftBody&, SoftBodyState& state) {
        uint32_t seed = 12345;
        const auto next = [&seed] {
            seed = seed * 1664525u + 1013904223u;  // Numerical Recipes' generator
            return (static_cast<double>(seed >> 8) / 16777216.0 - 0.5) * kCells * kCell;
        };
        for (size_t v = 0; v < state.x.size(); ++v) {
            const double x = next(), y = next(), z = next();
            put(state, v, Vec3(x, y, z));
        }
    };
}

Disturb collapse() {
    return [](const SoftBody&, SoftBodyState& state) {
        for (size_t v = 0; v < state.x.size(); ++v) put(state, v, Vec3(1e-3, 2e-3, 3e-3));
    };
}

const char* method_name(Method method) noexcept {
    switch (method) {
        case Method::kVbd:
            return "vbd";
        case Method::kXpbd:
            return "xpbd";
        case Method::kXpbdPair:
            return "xpbd_pair";
    }
    return "?";
}

}  // namespace

const char* verdict_name(StabilityVerdict verdict) noexcept {
    switch (verdict) {
        case StabilityVerdict::kHolds:
            return "holds";
        case StabilityVerdict::kRecovers:
            return "recovers";
        case StabilityVerdict::kRestored:
            return "re-seeded";
        case StabilityVerdict::kRefused:
            return "refused at load";
        case StabilityVerdict::kFails:
            return "FAILS";
    }
    return "?";
}

std::vector<std::string> stability_case_names() {
    return {"flat",        "mirrored", "random cube", "exact point",    "stretch 50 %",
            "mass 1:1000", "nu 0.499", "slivers",     "frames of 4 ms", "pushed through",
            "squeezed",    "rest",     "random pokes"};
}

StabilityResult run_stability_case(const std::string& name, Method method,
                                   const StabilityOptions& options) {
    StabilityResult result;
    result.name = name;
    result.method = method_name(method);
    StabilityBlock block;
    const double t = options.seconds;
    try {
        if (name == "flat") {
            run_block(result, block, method, t, flatten(0));
        } else if (name == "mirrored") {
            run_block(result, block, method, t, flatten(-1));
        } else if (name == "random cube") {
            run_block(result, block, method, t, scramble());
        } else if (name == "exact point") {
            run_block(result, block, method, t, collapse());
        } else if (name == "stretch 50 %") {
            run_block(result, block, method, t, stretch(1.5));
        } else if (name == "mass 1:1000") {
            block.dense_kg_m3 = 1e6;
            run_block(result, block, method, 4 * t, stretch(1.2));
        } else if (name == "nu 0.499") {
            block.poissons_ratio = 0.499;
            run_block(result, block, method, t, stretch(1.2));
        } else if (name == "slivers") {
            block.thin_m = 1e-5;  // quality 6 sqrt(2) V / l_rms^3 of its tets: 0.01 to 0.02
            run_block(result, block, method, t, stretch(1.2));
        } else if (name == "frames of 4 ms") {
            block.frame_s = 4e-3;
            run_block(result, block, method, t, stretch(1.2));
        } else if (name == "pushed through") {
            run_through(result, method, t);
        } else if (name == "squeezed") {
            run_squeeze(result, method, t);
        } else if (name == "rest") {
            run_rest(result, method, options.rest_seconds);
        } else if (name == "random pokes") {
            run_pokes(result, method, options);
        } else {
            throw std::invalid_argument("no stability case named " + name);
        }
    } catch (const MeshError& e) {
        result.verdict = StabilityVerdict::kRefused;
        result.detail = e.what();
    }
    return result;
}

}  // namespace placode::sim
