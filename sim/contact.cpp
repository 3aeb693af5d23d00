// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/step_scratch.h"

namespace placode::sim {
namespace {

constexpr int kMostCandidates = 16384, kMostContacts = 2048, kMostVertices = 2048;
constexpr double kTissueReach = 0.0005;  // tissue may come this much nearer within a frame [m]
constexpr double kStepOfRadius = 0.6;    // motion per substep near tissue, in radii of the tip
constexpr double kFreeStep = 0.003;      // motion per frame where nothing is near [m]
// Tried on a 1.5 mm probe in 60 kPa tissue with grips of 50 and 600 N/m: 1 oscillates, 4 is quiet.
constexpr double kCaution = 6;
constexpr double kStiffnessMemory = 0.95;  // per substep: a short lift-off does not forget tissue
// Deepest overlap that still adds force [m]. In touch it stays below 0.02 mm; more only happens
// where surface appears inside an instrument (removed tets) or a hand comes back inside tissue.
constexpr double kDeepest = 1e-4;
constexpr double kFacing = 0.5;  // faces that look away from the instrument more than this are not
                                 // touched: their other side is

Vec3 position(const SoftBodyState& body, int v) noexcept {
    const Float4& x = body.x[v];
    return {x.x, x.y, x.z};
}

/// Normalised linear interpolation: for the small turns of a frame as good as slerp, without the
/// library's sine, whose last bit depends on the processor.
Quat between(const Quat& from, const Quat& to, double share) noexcept {
    const double sign = from.dot(to) < 0 ? -1.0 : 1.0;
    Quat q;
    q.coeffs() = (1 - share) * from.coeffs() + (share * sign) * to.coeffs();
    q.normalize();
    return q;
}

double gap_of(const Contact& c, const SoftBodyState& body) noexcept {
    double gap = c.offset_m;
    for (int i = 0; i < 3; ++i) gap += c.b[i] * c.n.dot(position(body, c.vertex[i]));
    return gap;
}

/// Slot of a vertex in the contact colour; -1 when the list is full.
int slot_of(ContactSet& set, SoftBodyState& body, int v) noexcept {
    if (set.slot[v] >= 0) return set.slot[v];
    if (set.vertex_count == static_cast<int>(set.vertices.size())) return -1;
    set.slot[v] = set.vertex_count;
    set.vertices[set.vertex_count] = {};
    set.vertices[set.vertex_count].vertex = v;
    body.contact_vertex[v] = 1;
    return set.vertex_count++;
}

void clear_contacts(ContactSet& set, SoftBodyState& body) noexcept {
    set.previous_count = set.vertex_count;
    for (int i = 0; i < set.vertex_count; ++i) {
        const int v = set.vertices[i].vertex;
        set.previous[i] = v;
        set.slot[v] = -1;
        body.contact_vertex[v] = 0;
    }
    set.contact_count = set.vertex_count = 0;
}

/// Incidence lists: contacts of each vertex, in the order of the contacts.
void build_incidence(ContactSet& set) noexcept {
    for (int i = 0; i < set.contact_count; ++i) {
        for (const int32_t v : set.contacts[i].vertex) ++set.vertices[set.slot[v]].count;
    }
    int sum = 0;
    for (int i = 0; i < set.vertex_count; ++i) {
        set.vertices[i].first = sum;
        sum += set.vertices[i].count;
        set.vertices[i].count = 0;
    }
    for (int i = 0; i < set.contact_count; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            ContactVertex& cv = set.vertices[set.slot[set.contacts[i].vertex[corner]]];
            set.incidence[cv.first + cv.count++] = i * 4 + corner;
        }
    }
}

/// Notes the nearest spot of bare metal.
void note_spot(const Scene& scene, const SoftBodyState& body, ToolState& tool,
               const SurfaceTriangle& tri, const Triangle& x, const TriangleDistance& d) noexcept {
    if (d.value_m >= tool.bare_gap_m) return;
    tool.bare_gap_m = d.value_m;
    tool.spot = tool.rest_spot = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        tool.spot += d.weight[i] * x[i];
        tool.rest_spot += d.weight[i] * scene.body.mesh().rest[origin_of(body, tri.vertex[i])];
    }
    tool.spot_tet = tri.tet;
    tool.touched = tri.tissue;
}

struct Friction {
    Vec3 slide = Vec3::Zero();  // tangential way from the anchor [m]
    Vec3 normal = Vec3::UnitZ();
    double stiffness_n_m = 0, limit_n = 0;
};

