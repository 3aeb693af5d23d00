// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/grasp.h"

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"
#include "sim/solver/vertex_stiffness.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kReach = 0.0006;        // tissue this far beyond the tips is still bitten [m]
constexpr double kTipOverhang = 0.0003;  // slid further than that beyond the reach: out [m]
constexpr double kSideOverhang = 0.0005;
constexpr double kLeastBite = 0.001;      // of the bitten length along the jaw [m]
constexpr float kLetGo = 1.25f;           // opening against that of the grasp at which jaws let go
constexpr double kSqueeze = 0.5;          // jaws squeezed fully leave this share of the thickness
constexpr double kSlipPerSubstep = 2e-5;  // so that a slip is a slide, not a jump [m]
constexpr float kSlipNotice = 3e-4f;      // less is tissue settling between closing jaws [m]
constexpr float kSlipEnds = 0.1f;         // without slipping this long, the slip is over [s]
constexpr float kTractionS = 0.3f;   // above the limit it counts from here on, below it ends [s]
constexpr double kCarryStep = 1e-4;  // tissue follows closing jaws at most so far a substep [m]

/// Where a held vertex belongs now, in T.
Vec3 place_T(const Grasp& g, const GraspedVertex& held) noexcept {
    const double closed =
        g.meet_rad > 0 ? std::clamp(static_cast<double>(g.jaw_rad) / g.meet_rad, 0.0, 1.0) : 1.0;
    return {held.at_T[0], held.at_T[1] * (kSqueeze + (1 - kSqueeze) * closed), held.at_T[2]};
}

bool lives(const Scene& scene, const State& state, int v) noexcept {
    if (scene.patch && scene.patch->owns(v)) return true;
    const auto around = tets_around(scene.body, state.body, v);
    return std::any_of(around.begin(), around.end(),
                       [&](int32_t t) { return state.body.tet_alive[t] != 0; });
}

void drop(const Scene& scene, State& state, Grasp& g, int i) noexcept {
    const int v = g.held[i].vertex;
    state.held_by[v] = -1;
    rouse(state.body, v);
    if (lives(scene, state, v)) state.body.x[v].w = 1.0F / mass_of(scene.body, state.body, v);
    g.held[i] = g.held[--g.count];
}

Event grasp_event(const State& state, EventKind kind, int tool) noexcept {
    const Grasp& g = state.grasps[tool];
    Event e;
    e.time_s = state.time_s;
    e.kind = kind;
    e.tool = static_cast<int8_t>(tool);
    e.tissue = g.tissue;
    e.rest_position_m = g.rest_m;
    e.element = g.tet;
    return e;
}

/// Most frequent tissue among the surface triangles of the bite; and where it is at rest.
void describe(const Scene& scene, State& state, int t) noexcept {
    Grasp& g = state.grasps[t];
    std::array<int, kTissueCount> count{};
    double low = 0, high = -1;
    Vec3 rest = Vec3::Zero();
    g.tet = -1;
    for (int i = 0; i < g.count; ++i) {
        for (const int32_t tet : tets_around(scene.body, state.body, g.held[i].vertex)) {
            if (!state.body.tet_alive[tet]) continue;
            ++count[static_cast<int>(scene.body.mesh().tissue[tet])];
            g.tet = tet;
        }
        rest += scene.body.mesh().rest[origin_of(state.body, g.held[i].vertex)] / g.count;
        const double z = g.held[i].at_T[2];
        low = i == 0 ? z : std::min(low, z);
        high = i == 0 ? z : std::max(high, z);
    }
    g.tissue = static_cast<Tissue>(std::max_element(count.begin(), count.end()) - count.begin());
    if (g.tet < 0) g.tissue = scene.patch->triangles.front().tissue;  // only a label
    for (int k = 0; k < 3; ++k) g.rest_m[k] = static_cast<float>(rest[k]);
    const ToolSpec& spec = scene.tools[t];
    const double bite = std::clamp(high - low, kLeastBite, spec.tip_length_m);
    g.area_m2 = static_cast<float>(bite * spec.jaw_width_m);
}

/// Takes every free vertex of the surface, and of a patch, that lies between the jaws.
class Bite {
 public:
    Bite(const Scene& scene, State& state, int t) noexcept
        : state_(state),
          grasp_(state.grasps[t]),
          spec_(scene.tools[t]),
          to_tool_(state.tools[t].proxy.inverse()),
          tool_(t) {}

