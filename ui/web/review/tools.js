// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments as round bars: enough to see what they are and where.

import {add, cross, turned, unit} from "./vector.js";

export const ENGAGED = 1;  // flags of a tool
const ENERGISED = 2, COAGULATES = 4;
const STEEL = [0.55, 0.56, 0.58], INSULATION = [0.02, 0.02, 0.025], HOT = [1.0, 0.75, 0.25],
      COAG = [0.35, 0.55, 1.0];
const SIDES = 16;

// A round bar from a to b, with radii there [mm]; flat ends.
export const bar = (soup, a, b, ra, rb, colour) => {
  const along = unit(add(b, a, -1));
  const right = unit(cross(along, Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  const up = cross(along, right);
  soup.room(12 * SIDES);
  for (let i = 0; i < SIDES; ++i) {
    const [n, m] = [i, i + 1].map((j) => {
      const angle = 2 * Math.PI * j / SIDES;
      return add(right.map((c) => c * Math.cos(angle)), up, Math.sin(angle));
    });
    const a0 = add(a, n, ra), a1 = add(a, m, ra), b0 = add(b, n, rb), b1 = add(b, m, rb);
    for (const [p, q] of [[a0, n], [a1, m], [b1, m], [a0, n], [b1, m], [b0, n]])
      soup.corner(p, q, colour);
    for (const p of [a, a0, a1]) soup.corner(p, add([0, 0, 0], along, -1), colour);
    for (const p of [b, b1, b0]) soup.corner(p, along, colour);
  }
};

// An instrument in its frame: tip at the origin, +z distal.
export const drawTool = (soup, spec, state, flags) => {
  const place = state.slice(0, 3).map((c) => 1000 * c), q = state.slice(3, 7), jaw = state[7];
  const world = (v) => add(turned(q, v), place);
  const tip = 1000 * spec.tip_length_m, shaft = 1000 * spec.shaft_radius_m;
  const radius = 1000 * spec.tip_radius_m;
  const hot = flags & ENERGISED ? (flags & COAGULATES ? COAG : HOT) : STEEL;
  bar(soup, world([0, 0, -1000 * spec.length_m]), world([0, 0, -tip]), shaft, shaft, INSULATION);
  if (["grasper", "scissors", "needle_driver"].includes(spec.kind)) {
    for (const side of [-1, 1]) {
      const s = Math.sin(side * jaw / 2), c = Math.cos(side * jaw / 2);
      const width = 500 * spec.jaw_width_m;
      bar(soup, world([0, 0, -tip]), world([0, s * tip, (c - 1) * tip]), width,
          spec.kind === "scissors" ? 0.3 * width : 0.7 * width, STEEL);
    }
  } else if (spec.kind === "hook") {
    bar(soup, world([0, 0, -tip]), world([0, 0, 0]), radius, radius, hot);
    bar(soup, world([0, 0, 0]), world([0, 0.5 * tip, 0]), radius, radius, hot);
  } else {
    bar(soup, world([0, 0, -tip]), world([0, 0, -radius]), 1.5 * radius, radius, hot);
    bar(soup, world([0, 0, -radius]), world([0, 0, 0]), radius, 0.3 * radius, hot);
  }
};
