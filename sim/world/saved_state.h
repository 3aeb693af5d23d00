// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A state as bytes, and as one number: both go through the fields() of its parts, so that neither
// can forget one. Going back in a replay, trying two ways from one moment, environments that reset.

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace placode::sim {

struct Scene;
struct State;

/// Bytes that are no state of this scene: what is wrong, and what to do.
class StateError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Of every field that decides the future. Two states of one scene with the same number go on
/// alike.
[[nodiscard]] uint64_t whole_hash(const State& state) noexcept;

/// Format 2, of this build's field lists and byte order: for a running program, not for archives.
[[nodiscard]] std::vector<uint8_t> save_state(const Scene& scene, const State& state);
/// The same into memory that is used again.
void save_state(const Scene& scene, const State& state, std::vector<uint8_t>& into);

/// Makes `state` the saved one. Scratch is forgotten. Threads stay.
/// @pre `state` was built for `scene`, and so was the saved one, with the same live tuning.
/// @throws StateError for other bytes; `state` is then as it was.
void load_state(const Scene& scene, State& state, std::span<const uint8_t> saved);

/// The same for bytes that this program saved of the same scene and kept to itself: neither they
/// nor the scene are summed up once more, a third of the time.
void load_own_state(State& state, std::span<const uint8_t> saved);

}  // namespace placode::sim