    /// @param reach_m so far beyond the tips.
    void take(std::span<const SurfaceTriangle> triangles, double reach_m) noexcept {
        reach_ = reach_m;
        for (const SurfaceTriangle& tri : triangles) {
            for (const int32_t v : tri.vertex) {
                if (grasp_.count == kMaxGrasped) return;
                take(v);
            }
        }
    }

 private:
    void take(int32_t v) noexcept {
        if (state_.held_by[v] >= 0) return;
        if (state_.body.x[v].w == 0 && !state_.pieces.resting[v]) return;
        const Vec3 p = to_tool_ * position(state_.body, v);
        if (p.z() > reach_ || p.z() < -spec_.tip_length_m || std::abs(p.x()) > half_) return;
        const double gap =
            std::max(slope_ * (spec_.tip_length_m + p.z()), 0.25 * spec_.jaw_touch_m);
        if (std::abs(p.y()) > gap) return;
        state_.held_by[v] = static_cast<int8_t>(tool_);
        grasp_.held[grasp_.count++] = {
            v, {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}};
    }

    State& state_;
    Grasp& grasp_;
    const ToolSpec& spec_;
    Pose to_tool_;
    int tool_;
    double reach_ = kReach;
    double half_ = spec_.jaw_width_m / 2;
    // Jaws meet at an angle: the gap shrinks towards the hinge, never below half of the tip's.
    double slope_ = tan_portable(std::max(0.0, grip_angle(spec_)) / 2);
};

/// What needle and thread pull at a held vertex.
Vec3 needle_pull_on(const Scene& scene, State& state, int v) noexcept {
    const SuturedTissue tissue{scene.body, state.body, scene.surface, state.surface};
    return pull_on_vertex(*scene.suture, state.suturing.needle[0], tissue, state.scratch->suture[0],
                          v);
}

std::optional<Event> slip_event(const State& state, int t, float way_m) noexcept {
    if (!(way_m > kSlipNotice)) return std::nullopt;
    Event e = grasp_event(state, EventKind::kSlipped, t);
    e.value = way_m;
    e.value2 = state.grasps[t].slip_peak_n;
    return e;
}

void end_slip(State& state, int t) noexcept {
    Grasp& g = state.grasps[t];
    if (const auto slipped = slip_event(state, t, g.slip_m)) add_event(state, *slipped);
    g.slip_m = g.slip_shut_m = g.slip_peak_n = g.slip_pause_s = 0;
}

void end_traction(State& state, int t) noexcept {
    Grasp& g = state.grasps[t];
    if (const auto pull = open_traction(state, t)) add_event(state, *pull);
    g.traction_s = g.traction_peak_n = g.traction_pause_s = 0;
}

void end_grasp(const Scene& scene, State& state, int t) noexcept {
    Grasp& g = state.grasps[t];
    end_slip(state, t);
    end_traction(state, t);
    Event e = grasp_event(state, EventKind::kReleased, t);
    e.value = g.held_s;
    e.value2 = g.peak_n;
    add_event(state, e);
    while (g.count > 0) drop(scene, state, g, g.count - 1);
    g.pinch_n = g.held_s = g.peak_n = 0;
    g.crushed = 0;
    g.force_n = Vec3::Zero();
    update_free_vertices(scene.body, state.body);
}

/// `jaw_rad`: as update_grasps() takes it from the input, finite and not negative.
void begin_grasp(const Scene& scene, State& state, int t, float jaw_rad) noexcept {
    Grasp& g = state.grasps[t];
    g.meet_rad = g.jaw_rad = jaw_rad;
    Bite bite(scene, state, t);
    if (scene.patch) bite.take(scene.patch->triangles, kReach);
    // A patch between the jaws keeps them off the tissue below it, unless they are pressed in.
    bite.take(state.surface.triangles(), g.count > 0 ? 0 : kReach);
    if (g.count == 0) return;
    for (int i = 0; i < g.count; ++i) state.body.x[g.held[i].vertex].w = 0;
    g.grasped = g.count;
    describe(scene, state, t);
    Event e = grasp_event(state, EventKind::kGrasped, t);
    e.value = static_cast<float>(g.count);
    e.value2 = g.pinch_n;
    add_event(state, e);
    update_free_vertices(scene.body, state.body);
}

