// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Instruments against tissue. Vertices of triangles next to an instrument form the "contact
// colour": the kernels' sweep leaves them out, and they are solved here one by one with their full
// Hessian plus k b^2 n n^T of every closest-point contact and a tangential spring for dry friction.
// The same holds for bodies solved by XPBD: their contact vertices take a vertex step instead of
// constraint projections, so that the force is read from one place.
//
// The instrument is held by a hand of finite stiffness (ToolSpec::grip_n_m) and yields to the
// force: its proxy is what touches. Every instrument touches, the scope as a capsule of its shaft.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/tissue.h"
#include "sim/tool_shape.h"

namespace placode::sim {

struct Scene;
struct State;

/// In place of a tool: the other side is tissue as well.
inline constexpr int8_t kTissueSide = -1;

/// One triangle against one instrument, or a vertex against a triangle of other tissue.
/// f = k max(0, -gap), gap = n . (sum b x) + offset.
struct Contact {
    std::array<int32_t, 4> vertex{};
    std::array<double, 4> b{};  // barycentric weights; those of the other side are negative
    Vec3 n = Vec3::UnitZ();     // from the other side into the tissue, in W
    double offset_m = 0;
    double stiffness_n_m = 0;
    Tissue tissue = Tissue::kSkin;
    int8_t tool = 0;     // or kTissueSide
    int8_t corners = 3;  // the first of `vertex` and `b` that count
};

/// A vertex of the contact colour and its share of the contacts.
struct ContactVertex {
    int32_t vertex = 0;
    int32_t first = 0, count = 0;  // into ContactSet::incidence
    int8_t tool = kTissueSide;     // that touches it
    float friction = 0, friction_static_ratio = 1;
    Vec3 normal_force_n = Vec3::Zero();
    double stiffness_n_m = 0;  // of the tissue alone, along the normal
    double friction_n_m = 0;   // of the tangential spring
};

/// Bounded lists of a frame. Incidence entries are contact * 4 + corner.
struct ContactSet {
    explicit ContactSet(const Scene& scene);
    std::array<ToolShape, kMaxTools> shapes;
    std::array<uint8_t, kMaxTools> near{};    // 1 = the tool has candidates in this frame
    std::vector<int32_t> candidates;          // triangle * 4 + tool
    std::vector<std::array<float, 4>> start;  // of each: centre in T at the frame's start, distance
    uint32_t fitted = ~0U;                    // surface version of the last refit
    std::vector<TriangleDistance> nearest;    // of each: on the triangle, in this substep
    std::vector<Contact> contacts;
    std::vector<ContactVertex> vertices;
    std::vector<int32_t> incidence;
    std::vector<int32_t> previous;  // contact colour of the substep before
    std::vector<int32_t> slot;      // (V) into vertices, -1 = not in contact
    // What a vertex answers with its neighbours held: xx xy xz yy yz zz [N/m], of this frame.
    std::vector<std::array<float, 6>> hessian;  // (V)
    std::vector<int64_t> hessian_frame;         // (V)
    // Corners and edges that have their contact already: open addressing, key + 1, 0 = empty.
    std::vector<uint64_t> feature;
    std::vector<int32_t> feature_used;
    int feature_count = 0;
    int candidate_count = 0, contact_count = 0, vertex_count = 0, previous_count = 0;
    int most_contacts = 0;  // within this frame
};

/// Start of a frame: refits the tree of the surface and collects the triangles that any instrument
/// can reach before the frame's end.
void collect_candidates(const Scene& scene, State& state) noexcept;

/// Start of a substep: moves the proxies towards where the hand is after `share` of the frame (no
/// farther than a part of the tip's radius while tissue is near, so that nothing is jumped over).
void move_tools(const Scene& scene, State& state, std::span<const Pose> from,
                std::span<const Pose> to, double share) noexcept;

/// Closest points of the candidates; marks the contact colour in `contact_vertex`.
void find_contacts(const Scene& scene, State& state) noexcept;

/// Adds a contact between tissue and tissue to the colour. False when a list is full.
bool add_tissue_contact(State& state, const Contact& contact) noexcept;

/// One pass over the contact colour, there or back: the two together are symmetric, as sweeps that
/// carry momentum must be to stay calm. h [s].
void solve_contacts(const Scene& scene, State& state, double h, bool backward) noexcept;

/// End of a substep: forces on the instruments, friction's memory.
void finish_contacts(State& state) noexcept;

}  // namespace placode::sim
