// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/verify/stability_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "sim/event.h"
#include "sim/number_text.h"
#include "sim/reseed.h"
#include "sim/step.h"
#include "sim/verify/random_pokes.h"

namespace placode::sim {
namespace {

constexpr double kCell = 0.001;      // edge of the block's cells [m]
constexpr int kCells = 6;            // along each side
constexpr double kEdgeBound = 0.02;  // an edge within 2 % of its rest length counts as back
constexpr double kCheck = 0.01;      // between two looks [s]
constexpr double kReseedEvery = 0.256;

/// What a case changes on the block (5 kPa, nu 0.45, cells of 1 mm, free; VBD with its usual 4
/// substeps a frame, XPBD with the 8 that its Courant number asks for).
struct Block {
    double poissons_ratio = 0.45, frame_s = 1e-3, damping_per_s = 20;
    double dense_kg_m3 = 1000;  // of its upper half
    double thin_m = 0;          // thickness of the middle layer, 0 = like the others
    bool hold_bottom = false;
    Vec3 gravity = Vec3::Zero();
};

SoftBodySpec block_spec(const Block& block, Method method) {
    SoftBodySpec spec;
    TetMesh box = box_mesh(Vec3(1, 1, 1) * (kCells * kCell), {kCells, kCells, kCells});
    for (Vec3& x : box.rest) {
        x -= Vec3(1, 1, 1) * (kCells * kCell / 2);
        if (block.thin_m > 0 && x.z() > kCell / 2) x.z() -= kCell - block.thin_m;
    }
    for (size_t t = 0; t < box.tets.size(); ++t) {
        double z = 0;
        for (const int32_t v : box.tets[t]) z += box.rest[static_cast<size_t>(v)].z() / 4;
        if (z > 0) box.tissue[t] = Tissue::kMuscle;
    }
    spec.mesh = renumbered(box, rcm_order(box));
    Material m;
    m.poissons_ratio = block.poissons_ratio;
    m.damping_per_s = block.damping_per_s;
    m.fail_stretch = m.injury_stretch = 1000;
    spec.materials.fill(m);
    spec.materials[static_cast<size_t>(Tissue::kMuscle)].density_kg_m3 = block.dense_kg_m3;
    spec.solver.method = method;
    spec.solver.frame_s = block.frame_s;
    spec.solver.substeps = method == Method::kVbd ? 4 : 8;
    spec.solver.over_relaxation = 1.0;
    spec.solver.gravity_m_s2 = block.gravity;
    for (size_t v = 0; v < spec.mesh.rest.size(); ++v) {
        if (block.hold_bottom && spec.mesh.rest[v].z() < -kCells * kCell / 2 + 1e-9) {
            spec.fixed.push_back(static_cast<int32_t>(v));
        }
    }
    return spec;
}

Vec3 at(const SoftBodyState& state, int32_t v) {
    const Float4& x = state.x[static_cast<size_t>(v)];
    return {x.x, x.y, x.z};
}

void put(SoftBodyState& state, size_t v, const Vec3& p) {
    state.x[v] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()),
                  state.x[v].w};
}

struct Shape {
    double worst_edge = 0;  // |length / rest - 1|
    int inverted = 0;
    bool finite = true;
    [[nodiscard]] bool sound() const { return finite && inverted == 0 && worst_edge < kEdgeBound; }
};

Shape shape_of(const SoftBody& body, const SoftBodyState& state) {
    Shape shape;
    for (int t = 0; t < body.tet_count(); ++t) {
        const auto& k = body.mesh().tets[static_cast<size_t>(t)];
        Mat3 edges;
        for (int i = 1; i < 4; ++i) edges.col(i - 1) = at(state, k[i]) - at(state, k[0]);
        if (!edges.allFinite()) shape.finite = false;
        if (!(edges.determinant() > 0)) ++shape.inverted;
        for (int i = 1; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                const double rest = (body.mesh().rest[static_cast<size_t>(k[i])] -
                                     body.mesh().rest[static_cast<size_t>(k[j])])
                                        .norm();
                const double now = (at(state, k[i]) - at(state, k[j])).norm();
                shape.worst_edge = std::max(shape.worst_edge, std::abs(now / rest - 1));
            }
        }
    }
    return shape;
}

std::string microns(double metres) { return rounded_text(1e6 * metres, 3) + " um"; }

std::string describe(const Shape& shape) {
    if (!shape.finite) return "not finite";
    return std::to_string(shape.inverted) + " inverted tets, worst edge off by " +
           rounded_text(100 * shape.worst_edge, 3) + " %";
}

