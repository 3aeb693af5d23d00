// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a track: some seconds of pictures, each as its difference to the one before. Written by
// reports/review_part.cpp; the layout stands in docs/web.md.

export const FLOATS_OF_TOOL = 9, FLOATS_OF_NEEDLE = 7;

// Differences of both signs are kept as 0, -1, 1, -2, ...
const unzigzag = (value) => (value >> 1) ^ -(value & 1);

export class Part {
  constructor(buffer) {
    const [version, pictures, vertices, surfaces, points, tools, needles, threadPoints] =
        new Uint32Array(buffer, 0, 8);
    if (version !== 3) throw new Error("version " + version);
    Object.assign(this, {pictures, vertices, points, tools, needles, threadPoints});
    let at = 32;
    const take = (Kind, count) => {
      const array = new Kind(buffer, at, count);
      at += array.byteLength;
      return array;
    };
    this.times = take(Float32Array, pictures);
    this.surfaceOf = take(Uint32Array, pictures);
    this.toolStates = take(Float32Array, pictures * tools * FLOATS_OF_TOOL);
    this.needleStates = take(Float32Array, pictures * needles * FLOATS_OF_NEEDLE);
    this.threadCounts = take(Uint32Array, pictures * needles);
    this.heads = take(Uint32Array, 2 * surfaces);
    let edits = 0;
    for (let s = 0; s < surfaces; ++s) edits += this.heads[2 * s + 1];
    this.edits = edits;
    this.editGap = take(Uint32Array, edits);
    this.toolFlags = take(Uint8Array, pictures * tools);
    this.editCorners = take(Uint8Array, 9 * edits);
    this.editTissue = take(Uint8Array, edits);
    this.pointFlags = take(Uint8Array, pictures * points);
    this.damageSteps = take(Uint8Array, pictures * 3 * vertices);
    this.places = vertices + points;
    this.low = take(Uint8Array, pictures * 3 * this.places);
    this.high = take(Uint8Array, pictures * 3 * this.places);
    this.threadLow = take(Uint8Array, 3 * threadPoints);
    this.threadHigh = take(Uint8Array, 3 * threadPoints);
    const most = Math.max(0, ...Array.from({length: surfaces}, (_, s) => this.heads[2 * s]));
    this.x = new Uint16Array(3 * this.places);     // axis by axis
    this.damage = new Uint8Array(3 * vertices);    // kind by kind
    this.corners = new Uint32Array(3 * most);
    this.tissue = new Uint8Array(most);
    this.rewind();
  }

  // Of picture p: place and orientation of the suture needle, or null; steps of its thread's points.
  needleAt(p) {
    if (!this.needles) return null;
    const state = Array.from(this.needleStates.subarray(p * FLOATS_OF_NEEDLE,
                                                        (p + 1) * FLOATS_OF_NEEDLE));
    return state.slice(3).some((c) => c !== 0) ? state : null;
  }
  threadAt(p) {
    if (!this.needles) return [];
    let first = 0;
    for (let i = 0; i < p; ++i) first += this.threadCounts[i];
    return Array.from({length: this.threadCounts[p]}, (_, i) => [0, 1, 2].map((axis) => {
      const n = axis * this.threadPoints + first + i;
      return this.threadLow[n] | (this.threadHigh[n] << 8);
    }));
  }

  rewind() {
    this.picture = -1;
    this.surface = -1;
    this.edit = 0;
    this.corner = 0;
    this.triangles = 0;
    this.x.fill(0);
    this.damage.fill(0);
  }

  // The state of picture `wanted`, in x, damage, corners, tissue and triangles.
  go(wanted) {
    if (wanted < this.picture) this.rewind();
    while (this.picture < wanted) this.next();
  }

  // Column `k` of the corners of edit `e`: its low, middle and high byte lie apart.
  cornerStep(e, k) {
    const at = k * this.edits + e, plane = 3 * this.edits, bytes = this.editCorners;
    return bytes[at] | (bytes[at + plane] << 8) | (bytes[at + 2 * plane] << 16);
  }

  next() {
    const p = ++this.picture, n = 3 * this.places;
    for (let i = 0, at = p * n; i < n; ++i, ++at) {
      const value = this.low[at] | (this.high[at] << 8);
      const before = p > 0 ? this.x[i] : i > 0 ? this.x[i - 1] : 0;
      this.x[i] = before + unzigzag(value);
    }
    const kinds = 3 * this.vertices;
    for (let i = 0; i < kinds; ++i) this.damage[i] += this.damageSteps[p * kinds + i];
    while (this.surface < this.surfaceOf[p]) {
      ++this.surface;
      this.triangles = this.heads[2 * this.surface];
      let t = -1;
      for (let left = this.heads[2 * this.surface + 1]; left > 0; --left, ++this.edit) {
        t += 1 + this.editGap[this.edit];
        this.corner += unzigzag(this.cornerStep(this.edit, 0));
        this.corners[3 * t] = this.corner;
        for (const k of [1, 2])
          this.corners[3 * t + k] = this.corner + this.cornerStep(this.edit, k);
        this.tissue[t] = this.editTissue[this.edit];
      }
    }
  }
}