/// What pressure and pull do to the tissue that is held.
void watch_tissue(const Scene& scene, State& state, int t, float pull, float seconds) noexcept {
    Grasp& g = state.grasps[t];
    const Material& material = scene.body.spec().materials[static_cast<int>(g.tissue)];
    const double pressure = g.area_m2 > 0 ? g.pinch_n / g.area_m2 : 0;
    if (pressure > material.crush_pa && !g.crushed) {
        g.crushed = 1;
        Event e = grasp_event(state, EventKind::kCrushed, t);
        e.value = static_cast<float>(pressure);
        e.value2 = g.pinch_n;
        add_event(state, e);
    }
    if (pull > material.traction_limit_n) {
        g.traction_s += seconds;
        g.traction_peak_n = std::max(g.traction_peak_n, pull);
        g.traction_pause_s = 0;
    } else if (g.traction_s > 0) {
        // Tugs that follow each other at once are one pull: each alone would be too short to count.
        g.traction_pause_s += seconds;
        if (g.traction_pause_s > kTractionS) end_traction(state, t);
    }
}

/// Pressure, traction and slip of a grasp that goes on.
void watch(const Scene& scene, State& state, int t, double dt) noexcept {
    Grasp& g = state.grasps[t];
    const auto seconds = static_cast<float>(dt);
    g.held_s += seconds;
    const auto pull = static_cast<float>(g.force_n.norm());
    g.peak_n = std::max(g.peak_n, pull);
    // A patch alone is neither crushed nor pulled too much.
    if (g.tet >= 0) watch_tissue(scene, state, t, pull, seconds);
    if (g.slip_m > 0) {
        g.slip_pause_s += seconds;
        if (g.slip_pause_s > kSlipEnds) end_slip(state, t);
    }
}

/// Slides what is held towards its pull by what friction cannot hold.
void slip(const Scene& scene, State& state, int t, const Vec3& force, double stiffness) noexcept {
    Grasp& g = state.grasps[t];
    const ToolSpec& spec = scene.tools[t];
    const double pull = force.norm(), limit = 2 * spec.jaw_friction * g.pinch_n;
    if (!(pull > limit) || !(stiffness > 0)) return;
    const double path = std::min(kSlipPerSubstep, (pull - limit) / stiffness);
    const Vec3 slide_T = state.tools[t].proxy.q.conjugate() * (path / pull * force);
    for (int i = g.count - 1; i >= 0; --i) {
        GraspedVertex& held = g.held[i];
        // The jaws close off y: tissue slides along them.
        held.at_T[0] += static_cast<float>(slide_T.x());
        held.at_T[2] += static_cast<float>(slide_T.z());
        if (held.at_T[2] > kReach + kTipOverhang || held.at_T[2] < -spec.tip_length_m ||
            std::abs(held.at_T[0]) > spec.jaw_width_m / 2 + kSideOverhang) {
            drop(scene, state, g, i);
        }
    }
    g.slip_m += static_cast<float>(path);
    g.slip_peak_n = std::max(g.slip_peak_n, static_cast<float>(pull));
    g.slip_pause_s = 0;
}

}  // namespace

std::optional<Event> open_slip(const State& state, int t) noexcept {
    return slip_event(state, t, state.grasps[t].slip_shut_m);
}

std::optional<Event> open_traction(const State& state, int t) noexcept {
    const Grasp& g = state.grasps[t];
    if (g.traction_s < kTractionS) return std::nullopt;
    Event e = grasp_event(state, EventKind::kOverTraction, t);
    e.time_s -= static_cast<double>(g.traction_pause_s);
    e.value = g.traction_s;
    e.value2 = g.traction_peak_n;
    return e;
}

double grip_angle(const ToolSpec& spec) noexcept {
    const double sine = spec.jaw_touch_m / std::max(2 * spec.tip_length_m, spec.jaw_touch_m);
    // asin by its series: the library's last bit depends on the processor, and 2 % do not matter.
    return 2 * (sine + sine * sine * sine / 6);
}

void carry_grasped(const Scene& scene, State& state) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const Grasp& g = state.grasps[t];
        for (int i = 0; i < g.count; ++i) {
            Float4& x = state.body.x[g.held[i].vertex];
            const Vec3 goal = state.tools[t].proxy * place_T(g, g.held[i]);
            Vec3 step = goal - Vec3(x.x, x.y, x.z);
            const double length = step.norm();
            if (length > kCarryStep) step *= kCarryStep / length;
            x.x += static_cast<float>(step.x());
            x.y += static_cast<float>(step.y());
            x.z += static_cast<float>(step.z());
        }
    }
}

