// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The tissue of a moment as triangles, with its burns.

import {Soup} from "./soup.js";
import {add, cross, unit} from "./vector.js";

const FRESH = 0x80;  // of a triangle: uncovered during the attempt
const WOUND = [0.30, 0.05, 0.045], BLANCHED = [0.78, 0.72, 0.62], DRIED = [0.33, 0.22, 0.12],
      CHARRED = [0.02, 0.017, 0.015];

export class TissueSoup {
  constructor(head) {
    this.head = head;
    this.soup = new Soup();
  }

  build(part) {
    const n = part.places, step = 1000 * this.head.step_m, least = 1000 * this.head.least_m;
    const at = (v, axis) => least + step * part.x[axis * n + v];
    const normal = new Float32Array(3 * part.vertices), colour = new Float32Array(4 * part.vertices);
    for (let t = 0; t < part.triangles; ++t) {
      const a = part.corners[3 * t], b = part.corners[3 * t + 1], c = part.corners[3 * t + 2];
      const ab = [at(b, 0) - at(a, 0), at(b, 1) - at(a, 1), at(b, 2) - at(a, 2)];
      const ac = [at(c, 0) - at(a, 0), at(c, 1) - at(a, 1), at(c, 2) - at(a, 2)];
      const area = cross(ab, ac);
      const base = this.head.tissues_linear_rgb[part.tissue[t] & 0x7f];
      for (const v of [a, b, c]) {
        for (let k = 0; k < 3; ++k) normal[3 * v + k] += area[k];
        if (part.tissue[t] & FRESH) continue;
        for (let k = 0; k < 3; ++k) colour[4 * v + k] += base[k];
        colour[4 * v + 3] += 1;
      }
    }
    const out = this.soup;
    out.clear();
    out.room(3 * part.triangles);
    for (let t = 0; t < part.triangles; ++t) {
      const fresh = (part.tissue[t] & FRESH) !== 0;
      for (let k = 0; k < 3; ++k) {
        const v = part.corners[3 * t + k], share = 1 / (colour[4 * v + 3] || 1);
        const skin = fresh ? WOUND : [0, 1, 2].map((i) => share * colour[4 * v + i]);
        out.corner([at(v, 0), at(v, 1), at(v, 2)],
                   unit([normal[3 * v], normal[3 * v + 1], normal[3 * v + 2]]),
                   this.damaged(part, v, skin));
      }
    }
    return out;
  }

  damaged(part, v, colour) {
    [BLANCHED, DRIED, CHARRED].forEach((tone, kind) => {
      const share = part.damage[kind * part.vertices + v] / 255;
      if (share > 0) colour = add(colour, add(tone, colour, -1), share);
    });
    return colour;
  }
}