/// Tangential spring of a vertex, softened where the cone ends.
Friction friction_of(const Scene& scene, const State& state, const ContactVertex& cv) noexcept {
    Friction f;
    const FrictionAnchor& anchor = state.friction[cv.vertex];
    const double load = cv.normal_force_n.norm();
    if (anchor.tool < 0 || !(load > 0)) return f;
    f.normal = cv.normal_force_n / load;
    const Vec3 at = state.tools[anchor.tool].proxy *
                    Vec3(anchor.anchor_T[0], anchor.anchor_T[1], anchor.anchor_T[2]);
    const Vec3 way = position(state.body, cv.vertex) - at;
    f.slide = way - f.normal * f.normal.dot(way);
    f.limit_n = cv.friction * load * (anchor.slipping ? 1.0f : cv.friction_static_ratio);
    f.stiffness_n_m = scene.contact.stiffness_n_m;
    const double length = f.slide.norm();
    if (length * f.stiffness_n_m > f.limit_n) f.stiffness_n_m = f.limit_n / length;
    return f;
}

/// After a substep: drags the anchor along where the vertex slips, forgets it where it lifts off.
void update_anchor(const Scene& scene, State& state, const ContactVertex& cv) noexcept {
    FrictionAnchor& anchor = state.friction[cv.vertex];
    if (!(cv.normal_force_n.norm() > 0)) {
        anchor = {};
        return;
    }
    const Vec3 x = position(state.body, cv.vertex);
    Vec3 at = x;
    if (anchor.tool == cv.tool) {
        const Friction f = friction_of(scene, state, cv);
        const double k = scene.contact.stiffness_n_m, length = f.slide.norm();
        const double dynamic = cv.friction * cv.normal_force_n.norm();
        if (length * k > f.limit_n) anchor.slipping = 1;
        if (length * k < 0.99 * dynamic) anchor.slipping = 0;
        const double keep = anchor.slipping && length * k > dynamic ? dynamic / (length * k) : 1.0;
        at = x - keep * f.slide;
    } else {
        anchor.slipping = 0;
    }
    const Vec3 at_T = state.tools[cv.tool].proxy.inverse() * at;
    anchor.tool = cv.tool;
    for (int i = 0; i < 3; ++i) anchor.anchor_T[i] = static_cast<float>(at_T[i]);
}

}  // namespace

ContactSet::ContactSet(const Scene& scene)
    : candidates(kMostCandidates),
      contacts(kMostContacts),
      vertices(kMostVertices),
      incidence(3 * kMostContacts),
      previous(kMostVertices),
      slot(scene.body.vertex_capacity(), -1) {
    for (size_t t = 0; t < scene.tools.size() && t < shapes.size(); ++t) {
        shapes[t] = make_tool_shape(scene.tools[t]);
    }
}

void collect_candidates(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    set.candidate_count = set.most_contacts = 0;
    set.near.fill(0);
    state.surface.refit(state.body.x);
    const auto triangles = state.surface.triangles();
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolState& tool = state.tools[t];
        if (!tool.engaged) continue;
        const ToolShape& shape = set.shapes[t];
        const Pose to_tool = tool.proxy.inverse();
        const double way = (tool.hand.p - tool.proxy.p).norm() +
                           kStepOfRadius * shape.parts[0].near_radius_m * state.substeps;
        const double limit = scene.contact.margin_m + std::min(way, kFreeStep) + kTissueReach;
        // A ball around box or triangle: the distance changes by no more than the way.
        const auto beyond = [&](const Vec3& centre, double radius) noexcept {
            return signed_distance(shape, to_tool * centre).value_m > limit + radius;
        };
        state.surface.tree().walk(
            [&](const SurfaceTree::Box& box) noexcept {
                const Vec3 low(box.low[0], box.low[1], box.low[2]);
                const Vec3 high(box.high[0], box.high[1], box.high[2]);
                return beyond(0.5 * (low + high), 0.5 * (high - low).norm());
            },
            [&](int i) noexcept {
                const auto& v = triangles[i].vertex;
                const Vec3 a = position(state.body, v[0]), b = position(state.body, v[1]),
                           c = position(state.body, v[2]);
                const Vec3 centre = (a + b + c) / 3;
                const double radius =
                    std::sqrt(std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(),
                                        (c - centre).squaredNorm()}));
                if (beyond(centre, radius)) return;
                if (set.candidate_count == static_cast<int>(set.candidates.size())) {
                    state.flags |= kContactsDropped;
                    return;
                }
                set.near[t] = 1;
                set.candidates[set.candidate_count++] = i * 4 + t;
            });
    }
}

