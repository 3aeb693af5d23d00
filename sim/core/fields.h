// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a struct of state names its fields, once, for hash, save and load. Beside the struct stands
//
//   template <class Visit>
//   void fields(Of<Grasp> auto& s, Visit&& visit) {
//       auto& [held, count] = s;
//       visit.state(held, count);
//   }
//
// A field that is added to the struct and not to the list does not compile. Three kinds:
// state() decides the future; kept() follows from it, or only speeds up, and is saved so that it
// need not be found again; constant() is built from the scene, or is lost between two frames.
// Lists with room for more than they hold: state_of(count, list), kept_of(count, list), where
// `count` is listed before them; what lies behind is no part of the state.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "sim/core/float4.h"
#include "sim/core/geometry.h"

namespace placode::sim {

template <class T, class S>
concept Of = std::same_as<std::remove_const_t<T>, S>;

/// Values that are all of their bytes: no padding, no pointers.
template <class T>
inline constexpr bool kPlainBytes = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <>
inline constexpr bool kPlainBytes<Float4> = true;
template <>
inline constexpr bool kPlainBytes<Vec3> = true;
template <>
inline constexpr bool kPlainBytes<Quat> = true;
template <class T, size_t N>
inline constexpr bool kPlainBytes<std::array<T, N>> = kPlainBytes<T>;

template <class Visit>
void fields(Of<Pose> auto& s, Visit&& visit) {
    auto& [p, q] = s;
    visit.state(p, q);
}

}  // namespace placode::sim