void feel_grasped(const Scene& scene, State& state) noexcept {
    const double share = 1.0 / state.substeps;
    const double h = scene.body.spec().solver.frame_s / state.substeps;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        Grasp& g = state.grasps[t];
        if (g.count == 0) continue;
        // What the held vertices pull on each other cancels in the sum.
        Vec3 force = Vec3::Zero();
        double stiffness = 0;
        for (int i = 0; i < g.count; ++i) {
            const int v = g.held[i].vertex;
            const double mass = mass_of(scene.body, state.body, v), inertia = mass / (h * h);
            const Mat3 hessian = vertex_stiffness(scene.body, state.body, v, h);
            force += elastic_force(scene.body, state.body, v) +
                     mass * scene.body.spec().solver.gravity_m_s2;
            stiffness += hessian.trace() / 3 - inertia;
            if (scene.suture) force += needle_pull_on(scene, state, v);
        }
        if (!force.allFinite()) continue;
        g.force_n += share * force;
        ToolState& tool = state.tools[t];
        tool.substep_force_n += force;
        tool.substep_stiffness_n_m = std::max(tool.substep_stiffness_n_m, stiffness / 2);
        tool.force_n += share * force;
        tool.stiffness_n_m += share * stiffness / 2;
        if (g.tissue == Tissue::kPlacode) tool.placode_force_n += share * force.norm();
        slip(scene, state, t, force, stiffness);
    }
}

void update_grasps(const Scene& scene, State& state, double dt) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolSpec& spec = scene.tools[t];
        if (spec.kind != ToolKind::kGrasper) continue;
        Grasp& g = state.grasps[t];
        const ToolState& tool = state.tools[t];
        const auto meet = static_cast<float>(grip_angle(spec));
        const float jaw = std::isfinite(tool.jaw_rad) ? std::max(0.0f, tool.jaw_rad) : g.jaw_rad;
        if (jaw <= g.jaw_rad) g.slip_shut_m = g.slip_m;
        if (g.count > 0 && (!tool.engaged || jaw > kLetGo * g.meet_rad)) {
            // What slides while the jaws open is let go, not lost.
            g.slip_m = g.slip_shut_m;
            end_grasp(scene, state, t);
        } else if (g.grasped > 0 && g.count == 0 && g.held_s > 0) {
            end_grasp(scene, state, t);  // all of it slipped out, or died
        } else if (g.count > 0) {
            g.jaw_rad = std::min(jaw, g.meet_rad);
            g.pinch_n = static_cast<float>(spec.jaw_force_n) *
                        (1 - g.jaw_rad / std::max(g.meet_rad, 1e-6f));
            watch(scene, state, t, dt);
        }
        if (jaw > kLetGo * meet) {
            g.shut = 0;
        } else if (!g.shut && jaw <= meet && tool.engaged && g.count == 0) {
            g.shut = 1;
            begin_grasp(scene, state, t, jaw);
        }
        g.jaw_rad = jaw;
        if (g.count == 0) g.grasped = 0;
    }
}

void hold_copy(const Scene& scene, State& state, int vertex, int copy) noexcept {
    const int8_t t = state.held_by[vertex];
    state.held_by[copy] = -1;
    state.pieces.resting[copy] = state.pieces.resting[vertex];
    if (t < 0) return;
    Grasp& g = state.grasps[t];
    for (int i = 0; i < g.count; ++i) {
        if (g.held[i].vertex != vertex) continue;
        if (g.count == kMaxGrasped) break;
        g.held[g.count] = {copy, g.held[i].at_T};
        ++g.count;
        state.held_by[copy] = t;
        state.body.x[copy].w = 0;
        return;
    }
    state.body.x[copy].w = 1.0F / mass_of(scene.body, state.body, copy);
}

void let_go_vertex(const Scene& scene, State& state, int vertex) noexcept {
    const int8_t t = state.held_by[vertex];
    if (t < 0) return;
    Grasp& g = state.grasps[t];
    for (int i = 0; i < g.count; ++i) {
        if (g.held[i].vertex != vertex) continue;
        drop(scene, state, g, i);
        return;
    }
}

}  // namespace placode::sim