void move_tools(const Scene& scene, State& state, std::span<const Pose> from,
                std::span<const Pose> to, double share) noexcept {
    ContactSet& set = state.scratch->contacts;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        if (!tool.engaged) continue;
        const Vec3 hand = from[t].p + share * (to[t].p - from[t].p);
        tool.proxy.q = between(from[t].q, to[t].q, share);
        if (!set.near[t]) {
            Vec3 way = hand - tool.proxy.p;
            const double most = kFreeStep / state.substeps, length = way.norm();
            if (length > most) way *= most / length;
            tool.proxy.p += way;
            continue;
        }
        // Quasi-static balance of hand and tissue, one Newton step with the stiffness that the
        // touched vertices show at once. kCaution keeps it calm while contacts come and go; at rest
        // the balance is exact whatever the stiffness.
        const double grip = scene.tools[t].grip_n_m;
        Vec3 step = (grip * (hand - tool.proxy.p) + tool.substep_force_n) /
                    (grip + kCaution * tool.substep_stiffness_n_m);
        const double longest = kStepOfRadius * set.shapes[t].parts[0].near_radius_m;
        const double length = step.norm();
        if (length > longest) step *= longest / length;
        tool.proxy.p += step;
    }
}

void find_contacts(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    clear_contacts(set, state.body);
    const auto triangles = state.surface.triangles();
    std::array<Pose, kMaxTools> to_tool;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        to_tool[t] = state.tools[t].proxy.inverse();
        state.tools[t].bare_gap_m = state.tools[t].gap_m = 1;
    }
    for (int i = 0; i < set.candidate_count; ++i) {
        const SurfaceTriangle& tri = triangles[set.candidates[i] / 4];
        const int t = set.candidates[i] % 4;
        // What the jaws hold does not push them.
        if (state.held_by[tri.vertex[0]] == t || state.held_by[tri.vertex[1]] == t ||
            state.held_by[tri.vertex[2]] == t) {
            continue;
        }
        Triangle x, x_T;
        for (int k = 0; k < 3; ++k) {
            const Float4& before = state.body.x_start[tri.vertex[k]];
            x[k] = Vec3(before.x, before.y, before.z);
            x_T[k] = to_tool[t] * x[k];
        }
        const ToolShape& shape = set.shapes[t];
        const TriangleDistance d = nearest_on_triangle(shape, x_T, scene.contact.margin_m);
        if (d.part < 0 || (d.part == 0 && blades_open(scene, state, t))) continue;
        if (d.part < shape.bare_parts) note_spot(scene, state.body, state.tools[t], tri, x, d);
        const Vec3 face = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
        Vec3 n = state.tools[t].proxy.q * d.gradient;
        double gap = d.value_m;
        if (d.pierced) {
            n = -face;  // back to the side that the instrument came from
        } else if (n.dot(face) > kFacing) {
            continue;
        }
        state.tools[t].gap_m = std::min(state.tools[t].gap_m, gap);
        gap = std::max(gap, -kDeepest * state.tools[t].contact_share);
        if (set.contact_count == static_cast<int>(set.contacts.size())) {
            state.flags |= kContactsDropped;
            break;
        }
        int slots[3];
        for (int k = 0; k < 3; ++k) slots[k] = slot_of(set, state.body, tri.vertex[k]);
        if (slots[0] < 0 || slots[1] < 0 || slots[2] < 0) {
            state.flags |= kContactsDropped;
            break;
        }
        Contact& c = set.contacts[set.contact_count++];
        c = {tri.vertex, {d.weight[0], d.weight[1], d.weight[2]},
             n,          0,
             tri.tissue, static_cast<int8_t>(t)};
        c.offset_m = gap - (d.weight[0] * n.dot(x[0]) + d.weight[1] * n.dot(x[1]) +
                            d.weight[2] * n.dot(x[2]));
        const Material& material = scene.body.spec().materials[static_cast<int>(tri.tissue)];
        for (const int slot : slots) {
            ContactVertex& cv = set.vertices[slot];
            cv.tool = static_cast<int8_t>(t);
            cv.friction = static_cast<float>(material.friction);
            cv.friction_static_ratio = static_cast<float>(material.friction_static_ratio);
        }
    }
    // Who left the colour has lifted off.
    for (int i = 0; i < set.previous_count; ++i) {
        if (set.slot[set.previous[i]] < 0) state.friction[set.previous[i]] = {};
    }
    // A vertex between instrument and tissue starts from where it was (the gaps above are those of
    // that place, or the deepest-overlap bound would mean nothing): with the swept guess of its
    // momentum a pressed patch was seen to burst into oscillation (60 kPa, h = .25 ms, one sweep).
    for (int i = 0; i < set.vertex_count; ++i) {
        Float4& x = state.body.x[set.vertices[i].vertex];
        const Float4& before = state.body.x_start[set.vertices[i].vertex];
        x = {before.x, before.y, before.z, x.w};
    }
    build_incidence(set);
    set.most_contacts = std::max(set.most_contacts, set.contact_count);
}

