// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A suture needle, a half circle of wire, and its thread.

import {bar} from "./tools.js";
import {add, turned} from "./vector.js";

const STEEL = [0.62, 0.63, 0.65], THREAD = [0.16, 0.1, 0.45];
const PIECES = 20, TAPER = 0.2, THREAD_MM = 0.09;

// `state`: place [m] and orientation; its frame stands in sim/suture/needle.h.
export const drawNeedle = (soup, spec, state) => {
  const place = state.slice(0, 3).map((c) => 1000 * c), q = state.slice(3, 7);
  const radius = 1000 * spec.arc_m / Math.PI, wire = 1000 * spec.wire_radius_m;
  const at = (share) => {
    const angle = Math.PI * share;
    return add(turned(q, [radius * Math.cos(angle), radius * Math.sin(angle), 0]), place);
  };
  const thick = (share) => wire * Math.min(1, 0.05 + share / TAPER);
  for (let i = 0; i < PIECES; ++i) {
    const from = i / PIECES, to = (i + 1) / PIECES;
    bar(soup, at(from), at(to), thick(from), thick(to), STEEL);
  }
};

// Through places [mm], from the needle on.
export const drawThread = (soup, places) => {
  for (let i = 0; i + 1 < places.length; ++i)
    bar(soup, places[i], places[i + 1], THREAD_MM, THREAD_MM, THREAD);
};
