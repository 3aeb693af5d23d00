// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn: corners of nine floats: place [mm], normal, linear colour.

export class Soup {
  constructor() {
    this.data = new Float32Array(9 * 1024);
    this.used = 0;
  }
  clear() {
    this.used = 0;
  }
  room(corners) {
    const wanted = this.used + 9 * corners;
    if (wanted <= this.data.length) return;
    const larger = new Float32Array(Math.max(wanted, 2 * this.data.length));
    larger.set(this.data.subarray(0, this.used));
    this.data = larger;
  }
  corner(p, n, colour) {
    this.data.set(p, this.used);
    this.data.set(n, this.used + 3);
    this.data.set(colour, this.used + 6);
    this.used += 9;
  }
}
