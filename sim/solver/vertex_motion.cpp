// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/vertex_motion.h"

#include <array>
#include <cmath>

#include "sim/core/event.h"
#include "sim/solver/double_float.h"

namespace placode::sim {
namespace {

bool finite(const Float4& p) noexcept { return p.x * 0 + p.y * 0 + p.z * 0 == 0; }

/// x + low += h velocity
void advance(Float4& x, Float4& low, const Float4& velocity, float h) noexcept {
    carry(x.x, low.x, h * velocity.x);
    carry(x.y, low.y, h * velocity.y);
    carry(x.z, low.z, h * velocity.z);
}

}  // namespace

uint32_t VertexMotion::begin(size_t i) noexcept {
    uint32_t flags = 0;
    Float4 x = state_.x[i], v = state_.v[i];
    if (!finite(x) || !finite(v)) {
        const float w = x.w;
        if (!finite(x)) x = state_.x_start[i];
        x.w = w;
        v = {};
        state_.v[i] = v;
        state_.x[i] = x;
        flags = kNotFinite;
    }
    state_.x_start[i] = x;
    if (!state_.force_n.empty()) {
        const Float4 push = pushed_by_force(i);
        v = {v.x + push.x, v.y + push.y, v.z + push.z, 0};
        state_.pushed[i] = v;
    }
    if (x.w > 0) state_.x[i] = guessed(x, planned(i, state_.v[i]));
    if (keeps_low()) begin_low(i);
    return flags;
}

uint32_t VertexMotion::end(size_t i) noexcept {
    const float h = motion_.h, inverse_h = 1.0F / h;
    Float4& x = state_.x[i];
    const Float4 start = state_.x_start[i];
    Float4& v = state_.v[i];
    if (!finite(x)) {
        x = {start.x, start.y, start.z, x.w};
        v = {};
        if (keeps_low()) state_.x_low[i] = state_.x_start_low[i];
        return kNotFinite;
    }
    // Velocity is a state of its own: what the guess assumed plus what the sweep changed,
    // so that rounding of the position never enters it. Held vertices: the difference.
    const Float4 base = x.w > 0 ? planned(i, v) : Float4{};
    const Float4 from = guessed(start, base);
    Float4 changed = {x.x - from.x, x.y - from.y, x.z - from.z, 0};
    if (keeps_low()) changed = changed_low(i, base);
    const float keep = 1.0F / scaled_sum(h, motion_.damping_per_s[i], 1.0F);
    v = {keep * scaled_sum(changed.x, inverse_h, base.x),
         keep * scaled_sum(changed.y, inverse_h, base.y),
         keep * scaled_sum(changed.z, inverse_h, base.z), 0};
    return 0;
}

/// The guess once more, with low parts.
void VertexMotion::begin_low(size_t i) noexcept {
    Float4& low = state_.x_low[i];
    if (!finite(low)) low = {};
    state_.x_start_low[i] = low;
    Float4 x = state_.x_start[i];
    if (x.w == 0) return;
    advance(x, low, planned(i, state_.v[i]), motion_.h);
    state_.x[i] = x;
}

/// What the sweep changed, with low parts.
Float4 VertexMotion::changed_low(size_t i, const Float4& base) const noexcept {
    const Float4 &x = state_.x[i], &low = state_.x_low[i];
    Float4 from = state_.x_start[i], from_low = state_.x_start_low[i];
    advance(from, from_low, base, motion_.h);
    return {(x.x - from.x) + (low.x - from_low.x), (x.y - from.y) + (low.y - from_low.y),
            (x.z - from.z) + (low.z - from_low.z), 0};
}

/// Velocity that the start guess assumes. VBD leaves gravity to the target (in the guess it
/// makes the sweep overshoot), except where nothing holds the tissue.
Float4 VertexMotion::planned(size_t i, const Float4& v) const noexcept {
    const bool falls = motion_.gravity_in_guess || state_.free_vertex[i] != 0;
    // + 0, not nothing: the kernels add it, and it makes -0 into 0.
    const std::array<float, 4> g = falls ? motion_.fall_m_s : std::array<float, 4>{};
    const Float4 u = {v.x + g[0], v.y + g[1], v.z + g[2], 0};
    if (state_.force_n.empty() || !falls) return u;
    const Float4 push = pushed_by_force(i);
    return {u.x + push.x, u.y + push.y, u.z + push.z, 0};
}

/// h force / m.
Float4 VertexMotion::pushed_by_force(size_t i) const noexcept {
    const Float4& f = state_.force_n[i];
    const float s = motion_.h * state_.x[i].w;
    return {s * f.x, s * f.y, s * f.z, 0};
}

/// scale a + b, rounded as MulAdd of the kernels does.
float VertexMotion::scaled_sum(float scale, float a, float b) const noexcept {
    return motion_.fused ? std::fma(scale, a, b) : scale * a + b;
}

Float4 VertexMotion::guessed(const Float4& x, const Float4& u) const noexcept {
    const float h = motion_.h;
    return {scaled_sum(h, u.x, x.x), scaled_sum(h, u.y, x.y), scaled_sum(h, u.z, x.z), x.w};
}

}  // namespace placode::sim
