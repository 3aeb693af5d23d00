// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity as it is now: that of the body until the first cut, then the state's own.

#include "sim/core/as_index.h"
#include "sim/solver/topology.h"

namespace placode::sim {
TopologyPointer::TopologyPointer() = default;
TopologyPointer::~TopologyPointer() = default;
TopologyPointer::TopologyPointer(TopologyPointer&&) noexcept = default;
TopologyPointer& TopologyPointer::operator=(TopologyPointer&&) noexcept = default;
TopologyPointer::TopologyPointer(const TopologyPointer& other)
    : value_(other.value_ ? std::make_unique<Topology>(*other.value_) : nullptr) {}
TopologyPointer& TopologyPointer::operator=(const TopologyPointer& other) {
    if (this != &other) value_ = other.value_ ? std::make_unique<Topology>(*other.value_) : nullptr;
    return *this;
}
void TopologyPointer::create(const SoftBody& body) { value_ = std::make_unique<Topology>(body); }

std::span<const int32_t> tets_around(const SoftBody& body, const SoftBodyState& state,
                                     int vertex) noexcept {
    if (!state.topology) return body.tets_of(vertex);
    const Topology& top = *state.topology;
    return {top.around.data() + top.first[as_index(vertex)], as_index(top.count[as_index(vertex)])};
}

const std::array<int32_t, 4>& corners(const SoftBody& body, const SoftBodyState& state,
                                      int tet) noexcept {
    return state.topology ? state.topology->tets[as_index(tet)] : body.mesh().tets[as_index(tet)];
}

std::span<const std::array<int32_t, 4>> current_tets(const SoftBodyState& state) noexcept {
    if (!state.topology) return {};
    return state.topology->tets;
}

const KernelLayout& packed_of(const SoftBody& body, const SoftBodyState& state) noexcept {
    return state.topology ? state.topology->packed : body.packed();
}

int32_t origin_of(const SoftBodyState& state, int vertex) noexcept {
    return state.topology ? state.topology->origin[as_index(vertex)] : vertex;
}

const Vec3& rest_place(const SoftBody& body, const SoftBodyState& state, int vertex) noexcept {
    return state.topology ? state.topology->rest[as_index(vertex)]
                          : body.mesh().rest[as_index(vertex)];
}

float rest_volume_of(const SoftBody& body, const SoftBodyState& state, int tet) noexcept {
    return state.topology ? state.topology->volume_m3[as_index(tet)]
                          : body.volume_m3()[as_index(tet)];
}

float mass_of(const SoftBody& body, const SoftBodyState& state, int vertex) noexcept {
    return state.topology ? state.topology->mass_kg[as_index(vertex)]
                          : body.mass_kg()[as_index(vertex)];
}

}  // namespace placode::sim