/// Follows a shape that was disturbed: when was it back for good?
class Watch {
 public:
    void look(double time, const Shape& shape) {
        last_ = shape;
        if (shape.sound()) {
            if (back_ < 0) back_ = time;
        } else {
            back_ = -1;
            left_ = true;
        }
        if (!shape.finite) never_finite_ = true;
    }
    void finish(StabilityResult& result, bool reseeded) const {
        result.error = last_.worst_edge;
        result.seconds = std::max(back_, 0.0);
        if (never_finite_ || back_ < 0) {
            result.verdict = StabilityVerdict::kFails;
            result.detail = never_finite_ ? "not finite" : "at the end " + describe(last_);
        } else {
            result.verdict = reseeded ? StabilityVerdict::kReseeded
                             : left_  ? StabilityVerdict::kRecovers
                                      : StabilityVerdict::kHolds;
        }
    }

 private:
    Shape last_;
    double back_ = -1;
    bool left_ = false, never_finite_ = false;
};

using Disturb = std::function<void(const SoftBody&, SoftBodyState&)>;

/// Runs the bare solver on a disturbed block.
void run_block(StabilityResult& result, const Block& block, Method method, double seconds,
               const Disturb& disturb) {
    const SoftBody body(block_spec(block, method));
    SoftBodyState state(body);
    Workers workers(1);
    disturb(body, state);
    const SolverSettings& s = body.spec().solver;
    const double h = s.frame_s / s.substeps;
    const auto count = static_cast<int64_t>(seconds / h);
    const auto look = std::max<int64_t>(1, static_cast<int64_t>(kCheck / h));
    const auto search = std::max<int64_t>(1, static_cast<int64_t>(kReseedEvery / h));
    Watch watch;
    watch.look(0, shape_of(body, state));
    bool reseeded = false;
    for (int64_t n = 1; n <= count; ++n) {
        begin_substep(body, state, h, workers);
        for (int i = 0; i < s.iterations; ++i) sweep(body, state, h, workers);
        end_substep(body, state, h, workers);
        if (n % search == 0) reseeded |= reseed_collapsed(body, state) > 0;
        if (n % look == 0) watch.look(static_cast<double>(n) * h, shape_of(body, state));
    }
    watch.finish(result, reseeded);
}

/// Block with probes of 1 mm radius and a hand of 600 N/m.
Scene probe_scene(const Block& block, Method method, int tools) {
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

void run_probes(StabilityResult& result, const Block& block, Method method, int tools,
                double seconds, const Path& path) {
    const Scene scene = probe_scene(block, method, tools);
    State state(scene, 1);
    std::vector<ToolInput> inputs(static_cast<size_t>(tools));
    std::vector<ToolFeedback> feedback(inputs.size());
    Watch watch;
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
                     rounded_text(force, 3) + " N, deepest " + microns(deepest);
}

Quat pointing(const Vec3& distal) { return Quat::FromTwoVectors(Vec3::UnitZ(), distal); }

void run_through(StabilityResult& result, Method method, double seconds) {
    Block block;
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
    Block block;
    const double side = kCells * kCell / 2;
    // From both sides to 60 % of the width within 0.2 s, held, and let go in the second half.
    run_probes(result, block, method, 2, seconds, [&](int tool, double t) {
        const double in = t < seconds / 2 ? std::min(1.0, t / 0.2) * 0.0012 : -0.004;
        const double sign = tool == 0 ? 1 : -1;
        return Pose{Vec3(sign * (side - in), 0.0001, 0.0002), pointing(Vec3(-sign, 0, 0))};
    });
}

void run_pokes(StabilityResult& result, Method method, const StabilityOptions& options) {
    Block block;
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
                    " frames in touch, penetration p50 " + microns(report.median_m) + ", p99 " +
                    microns(report.p99_m) + ", max " + microns(report.deepest_m) + ", peak force " +
                    rounded_text(report.largest_force_n, 3) + " N";
}

void run_rest(StabilityResult& result, Method method, double seconds) {
    Block block;
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
        settled.push_back(at(state, v));
        own = std::max(own, (settled.back() - body.mesh().rest[static_cast<size_t>(v)]).norm());
    }
    run(seconds);
    for (int32_t v = 0; v < body.vertex_count(); ++v) {
        const double moved = (at(state, v) - settled[static_cast<size_t>(v)]).norm();
        result.error = std::isfinite(moved) ? std::max(result.error, moved) : 1.0;
    }
    // A unit in the last place of 3 mm is 0.2 nm.
    result.verdict = result.error < 1e-6 ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    result.detail = "moved " + microns(result.error) + " in " + rounded_text(seconds, 3) +
                    " s; its rest shape lies " + microns(own) + " from the body's";
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
        case StabilityVerdict::kReseeded:
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
    Block block;
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