void solve_contacts(const Scene& scene, State& state, double h) noexcept {
    ContactSet& set = state.scratch->contacts;
    const double k = scene.contact.stiffness_n_m;
    for (int i = 0; i < set.vertex_count; ++i) {
        ContactVertex& cv = set.vertices[i];
        Float4& x = state.body.x[cv.vertex];
        if (x.w == 0) continue;
        VertexSystem system = vertex_system(scene.body, state.body, cv.vertex, h);
        const Mat3 tissue = system.hessian;
        Vec3 load = Vec3::Zero();
        for (int n = cv.first; n < cv.first + cv.count; ++n) {
            const Contact& c = set.contacts[set.incidence[n] / 4];
            const double b = c.b[set.incidence[n] % 4], gap = gap_of(c, state.body);
            if (gap >= 0 || b == 0) continue;
            system.gradient += k * gap * b * c.n;
            system.hessian += (k * b * b) * c.n * c.n.transpose();
            load -= k * gap * b * c.n;
        }
        cv.normal_force_n = load;
        const double size = load.norm();
        cv.stiffness_n_m = size > 0 ? load.dot(tissue * load) / (size * size) : 0.0;
        const Friction f = friction_of(scene, state, cv);
        if (f.stiffness_n_m > 0) {
            system.gradient += f.stiffness_n_m * f.slide;
            system.hessian +=
                f.stiffness_n_m * (Mat3::Identity() - f.normal * f.normal.transpose());
        }
        Vec3 step = -system.hessian.llt().solve(system.gradient);
        const double longest =
            0.25 * scene.body.shortest_edge_m()[origin_of(state.body, cv.vertex)];
        const double length = step.norm();
        if (!std::isfinite(length)) {
            state.flags |= kNotFinite;
            continue;
        }
        if (length > longest) {
            step *= longest / length;
            state.flags |= kStepLimited;
        }
        x.x += static_cast<float>(step.x());
        x.y += static_cast<float>(step.y());
        x.z += static_cast<float>(step.z());
    }
}

void finish_contacts(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    const double share = 1.0 / state.substeps;
    for (ToolState& tool : state.tools) {
        tool.substep_force_n = Vec3::Zero();
    }
    std::array<double, kMaxTools> stiffness{};
    for (int i = 0; i < set.vertex_count; ++i) set.vertices[i].normal_force_n = Vec3::Zero();
    for (int i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[i];
        const double gap = gap_of(c, state.body);
        if (gap >= 0) continue;
        const double force = -scene.contact.stiffness_n_m * gap;
        ToolState& tool = state.tools[c.tool];
        tool.substep_force_n -= force * c.n;
        if (c.tissue == Tissue::kPlacode) tool.placode_force_n += share * force;
        for (int corner = 0; corner < 3; ++corner) {
            set.vertices[set.slot[c.vertex[corner]]].normal_force_n += force * c.b[corner] * c.n;
        }
    }
    for (int i = 0; i < set.vertex_count; ++i) {
        const ContactVertex& cv = set.vertices[i];
        ToolState& tool = state.tools[cv.tool];
        const Friction f = friction_of(scene, state, cv);
        tool.substep_force_n += f.stiffness_n_m * f.slide;
        stiffness[cv.tool] += cv.stiffness_n_m;
        update_anchor(scene, state, cv);
    }
    for (int t = 0; t < kMaxTools; ++t) {
        ToolState& tool = state.tools[t];
        tool.substep_stiffness_n_m =
            std::max(stiffness[t], kStiffnessMemory * tool.substep_stiffness_n_m);
        tool.force_n += share * tool.substep_force_n;
        tool.stiffness_n_m += share * stiffness[t];
    }
}

}  // namespace placode::sim
