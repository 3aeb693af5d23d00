// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Small vectors, as arrays of three.

export const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) =>
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};
// v turned by the quaternion (w, x, y, z).
export const turned = (q, v) => {
  const u = [q[1], q[2], q[3]], t = cross(u, v).map((c) => 2 * c), s = cross(u, t);
  return [0, 1, 2].map((i) => v[i] + q[0] * t[i] + s[i]);
};
